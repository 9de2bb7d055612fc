/* SPDX-License-Identifier: Apache-2.0 */
/* Film, infeed and knife of a packing machine as one line. The master drives the infeed. The film follows the
 * infeed through a gate that waits for missing products. The knife follows the film through a gate that waits
 * while a product is in its path. After the sealing window of each cut the next cut is planned: at its mark,
 * within limits, and only if no product is in the way. */
#ifndef CTL_PACKER_H
#define CTL_PACKER_H

#include "base/ctl_bank.h"
#include "base/ctl_board.h"
#include "ctl_registers.h"
#include "engine/ctl_ramp.h"
#include "packer/ctl_edges.h"
#include "packer/ctl_eye_edges.h"
#include "packer/ctl_feed.h"
#include "packer/ctl_gate.h"
#include "packer/ctl_jam.h"
#include "packer/ctl_knives.h"
#include "packer/ctl_mark_sensor.h"
#include "packer/ctl_marks.h"
#include "packer/ctl_past.h"
#include "packer/ctl_phase.h"
#include "packer/ctl_products.h"
#include "packer/ctl_wheel.h"

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_BAG_REGISTERS 4u
/* The infeed is corrected to its place within this number of cycles. */
#define CTL_INFEED_CYCLES 4u

/* All in 1/256 pulse of the film motor, at the knife. */
typedef struct {
    int64_t command; /* of the film motor at the time of the cut */
    int64_t lag;     /* expected difference of its position at the cut */
    bool tracked;    /* it follows a mark */
    bool seen;       /* the mark was seen, not estimated */
} ctl_cut;

typedef struct {
    int64_t at;      /* film position of the last cut */
    int64_t mark_at; /* and of its mark; the same without a mark */
    int64_t pitch;   /* from the previous mark to it */
    int64_t error;
    bool tracked;
    bool seen;
    bool had_products;
    bool changed;    /* the program changed since the previous cut */
    bool scrap;      /* this or the previous cut was not in register */
    bool burned;     /* at one of its ends the jaws were closed for too long, */
    bool jammed;     /* or stopped by a jam */
    bool taken;      /* a person wants it */
    uint32_t bags;   /* bag lengths since then */
    int64_t command; /* of the film motor at the time of the cut, 1/256 pulse */
    int64_t set_um;  /* set length of the previous bag */
} ctl_last_cut;

/* A bag is one of these. */
typedef enum { CTL_BAG_GOOD, CTL_BAG_EMPTY, CTL_BAG_REJECTED } ctl_bag_class;
#define CTL_BAG_CLASSES 3u

/* Lengths of the film motor, from the parameters and the program. */
typedef struct {
    uint32_t writes;   /* board->parameter_writes when they were computed, */
    uint32_t done;     /* so many pieces of it */
    uint32_t row;      /* of the table, to which the knife's pulses before the cut are summed up; */
    uint32_t ticks;    /* from there to the cut */
    int64_t clearance; /* from a product to a cut */
    ctl_mark_settings marks;
    ctl_phase_limits phase;
    int64_t cut;         /* by the operator's hand, film; */
    int64_t length;      /* added to every bag, film; */
    int64_t product;     /* of the infeed ahead of the middle of the bag, infeed */
    int64_t jaws_before; /* the cut they touch the film, pulses of the knife; */
    int64_t jaws_behind; /* and behind it, */
    int64_t jam_back;    /* and the way back after a jam */
} ctl_packer_settings;

/* Lengths of a program, from it and the parameters, as far as it needs them where it begins. They cost many
 * divisions, so that they are computed before, in pieces. */
