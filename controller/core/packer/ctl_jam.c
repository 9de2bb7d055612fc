/* SPDX-License-Identifier: Apache-2.0 */
#include "packer/ctl_jam.h"

#include "base/ctl_words.h"

#include <string.h>

#define FINE_BITS 4u
/* So many average spreads belong to the band. */
#define SPREADS 4
/* Two reports are beyond the band, and no less than this time. */
#define BEYOND_US 1000u
/* A report is late by one interval, and the next two show a jam. */
#define INTERVALS_TO_SEE 3u
#define SEEN_WITHIN_US 4000u
/* Parts are learned quickly at first. */
#define QUICK_CYCLES 6u
#define QUICK_BITS 1u
#define SLOW_BITS 3u
#define ARMED_BITS 6u
#define RESIDUE_BAGS 1000
#define RESIDUE_STEP ((RESIDUE_BAGS << FINE_BITS) / 10) /* 0.01 % in the sum over so many bags */
#define INTERVAL_US 10u                                 /* of the register */
#define FULL_CIRCLE 36000
#define SCALE_BITS 24u
#define SLOW_SHARE (CTL_JAM_FULL_SPEED / 4u * 3u)

_Static_assert(CTL_REG_JAM_WIDTH - CTL_REG_JAM_EXPECTED == CTL_JAM_BINS, "the registers of the band follow");
_Static_assert(CTL_REG_JAM_WIDTH + CTL_JAM_BINS - CTL_REG_JAM_STATE == CTL_GROUP_JAM, "and end the group");

void ctl_jam_forget(ctl_jam* jam)
{
    jam->cycles = 0;
    jam->even = false;
    jam->count = 0;
    jam->inside = false;
    jam->learning = CTL_JAM_BINS;
    jam->beyond = false;
    jam->has_changed = false;
    jam->interval_us = 0;
    jam->residue_sum = 0;
    jam->residue_bags = 0;
}

void ctl_jam_set(ctl_jam* jam, const ctl_jam_settings* settings)
{
    const ctl_jam_settings* now = &jam->settings;
    if (settings->on != now->on || settings->from != now->from || settings->to != now->to)
        ctl_jam_forget(jam);
    jam->settings = *settings;
    const uint32_t pulses = (uint32_t)(settings->to - settings->from);
    jam->settings.scale = pulses == 0 ? 0u : ((uint32_t)CTL_JAM_BINS << SCALE_BITS) / pulses;
}

static uint32_t part_at(const ctl_jam* jam, int32_t from_cut)
{
    return (uint32_t)(from_cut - jam->settings.from) * jam->settings.scale >> SCALE_BITS;
}

/* A drive that reports always the same has no interval. */
static void take_report(ctl_jam* jam, const ctl_jam_slice* slice)
{
    const bool missed = jam->missed;
    jam->missed = false;
    if (slice->torque == jam->report)
        return;
    const uint32_t interval = slice->now_us - jam->report_us;
    if (jam->has_changed && (jam->interval_us == 0 || interval < jam->interval_us))
        jam->interval_us = interval;
    jam->has_changed = !missed;
    jam->report = slice->torque;
    jam->report_us = slice->now_us;
}

static void begin_cycle(ctl_jam* jam, const ctl_jam_slice* slice)
{
    if (jam->even && jam->count != 0) {
        jam->friction = jam->sum * (1 << FINE_BITS) / (int32_t)jam->count;
        if (jam->cycles < CTL_JAM_CYCLES) {
            jam->cycles += 1;
            jam->first = jam->parts[part_at(jam, 0)].mean;
        }
    }
    jam->cycle = slice->cycle;
    jam->even = true;
    jam->inside = false;
    jam->sum = 0;
    jam->count = 0;
}

static int32_t approach(int32_t value, int32_t target, uint32_t bits)
{
    return value + (target - value) / (int32_t)(1u << bits);
}

