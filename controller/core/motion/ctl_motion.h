/* SPDX-License-Identifier: Apache-2.0 */
/* The states of the machine and what moves the axis in each: the table under a ramped master, jogging,
 * homing. */
#ifndef CTL_MOTION_H
#define CTL_MOTION_H

#include "bank/ctl_transfer.h"
#include "base/ctl_board.h"
#include "engine/ctl_press.h"
#include "engine/ctl_ramp.h"
#include "engine/ctl_table.h"
#include "master/ctl_master.h"
#include "motion/ctl_change.h"
#include "motion/ctl_heartbeat.h"
#include "motion/ctl_measure.h"
#include "motion/ctl_park.h"
#include "packer/ctl_packer.h"

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Ramp of jogging and homing, from standstill to their frequency and back. */
#define CTL_JOG_RAMP_MS 50u
#define CTL_SPEED_SAMPLES 8u

/* At once; landing on the cycle's boundary; where the table itself comes to rest. */
typedef enum { CTL_STOP_NOW, CTL_STOP_AT_BOUNDARY, CTL_STOP_AT_REST } ctl_stop;
typedef enum { CTL_HOMING_SEARCH, CTL_HOMING_BRAKE, CTL_HOMING_RETURN, CTL_HOMING_ARRIVED } ctl_homing;

typedef struct {
    int64_t position[CTL_SPEED_SAMPLES];
    uint64_t time_us[CTL_SPEED_SAMPLES];
    uint8_t next;
} ctl_speed_meter;

typedef struct {
    const ctl_board* board; /* this and the parts below are set before ctl_motion_init() */
    ctl_banks* banks;
    ctl_transfer* transfer;
    ctl_packer* packer;
    ctl_master* master;
    ctl_heartbeat* heartbeat;
    uint16_t state; /* CTL_STATE_... */
    uint16_t fault; /* bits CTL_FAULT_BIT_... */
    bool homed;     /* origin is the index mark */
    bool in_phase;  /* the axis stands where the table's cycle says */
    bool manual;    /* jogging or homing moves the axis, otherwise the table */
    bool start_after_home;
    bool one_bag; /* this run ends with the next cut */
    bool begins;  /* a run or a program, in this slice */
    bool follows; /* the run follows an encoder, also while the knife is open under a line that stands */
    bool torque_limited; /* the drive of the axis says so */
    ctl_stop stop;
    ctl_homing homing;
    ctl_park park;
    ctl_ramp ramp;
    ctl_table table;         /* valid while there is an active bank */
    int32_t direction;       /* of the master, 1 or -1 */
    ctl_press press;         /* instead of it when that is a press's */
    uint32_t cycle_count;    /* cycles completed since power-up; all strokes of a press */
    uint64_t stop_remaining; /* master ticks to where the motion ends: a boundary, or at once */
    uint16_t speed_percent;  /* of the program's rate, as the operator wants it */
    uint32_t stop_limit;     /* maximum ramp speed of a stopping master */
    bool change_planned;     /* running with an armed program: */
    bool change_opens;       /* the knife is open for it, */
    bool change_rests;       /* or the line leaves its encoder for it */
    bool change_decides;     /* whether it does, in this slice */
    uint32_t change_speed;   /* speed of the ramp at which it may take over */
    uint64_t change_ticks;   /* master ticks to the boundary of the change */
    ctl_change_plan change;  /* to the program that was last asked to take over while running */
    uint32_t manual_hz;
    int32_t manual_direction; /* 1 or -1 */
    uint64_t manual_rest;     /* of a pulse, in 1 / timer clock */
    uint64_t homing_left;     /* pulses to search, then master ticks to the target */
    int64_t target;
    int64_t commanded; /* pulses sent since power-up */
    int64_t actual;    /* encoder since power-up */
    int64_t origin;    /* position of the index mark in both, once homed; of a press the upper position */
    int64_t actual_hz;
    ctl_speed_meter meter;
    const uint16_t* inputs; /* bits CTL_INPUT_BIT_..., as the slice began */
    bool measures;          /* the jog is a measurement's: */
    ctl_measure measure;    /* the last one */
} ctl_motion;

