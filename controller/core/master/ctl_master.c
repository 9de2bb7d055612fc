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
/* A slice travels so many times its ticks at most: no line is faster. */
#define MAX_TRAVEL 4u
#define RATE_BITS 24u
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

static int64_t read_counts(const ctl_master* master)
{
    const ctl_port* port = &master->board->port;
    const int64_t counts = port->master(port->context, master->signal);
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

static bool has_master(const ctl_bank* bank)
{
    return is_cutter(bank) || ctl_bank_follows_master(bank);
}

/* A cam whose master turns back by itself would never engage. */
static bool can_follow(const ctl_master* master, const ctl_bank* bank)
{
    return has_master(bank) && ctl_bank_at_end(bank) == CTL_END_BEHAVIOR_REPEAT &&
           ctl_bank_direction(bank) > 0 && ratio_of(master, bank).denominator < MAX_DENOMINATOR;
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
    if (master->reads)
        ctl_tracker_reset(&master->tracker, read_counts(master), MAX_SMOOTHING_US);
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
        ctl_tracker_read(&master->tracker, read_counts(master));
    master->speed += (master->tracker.speed - master->speed) / (1 << SPEED_BITS);
}

/* Film that passes at `speed`, um per second. */
static int64_t um_per_s(const ctl_master* master, int64_t speed)
{
    const int64_t counts_per_s = speed / (1 << 8) * US_PER_S / (1 << (RATE_BITS - 8u)); /* 1 / 2^8 */
    return counts_per_s * setting32(master, CTL_REG_MASTER_REVOLUTION) /
           (int64_t)((uint64_t)setting32(master, CTL_REG_MASTER_COUNTS) << 8u);
}

/* The counts of a microsecond as ticks of the table's, in percent of full speed. */
static bool is_too_fast(const ctl_master* master, const ctl_bank* bank)
{
    const gear_ratio ratio = ratio_of(master, bank);
    const uint64_t per_count = ratio.numerator / ratio.denominator + 1u;
    const uint64_t speed = (uint64_t)(master->speed < 0 ? -master->speed : master->speed) >> FINE_BITS;
    const uint64_t percent = speed * per_count * PERCENT / (master->board->config.timer_clock_hz / MS_PER_S);
    return percent * MS_PER_S >> (CTL_TRACKER_BITS - FINE_BITS) > setting16(master, CTL_REG_MASTER_SPEED_MAX);
}

uint16_t ctl_master_refusal(const ctl_master* master, const ctl_bank* bank)
{
    if (!wants_encoder(master) || !has_master(bank))
        return CTL_REFUSAL_NONE;
    if (master->board->port.master == NULL)
        return CTL_REFUSAL_NO_MASTER_INPUT;
    if (!can_follow(master, bank))
        return CTL_REFUSAL_CANNOT_FOLLOW_MASTER;
    return is_too_fast(master, bank) ? CTL_REFUSAL_MASTER_TOO_FAST : CTL_REFUSAL_NONE;
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
    const uint64_t clock_khz = master->board->config.timer_clock_hz / MS_PER_S;
    const uint64_t rate = (ramp->full * master->gear.fine >> CTL_GEAR_BITS) / clock_khz * MS_PER_S;
    master->per_speed = rate < UINT32_MAX ? (uint32_t)rate : UINT32_MAX;
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
    int64_t way = (master->line - at - master->offset) % cycle;
    while (way < (int64_t)half)
        way += cycle;
    return (ctl_clutch_curve){2u * (uint32_t)way, (uint32_t)way};
}

void ctl_master_engage(ctl_master* master, const ctl_bank* bank, uint32_t start, ctl_ramp* ramp)
{
    master->too_fast = false;
    master->fails = false;
    master->leads = master->reads && can_follow(master, bank);
    if (!master->leads)
        return;
    master->engine_us = is_cutter(bank) ? 0u : CTL_CAM_UPDATE_US;
    master->goes_back = !is_cutter(bank) && setting16(master, CTL_REG_MASTER_BACKWARD) != 0;
    set_gear(master, bank);
    set_rate(master, ramp);
    master->cycle = ctl_bank_cycle_ticks(bank);
    master->line = start;
    master->tracker.constant_us = smoothing_us(master);
    master->tracker.step_us = 0;
    const int64_t at = position(master);
    const ctl_clutch_curve curve = engaging_curve(master, ramp, at);
    ctl_clutch_engage(&master->clutch, at, master->line, curve);
    master->offset = master->clutch.offset;
    master->in_phase = true;
    master->wanted = master->line;
    ctl_ramp_lead(ramp, top_of(master), curve.stretch, 0);
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

static void watch_speed(ctl_master* master, const ctl_ramp* ramp, uint64_t travel, uint32_t ticks)
{
    const uint64_t most = (uint64_t)ramp->full * setting16(master, CTL_REG_MASTER_SPEED_MAX);
    const uint64_t top = (uint64_t)ramp->top * PERCENT;
    master->too_fast = master->too_fast || top > most;
    master->fails = top * FAULT_DENOMINATOR > most * FAULT_NUMERATOR || travel > MAX_TRAVEL * (uint64_t)ticks;
}

int32_t ctl_master_travel(ctl_master* master, ctl_ramp* ramp, uint32_t ticks)
{
    master->wanted = ctl_clutch_follow(&master->clutch, position(master));
    const int64_t way = master->wanted - master->line;
    const int64_t travel = way > 0 || master->goes_back ? way : 0;
    const ctl_clutch* clutch = &master->clutch;
    const bool ends = clutch->ends && clutch->state != CTL_CLUTCH_ENGAGING;
    watch_speed(master, ramp, (uint64_t)(travel < 0 ? -travel : travel), ticks);
    if (master->fails)
        return 0;
    master->line += travel;
    ctl_ramp_lead(ramp, top_of(master), ends ? clutch->off.stretch : clutch->on.stretch,
                  way_from_rest(master));
    if (clutch->state == CTL_CLUTCH_OFF)
        ramp->speed = 0;
    return (int32_t)travel;
}

uint64_t ctl_master_disengage(ctl_master* master, const ctl_ramp* ramp, uint32_t to_boundary)
{
    const uint32_t half = stretch_of(master, ramp) / 2u;
    const ctl_clutch_curve curve = {2u * half, half};
    const int64_t nearest = ctl_clutch_nearest_end(&master->clutch, master->line, curve);
    int64_t end = master->line + to_boundary;
    while (end < nearest)
        end += master->cycle;
    ctl_clutch_disengage(&master->clutch, end, curve);
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

static int64_t um_of_ticks(const ctl_master* master, int64_t ticks)
{
    const uint64_t per_count = master->gear.fine;
    if (master->gear.denominator == 0 || per_count == 0)
        return 0;
    return (ticks << CTL_GEAR_BITS) / (int64_t)per_count * setting32(master, CTL_REG_MASTER_REVOLUTION) /
           setting32(master, CTL_REG_MASTER_COUNTS);
}

static uint16_t state_of(const ctl_master* master)
{
    if (!master->leads)
        return CTL_MASTER_STATE_OFF;
    switch (master->clutch.state) {
    case CTL_CLUTCH_ENGAGING:
        return CTL_MASTER_STATE_ENGAGING;
    case CTL_CLUTCH_ON:
        return CTL_MASTER_STATE_ENGAGED;
    case CTL_CLUTCH_DISENGAGING:
        return CTL_MASTER_STATE_DISENGAGING;
    default:
        return CTL_MASTER_STATE_OFF;
    }
}

static void put(uint16_t* registers, uint32_t address, uint16_t value)
{
    registers[address - CTL_REG_MASTER_STATUS_AVAILABLE] = value;
}

static void put_wide(uint16_t* registers, uint32_t address, int64_t value)
{
    ctl_put32(&registers[address - CTL_REG_MASTER_STATUS_AVAILABLE],
              (uint32_t)((uint64_t)value & UINT32_MAX));
}

/* Returns what the line still has to go while it engages. */
static int64_t ticks_to_engaged(const ctl_master* master)
{
    const ctl_clutch* clutch = &master->clutch;
    const bool engages = state_of(master) == CTL_MASTER_STATE_ENGAGING;
    return engages ? clutch->line + clutch->on.way - master->line : 0;
}

void ctl_master_registers(const ctl_master* master, uint16_t* registers)
{
    memset(registers, 0, CTL_GROUP_MASTER_STATUS * sizeof registers[0]);
    put(registers, CTL_REG_MASTER_STATUS_AVAILABLE, master->board->port.master != NULL ? 1u : 0u);
    if (!master->reads)
        return;
    const int64_t counts = setting32(master, CTL_REG_MASTER_COUNTS);
    const int64_t revolution_um = setting32(master, CTL_REG_MASTER_REVOLUTION);
    const int64_t speed_um = um_per_s(master, master->speed);
    const int64_t angle = (master->tracker.count % counts + counts) % counts;
    put(registers, CTL_REG_MASTER_STATUS_STATE, state_of(master));
    put_wide(registers, CTL_REG_MASTER_STATUS_COUNTS, master->tracker.count);
    put_wide(registers, CTL_REG_MASTER_STATUS_SPEED, speed_um);
    put(registers, CTL_REG_MASTER_STATUS_ANGLE, (uint16_t)(angle * 36000 / counts));
    put(registers, CTL_REG_MASTER_STATUS_ERROR,
        ctl_saturated16((master->tracker.error / (1 << CTL_GEAR_BITS) * revolution_um / counts) /
                        (1 << CTL_GEAR_BITS)));
    put(registers, CTL_REG_MASTER_STATUS_LEAD, ctl_saturated16(speed_um * master->lead_us / US_PER_S));
    put(registers, CTL_REG_MASTER_STATUS_HELD,
        ctl_saturated16(master->leads ? um_of_ticks(master, master->line - master->wanted) : 0));
    put_wide(registers, CTL_REG_MASTER_STATUS_TO_ENGAGED, um_of_ticks(master, ticks_to_engaged(master)));
    put(registers, CTL_REG_MASTER_STATUS_SMOOTHING, (uint16_t)master->tracker.constant_us);
}
