/* SPDX-License-Identifier: Apache-2.0 */
/* A jam is something under the closing jaws, and the knife's torque shows it. The torque of good cycles is
 * learned in equal parts of the closing range, in relation to what friction needs; what accelerates the knife
 * there changes with the square of the speed. Torque beyond it in two reports of the drive, or a drive at its
 * torque limit, is a jam. Torque in 0.1 % of the rated torque, angles in pulses of the knife from its cut. */
#ifndef CTL_JAM_H
#define CTL_JAM_H

#include "ctl_registers.h"

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_JAM_CYCLES 20u

/* One slice of the knife's motion. */
typedef struct {
    uint32_t now_us;  /* modulo 2^32 */
    uint32_t cycle;   /* differs from that of the cycle before */
    int32_t from_cut; /* the measured position */
    bool in_phase;    /* nothing but program and master accelerates the knife */
    uint32_t share;   /* of full speed, CTL_JAM_FULL_SPEED: all of it */
    bool limited;     /* the drive is at its torque limit */
    int32_t torque;   /* as reported */
} ctl_jam_slice;
#define CTL_JAM_SHARE_BITS 12u
#define CTL_JAM_FULL_SPEED (1u << CTL_JAM_SHARE_BITS)

/* One part of the band, in 1/16 of the torque's unit. */
typedef struct {
    int32_t mean;   /* torque beyond friction at full speed */
    int32_t spread; /* largest distance from it in a passage, on average */
    bool learned;
    bool passed; /* in the present cycle, with torque in between these */
    int32_t lowest;
    int32_t highest;
} ctl_jam_part;

typedef struct {
    bool on;
    bool reports; /* the board has the drive's torque */
    int32_t from; /* the range that is learned, */
    int32_t to;
    int32_t five;   /* pulses of five degrees, which are not judged at both its ends */
    uint32_t scale; /* parts of a pulse, 1/2^24 */
    int32_t margin;
} ctl_jam_settings;

/* It is so, or was so shortly before. */
typedef struct {
    bool is_near;
    uint32_t us;
} ctl_jam_time;

/* The last jam: source and place. */
typedef struct {
    uint16_t source; /* CTL_JAM_SOURCE_... */
    int32_t at;
    int32_t torque;
    int32_t limit;
    int32_t run_on; /* from there to standstill */
} ctl_jam_event;

typedef struct {
    ctl_jam_settings settings;
    ctl_jam_part parts[CTL_JAM_BINS];
    uint32_t cycles;  /* learned, at most CTL_JAM_CYCLES */
    int32_t friction; /* 1/16 of the torque's unit */
    /* The present cycle, */
    uint32_t cycle;
    bool even; /* all of it at full speed, in phase and within the band */
    int32_t sum;
    uint32_t count;
    /* the closing range, */
    bool inside;
    uint32_t entered_us;
    uint32_t allowed_us; /* the time in which a jam must be seen */
    uint32_t reach;      /* parts to each side that one report may belong to */
    uint32_t learning;   /* part that is learned next from this passage, CTL_JAM_BINS: none, */
    int32_t next_widest; /* largest end of the band in those before it, */
    int32_t widest;      /* and in all */
    bool beyond;         /* the band, since beyond_us */
    uint32_t beyond_us;
    /* and the reports. */
    int32_t report;
    bool has_changed;
    uint32_t report_us;
    bool missed;          /* the slice before had no time for them */
    uint32_t interval_us; /* shortest time between two, 0: unknown */
    ctl_jam_time out_of_phase;
    ctl_jam_time in_ramp;

    uint16_t number; /* jams since power-up */
    ctl_jam_event last;
    int32_t first; /* torque at the cut when it was learned */
    int32_t residue_sum;
    uint32_t residue_bags;
    uint32_t residue_number;
    int16_t residue; /* 0.01 % of the rated torque */
} ctl_jam;

/* Another program: learns again. */
void ctl_jam_forget(ctl_jam* jam);
/* Sets all but `scale`, which follows; learns again if the range is another one. */
void ctl_jam_set(ctl_jam* jam, const ctl_jam_settings* settings);
/* Watches one slice of the motion; returns true when there is a jam. */
bool ctl_jam_watch(ctl_jam* jam, const ctl_jam_slice* slice);
/* A slice has no time for it: the next report may have come in it. */
void ctl_jam_miss(ctl_jam* jam);
/* While the knife still moves behind a jam. */
void ctl_jam_run_on(ctl_jam* jam, int32_t from_cut);
/* Returns CTL_JAM_STATE_... */
uint16_t ctl_jam_state(const ctl_jam* jam);
/* Writes the registers of the group `jam`; `revolution`: pulses of the knife's shaft. */
void ctl_jam_registers(const ctl_jam* jam, uint32_t revolution, uint16_t* registers);

#ifdef __cplusplus
}
#endif

#endif
