/* SPDX-License-Identifier: Apache-2.0 */
#include "master/ctl_master.h"

#include "engine/ctl_cam.h"

#include <stddef.h>
#include <string.h>

#define US_PER_S 1000000u
#define MS_PER_S 1000u
#define PERCENT 100u
#define FINE_BITS 8u
/* Where no time constant is set: so many counts at the program's rate. */
#define SMOOTHING_COUNTS 20u
#define MIN_SMOOTHING_US 2000u
#define MAX_SMOOTHING_US 20000u
/* The speed that the lag of the axes goes with is smoother than the tracked one. */
#define SPEED_BITS 6u
/* So much faster than its maximum it is a fault. */
#define FAULT_NUMERATOR 5u
#define FAULT_DENOMINATOR 4u
/* A slice travels so many times its ticks at most, or a whole one's: no line is faster. A short slice behind
 * others without a reading makes up for them. */
#define MAX_TRAVEL 4u
#define RATE_BITS 24u
#define HUNDREDTHS 10000
/* So many bits of the gear's fraction are dropped, so that the product stays below 2^64. */
#define SPARE_BITS 4u
/* The line disengages over a longer stretch where the master has become faster by this part. */
#define FASTER_SHARE 32u
/* Above it the gear's whole numbers are too large. */
#define MAX_DENOMINATOR (UINT64_C(1) << 42)
/* A cam's master revolutions per cycle are the product of two thousandths. */
#define RATIO_UNIT 1000000u

static uint16_t setting16(const ctl_master* master, uint32_t address)
{
    return master->board->master[address - CTL_REG_MASTER_SOURCE];
}

static uint32_t setting32(const ctl_master* master, uint32_t address)
{
    return ctl_get32(&master->board->master[address - CTL_REG_MASTER_SOURCE]);
}

static bool wants_encoder(const ctl_master* master)
{
    return setting16(master, CTL_REG_MASTER_SOURCE) == CTL_MASTER_SOURCE_ENCODER;
}

static ctl_master_input read_input(const ctl_master* master)
{
    const ctl_port* port = &master->board->port;
    ctl_master_input input = {0, 0, 0, 0};
    port->master(port->context, master->signal, &input);
    input.counts = ctl_master_signed(master, input.counts);
    input.index_at = ctl_master_signed(master, input.index_at);
    return input;
}

int64_t ctl_master_signed(const ctl_master* master, int64_t counts)
{
    return master->reversed ? -counts : counts;
}

static bool is_cutter(const ctl_bank* bank)
{
    return ctl_bank_kind(bank) == CTL_PROGRAM_KIND_ROTARY_CUTTER;
}

typedef struct {
    uint64_t numerator;
    uint64_t denominator;
} gear_ratio;

/* Ticks of the table per count: a bag of film a cycle, of a cam its master's revolutions. */
static gear_ratio ratio_of(const ctl_master* master, const ctl_bank* bank)
{
    const uint64_t cycle = ctl_bank_cycle_ticks(bank);
    const uint64_t counts = setting32(master, CTL_REG_MASTER_COUNTS);
    if (is_cutter(bank))
        return (gear_ratio){cycle * setting32(master, CTL_REG_MASTER_REVOLUTION),
                            ctl_bank_bag_um(bank) * counts};
    const uint64_t turns = (uint64_t)ctl_get32(&bank->registers[CTL_OFFSET_CAM_MASTER_RATIO]) *
                           ctl_get32(&bank->registers[CTL_OFFSET_CAM_MASTER_SCALE]);
    return (gear_ratio){cycle * RATIO_UNIT, turns < MAX_DENOMINATOR ? turns * counts : MAX_DENOMINATOR};
}

/* Somebody else drives the film. */
static bool is_wheel(const ctl_master* master, const ctl_bank* bank)
{
    return is_cutter(bank) && setting16(master, CTL_REG_MASTER_PLACE) == CTL_MASTER_PLACE_WHEEL;
}

static bool has_master(const ctl_bank* bank)
{
    return is_cutter(bank) || ctl_bank_follows_master(bank);
}

/* A cam whose master turns back by itself would never engage. */
static bool can_follow_by(gear_ratio ratio, const ctl_bank* bank)
{
    return has_master(bank) && ctl_bank_at_end(bank) == CTL_END_BEHAVIOR_REPEAT &&
           ctl_bank_direction(bank) > 0 && ratio.denominator < MAX_DENOMINATOR;
}