void ctl_motion_init(ctl_motion* motion);
/* Advances by the timer ticks since the last call. */
void ctl_motion_slice(ctl_motion* motion, uint32_t ticks);
/* Stops all pulses at once. */
void ctl_motion_fault(ctl_motion* motion, uint16_t fault_bit);

/* Set the axis off. Only the gate in ctl_start.c calls them. */
void ctl_motion_start(ctl_motion* motion);
/* The same slowly, by the clock whatever leads, up to the end of the cycle of the next cut. */
void ctl_motion_start_bag(ctl_motion* motion);
/* The knife makes one cut while the film stands, and is where it was. */
void ctl_motion_start_cut(ctl_motion* motion);
void ctl_motion_home(ctl_motion* motion);
/* An axis turns slowly forward, for so many turns of its index mark, 0: a quarter of a turn. */
void ctl_motion_measure(ctl_motion* motion, uint16_t axis, uint16_t turns);
/* Commands; each returns CTL_REFUSAL_... */
uint16_t ctl_motion_stop_at_cycle_end(ctl_motion* motion);
uint16_t ctl_motion_stop_now(ctl_motion* motion);
/* The same, and the knife stays where it stops. */
void ctl_motion_emergency_stop(ctl_motion* motion);
uint16_t ctl_motion_reset_fault(ctl_motion* motion);
/* While running: computes the change to the staged program; returns CTL_REFUSAL_..., the reason why it cannot
 * take over. */
uint16_t ctl_motion_change_refusal(ctl_motion* motion);
/* Something is under the closing jaws: all axes stop together, within `parameter.jam_stop_time`, and the
 * knife goes back; then there is a fault in which film and knife keep their places. */
void ctl_motion_stop_jam(ctl_motion* motion);
/* Stops unattended motion (jog, homing). */
void ctl_motion_stop_unattended(ctl_motion* motion);

/* At standstill: the axes are no longer in phase, and the next start is a new beginning. */
void ctl_motion_lose_phase(ctl_motion* motion);
/* At standstill: activates the staged program. */
void ctl_motion_change_program(ctl_motion* motion);
bool ctl_motion_standstill(const ctl_motion* motion);
/* Returns true while a run follows an encoder or waits for it: its line may run. */
bool ctl_motion_follows(const ctl_motion* motion);
/* Returns true while the axis follows its table. */
bool ctl_motion_in_cycle(const ctl_motion* motion);

uint16_t ctl_motion_master_angle(const ctl_motion* motion); /* 0.01 degrees */
uint16_t ctl_motion_master_speed(const ctl_motion* motion); /* 0.01 % of the table's speed, unsigned */
int64_t ctl_motion_commanded_hz(const ctl_motion* motion);

/* Writes the registers of the group `measure`. */
void ctl_measure_registers(const ctl_motion* motion, uint16_t* registers);

/* Returns the force of a press, N; 0 without a press. */
int32_t ctl_motion_press_force(const ctl_motion* motion);

/* Returns true when the jaws of a packing machine's knife do not touch the film. */
bool ctl_motion_jaws_are_open(const ctl_motion* motion);
/* While running a packing line: stops at the end of the cycle as soon as not more than so many bags would be
 * cut until then; asked in every slice in which there is time. */
void ctl_motion_end_after(ctl_motion* motion, uint32_t bags);

