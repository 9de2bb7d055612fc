/* SPDX-License-Identifier: Apache-2.0 */
/* The pulse generator of the paper on intervals: two cascaded accumulators (a digital differential analyzer).
 * Each iteration adds the acceleration to the velocity accumulator, whose carries step the velocity toward
 * its last value, then adds the velocity to the position accumulator, whose carry is a pulse. One interval
 * runs, one is loaded. Iterations are not gone through one by one: sums over them are computed in closed
 * form. */
#ifndef CTL_DDA_H
#define CTL_DDA_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* An iteration takes 6 clocks of 50 MHz: 25 000 000 / 3 iterations per second. */
#define CTL_DDA_ITERATIONS_PER_3S 25000000u
#define CTL_DDA_CAPACITY_BITS 23u
#define CTL_DDA_MAX_FRACTION_BITS 8u

/* Status: the paper's two bits and its flag. */
#define CTL_DDA_FINISHED 1u   /* the interval is finished, or there is none */
#define CTL_DDA_WRITABLE 2u   /* the next interval may be written */
#define CTL_DDA_V1_REACHED 4u /* the interval runs, or ended, at its last speed */

/* Speeds and acceleration count 2^-fraction_bits pulses/s and pulses/s^2 at 2^23 iterations per second. */
typedef struct {
    uint32_t distance; /* pulses */
    uint32_t first_speed;
    uint32_t last_speed;
    uint32_t acceleration; /* without its sign; each iteration adds so many 2^-23 to the speed */
} ctl_interval_row;

typedef struct {
    ctl_interval_row running;
    ctl_interval_row loaded;
    bool moves;      /* `running` is under way */
    bool has_loaded; /* `loaded` follows it */
    uint32_t position_bits;
    uint32_t emitted;       /* pulses of `running` */
    uint32_t velocity;      /* as the row's speeds */
    uint32_t velocity_rest; /* velocity accumulator, below 2^23 */
    uint32_t position_rest; /* position accumulator, below 2^position_bits */
} ctl_dda;

/* Standstill, nothing loaded. The position accumulator gets as many bits more as the rows have of fraction,
 * at most CTL_DDA_MAX_FRACTION_BITS; 0 is the paper's generator, bit for bit. */
void ctl_dda_reset(ctl_dda* dda, uint32_t fraction_bits);
/* Hands over the next interval; false, and nothing happens, unless CTL_DDA_WRITABLE. From standstill both
 * accumulators begin at 0; an interval that follows another begins with the velocity accumulator at 0 and the
 * position accumulator as it was left. */
bool ctl_dda_write(ctl_dda* dda, ctl_interval_row row);
uint32_t ctl_dda_status(const ctl_dda* dda);
/* Goes on by *iterations (at most 2^31), at most to the end of the running interval, and takes the loaded one
 * over there. Returns the pulses; *iterations becomes what was used. */
uint32_t ctl_dda_iterate(ctl_dda* dda, uint32_t* iterations);
/* Returns the iterations to the next pulse, at most `max`. */
uint32_t ctl_dda_to_pulse(const ctl_dda* dda, uint32_t max);

#ifdef __cplusplus
}
#endif

#endif
