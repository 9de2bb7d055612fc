/* SPDX-License-Identifier: Apache-2.0 */
/* The registers of the group `master_status`. */
#include "base/ctl_words.h"
#include "master/ctl_master.h"

#include <stddef.h>
#include <string.h>

#define US_PER_S 1000000u
#define RATE_BITS 24u
#define SPEED_SHIFT 8u
#define FULL_CIRCLE 36000 /* 0.01 degrees */
#define UM_PER_MM 1000

static uint32_t setting32(const ctl_master* master, uint32_t address)
{
    return ctl_get32(&master->board->master[address - CTL_REG_MASTER_SOURCE]);
}

/* Film that passes at `speed`, um per second. */
static int64_t um_per_s(const ctl_master* master, int64_t speed)
{
    const int64_t counts_per_s = speed / (1 << SPEED_SHIFT) * US_PER_S / (1 << (RATE_BITS - SPEED_SHIFT));
    return counts_per_s * setting32(master, CTL_REG_MASTER_REVOLUTION) /
           (int64_t)((uint64_t)setting32(master, CTL_REG_MASTER_COUNTS) << SPEED_SHIFT);
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

/* 0.01 degrees. */
static int64_t present_phase(const ctl_master* master)
{
    const ctl_master_phase* phase = &master->phase;
    return master->cycle == 0
               ? 0
               : phase->set - (phase->way - phase->done) * FULL_CIRCLE / (int64_t)master->cycle;
}

static int64_t passed_mm(const ctl_master* master)
{
    const int64_t counts = setting32(master, CTL_REG_MASTER_COUNTS);
    const int64_t revolution_um = setting32(master, CTL_REG_MASTER_REVOLUTION);
    return master->passed / counts * revolution_um / UM_PER_MM +
           master->passed % counts * revolution_um / counts / UM_PER_MM;
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
    put(registers, CTL_REG_MASTER_STATUS_PHASE, ctl_saturated16(present_phase(master)));
    put(registers, CTL_REG_MASTER_STATUS_RIPPLE, master->ripple.share);
    put(registers, CTL_REG_MASTER_STATUS_INPUT_ERRORS,
        (uint16_t)(master->lost.errors < UINT16_MAX ? master->lost.errors : UINT16_MAX));
    put(registers, CTL_REG_MASTER_STATUS_INDEX_ERROR, ctl_saturated16(master->lost.index_off));
    put(registers, CTL_REG_MASTER_STATUS_LAG, ctl_saturated16(um_of_ticks(master, master->lag)));
    put_wide(registers, CTL_REG_MASTER_STATUS_PASSED, passed_mm(master));
}
