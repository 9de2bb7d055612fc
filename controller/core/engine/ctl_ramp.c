/* SPDX-License-Identifier: Apache-2.0 */
#include "engine/ctl_ramp.h"

#define SHARE_BITS CTL_RAMP_SHARE_BITS
/* The place in the stretch of a line that is led has so many bits; a search looks so far from the last one
 * first. */
#define PLACE_BITS 15u
#define NEAR_PLACES 32u
#define WHOLE ((uint64_t)1 << SHARE_BITS)

void ctl_ramp_reset(ctl_ramp* ramp, uint32_t full)
{
    ramp->full = full;
    ramp->limit = full;
    ramp->speed = 0;
    ramp->rest = 0;
    ramp->s_curve = false;
    ramp->led = false;
    ramp->place = 0;
}

void ctl_ramp_reset_s(ctl_ramp* ramp, uint32_t full)
{
    ctl_ramp_reset(ramp, full);
    ramp->s_curve = true;
}

/* 2 x^2 of the nearer end of the ramp, x being the way from there. */
static uint64_t share_from_end(const ctl_ramp* ramp, uint32_t from_end)
{
    const uint64_t part = ((uint64_t)from_end << SHARE_BITS) / ramp->full;
    return 2u * (part * part >> SHARE_BITS);
}

/* Share of full speed on the S-curve. */
static uint64_t s_share(const ctl_ramp* ramp)
{
    const uint32_t left = ramp->full - ramp->speed;
    return ramp->speed <= left ? share_from_end(ramp, ramp->speed) : WHOLE - share_from_end(ramp, left);
}

/* Travel of the S-curve from standstill to `speed`, and just as well from there to standstill: the integral
 * of its share. A difference of two is exact however a ramp is cut. */
static uint32_t s_travel(const ctl_ramp* ramp, uint32_t speed)
{
    const uint32_t left = ramp->full - speed;
    const uint32_t from_end = speed <= left ? speed : left;
    const uint32_t curved = (uint32_t)(from_end * share_from_end(ramp, from_end) / 3u >> SHARE_BITS);
    return speed <= left ? curved : speed - ramp->full / 2u + curved;
}

/* Travel while the speed changes evenly from the present one to `end`. */
static uint32_t travel(ctl_ramp* ramp, uint32_t end, uint32_t ticks)
{
    if (ramp->s_curve) {
        const uint32_t one = s_travel(ramp, ramp->speed);
        const uint32_t other = s_travel(ramp, end);
        ramp->speed = end;
        return one < other ? other - one : one - other;
    }
    const uint64_t unit = 2u * (uint64_t)ramp->full;
    const uint64_t sum = ((uint64_t)ramp->speed + end) * ticks + ramp->rest;
    ramp->speed = end;
    ramp->rest = sum % unit;
    return (uint32_t)(sum / unit);
}

uint32_t ctl_ramp_down(ctl_ramp* ramp, uint32_t ticks)
{
    const uint32_t falling = ramp->speed < ticks ? ramp->speed : ticks;
    return travel(ramp, ramp->speed - falling, falling);
}

/* The root of 32 bits, rounded down, and *rest, which is left of the square. */
static uint32_t short_root(uint32_t square, uint32_t* rest)
{
    uint32_t root = 0;
    for (uint32_t bit = (uint32_t)1 << 30; bit != 0; bit >>= 2) {
        const uint32_t sum = root + bit;
        root >>= 1;
        if (square >= sum) {
            square -= sum;
            root += bit;
        }
    }
    *rest = square;
    return root;
}

/* The lower half of the root is the rest by twice the upper half, or one less (P. Zimmermann, Karatsuba
 * square root). */
uint32_t ctl_square_root(uint64_t square)
{
    uint32_t rest = 0;
    uint32_t shift = 0;
    if (square <= UINT32_MAX)
        return short_root((uint32_t)square, &rest);
    for (uint32_t bits = 8; bits != 0; bits >>= 1) {
        if (square >> (64u - 2u * bits) == 0) {
            square <<= 2u * bits;
            shift += bits;
        }
    }
    const uint32_t upper = short_root((uint32_t)(square >> 32), &rest);
    const uint32_t low = (uint32_t)square;
    const uint32_t half = (rest << 15) + (low >> 17);
    uint32_t lower = half / upper;
    if (lower > UINT16_MAX)
        return (upper << 16 | UINT16_MAX) >> shift;
    const uint32_t left = half % upper << 1 | (low >> 16 & 1u);
    if (left <= UINT16_MAX && (left << 16 | (low & UINT16_MAX)) < lower * lower)
        return ((upper << 16) + lower - 1u) >> shift;
    return ((upper << 16) + lower) >> shift;
}

