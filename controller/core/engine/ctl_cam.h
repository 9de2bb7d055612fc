/* SPDX-License-Identifier: Apache-2.0 */
/* The cam-point engine: the slave follows a master that runs through equal intervals, a cubic with the rows'
 * slopes in between. Every CTL_CAM_UPDATE_US of real time the position is taken where the master is then; on
 * the straight line to it the pulses leave during the next CTL_CAM_UPDATE_US. So the axis comes that much
 * later than the master, and no pulse is lost. A cycle ends exactly advance + remainder / divisor pulses from
 * where it began, whatever the rounding of its last row; it may be run in either direction. */
#ifndef CTL_CAM_H
#define CTL_CAM_H

#include "base/ctl_bank.h"
#include "base/ctl_pace.h"

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_CAM_UPDATE_US 2000u

typedef struct {
    const ctl_bank* bank;
    uint32_t intervals;
    uint32_t cycle_ticks;
    uint32_t update_ticks; /* timer ticks from one update to the next */
    uint64_t position;     /* of the master from the start of the cycle, ticks */
    bool in_cycle;         /* otherwise between two */
    bool holding;          /* beyond the end, at the last slope */
    int64_t base;          /* slave at the start of the cycle, or now when holding; 1/256 pulse */
    uint64_t owed;         /* fraction of 1/256 pulse not yet in base, over the bank's divisor */
    uint64_t hold_rest;    /* the same while holding, over the ticks of a cycle */
    int64_t line_from;     /* what is being emitted, 1/256 pulse */
    int64_t line_to;
    uint32_t line_ticks; /* timer ticks passed of it */
    int64_t sent;        /* pulses since the reset */
    ctl_train train;     /* pulses left of the line, at ticks of the line */
} ctl_cam;

/* Checks what ctl_bank_check() leaves to the engine: the rest of the header, every row, their end. */
ctl_verdict ctl_cam_check(const ctl_bank* bank, const ctl_config* config, ctl_row_check* check,
                          uint32_t rows);

/* Pulse frequency at full speed at the end of a cycle, or at its beginning. */
int64_t ctl_cam_boundary_hz(const ctl_bank* bank, const ctl_config* config, bool end);

/* Stand between two cycles of `bank` with no fraction owed. */
void ctl_cam_reset(ctl_cam* cam, const ctl_bank* bank, const ctl_config* config);
/* Between two cycles: go on with another bank; what is owed is kept. */
void ctl_cam_change_bank(ctl_cam* cam, const ctl_bank* bank);
/* Between two cycles: start the next one from its beginning, or backwards (-1) from its end. */
void ctl_cam_begin_cycle(ctl_cam* cam, int32_t direction);
/* Moves the master by *ticks, at most to the end of the cycle; *ticks becomes what was used. Beyond the end
 * of a cam that holds its last speed it goes on. */
void ctl_cam_advance(ctl_cam* cam, int32_t direction, uint32_t* ticks);

/* Slave where the master is, 1/256 pulse since the reset. */
int64_t ctl_cam_target(const ctl_cam* cam);
/* Timer ticks to the next update. */
uint32_t ctl_cam_until_update(const ctl_cam* cam);
/* Lets so many timer ticks pass, at most to the next update, which is then made; returns the pulses that
 * leave meanwhile. */
int64_t ctl_cam_pass(ctl_cam* cam, uint32_t ticks, const ctl_pace* pace);
/* Everything up to where the master stands has left. */
bool ctl_cam_settled(const ctl_cam* cam);
/* More pulses than the output stage gives are to leave until the next update. */
bool ctl_cam_too_fast(const ctl_cam* cam, const ctl_config* config);
/* Pulse frequency until the next update. */
int64_t ctl_cam_hz(const ctl_cam* cam, const ctl_config* config);

#ifdef __cplusplus
}
#endif

#endif