static void add_residue(ctl_jam* jam, int32_t torque)
{
    jam->residue_sum += torque - jam->first;
    jam->residue_bags += 1;
    if (jam->residue_bags < RESIDUE_BAGS)
        return;
    jam->residue = (int16_t)ctl_saturated16(jam->residue_sum / RESIDUE_STEP);
    jam->residue_number += 1;
    jam->residue_sum = 0;
    jam->residue_bags = 0;
}

static void learn(ctl_jam* jam, ctl_jam_part* part)
{
    const int32_t middle = (part->lowest + part->highest) / 2;
    const int32_t above = part->highest - part->mean;
    const int32_t below = part->mean - part->lowest;
    const uint32_t learning = jam->cycles < QUICK_CYCLES ? QUICK_BITS : SLOW_BITS;
    const uint32_t bits = jam->cycles < CTL_JAM_CYCLES ? learning : ARMED_BITS;
    if (part->learned) {
        part->spread = approach(part->spread, above > below ? above : below, bits);
        part->mean = approach(part->mean, middle, bits);
        return;
    }
    part->mean = middle;
    part->spread = (part->highest - part->lowest) / 2;
    part->learned = true;
}

/* Behind a passage in an even cycle: one part in each slice. The first passage of a program is the first to
 * learn anything. */
static void learn_next(ctl_jam* jam)
{
    ctl_jam_part* part = &jam->parts[jam->learning];
    if (jam->cycles == 1u)
        part->learned = false;
    if (!part->learned)
        part->mean = part->spread = 0;
    if (part->passed && jam->cycles == CTL_JAM_CYCLES && jam->learning == part_at(jam, 0))
        add_residue(jam, (part->lowest + part->highest) / 2);
    if (part->passed)
        learn(jam, part);
    part->passed = false;
    const int32_t end = part->mean + SPREADS * part->spread;
    jam->next_widest = jam->learning == 0 || end > jam->next_widest ? end : jam->next_widest;
    jam->learning += 1;
    if (jam->learning == CTL_JAM_BINS)
        jam->widest = jam->next_widest;
}

static void pass_part(const ctl_jam* jam, ctl_jam_part* part, const ctl_jam_slice* slice)
{
    const int32_t torque = slice->torque * (1 << FINE_BITS) - jam->friction;
    part->lowest = part->passed && part->lowest < torque ? part->lowest : torque;
    part->highest = part->passed && part->highest > torque ? part->highest : torque;
    part->passed = true;
}

/* The times of five degrees and of a part at full speed, as the knife has passed its closing range. */
static void measure_passage(ctl_jam* jam, uint32_t now_us)
{
    const uint32_t pulses = (uint32_t)(jam->settings.to - jam->settings.from);
    const uint32_t passage_us = now_us - jam->entered_us;
    const uint32_t five_us = (passage_us >> FINE_BITS) * (uint32_t)jam->settings.five / pulses << FINE_BITS;
    jam->allowed_us = five_us > SEEN_WITHIN_US ? five_us : SEEN_WITHIN_US;
    jam->reach = 1u + jam->interval_us / (passage_us / CTL_JAM_BINS + 1u);
}

static void enter_range(ctl_jam* jam, uint32_t now_us)
{
    for (uint32_t i = 0; i < CTL_JAM_BINS; ++i)
        jam->parts[i].passed = false;
    jam->learning = CTL_JAM_BINS;
    jam->entered_us = now_us;
    jam->inside = true;
}

/* In an even cycle whose friction is known the passage is worth learning. */
static void leave_range(ctl_jam* jam, uint32_t now_us)
{
    if (jam->even)
        measure_passage(jam, now_us);
    if (jam->even && jam->cycles != 0)
        jam->learning = 0;
    jam->inside = false;
    jam->beyond = false;
}

uint16_t ctl_jam_state(const ctl_jam* jam)
{
    if (!jam->settings.on)
        return CTL_JAM_STATE_OFF;
    if (!jam->settings.reports || (jam->cycles == CTL_JAM_CYCLES && jam->interval_us == 0))
        return CTL_JAM_STATE_NOT_REPORTED;
    if (jam->cycles < CTL_JAM_CYCLES)
        return CTL_JAM_STATE_LEARNING;
    return INTERVALS_TO_SEE * jam->interval_us > jam->allowed_us ? CTL_JAM_STATE_TOO_SLOW
                                                                 : CTL_JAM_STATE_ARMED;
}