/* 2 x^3 - x^4 of x in 1 / 2^15. */
static uint64_t led_way(uint32_t x)
{
    return (uint64_t)(x * x) * (x * ((2u << PLACE_BITS) - x));
}

/* Returns the largest place whose way is at most this, x of it being near. */
static uint32_t led_place(uint64_t way, uint32_t x)
{
    uint32_t bit = NEAR_PLACES / 2u;
    if (x < NEAR_PLACES || x + 2u * NEAR_PLACES > 1u << PLACE_BITS || led_way(x - NEAR_PLACES) > way ||
        led_way(x + NEAR_PLACES) <= way) {
        x = 0;
        bit = 1u << (PLACE_BITS - 1u);
    } else if (led_way(x) > way) {
        x -= NEAR_PLACES;
    }
    for (; bit != 0; bit >>= 1) {
        if (led_way(x + bit) <= way)
            x += bit;
    }
    return x;
}

/* Speed of a line that is led, at a way from standstill; `place` is one near it and becomes its own. */
static uint32_t led_speed(const ctl_ramp* ramp, uint64_t way, uint32_t* place)
{
    if (ramp->stretch == 0 || way >= ramp->stretch / 2u)
        return ramp->top;
    const uint32_t x = led_place(((way << 30u) / ramp->stretch) << 31u, *place);
    const uint64_t square = x * x;
    const uint64_t share = (3u * square << PLACE_BITS) - 2u * square * x; /* 1 / 2^45 */
    *place = x;
    return (uint32_t)(ramp->top * (share >> PLACE_BITS) >> (2u * PLACE_BITS));
}

static uint32_t led_speed_at(const ctl_ramp* ramp, uint64_t way)
{
    uint32_t place = ramp->place;
    return led_speed(ramp, way, &place);
}

void ctl_ramp_lead(ctl_ramp* ramp, uint32_t top, uint32_t stretch, uint64_t way)
{
    ramp->led = true;
    ramp->s_curve = false; /* it would be its own */
    ramp->top = top;
    ramp->stretch = stretch;
    ramp->way = way;
    ramp->speed = led_speed(ramp, way, &ramp->place);
}

uint32_t ctl_ramp_speed_after(const ctl_ramp* ramp, uint32_t way)
{
    if (ramp->led)
        return led_speed_at(ramp, ramp->way + way);
    if (ramp->speed == ramp->limit)
        return ramp->speed;
    const uint64_t square = (uint64_t)ramp->speed * ramp->speed;
    const uint64_t change = 2u * (uint64_t)ramp->full * way;
    const uint64_t end = (uint64_t)ramp->limit * ramp->limit;
    if (ramp->speed > ramp->limit)
        return square > end + change ? ctl_square_root(square - change) : ramp->limit;
    return square + change < end ? ctl_square_root(square + change) : ramp->limit;
}

uint64_t ctl_ramp_stopping_way(const ctl_ramp* ramp)
{
    return (uint64_t)ramp->speed * ramp->speed / (2u * (uint64_t)ramp->full);
}

uint32_t ctl_ramp_speed_before(const ctl_ramp* ramp, uint64_t way, uint32_t end, uint32_t most)
{
    if (ramp->led) {
        const uint32_t speed = led_speed_at(ramp, way);
        return speed < most ? speed : most;
    }
    const uint64_t square = (uint64_t)end * end + 2u * (uint64_t)ramp->full * way;
    return square < (uint64_t)most * most ? ctl_square_root(square) : most;
}

bool ctl_ramp_can_land(const ctl_ramp* ramp, uint64_t remaining)
{
    if (ramp->s_curve)
        return s_travel(ramp, ramp->speed) <= remaining;
    return (uint64_t)ramp->speed * ramp->speed <= 2u * (uint64_t)ramp->full * remaining;
}