static bool can_follow(const ctl_master* master, const ctl_bank* bank)
{
    return can_follow_by(ratio_of(master, bank), bank);
}

void ctl_master_init(ctl_master* master, const ctl_board* board)
{
    memset(master, 0, sizeof *master);
    master->board = board;
    master->writes = board->parameter_writes - 1u;
}

/* The panel has written a parameter, perhaps one of these. A run keeps those that it began with. */
static void read_settings(ctl_master* master)
{
    const ctl_board* board = master->board;
    const bool read = master->reads;
    const bool reversed = master->reversed;
    const uint16_t signal = master->signal;
    master->writes = board->parameter_writes;
    master->reads = board->port.master != NULL && wants_encoder(master);
    master->signal = setting16(master, CTL_REG_MASTER_SIGNAL);
    master->reversed = setting16(master, CTL_REG_MASTER_REVERSED) != 0;
    master->lead_us = setting16(master, CTL_REG_MASTER_LEAD) == 0
                          ? 0u
                          : board->config.output_us + setting16(master, CTL_REG_MASTER_DELAY);
    if (master->reads == read && master->signal == signal && master->reversed == reversed)
        return;
    master->last_us = board->now_us;
    master->in_phase = false;
    master->gear.denominator = 0;
    if (!master->reads)
        return;
    const ctl_master_input input = read_input(master);
    ctl_tracker_reset(&master->tracker, input.counts, MAX_SMOOTHING_US);
    ctl_lost_reset(&master->lost, &input);
}

static void watch_ripple(ctl_master* master)
{
    ctl_ripple* ripple = &master->ripple;
    const int64_t speed = master->speed;
    ripple->most = speed > ripple->most ? speed : ripple->most;
    ripple->least = speed < ripple->least ? speed : ripple->least;
    if (master->last_us - ripple->since_us < US_PER_S)
        return;
    const int64_t sum = (ripple->most + ripple->least) / HUNDREDTHS;
    const int64_t share = sum == 0 ? 0 : (ripple->most - ripple->least) / sum;
    ripple->share = share < 0 || share > UINT16_MAX ? UINT16_MAX : (uint16_t)share;
    *ripple = (ctl_ripple){master->last_us, speed, speed, ripple->share};
}

/* Film by a wheel that passes the knife uncut. */
static void count_passed(ctl_master* master, int64_t counts)
{
    if (!master->leads || master->clutch.state == CTL_CLUTCH_OFF)
        master->passed += counts;
}

static void take(ctl_master* master)
{
    const ctl_master_input input = read_input(master);
    count_passed(master, input.counts - master->lost.last);
    const uint16_t fault = ctl_lost_watch(&master->lost, &input, setting32(master, CTL_REG_MASTER_COUNTS),
                                          setting16(master, CTL_REG_MASTER_INDEX_LIMIT));
    if (master->leads && fault != CTL_LOST_NONE)
        master->fault = fault;
    ctl_tracker_read(&master->tracker, input.counts);
}

void ctl_master_slice(ctl_master* master)
{
    const ctl_board* board = master->board;
    if (master->writes != board->parameter_writes && !master->leads)
        read_settings(master);
    if (!master->reads)
        return;
    ctl_tracker_pass(&master->tracker, (uint32_t)(board->now_us - master->last_us));
    master->last_us = board->now_us;
    if (!board->catching_up)
        take(master);
    master->speed += (master->tracker.speed - master->speed) / (1 << SPEED_BITS);
    watch_ripple(master);
}

/* Compares the counts of a microsecond as ticks of the table's, in percent of full speed. */
static bool is_too_fast(const ctl_master* master, gear_ratio ratio)
{
    const uint64_t per_count = ratio.numerator / ratio.denominator + 1u;
    const uint64_t speed = (uint64_t)(master->speed < 0 ? -master->speed : master->speed) >> FINE_BITS;
    const uint32_t above = (setting16(master, CTL_REG_MASTER_SPEED_MAX) + 1u)
                           << (CTL_TRACKER_BITS - FINE_BITS);
    const uint64_t per_percent = master->board->config.timer_clock_hz / MS_PER_S;
    return speed * per_count * PERCENT >= per_percent * ((above + MS_PER_S - 1u) / MS_PER_S);
}

