/* SPDX-License-Identifier: Apache-2.0 */
/* One stroke of a press in five stages. Up to the place where the work piece is felt a position is where the
 * machine's scale says; from there on the pulses that are left are counted by the pulse generator, so that
 * the stop does not depend on how often the controller looks. Nothing is ever corrected backwards. */
#ifndef CTL_PRESS_H
#define CTL_PRESS_H

#include "base/ctl_bank.h"
#include "engine/ctl_count.h"

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Rows of the table. */
enum { CTL_PRESS_APPROACH, CTL_PRESS_PROBE, CTL_PRESS_PRESS, CTL_PRESS_HOLD, CTL_PRESS_RETURN };

#define CTL_PRESS_FINE 256 /* of a position in a reading, per pulse */
/* The ram stands when its position has kept within one pulse for this long after the last pulse. */
#define CTL_PRESS_REST_US 20000u
/* The rest that a position still lacks then is added at most so many times. */
#define CTL_PRESS_ADDITIONS 3u
#define CTL_PRESS_NO_FAULT 0xFFFFu

typedef struct {
    uint32_t frequency_hz;
    int32_t end;      /* pulses below the upper position; of the return the upper position itself */
    uint32_t force;   /* N: felt (approach, probe), largest one allowed (press; valid in all stages) */
    uint32_t time_ms; /* ramp of a stage that moves, duration of the hold */
} ctl_press_row;

/* Position and force as the machine gives them at now_us. */
typedef struct {
    int64_t position; /* 1/256 pulse below the upper position */
    int32_t force;    /* N */
    uint64_t now_us;
    bool fresh; /* read at now_us; false while the controller catches up with time that has passed */
} ctl_press_reading;

typedef struct {
    uint16_t result; /* CTL_STROKE_RESULT_... */
    int64_t error;   /* whole pulses from where it should have stopped to where it did; 0 when it did not get
                        there */
    int32_t force;   /* N at the stop, 0 likewise */
    int32_t peak;    /* N, largest of the stroke */
} ctl_stroke;

typedef struct {
    const ctl_bank* bank;
    uint32_t clock_hz;
    uint16_t stage; /* CTL_PRESS_STAGE_... */
    bool lifting;   /* on the way up before the stroke begins */
    bool felt;      /* the work piece, in the probing stage */
    bool stopped;   /* by command: the stroke ends where the ram comes to stand */
    bool measured;  /* stop position and force are known */
    uint16_t fault; /* bit that the stroke ends with, CTL_PRESS_NO_FAULT when in order */
    ctl_count count;
    int32_t direction;     /* 1: down, -1: up */
    uint32_t runs;         /* begun in this stage */
    bool resting;          /* a reading to compare with was taken since the last pulse */
    int64_t rest_position; /* that reading */
    uint64_t rest_since_us;
    uint64_t hold_since_us;
    ctl_stroke now;  /* of the stroke under way */
    ctl_stroke last; /* of the last one that ended */
} ctl_press;

ctl_press_row ctl_press_row_of(const ctl_bank* bank, uint32_t index);
/* Checks the five rows: all that must hold on this board, beyond what holds for every bank. */
ctl_verdict ctl_press_check(const ctl_bank* bank, const ctl_config* config);

/* Stand; nothing is known of a last stroke. */
void ctl_press_reset(ctl_press* press);
/* Standing: begin a stroke; a ram that is not up goes there first. */
void ctl_press_begin(ctl_press* press, const ctl_bank* bank, uint32_t clock_hz,
                     const ctl_press_reading* reading);
/* Moves on by `ticks` after the reading; returns the pulses that come meanwhile, negative upwards. The stroke
 * has ended when the stage is Standing afterwards. */
int32_t ctl_press_slice(ctl_press* press, const ctl_press_reading* reading, uint32_t ticks,
                        const ctl_pace* pace);
/* Ramp down; the stroke ends where the ram comes to stand. */
void ctl_press_stop(ctl_press* press);
/* The stroke under way ends here and now, without another pulse. */
void ctl_press_abandon(ctl_press* press);
/* Pulse frequency now, negative upwards. */
int64_t ctl_press_hz(const ctl_press* press);

#ifdef __cplusplus
}
#endif

#endif