uint32_t ctl_ramp_share(const ctl_ramp* ramp, uint32_t value)
{
    if (ramp->speed == ramp->full)
        return value;
    if (ramp->s_curve)
        return (uint32_t)(value * s_share(ramp) >> SHARE_BITS);
    return (uint32_t)((uint64_t)value * ramp->speed / ramp->full);
}

/* Goes on evenly on the S-curve for at most *ticks, at most `way`; *ticks becomes what is left of them. */
static uint32_t cruise(ctl_ramp* ramp, uint32_t* ticks, uint64_t way)
{
    const uint64_t share = s_share(ramp);
    uint64_t used = *ticks;
    if (way <= used) {
        const uint64_t wanted = way << SHARE_BITS;
        const uint64_t needed = wanted > ramp->rest ? (wanted - ramp->rest + share - 1u) / share : 0;
        used = needed < used ? needed : used;
    }
    const uint64_t sum = share * used + ramp->rest;
    ramp->rest = sum % WHOLE;
    *ticks -= (uint32_t)used;
    return (uint32_t)(sum >> SHARE_BITS);
}

/* Goes on evenly. */
static uint32_t go_on(ctl_ramp* ramp, uint32_t ticks)
{
    if (ramp->speed == ramp->full)
        return ticks;
    return ramp->s_curve ? cruise(ramp, &ticks, UINT64_MAX) : travel(ramp, ramp->speed, ticks);
}

/* The speed that many ticks nearer to the limit. */
static uint32_t nearer_to_limit(const ctl_ramp* ramp, uint32_t ticks)
{
    if (ramp->speed <= ramp->limit)
        return ramp->limit - ramp->speed < ticks ? ramp->limit : ramp->speed + ticks;
    return ramp->speed - ramp->limit < ticks ? ramp->limit : ramp->speed - ticks;
}

static uint32_t approach_limit(ctl_ramp* ramp, uint32_t ticks)
{
    const uint32_t end = nearer_to_limit(ramp, ticks);
    const uint32_t used = end > ramp->speed ? end - ramp->speed : ramp->speed - end;
    const uint32_t travelled = travel(ramp, end, used);
    return used == ticks ? travelled : travelled + go_on(ramp, ticks - used);
}

uint32_t ctl_ramp_up(ctl_ramp* ramp, uint32_t ticks)
{
    if (ramp->speed != ramp->limit)
        return approach_limit(ramp, ticks);
    return ramp->speed == ramp->full ? ticks : go_on(ramp, ticks);
}

void ctl_ramp_limit(ctl_ramp* ramp, uint32_t percent)
{
    ramp->limit = percent < 100u ? ctl_ramp_speed_of(ramp, WHOLE / 100u * percent) : ramp->full;
}

/* Gains speed while that may still be braked, goes on evenly to where the braking begins, brakes. */
static uint32_t land_s(ctl_ramp* ramp, uint32_t ticks, uint64_t remaining, uint32_t limit)
{
    uint32_t travelled = 0;
    if (ramp->speed < limit) {
        ctl_ramp faster = *ramp;
        const uint32_t rising = limit - ramp->speed < ticks ? limit - ramp->speed : ticks;
        const uint32_t gained = travel(&faster, ramp->speed + rising, rising);
        if (gained + s_travel(&faster, faster.speed) < remaining) {
            *ramp = faster;
            travelled = gained;
            ticks -= rising;
        }
    }
    if (remaining == travelled ||
        s_share(ramp) == 0) { /* too slow to move at all: what is left is a fraction of a slice */
        ramp->speed = 0;
        return (uint32_t)remaining;
    }
    const uint64_t way = remaining - travelled - s_travel(ramp, ramp->speed);
    travelled += cruise(ramp, &ticks, way);
    if (remaining - travelled == s_travel(ramp, ramp->speed))
        travelled += ctl_ramp_down(ramp, ticks);
    if (travelled == remaining)
        ramp->speed = 0;
    return travelled;
}