typedef struct {
    uint32_t crc;       /* of the program; */
    uint32_t writes;    /* board->parameter_writes when they were computed, */
    uint32_t done;      /* so many pieces of them */
    uint32_t cycle;     /* ticks */
    uint32_t engage;    /* in it, */
    uint32_t release;   /* likewise, */
    uint32_t cut;       /* likewise */
    int64_t bag;        /* film; */
    int64_t way_to_cut; /* from the start of a cycle, film */
    int64_t flight;     /* infeed; */
    int64_t ahead;      /* the next product's place of the start of a cycle, infeed */
    int64_t per_tick;   /* of a wheel on the film, */
    int64_t per_film;   /* likewise */
    int64_t clearance;
    ctl_mark_settings marks;
    ctl_product_settings products;
} ctl_packer_lengths;

/* The master that drives the line. */
#define CTL_DRIVE_NO_END UINT64_MAX
typedef struct {
    const ctl_ramp* ramp;
    bool running;       /* otherwise it is stopping */
    uint64_t end_ticks; /* of the master to a boundary, CTL_DRIVE_NO_END: none; */
    uint32_t end_speed; /* it comes down to this speed there, for a stop or a change of program */
    uint32_t limit;     /* stopping, it may still gain this speed */
    bool changes;       /* the program changes at the end of its cycle */
    bool opens;         /* the knife is open for this */
} ctl_drive;

typedef struct {
    const ctl_board* board;
    const ctl_bank* bank; /* NULL: no film axis, or a program without a knife */
    bool threading;       /* the knife is open until its cut can follow a mark */
    bool broken_off;      /* jogged, homed or in fault: the next run starts a new cycle */
    bool cut_before;      /* last_cut is the one before the next */
    bool in_register;     /* a cut has followed its mark since the last loss of register */
    uint32_t cycle;       /* ticks */
    uint32_t engage;
    uint32_t release;
    uint32_t cut;
    uint32_t master; /* ticks, 0..cycle-1 */
    int64_t number;  /* of the infeed's cycle */
    ctl_gate film_gate;
    ctl_gate knife_gate;
    ctl_feed film;
    ctl_feed infeed;
    ctl_marks marks;
    ctl_mark_sensor mark_sensor;
    ctl_edges edges;
    ctl_eye_edges eye_edges;
    bool busy; /* the slice has begun a run, planned a cut or handled an edge */
    ctl_products products;
    ctl_packer_settings settings;
    ctl_packer_lengths lengths; /* of the program that begins next, or began last */
    int64_t bag;                /* bag length, film */
    int64_t flight;             /* from product to product, infeed; products lie at its multiples */
    int64_t film_sent;          /* whole pulses since power-up */
    int64_t infeed_sent;
    int64_t film_at; /* the same with the fraction at the end of the slice, 1/256 pulse */
    int64_t infeed_at;
    int64_t film_actual; /* last measured, 1/256 pulse */
    int64_t infeed_actual;
    ctl_wheel wheel;
    ctl_past film_past;
    ctl_past infeed_past;
    bool planned; /* the cut of the film's next cycle */
    bool changed; /* the program, since the last cut */
    ctl_cut next;
    uint64_t end_ticks; /* the drive's, as they are expected at the next call */
    uint32_t top;       /* another master's speed that the next cut was planned for, */
    uint32_t top_then;  /* its speed when that was planned, */
    uint32_t since;     /* and ticks since then */
    int64_t lag;        /* at full speed: film position at a cut minus the command that was meant for it */
    bool lag_known;
    ctl_phase phase;
    int64_t cut_in_film;       /* without marks: settings.cut, as far as the film was shifted for it */
    int64_t product_in_infeed; /* settings.product, as far as the infeed was */
    ctl_knives knives;
    uint16_t alarms; /* bits CTL_WARNING_BIT_... until the next start */
    ctl_last_cut last_cut;
    uint32_t skips_in_row; /* since the last cut */
    uint32_t skips_in_run; /* since that or the start of the run */
    uint16_t last_skip;
    uint32_t skipped;
    uint32_t empty;
    uint64_t saved_um;
    uint32_t bags;
    uint32_t burned;     /* cuts whose bags were, from the next one */
    uint32_t jammed;     /* the same of a jam */
    bool scrapped;       /* the bag that ends with the next cut is scrap of one by hand */
    bool takes;          /* the next bag is for a person */
    bool alone;          /* the knife has moved alone since the last run; */
    bool no_bag;         /* it cut again at the same place */
    bool spoiled_behind; /* one of both behind the last cut, so that the recorded bag is spoiled, too */
    ctl_jam jam;
    uint32_t cut_pulses; /* of the knife, from the start of its cycle */
    uint16_t records[CTL_BAG_REGISTERS * CTL_BAG_RECORDS];
    int64_t bag_film; /* between the last two cuts, 0: the knife may have cut unseen */
    bool cut_known;   /* the last cut is the newest one */
} ctl_packer;