static int32_t scaled(int32_t value, uint32_t share)
{
    return (int32_t)((int64_t)value * share >> CTL_JAM_SHARE_BITS);
}

/* Returns the end of the band at this speed. The torque of a seal, where the knife is not accelerated, does
 * not become less with the speed. */
static int32_t end_of(const ctl_jam_part* part, uint32_t share)
{
    const int32_t slower = scaled(scaled(part->mean, share), share);
    return (slower > part->mean ? slower : part->mean) + SPREADS * part->spread;
}

/* Returns the largest of the parts that a report may belong to. Much slower than it was learned, a late one
 * belongs to another part: anything that is usual in one of them is then usual in all. */
static int32_t end_around(const ctl_jam* jam, uint32_t part, uint32_t share)
{
    if (share < SLOW_SHARE)
        return jam->widest;
    const uint32_t last = part + jam->reach < CTL_JAM_BINS ? part + jam->reach : CTL_JAM_BINS - 1u;
    int32_t largest = end_of(&jam->parts[part], share);
    for (uint32_t i = part > jam->reach ? part - jam->reach : 0u; i <= last; ++i) {
        const int32_t end = end_of(&jam->parts[i], share);
        largest = end > largest ? end : largest;
    }
    return largest;
}

/* A master that speeds up needs some torque itself. */
static int32_t limit_of(const ctl_jam* jam, uint32_t part, uint32_t share)
{
    const int32_t margin = jam->settings.margin * (jam->in_ramp.is_near ? 2 : 1);
    return jam->friction + end_around(jam, part, share) + margin * (1 << FINE_BITS);
}

static bool see(ctl_jam* jam, const ctl_jam_slice* slice, uint16_t source, uint32_t part)
{
    jam->number += 1u;
    jam->last = (ctl_jam_event){.source = source,
                                .at = slice->from_cut,
                                .torque = slice->torque,
                                .limit = limit_of(jam, part, slice->share) / (1 << FINE_BITS)};
    jam->beyond = false;
    jam->even = false;
    return true;
}

/* Most slices are within what is usual at their angle alone, which costs less to know. */
static bool is_beyond(const ctl_jam* jam, const ctl_jam_slice* slice, uint32_t part)
{
    const int32_t torque = slice->torque * (1 << FINE_BITS);
    const int32_t least = jam->friction + jam->parts[part].mean + jam->settings.margin * (1 << FINE_BITS);
    return torque > least && torque > limit_of(jam, part, slice->share) && !jam->out_of_phase.is_near &&
           ctl_jam_state(jam) == CTL_JAM_STATE_ARMED;
}

static bool is_jam(ctl_jam* jam, const ctl_jam_slice* slice)
{
    const uint32_t part = part_at(jam, slice->from_cut);
    pass_part(jam, &jam->parts[part], slice);
    if (slice->from_cut < jam->settings.from + jam->settings.five ||
        slice->from_cut >= jam->settings.to - jam->settings.five)
        return false;
    if (slice->limited)
        return see(jam, slice, CTL_JAM_SOURCE_TORQUE_LIMIT, part);
    if (!is_beyond(jam, slice, part)) {
        jam->beyond = false;
        return false;
    }
    if (!jam->beyond)
        jam->beyond_us = slice->now_us;
    jam->beyond = true;
    jam->even = false;
    const uint32_t interval = jam->interval_us + jam->interval_us / 4u;
    const uint32_t wait_us = interval > BEYOND_US ? interval : BEYOND_US;
    return slice->now_us - jam->beyond_us >= wait_us && see(jam, slice, CTL_JAM_SOURCE_TORQUE, part);
}

/* Reports of this may still come when it is over. */
static void note(ctl_jam_time* time, bool now, const ctl_jam* jam, const ctl_jam_slice* slice)
{
    if (!now && !time->is_near)
        return;
    if (now)
        time->us = slice->now_us;
    time->is_near = slice->now_us - time->us <= INTERVALS_TO_SEE * jam->interval_us;
}