uint16_t ctl_master_refusal(const ctl_master* master, const ctl_bank* bank)
{
    if (!wants_encoder(master) || !has_master(bank))
        return CTL_REFUSAL_NONE;
    const ctl_port* port = &master->board->port;
    if (port->master == NULL || (is_wheel(master, bank) && port->latch_master == NULL))
        return CTL_REFUSAL_NO_MASTER_INPUT;
    const gear_ratio ratio = ratio_of(master, bank);
    if (!can_follow_by(ratio, bank))
        return CTL_REFUSAL_CANNOT_FOLLOW_MASTER;
    return is_too_fast(master, ratio) ? CTL_REFUSAL_MASTER_TOO_FAST : CTL_REFUSAL_NONE;
}

static uint32_t smoothing_us(const ctl_master* master)
{
    const uint32_t set_us = setting16(master, CTL_REG_MASTER_SMOOTHING);
    if (set_us != 0)
        return set_us;
    const uint64_t us = (SMOOTHING_COUNTS * master->gear.fine >> CTL_GEAR_BITS) * US_PER_S /
                        master->board->config.timer_clock_hz;
    return us < MIN_SMOOTHING_US ? MIN_SMOOTHING_US : us > MAX_SMOOTHING_US ? MAX_SMOOTHING_US : (uint32_t)us;
}

static void set_gear(ctl_master* master, const ctl_bank* bank)
{
    const gear_ratio ratio = ratio_of(master, bank);
    if (ratio.numerator == master->gear.numerator && ratio.denominator == master->gear.denominator)
        return;
    ctl_gear_set(&master->gear, ratio.numerator, ratio.denominator, master->tracker.count);
    master->in_phase = false;
}

/* The ramp's full speed is the program's rate. */
static void set_rate(ctl_master* master, const ctl_ramp* ramp)
{
    const uint64_t ramp_us = ramp->full / (master->board->config.timer_clock_hz / MS_PER_S) * MS_PER_S;
    master->per_speed = ramp_us * (master->gear.fine >> SPARE_BITS) >> (CTL_GEAR_BITS - SPARE_BITS);
}

/* The master's speed, of the ramp's; one that goes back has none where the line waits for it. */
static uint32_t top_of(const ctl_master* master)
{
    if (master->speed <= 0 && !master->goes_back)
        return 0;
    const uint64_t top =
        ((uint64_t)(master->speed < 0 ? -master->speed : master->speed) >> (CTL_TRACKER_BITS - RATE_BITS)) *
            master->per_speed >>
        RATE_BITS;
    return top < UINT32_MAX ? (uint32_t)top : UINT32_MAX;
}

/* Long enough for the ramp's acceleration, which is two thirds of the curve's greatest: 1.5 v^2 / L. */
static uint32_t stretch_of(const ctl_master* master, const ctl_ramp* ramp)
{
    const uint64_t share = (uint64_t)master->cycle * setting16(master, CTL_REG_MASTER_ENGAGE) / PERCENT;
    const uint64_t top = top_of(master);
    const uint64_t ramped = 3u * top * top / (2u * (uint64_t)ramp->full);
    const uint64_t stretch = share > ramped ? share : ramped;
    return (uint32_t)(stretch < UINT32_MAX / 4u ? stretch : UINT32_MAX / 4u) | 1u;
}

static int64_t position(ctl_master* master)
{
    const uint32_t engine_us = master->lead_us == 0 ? 0u : master->engine_us;
    const ctl_tracked led = ctl_tracker_ahead(&master->tracker, master->lead_us + engine_us);
    return ctl_gear_ticks(&master->gear, led.count, led.fraction);
}

/* The shortest way of the line that meets the master in the phase that it had before. */
static ctl_clutch_curve engaging_curve(const ctl_master* master, const ctl_ramp* ramp, int64_t at)
{
    const uint32_t stretch = stretch_of(master, ramp);
    const uint32_t half = stretch / 2u;
    const bool reaches = master->cycle < INT32_MAX / 2;
    if (!master->in_phase || !reaches)
        return (ctl_clutch_curve){2u * half, half};
    const int64_t cycle = master->cycle;
    int64_t way = (master->line - at - master->clutch.offset) % cycle;
    while (way < (int64_t)half)
        way += cycle;
    return (ctl_clutch_curve){2u * (uint32_t)way, (uint32_t)way};
}