void ctl_packer_init(ctl_packer* packer, const ctl_board* board);
/* Returns CTL_REFUSAL_..., the reason why the active program `bank` cannot be run with these parameters. */
uint16_t ctl_packer_refusal(const ctl_packer* packer, const ctl_bank* bank);
/* Prepares a run of the active program `bank`, which has this CRC-32, with this ramp: clears interrupted
 * cycles and alarms, plans the next cut for the speed of the ramp. */
void ctl_packer_run(ctl_packer* packer, const ctl_bank* bank, uint32_t crc, const ctl_ramp* ramp);
/* Returns the ticks into the cycle at which such a run begins. */
uint32_t ctl_packer_start_position(const ctl_packer* packer, const ctl_bank* bank);
void ctl_packer_break_off(ctl_packer* packer);
/* Before such a run: somebody else drives film and infeed, and `packer->wheel.counts` are their positions; or
 * nobody else does. */
void ctl_packer_take_wheel(ctl_packer* packer, const ctl_bank* bank, bool on);
/* Behind the start of such a run, and in it: the place of the line belongs so many ticks ahead of where the
 * wheel is, and the film is where the wheel is. */
void ctl_packer_join_film(ctl_packer* packer, int64_t ahead);
/* Returns the ticks by which the line is to be shifted against the wheel, because its film was corrected. */
int64_t ctl_packer_wheel_shift(ctl_packer* packer, int64_t ahead);
/* The line was shifted against the wheel by so many ticks, so that its cuts come sooner. */
void ctl_packer_shift_line(ctl_packer* packer, int64_t ticks);
/* Computes a piece of the lengths of the program that may begin next, which has this CRC-32; returns false
 * when nothing is left. */
bool ctl_packer_prepare(ctl_packer* packer, const ctl_bank* bank, uint32_t crc);
/* Returns true when a running line may take that program over as far as its lengths are concerned. */
bool ctl_packer_is_prepared(const ctl_packer* packer, uint32_t crc);
/* Continues with another program of the same machine, which became active at the boundary of a cycle, with
 * this ramp. */
void ctl_packer_change_bank(ctl_packer* packer, const ctl_bank* bank, uint32_t crc, const ctl_ramp* ramp);
bool ctl_packer_active(const ctl_packer* packer);
/* Returns true when bag or flight have another length by the present parameters. */
bool ctl_packer_has_other_lengths(const ctl_packer* packer);
/* Returns the pulses of one turn of the knife's shaft, not 0. */
uint32_t ctl_packer_revolution(const ctl_packer* packer);
/* Returns true when infeed, film and knife are in the same phase, so that a program may be changed at the
 * boundary. The knife may be open there, and must be while running if a product is under the first cut of the
 * prepared program. */
bool ctl_packer_may_change(const ctl_packer* packer, bool standstill);
/* Pulses per second of film and infeed at full speed of `bank`. */
typedef struct {
    int64_t film;
    int64_t infeed;
} ctl_line_speed;
ctl_line_speed ctl_packer_full_speed(const ctl_packer* packer, const ctl_bank* bank);
/* While running: returns true when a product is under the first cut of the prepared program, so that it may
 * take over only while the knife is open. */