uint32_t ctl_ramp_land(ctl_ramp* ramp, uint32_t ticks, uint64_t remaining, uint32_t limit)
{
    if (limit > ramp->limit)
        limit = ramp->limit;
    if (ramp->s_curve)
        return land_s(ramp, ticks, remaining, limit);
    uint32_t end = ramp->speed;
    if (end < limit)
        end = limit - end < ticks ? limit : end + ticks;
    /* Speed from which the ramp ends exactly there: v = sqrt(2 a d). */
    const uint32_t curve = ctl_ramp_speed_before(ramp, remaining, 0, end + ticks + 1u);
    if (curve <= ticks) {
        ramp->speed = 0;
        ramp->rest = 0;
        return (uint32_t)remaining;
    }
    if (end > curve - ticks)
        end = curve - ticks;
    const uint32_t travelled = travel(ramp, end, ticks);
    if (travelled < remaining)
        return travelled;
    ramp->speed = 0;
    ramp->rest = 0;
    return (uint32_t)remaining;
}

bool ctl_ramp_can_approach(const ctl_ramp* ramp, uint64_t remaining, uint32_t end)
{
    if (ramp->speed <= end)
        return true;
    if (ramp->s_curve)
        return s_travel(ramp, ramp->speed) - s_travel(ramp, end) <= remaining;
    const uint64_t squares = (uint64_t)ramp->speed * ramp->speed - (uint64_t)end * end;
    return squares <= 2u * (uint64_t)ramp->full * remaining;
}

/* Gains speed while that may still be braked, goes on evenly to where the braking to `end` begins, brakes. */
static uint32_t approach_s(ctl_ramp* ramp, uint32_t ticks, uint64_t remaining, uint32_t end)
{
    const uint32_t end_way = s_travel(ramp, end);
    uint32_t travelled = 0;
    const uint32_t next = nearer_to_limit(ramp, ticks);
    const uint32_t changing = next > ramp->speed ? next - ramp->speed : ramp->speed - next;
    ctl_ramp faster = *ramp;
    const uint32_t gained = travel(&faster, next, changing);
    if (faster.speed <= ramp->speed || faster.speed <= end ||
        gained + (uint64_t)s_travel(&faster, faster.speed) - end_way < remaining) {
        *ramp = faster;
        travelled = gained;
        ticks -= changing;
    }
    const uint64_t braking = ramp->speed > end ? s_travel(ramp, ramp->speed) - end_way : 0;
    if (remaining > travelled + braking)
        travelled += cruise(ramp, &ticks, remaining - travelled - braking);
    if (ramp->speed > end) {
        const uint32_t falling = ramp->speed - end < ticks ? ramp->speed - end : ticks;
        travelled += travel(ramp, ramp->speed - falling, falling);
        ticks -= falling;
    }
    return travelled + cruise(ramp, &ticks, UINT64_MAX);
}

uint32_t ctl_ramp_approach(ctl_ramp* ramp, uint32_t ticks, uint64_t remaining, uint32_t end)
{
    if (ramp->s_curve)
        return approach_s(ramp, ticks, remaining, end);
    /* Speed from which the ramp comes down to `end` exactly there: v = sqrt(end^2 + 2 a d). */
    const uint32_t next = nearer_to_limit(ramp, ticks);
    const uint32_t curve = ctl_ramp_speed_before(ramp, remaining, end, next + ticks);
    const uint32_t limit = curve < end + ticks ? end : curve - ticks;
    return travel(ramp, next < limit ? next : limit, ticks);
}

uint64_t ctl_ramp_whole_share(const ctl_ramp* ramp)
{
    return ramp->s_curve ? s_share(ramp) : ((uint64_t)ramp->speed << SHARE_BITS) / ramp->full;
}

uint32_t ctl_ramp_speed_of(const ctl_ramp* ramp, uint64_t share)
{
    if (share >= WHOLE)
        return ramp->full;
    if (!ramp->s_curve)
        return (uint32_t)(share * ramp->full >> SHARE_BITS);
    /* Of 2 x^2 below the middle, of 1 - 2 (1 - x)^2 above it. */
    const bool low = share <= WHOLE / 2u;
    const uint64_t half = (low ? share : WHOLE - share) / 2u;
    const uint64_t part = ctl_square_root(half << SHARE_BITS) + (low ? 0u : 1u);
    const uint32_t from_end = (uint32_t)(part * ramp->full >> SHARE_BITS) + (low ? 0u : 1u);
    return low ? from_end : ramp->full - from_end;
}
