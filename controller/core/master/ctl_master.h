/* SPDX-License-Identifier: Apache-2.0 */
/* An encoder as the master of a line: its counts become the ticks that a slice of the line's table travels,
 * in place of a ramp's, and the ramp's speed follows the measured one. A cutter's line never goes back: where
 * the encoder does, it waits until the encoder has come back. A cam goes back along its curve. */
#ifndef CTL_MASTER_H
#define CTL_MASTER_H

#include "base/ctl_bank.h"
#include "base/ctl_board.h"
#include "engine/ctl_ramp.h"
#include "master/ctl_clutch.h"
#include "master/ctl_gear.h"
#include "master/ctl_lost.h"
#include "master/ctl_tracker.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Maximum and minimum of the smoothed speed, in the present second and as a figure of the last one. */
typedef struct {
    uint64_t since_us;
    int64_t most;
    int64_t least;
    uint16_t share; /* half of their difference, 0.01 % of their mean */
} ctl_ripple;

/* The shift of the line ahead of its master, superimposed while it is engaged. */
typedef struct {
    int32_t set;     /* 0.01 degrees: where it is, or goes */
    int64_t from;    /* ticks of the master: there it began, */
    int64_t stretch; /* and takes so long */
    int64_t way;     /* ticks, */
    int64_t done;    /* and how much of it is done */
    int64_t moved;   /* since it was last asked for */
} ctl_master_phase;

typedef struct {
    const ctl_board* board;
    uint32_t writes; /* board->parameter_writes when the settings were read */
    bool reads;      /* the encoder is the source, and the board has an input for it */
    bool leads;      /* a run follows it */
    bool too_fast;   /* it has ended the run; until the next start */
    uint16_t fault;  /* CTL_FAULT_BIT_..., what has ended the run, or CTL_LOST_NONE */
    bool in_phase;   /* the line has engaged with this gear before */
    bool reversed;
    uint16_t signal;
    uint64_t last_us;
    int64_t speed;        /* smoothed, counts per microsecond, 1 / 2^32 */
    uint32_t lead_us;     /* from a count to the movement, */
    uint32_t engine_us;   /* and what the table's engine needs */
    bool goes_back;       /* with the encoder, otherwise the line waits */
    uint64_t per_speed;   /* of the ramp at full speed, per 1 / 2^24 count per microsecond, 1 / 2^24 */
    uint32_t cycle;       /* ticks of the table that engaged last */
    uint32_t whole_slice; /* ticks of the longest slice */
    uint32_t end_top;     /* ramp speed of the master when the end of the run was chosen */
    int64_t line;         /* ticks since the start of the cycle in which it engaged, */
    int64_t wanted;       /* and where the encoder wants it */
    int64_t passed;       /* counts while no run followed */
    int64_t lag;          /* ticks by which the master was beyond the last cut when the knife came to it */
    ctl_ripple ripple;
    ctl_tracker tracker;
    ctl_gear gear;
    ctl_clutch clutch;
    ctl_lost lost;
    ctl_master_phase phase;
} ctl_master;

void ctl_master_init(ctl_master* master, const ctl_board* board);
/* At the start of each slice: reads the counts. */
void ctl_master_slice(ctl_master* master);
/* Returns CTL_REFUSAL_..., the reason why a run of `bank` cannot begin. */
uint16_t ctl_master_refusal(const ctl_master* master, const ctl_bank* bank);
/* A run of `bank` begins `start` ticks into its cycle, with this ramp at standstill: where the encoder is the
 * source, it leads the ramp. */
void ctl_master_engage(ctl_master* master, const ctl_bank* bank, uint32_t start, ctl_ramp* ramp);
/* At a boundary, `left` ticks of this slice's travel behind it, the line goes on by `bank`, whose ramp
 * stands: nothing of the master's way is lost. Returns the ticks that are left of the travel. */
uint32_t ctl_master_change(ctl_master* master, const ctl_bank* bank, ctl_ramp* ramp, uint32_t left);
/* Returns the ticks that the line travels in this slice of `ticks`; negative: back. */
int32_t ctl_master_travel(ctl_master* master, ctl_ramp* ramp, uint32_t ticks);
/* Begins to disengage, `to_boundary` ticks being left of the cycle; returns the ticks to the boundary at
 * which the line comes to rest. */
uint64_t ctl_master_disengage(ctl_master* master, const ctl_ramp* ramp, uint32_t to_boundary);
/* Returns true when it can come to rest within so many ticks. */
bool ctl_master_can_disengage(const ctl_master* master, const ctl_ramp* ramp, uint64_t way);
/* Returns what is left of them. */
uint64_t ctl_master_to_end(const ctl_master* master);
/* Disengages at once: the ramp goes on by itself from its present speed. */
void ctl_master_release(ctl_master* master, ctl_ramp* ramp);
/* Returns true where a run of `bank` follows a wheel on film that somebody else drives. */
bool ctl_master_is_wheel(const ctl_master* master, const ctl_bank* bank);
/* Returns the ticks by which the phase was shifted since the last call. */
int64_t ctl_master_take_shift(ctl_master* master);
/* A knife has come to its cut, which is at `cut` ticks of the cycle. */
void ctl_master_on_cut(ctl_master* master, uint32_t cut);
/* Returns the ticks of the master from here to where the line's present place belongs. */
int64_t ctl_master_ahead(ctl_master* master);
/* A wheel on the film: the line is shifted against it by so many ticks. */
void ctl_master_shift(ctl_master* master, int64_t ticks);
/* Returns counts of its input with the sign of the line's direction. */
int64_t ctl_master_signed(const ctl_master* master, int64_t counts);
/* Writes the registers of the group `master_status`. */
void ctl_master_registers(const ctl_master* master, uint16_t* registers);

/* Between the files of this module. */
/* At standstill the phase is set at once: the stretch of the clutch takes it up. */
void ctl_master_settle_phase(ctl_master* master);
/* The rest of a shift begins anew, as the next cycle has another length. */
void ctl_master_keep_phase(ctl_master* master);
/* Superimposes what the phase gains up to this tick; the master may go back meanwhile. */
void ctl_master_shift_phase(ctl_master* master, int64_t at);

#ifdef __cplusplus
}
#endif

#endif