bool ctl_packer_must_open(const ctl_packer* packer);
/* Returns true during a correction of the film or the infeed. */
bool ctl_packer_correcting(const ctl_packer* packer);
/* Returns the ticks since the start of the master's cycle. */
uint32_t ctl_packer_position(const ctl_packer* packer);
/* Advances the master by *ticks, at most to the end of its cycle; sets *ticks to the ticks used and returns
 * the knife's ticks. */
uint32_t ctl_packer_advance(ctl_packer* packer, const ctl_drive* drive, uint32_t* ticks);
/* Ends a slice: pulses of film and infeed, sensors, alarms. Returns true when an alarm ends the run after the
 * present cycle. */
bool ctl_packer_slice(ctl_packer* packer, bool in_cycle);

/* Handles a cut at this position of the film motor, 1/256 pulse, with the ramp of the line; NULL: the knife
 * does not follow the film. */
void ctl_packer_on_cut(ctl_packer* packer, int64_t film, const ctl_ramp* ramp);
/* Returns false when the last cut made no bag. */
bool ctl_packer_on_bag(ctl_packer* packer, uint32_t length_um);
/* The jaws were closed for too long, before a cut or behind it. */
void ctl_packer_burn(ctl_packer* packer, bool before_cut);
/* A jam stopped them there. */
void ctl_packer_spoil(ctl_packer* packer, bool before_cut);
/* Returns true when the lengths are computed that follow from parameters and program. */
bool ctl_packer_is_set(const ctl_packer* packer);
/* Returns what becomes of the bag that ended with the last cut. Rejected: a person takes it, it is longer
 * than one bag, is scrap of a start or a change of program, burned or jammed, or its cut did not follow a
 * mark although mark tracking is on. Empty: otherwise good, without a product. The reject output takes both.
 */
ctl_bag_class ctl_packer_bag_class(const ctl_packer* packer);

/* Returns CTL_REFUSAL_..., the reason why the knife cannot cut the film that stands. */
uint16_t ctl_packer_cut_refusal(const ctl_packer* packer, const ctl_bank* bank);
/* Returns true when the film's present cycle will be cut. */
bool ctl_packer_cuts_next(const ctl_packer* packer);
/* The bag that ends with the next cut is scrap of a start, */
void ctl_packer_scrap_next(ctl_packer* packer);
/* or a person takes it. */
void ctl_packer_take_next(ctl_packer* packer);
/* The knife moves without the film from now on, until a run begins. */
void ctl_packer_cut_alone(ctl_packer* packer);

/* At standstill behind ctl_packer_break_off(): film and infeed can be fed by hand. */
void ctl_packer_begin_by_hand(ctl_packer* packer, const ctl_bank* bank, uint32_t crc);
/* Feeds one of them by so much in this slice, 1/256 pulse. */
void ctl_packer_feed_by_hand(ctl_packer* packer, ctl_axis axis, int64_t way);

/* Starts to measure the distances of `marks` marks; returns CTL_REFUSAL_... */
uint16_t ctl_packer_teach(ctl_packer* packer, const ctl_bank* bank, uint16_t marks);
/* Returns the set length of the last measured bag of a program with bags of `bag_um`. */
int64_t ctl_packer_set_um(const ctl_packer* packer, uint32_t bag_um);
/* Converts lengths on the film to micrometers, and back. */
int64_t ctl_packer_um(const ctl_packer* packer, int64_t film);
int64_t ctl_packer_film(const ctl_packer* packer, int64_t um);
/* Writes the registers of the group `packer`. */
void ctl_packer_registers(const ctl_packer* packer, uint16_t* registers);