/* Sets what the gear decides. */
static void set_line(ctl_master* master, const ctl_bank* bank, const ctl_ramp* ramp)
{
    set_rate(master, ramp);
    master->cycle = ctl_bank_cycle_ticks(bank);
    master->whole_slice =
        master->board->config.timer_clock_hz / MS_PER_S * master->board->config.slice_us / MS_PER_S;
    master->tracker.constant_us = smoothing_us(master);
    master->tracker.step_us = 0;
}

void ctl_master_engage(ctl_master* master, const ctl_bank* bank, uint32_t start, ctl_ramp* ramp)
{
    master->too_fast = false;
    master->fault = CTL_LOST_NONE;
    master->leads = master->reads && can_follow(master, bank);
    if (!master->leads)
        return;
    ctl_lost_forgive(&master->lost, setting16(master, CTL_REG_MASTER_INDEX_LIMIT));
    master->engine_us = is_cutter(bank) ? 0u : CTL_CAM_UPDATE_US;
    master->goes_back = !is_cutter(bank) && setting16(master, CTL_REG_MASTER_BACKWARD) != 0;
    set_gear(master, bank);
    set_line(master, bank, ramp);
    master->line = start;
    ctl_master_settle_phase(master);
    const int64_t at = position(master);
    const ctl_clutch_curve curve = engaging_curve(master, ramp, at);
    ctl_clutch_engage(&master->clutch, at, master->line, curve);
    master->in_phase = true;
    master->wanted = master->line;
    ctl_ramp_lead(ramp, top_of(master), curve.stretch, 0);
}

uint32_t ctl_master_change(ctl_master* master, const ctl_bank* bank, ctl_ramp* ramp, uint32_t left)
{
    const gear_ratio ratio = ratio_of(master, bank);
    ctl_gear* gear = &master->gear;
    const int64_t boundary = master->line - left;
    int64_t offset = master->clutch.offset - boundary;
    if (ratio.numerator != gear->numerator || ratio.denominator != gear->denominator) {
        ctl_gear_change(gear, ratio.numerator, ratio.denominator, gear->ticks + offset);
        offset = 0;
    }
    ctl_master_keep_phase(master);
    set_line(master, bank, ramp);
    master->clutch.offset = offset;
    master->wanted = position(master) + offset;
    master->line = master->wanted > 0 ? master->wanted : 0;
    ctl_ramp_lead(ramp, top_of(master), master->clutch.on.stretch, UINT32_MAX);
    return (uint32_t)master->line;
}

/* The line's way from standstill, before or behind it. */
static uint64_t way_from_rest(const ctl_master* master)
{
    const ctl_clutch* clutch = &master->clutch;
    if (clutch->state == CTL_CLUTCH_ENGAGING)
        return master->line > clutch->line ? (uint64_t)(master->line - clutch->line) : 0u;
    if (clutch->state == CTL_CLUTCH_DISENGAGING && clutch->end > master->line)
        return (uint64_t)(clutch->end - master->line);
    return clutch->state == CTL_CLUTCH_ON ? UINT32_MAX : 0u;
}

int64_t ctl_master_ahead(ctl_master* master)
{
    return master->line - master->clutch.offset - ctl_gear_ticks(&master->gear, master->tracker.count, 0);
}

bool ctl_master_is_wheel(const ctl_master* master, const ctl_bank* bank)
{
    return master->reads && is_wheel(master, bank) && can_follow(master, bank);
}

void ctl_master_on_cut(ctl_master* master, uint32_t cut)
{
    if (!master->leads || master->clutch.state != CTL_CLUTCH_ON)
        return;
    const int64_t cycle = master->cycle;
    const int64_t at = ctl_gear_ticks(&master->gear, read_input(master).counts, 0);
    const int64_t beyond = (at + master->clutch.offset - cut) % cycle;
    const int64_t behind = beyond < 0 ? beyond + cycle : beyond;
    master->lag = behind > cycle / 2 ? behind - cycle : behind;
}

void ctl_master_shift(ctl_master* master, int64_t ticks)
{
    ctl_clutch_shift(&master->clutch, ticks);
}

