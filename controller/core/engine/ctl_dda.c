/* SPDX-License-Identifier: Apache-2.0 */
#include "engine/ctl_dda.h"

/* Then the rest is halved, whatever the speed does. */
#define MAX_GUESSES 8u
#define VELOCITY_MASK ((1u << CTL_DDA_CAPACITY_BITS) - 1u)

static void start(ctl_dda* dda, ctl_interval_row row)
{
    dda->running = row;
    dda->moves = true;
    dda->emitted = 0;
    dda->velocity = row.first_speed;
    dda->velocity_rest = 0;
}

void ctl_dda_reset(ctl_dda* dda, uint32_t fraction_bits)
{
    const ctl_dda standing = {.position_bits = CTL_DDA_CAPACITY_BITS + fraction_bits};
    *dda = standing;
}

bool ctl_dda_write(ctl_dda* dda, ctl_interval_row row)
{
    if (dda->has_loaded)
        return false;
    if (dda->moves) {
        dda->loaded = row;
        dda->has_loaded = true;
    } else {
        dda->position_rest = 0;
        start(dda, row);
    }
    return true;
}

uint32_t ctl_dda_status(const ctl_dda* dda)
{
    return (dda->moves ? 0u : CTL_DDA_FINISHED) | (dda->has_loaded ? 0u : CTL_DDA_WRITABLE) |
           (dda->velocity != 0 && dda->velocity == dda->running.last_speed ? CTL_DDA_V1_REACHED : 0u);
}

/* Sum of floor((first + step * i) / 2^23) over i = 0 .. count - 1, by Euclid's algorithm on the lattice below
 * the line. No overflow as long as the sum and every (first + step * i) fit. */
static uint64_t floor_sum(uint64_t count, uint64_t step, uint64_t first)
{
    uint64_t modulus = (uint64_t)1 << CTL_DDA_CAPACITY_BITS;
    uint64_t sum = 0;
    while (count != 0) {
        sum += (count % 2u == 0 ? count / 2u * (count - 1u) : (count - 1u) / 2u * count) * (step / modulus);
        sum += count * (first / modulus);
        step %= modulus;
        const uint64_t top = step * count + first % modulus;
        first = top % modulus;
        count = top / modulus;
        const uint64_t swapped = step;
        step = modulus;
        modulus = swapped;
    }
    return sum;
}

/* Iterations of the ramp that are left until the last speed is reached. */
static uint64_t ramp_left(const ctl_dda* dda)
{
    const uint32_t last = dda->running.last_speed;
    const uint64_t change = last > dda->velocity ? last - dda->velocity : dda->velocity - last;
    if (change == 0)
        return 0;
    if (dda->running.acceleration == 0)
        return UINT64_MAX;
    const uint64_t acceleration = dda->running.acceleration;
    return ((change << CTL_DDA_CAPACITY_BITS) - dda->velocity_rest + acceleration - 1u) / acceleration;
}

/* The position accumulator after so many iterations, its carries not taken off. */
static uint64_t position_after(const ctl_dda* dda, uint32_t iterations, uint64_t ramp)
{
    const uint64_t rising = ramp > iterations ? iterations : (ramp == 0 ? 0 : ramp - 1u);
    const uint64_t acceleration = dda->running.acceleration;
    const uint64_t change = floor_sum(rising, acceleration, dda->velocity_rest + acceleration);
    const uint64_t even = dda->position_rest + rising * dda->velocity +
                          (iterations - rising) * (uint64_t)dda->running.last_speed;
    return dda->running.last_speed > dda->velocity ? even + change : even - change;
}

static void accelerate(ctl_dda* dda, uint32_t iterations, uint64_t ramp)
{
    if (iterations >= ramp) {
        dda->velocity = dda->running.last_speed;
        dda->velocity_rest = 0;
        return;
    }
    const uint64_t sum = (uint64_t)dda->running.acceleration * iterations + dda->velocity_rest;
    const uint32_t carries = (uint32_t)(sum >> CTL_DDA_CAPACITY_BITS);
    dda->velocity += dda->running.last_speed > dda->velocity ? carries : 0u - carries;
    dda->velocity_rest = (uint32_t)sum & VELOCITY_MASK;
}

/* The iteration that brings pulse number `pulses` from here, known to be among the next `max`: first where
 * the speed of now would bring it, then nearer by what is lacking. */
static uint32_t iteration_of(const ctl_dda* dda, uint64_t pulses, uint32_t max, uint64_t ramp)
{
    const uint64_t wanted = pulses << dda->position_bits;
    const uint64_t speed = dda->velocity == 0 ? 1u : dda->velocity;
    uint32_t low = 0;
    uint32_t high = max;
    uint64_t guess = (wanted - dda->position_rest) / speed;
    for (uint32_t i = 0; high - low > 1u; ++i) {
        if (i >= MAX_GUESSES || guess <= low || guess >= high)
            guess = low + (i < MAX_GUESSES ? (guess <= low ? 1u : high - low - 1u) : (high - low) / 2u);
        const uint64_t position = position_after(dda, (uint32_t)guess, ramp);
        if (position >= wanted) {
            high = (uint32_t)guess;
            const uint64_t back = (position - wanted) / speed;
            guess = guess > back ? guess - back : 0;
        } else {
            low = (uint32_t)guess;
            guess += (wanted - position + speed - 1u) / speed;
        }
    }
    return high;
}

uint32_t ctl_dda_to_pulse(const ctl_dda* dda, uint32_t max)
{
    const uint64_t ramp = ramp_left(dda);
    const bool comes = dda->moves && position_after(dda, max, ramp) >> dda->position_bits != 0;
    return comes ? iteration_of(dda, 1, max, ramp) : max;
}

uint32_t ctl_dda_iterate(ctl_dda* dda, uint32_t* iterations)
{
    if (!dda->moves) {
        *iterations = 0;
        return 0;
    }
    const uint64_t ramp = ramp_left(dda);
    const uint32_t left = dda->running.distance - dda->emitted;
    const bool ends = position_after(dda, *iterations, ramp) >> dda->position_bits >= left;
    if (ends)
        *iterations = iteration_of(dda, left, *iterations, ramp);
    const uint64_t position = position_after(dda, *iterations, ramp);
    const uint32_t pulses = (uint32_t)(position >> dda->position_bits);
    dda->position_rest = (uint32_t)(position & (((uint64_t)1 << dda->position_bits) - 1u));
    dda->emitted += pulses;
    accelerate(dda, *iterations, ramp);
    if (ends) {
        dda->moves = dda->has_loaded;
        if (dda->has_loaded)
            start(dda, dda->loaded);
        dda->has_loaded = false;
    }
    return pulses;
}