/* Between the files of this module. */
/* A cut with the film here, before it is the last one. */
void ctl_packer_note_bag(ctl_packer* packer, int64_t film);
/* The knife has cut alone, with the film here. */
void ctl_packer_on_cut_alone(ctl_packer* packer, int64_t film);
/* Film and infeed are where their motors are. */
void ctl_packer_take_positions(ctl_packer* packer);
/* The next cut is not at its mark, and after another bag length than `bag_before` its mark is not known. */
void ctl_packer_leave_register(ctl_packer* packer, int64_t bag_before);
/* The film that somebody else drives goes on, perhaps with other bags. */
void ctl_packer_go_on_with_wheel(ctl_packer* packer, const ctl_bank* bank);
bool ctl_packer_tracks(const ctl_packer* packer);
/* Returns true when the line runs with this program. */
bool ctl_packer_drives(const ctl_packer* packer, const ctl_bank* bank);
/* Returns the ticks from the start of the cycle to the angle at this offset of the bank. */
uint32_t ctl_packer_ticks_at(const ctl_bank* bank, uint32_t offset);
/* Returns the longer dead time of the eye's edges. */
uint32_t ctl_packer_eye_dead_us(const ctl_packer* packer);
/* Computes the settings that a start needs at once from the parameters and the program; */
void ctl_packer_read_settings(ctl_packer* packer);
/* or takes them from its lengths. */
void ctl_packer_take_settings(ctl_packer* packer);
/* Does a piece of the rest, or of everything when the panel has written a parameter; returns false when
 * nothing is left. */
bool ctl_packer_refresh_settings(ctl_packer* packer);
/* Reads mark sensor and eye at the end of a slice. */
void ctl_packer_read_sensors(ctl_packer* packer);
/* Asks about the first cut at the start of the film's cycle, when the knife is open. */
void ctl_packer_ask_first_cut(ctl_packer* packer);
void ctl_packer_raise(ctl_packer* packer, uint32_t warning_bit);
/* Returns the command of the film motor at the next cut when nothing is corrected; asked behind a sealing
 * window or, with the knife standing, up to a cycle before the window. */
int64_t ctl_packer_uncorrected(const ctl_packer* packer);
/* Behind a sealing window: plans where the film's next cut is to be, and the correction that brings it there.
 */
void ctl_packer_plan_cut(ctl_packer* packer, const ctl_drive* drive);
/* The planned cut meets its mark at another speed, and so with another lag: a stop or a change of program was
 * decided on, or is no longer. Leaves it as it is where the way to its sealing window is short. */
void ctl_packer_plan_again(ctl_packer* packer, const ctl_drive* drive);
/* Returns true when the next cut can be planned again for another speed, which it is in the next slice then.
 */
bool ctl_packer_takes_other_speed(ctl_packer* packer);
/* Returns true when another master that leads has another speed than when the next cut was planned. */
bool ctl_packer_sees_other_speed(const ctl_packer* packer, const ctl_ramp* ramp);
/* Returns the lag of the film at a cut at this speed of the ramp. */
int64_t ctl_packer_lag(const ctl_packer* packer, uint32_t speed, const ctl_ramp* ramp);
/* Starts or stops mark tracking according to the present parameters. */
void ctl_packer_follow_marks(ctl_packer* packer);
/* Returns the maximum correction of a bag's film. */
int64_t ctl_packer_length_limit(const ctl_packer* packer);
/* Returns the set length of a bag, with what the operator's hand adds. */
int64_t ctl_packer_bag_um(const ctl_packer* packer);
/* Compute the settings of the operator's trims, in this order. */
void ctl_packer_read_cut_trim(ctl_packer* packer);
void ctl_packer_read_length_trim(ctl_packer* packer);
void ctl_packer_read_product_trim(ctl_packer* packer);
/* Behind a sealing window: moves the next cut toward its trim, and its mark with it; returns by how much it
 * comes later than it would. */
int64_t ctl_packer_move_cut(ctl_packer* packer);
/* Returns how far the trims may shift the next cut. */
int64_t ctl_packer_next_move(const ctl_packer* packer);
/* At the start of the master's cycle: moves the infeed toward the trim of the product. */
void ctl_packer_move_products(ctl_packer* packer);

#ifdef __cplusplus
}
#endif

#endif