bool ctl_jam_watch(ctl_jam* jam, const ctl_jam_slice* slice)
{
    if (slice->cycle != jam->cycle)
        begin_cycle(jam, slice);
    take_report(jam, slice);
    jam->even = jam->even && slice->in_phase && slice->share == CTL_JAM_FULL_SPEED;
    jam->sum += slice->torque;
    jam->count += 1;
    note(&jam->out_of_phase, !slice->in_phase, jam, slice);
    note(&jam->in_ramp, slice->share != CTL_JAM_FULL_SPEED, jam, slice);
    const bool inside = slice->from_cut >= jam->settings.from && slice->from_cut < jam->settings.to;
    if (inside && !jam->inside)
        enter_range(jam, slice->now_us);
    else if (!inside && jam->inside)
        leave_range(jam, slice->now_us);
    if (inside)
        return is_jam(jam, slice);
    if (jam->learning != CTL_JAM_BINS)
        learn_next(jam);
    return false;
}

void ctl_jam_miss(ctl_jam* jam)
{
    jam->has_changed = false;
    jam->missed = true;
}

void ctl_jam_run_on(ctl_jam* jam, int32_t from_cut)
{
    ctl_jam_event* last = &jam->last;
    if (from_cut - last->at > last->run_on)
        last->run_on = from_cut - last->at;
}

static uint16_t angle_of(int32_t pulses, uint32_t revolution)
{
    return ctl_saturated16((int64_t)pulses * FULL_CIRCLE / (int64_t)revolution);
}

static uint16_t tenths(int32_t fine)
{
    return ctl_saturated16(fine / (1 << FINE_BITS));
}

static void put(uint16_t* registers, uint32_t address, uint16_t value)
{
    registers[address - CTL_REG_JAM_STATE] = value;
}

void ctl_jam_registers(const ctl_jam* jam, uint32_t revolution, uint16_t* registers)
{
    const ctl_jam_event* last = &jam->last;
    memset(registers, 0, CTL_GROUP_JAM * sizeof registers[0]);
    put(registers, CTL_REG_JAM_STATE, ctl_jam_state(jam));
    put(registers, CTL_REG_JAM_CYCLES_LEFT, (uint16_t)(CTL_JAM_CYCLES - jam->cycles));
    put(registers, CTL_REG_JAM_INTERVAL, ctl_saturated16(jam->interval_us / INTERVAL_US));
    put(registers, CTL_REG_JAM_NUMBER, jam->number);
    put(registers, CTL_REG_JAM_SOURCE, last->source);
    put(registers, CTL_REG_JAM_ANGLE, angle_of(last->at, revolution));
    put(registers, CTL_REG_JAM_TORQUE, ctl_saturated16(last->torque));
    put(registers, CTL_REG_JAM_LIMIT, ctl_saturated16(last->limit));
    put(registers, CTL_REG_JAM_RUN_ON, angle_of(last->run_on, revolution));
    ctl_put32(&registers[CTL_REG_JAM_RESIDUE_NUMBER - CTL_REG_JAM_STATE], jam->residue_number);
    put(registers, CTL_REG_JAM_RESIDUE, (uint16_t)jam->residue);
    put(registers, CTL_REG_JAM_BAND_FROM, angle_of(jam->settings.from, revolution));
    put(registers, CTL_REG_JAM_BAND_TO, angle_of(jam->settings.to, revolution));
    for (uint32_t i = 0; i < CTL_JAM_BINS; ++i) {
        const ctl_jam_part* part = &jam->parts[i];
        put(registers, CTL_REG_JAM_EXPECTED + i, tenths(jam->friction + part->mean));
        put(registers, CTL_REG_JAM_WIDTH + i,
            part->learned && jam->cycles > 1u
                ? tenths(limit_of(jam, i, CTL_JAM_FULL_SPEED) - jam->friction - part->mean)
                : 0);
    }
}
