/* SPDX-License-Identifier: Apache-2.0 */
/* The states of the machine and what moves the axis in each: the table under a ramped master, jogging,
 * homing. */
#ifndef CTL_MOTION_H
#define CTL_MOTION_H

#include "engine/ctl_press.h"
#include "engine/ctl_ramp.h"
#include "engine/ctl_table.h"

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Ramp of jogging and homing, from standstill to their frequency and back. */
#define CTL_JOG_RAMP_MS 50u
#define CTL_SPEED_SAMPLES 8u

struct ctl_core;

/* At once; landing on the cycle's boundary; where the table itself comes to rest. */
typedef enum { CTL_STOP_NOW, CTL_STOP_AT_BOUNDARY, CTL_STOP_AT_REST } ctl_stop;
typedef enum { CTL_HOMING_SEARCH, CTL_HOMING_BRAKE, CTL_HOMING_RETURN } ctl_homing;

typedef struct {
    int64_t position[CTL_SPEED_SAMPLES];
    uint64_t time_us[CTL_SPEED_SAMPLES];
    uint8_t next;
} ctl_speed_meter;

typedef struct {
    uint16_t state; /* CTL_STATE_... */
    uint16_t fault; /* bits CTL_FAULT_BIT_... */
    bool homed;     /* origin is the index mark */
    bool in_phase;  /* the axis stands where the table's cycle says */
    bool manual;    /* jogging or homing moves the axis, otherwise the table */
    bool start_after_home;
    ctl_stop stop;
    ctl_homing homing;
    ctl_ramp ramp;
    ctl_table table;         /* valid while there is an active bank */
    int32_t direction;       /* of the master, 1 or -1 */
    ctl_press press;         /* instead of it when that is a press's */
    uint32_t cycle_count;    /* cycles completed since power-up; strokes of a press however they ended */
    uint64_t stop_remaining; /* master ticks to the boundary where the motion ends */
    uint32_t stop_limit;     /* ramp speed that a stopping master does not exceed */
    uint32_t manual_hz;
    int32_t manual_direction; /* 1 or -1 */
    uint64_t manual_rest;     /* of a pulse, in 1 / timer clock */
    uint64_t homing_left;     /* pulses to search, then master ticks to return */
    int64_t commanded;        /* pulses sent since power-up */
    int64_t actual;           /* encoder since power-up */
    int64_t origin; /* position of the index mark in both, once homed; of a press the upper position */
    int64_t actual_hz;
    ctl_speed_meter meter;
} ctl_motion;

void ctl_motion_init(struct ctl_core* core);
/* Moves on by the timer ticks that passed since the last call. */
void ctl_motion_slice(struct ctl_core* core, uint32_t ticks);
/* Pulses stop at once. */
void ctl_motion_fault(struct ctl_core* core, uint16_t fault_bit);

/* Commands; each returns CTL_REFUSAL_... */
uint16_t ctl_motion_start(struct ctl_core* core);
uint16_t ctl_motion_stop_at_cycle_end(struct ctl_core* core);
uint16_t ctl_motion_stop_now(struct ctl_core* core);
uint16_t ctl_motion_home(struct ctl_core* core);
uint16_t ctl_motion_reset_fault(struct ctl_core* core);
/* What moves by itself is stopped: nobody watches. */
void ctl_motion_stop_unattended(struct ctl_core* core);

/* At standstill: the staged program becomes the active one. */
void ctl_motion_change_program(struct ctl_core* core);
bool ctl_motion_standstill(const struct ctl_core* core);
/* The table moves the axis. */
bool ctl_motion_in_cycle(const struct ctl_core* core);

uint16_t ctl_motion_master_angle(const struct ctl_core* core); /* 0.01 degrees */
uint16_t ctl_motion_master_speed(const struct ctl_core* core); /* 0.01 % of the table's speed, unsigned */
int64_t ctl_motion_commanded_hz(const struct ctl_core* core);

/* Force of a press, N; 0 on a machine without. */
int32_t ctl_motion_press_force(const struct ctl_core* core);

/* Between the files of this module. */
void ctl_motion_emit(struct ctl_core* core, int64_t pulses);
bool ctl_motion_is_press(const struct ctl_core* core);
/* A press: where it stands is its upper position. */
void ctl_motion_take_top(struct ctl_core* core);
/* A press: the largest force is reached, so that nothing may move it down. */
bool ctl_motion_force_forbids(const struct ctl_core* core);
void ctl_motion_begin_stroke(struct ctl_core* core);
void ctl_motion_slice_stroke(struct ctl_core* core, uint32_t ticks);
void ctl_motion_run(struct ctl_core* core);
void ctl_motion_stand(struct ctl_core* core);
int32_t ctl_motion_wanted_direction(const struct ctl_core* core);
void ctl_motion_begin_manual(struct ctl_core* core, uint32_t frequency_hz, int32_t direction);

#ifdef __cplusplus
}
#endif

#endif