/* Between the files of this module. */
/* Sets the axis off, for a run or for one bag. */
void ctl_motion_set_off(ctl_motion* motion);
/* Limits the ramp to a speed from which the line can end within a cycle. */
void ctl_motion_limit_bag(ctl_motion* motion);
/* In a run of one bag: begins to stop, and returns true, as soon as the present cycle will be cut. */
bool ctl_motion_ends_with_bag(ctl_motion* motion);
/* The knife has made its cut at standstill. */
void ctl_motion_end_cut(ctl_motion* motion);
/* Returns true when the packing line, if any, allows a change of program now. */
bool ctl_motion_may_change(const ctl_motion* motion);
bool ctl_motion_is_press(const ctl_motion* motion);
/* Sets the present position of a press as its upper position. */
void ctl_motion_take_top(ctl_motion* motion);
/* Returns true when a press is at its maximum force, so that it must not move down. */
bool ctl_motion_force_forbids(const ctl_motion* motion);
/* Sets the ramp of the active bank, at standstill. */
void ctl_motion_set_ramp(ctl_motion* motion);
/* Sets its limit to what the operator wants. */
void ctl_motion_limit_speed(ctl_motion* motion);
/* Returns the master ticks to the next boundary of its cycle, not 0. */
uint32_t ctl_motion_to_boundary(const ctl_motion* motion);
/* Returns true while a running machine has an armed program, which takes over at the end of a cycle. */
bool ctl_motion_changes(const ctl_motion* motion);
/* Finds the boundary that the ramp can meet slowly enough. */
void ctl_motion_plan_change(ctl_motion* motion, uint32_t slice);
/* The same for a line that an encoder leads: it goes over the boundary as fast as it is, or comes to rest. */
void ctl_motion_plan_led_change(ctl_motion* motion);
/* At the boundary of the change, with `ticks` of the master left of this slice. */
void ctl_motion_pass_boundary(ctl_motion* motion, uint32_t* ticks);
/* The line has left its encoder for a change: it takes over and engages again, as a part of the same run. */
void ctl_motion_change_at_rest(ctl_motion* motion);
void ctl_motion_begin_stroke(ctl_motion* motion);
void ctl_motion_slice_stroke(ctl_motion* motion, const ctl_pace* pace);
/* Somebody else drives the film of the active program from now on, or no longer. */
void ctl_motion_take_wheel(ctl_motion* motion);
void ctl_motion_run(ctl_motion* motion);
void ctl_motion_stand(ctl_motion* motion);
/* At standstill behind a run. */
void ctl_motion_rest(ctl_motion* motion);
/* A run has come to rest: what is left of the stop is a knife that must not stay closed. */
void ctl_motion_come_to_rest(ctl_motion* motion);
/* Parts of a slice by hand: */
void ctl_motion_begin_jog_when_asked(ctl_motion* motion);
void ctl_motion_slice_jogging(ctl_motion* motion, ctl_pace pace);
void ctl_motion_slice_homing(ctl_motion* motion, ctl_pace pace);
/* Jogging, homing or the return from an open knife was stopped. */
void ctl_motion_slice_manual_stop(ctl_motion* motion, ctl_pace pace);
/* The knife opens behind a stop, or returns before a run. */
void ctl_motion_slice_park(ctl_motion* motion, ctl_pace pace);
int32_t ctl_motion_wanted_direction(const ctl_motion* motion);
void ctl_motion_begin_manual(ctl_motion* motion, uint32_t frequency_hz, int32_t direction);
/* The knife goes to where a run may begin, and the run begins there. */
void ctl_motion_return(ctl_motion* motion);
/* Pulses of jogging or homing while the ramp travels so far, at most `max`; returns their number. */
uint32_t ctl_motion_move_by_hand(ctl_motion* motion, ctl_pace pace, uint32_t travelled, uint64_t max);
/* Returns a turn of an axis by the settings, 1/256 pulse. */
int64_t ctl_motion_turn(const ctl_motion* motion, uint16_t axis);
void ctl_motion_slice_measure(ctl_motion* motion, const ctl_pace* pace);
/* Begins to move to a position by hand, at the frequency of homing. */
void ctl_motion_begin_move(ctl_motion* motion, int64_t target);

#ifdef __cplusplus
}
#endif

#endif