/* Wires A and B are exchanged, or somebody reverses the line: it waits for a master that has gone back this
 * far.
 */
static void watch_direction(ctl_master* master, int64_t at)
{
    const ctl_clutch* clutch = &master->clutch;
    const int64_t back =
        clutch->state == CTL_CLUTCH_ENGAGING ? clutch->from - at : master->line - master->wanted;
    if (!master->goes_back && back > (int64_t)master->cycle)
        master->fault = CTL_FAULT_BIT_MASTER_BACKWARD;
}

static void watch_speed(ctl_master* master, const ctl_ramp* ramp, uint64_t travel, uint32_t ticks)
{
    const uint64_t most = (uint64_t)ramp->full * setting16(master, CTL_REG_MASTER_SPEED_MAX);
    const uint64_t top = (uint64_t)ramp->top * PERCENT;
    master->too_fast = master->too_fast || top > most;
    if (travel > MAX_TRAVEL * (uint64_t)(ticks > master->whole_slice ? ticks : master->whole_slice))
        master->fault = CTL_FAULT_BIT_MASTER_SPEED;
    else if (top * FAULT_DENOMINATOR > most * FAULT_NUMERATOR)
        master->fault = CTL_FAULT_BIT_MASTER_TOO_FAST;
}

/* The line still follows a master that has become faster since the end was chosen. */
static void end_later_when_faster(ctl_master* master, const ctl_ramp* ramp)
{
    if (!master->clutch.ends || master->clutch.state == CTL_CLUTCH_DISENGAGING ||
        ramp->top <= master->end_top + master->end_top / FASTER_SHARE)
        return;
    (void)ctl_master_disengage(master, ramp, (uint32_t)(master->clutch.end - master->line));
}

int32_t ctl_master_travel(ctl_master* master, ctl_ramp* ramp, uint32_t ticks)
{
    const int64_t at = position(master);
    ctl_master_shift_phase(master, at);
    master->wanted = ctl_clutch_follow(&master->clutch, at);
    const int64_t way = master->wanted - master->line;
    const int64_t travel = way > 0 || master->goes_back ? way : 0;
    const ctl_clutch* clutch = &master->clutch;
    const bool ends = clutch->ends && clutch->state != CTL_CLUTCH_ENGAGING;
    watch_direction(master, at);
    watch_speed(master, ramp, (uint64_t)(travel < 0 ? -travel : travel), ticks);
    if (master->fault != CTL_LOST_NONE)
        return 0;
    master->line += travel;
    end_later_when_faster(master, ramp);
    ctl_ramp_lead(ramp, top_of(master), ends ? clutch->off.stretch : clutch->on.stretch,
                  way_from_rest(master));
    if (clutch->state == CTL_CLUTCH_OFF)
        ramp->speed = 0;
    return (int32_t)travel;
}

static ctl_clutch_curve disengaging_curve(const ctl_master* master, const ctl_ramp* ramp)
{
    const uint32_t half = stretch_of(master, ramp) / 2u;
    return (ctl_clutch_curve){2u * half, half};
}

bool ctl_master_can_disengage(const ctl_master* master, const ctl_ramp* ramp, uint64_t way)
{
    const ctl_clutch_curve curve = disengaging_curve(master, ramp);
    return ctl_clutch_nearest_end(&master->clutch, master->line, curve) - master->line <= (int64_t)way;
}

uint64_t ctl_master_disengage(ctl_master* master, const ctl_ramp* ramp, uint32_t to_boundary)
{
    const ctl_clutch_curve curve = disengaging_curve(master, ramp);
    const int64_t nearest = ctl_clutch_nearest_end(&master->clutch, master->line, curve);
    int64_t end = master->line + to_boundary;
    while (end < nearest)
        end += master->cycle;
    ctl_clutch_disengage(&master->clutch, end, curve);
    master->end_top = top_of(master);
    return (uint64_t)(end - master->line);
}

uint64_t ctl_master_to_end(const ctl_master* master)
{
    const int64_t left = master->clutch.end - master->line;
    return master->clutch.state == CTL_CLUTCH_OFF || left < 0 ? 0u : (uint64_t)left;
}

void ctl_master_release(ctl_master* master, ctl_ramp* ramp)
{
    master->leads = false;
    ramp->led = false;
    ctl_clutch_open(&master->clutch, master->line);
}
