/* SPDX-License-Identifier: Apache-2.0 */
#include "motion/ctl_park.h"

#include "base/ctl_words.h"
#include "ctl_registers.h"

#define US_PER_MS 1000u

static uint64_t parameter_us(const ctl_board* board, uint32_t address)
{
    return (uint64_t)ctl_parameter16(board, address) * US_PER_MS;
}

void ctl_park_return(ctl_park* park)
{
    park->phase = CTL_PARK_RETURNING;
    park->given_up = false;
    park->emergency = false;
    park->jam = false;
    park->line = false;
    park->stands = false;
}

void ctl_park_run(ctl_park* park)
{
    park->phase = CTL_PARK_OFF;
    park->given_up = false;
    park->away = false;
    park->emergency = false;
    park->jam = false;
    park->line = false;
    park->to_boundary = false;
    park->stands = false;
    park->closed = false;
    park->told = false;
}

void ctl_park_forget(ctl_park* park)
{
    ctl_park_run(park);
    park->known = false;
}

void ctl_park_begin_cycle(ctl_park* park, int64_t here)
{
    park->cycle_at = here;
    park->known = true;
}

int64_t ctl_park_from_cut(const ctl_park* park, const ctl_packer* packer, int64_t here)
{
    return here - park->cycle_at - (int64_t)packer->cut_pulses;
}

void ctl_park_begin_cut(ctl_park* park, const ctl_packer* packer, int64_t here, int64_t cycle)
{
    park->before_cut = ctl_park_from_cut(park, packer, here) < 0;
    if (!park->before_cut)
        park->cycle_at += cycle;
    park->turn = cycle;
    park->phase = CTL_PARK_CUTTING;
    park->given_up = false;
    park->emergency = false;
    park->jam = false;
    park->line = false;
}

void ctl_park_end_cut(ctl_park* park)
{
    if (park->before_cut)
        park->cycle_at += park->turn;
    park->place += park->turn;
    park->phase = CTL_PARK_OFF;
}

bool ctl_park_touches(const ctl_park* park, const ctl_packer* packer, int64_t here)
{
    const int64_t from = ctl_park_from_cut(park, packer, here);
    return park->known && ctl_packer_active(packer) && from > -packer->settings.jaws_before &&
           from < packer->settings.jaws_behind;
}

bool ctl_park_begin(ctl_park* park, const ctl_board* board, const ctl_packer* packer, int64_t here)
{
    if (!(park->jam || ctl_park_touches(park, packer, here)) || park->given_up || park->emergency)
        return false;
    if (!park->away)
        park->place = here;
    park->phase = CTL_PARK_WAITING;
    park->waits_us = board->now_us;
    return true;
}

bool ctl_park_begin_under_line(ctl_park* park, const ctl_board* board, const ctl_packer* packer, int64_t here,
                               bool stands)
{
    const bool stood = park->stands;
    park->stands = stands && ctl_park_touches(park, packer, here);
    if (!park->stands)
        return false;
    if (!stood)
        park->waits_us = board->now_us;
    if (!ctl_park_is_due(park, board))
        return false;
    park->place = here;
    park->phase = CTL_PARK_OPENING;
    park->away = true;
    park->line = true;
    return true;
}

void ctl_park_stop(ctl_park* park)
{
    if (park->phase == CTL_PARK_WAITING || park->phase == CTL_PARK_OPENING)
        park->given_up = true;
    park->phase = CTL_PARK_OFF;
}

bool ctl_park_is_due(const ctl_park* park, const ctl_board* board)
{
    return park->jam || board->now_us - park->waits_us >= parameter_us(board, CTL_REG_PARAMETER_PARK_DELAY);
}

int64_t ctl_park_target(const ctl_park* park, const ctl_packer* packer, int64_t here)
{
    const int64_t from = ctl_park_from_cut(park, packer, here);
    if (park->jam)
        return here - from + packer->jam.last.at - packer->settings.jam_back;
    return here - from + (from < 0 ? -packer->settings.jaws_before : packer->settings.jaws_behind);
}

int64_t ctl_park_boundary(const ctl_park* park, const ctl_packer* packer, int64_t here)
{
    const bool before = ctl_park_from_cut(park, packer, here) < 0;
    return park->cycle_at +
           (before ? 0 : (int32_t)ctl_get32(&packer->bank->registers[CTL_OFFSET_BANK_ADVANCE]));
}

void ctl_park_watch(ctl_park* park, const ctl_board* board, ctl_packer* packer, int64_t here)
{
    if (!ctl_park_touches(park, packer, here)) {
        park->closed = false;
        return;
    }
    if (!park->closed)
        park->closed_us = board->now_us;
    park->closed = true;
    if (park->told || !(park->emergency || ctl_park_is_closed_long(park, board)))
        return;
    park->told = true;
    ctl_packer_burn(packer, ctl_park_from_cut(park, packer, here) < 0);
}

bool ctl_park_is_closed_long(const ctl_park* park, const ctl_board* board)
{
    return park->closed &&
           board->now_us - park->closed_us > parameter_us(board, CTL_REG_PARAMETER_JAWS_CLOSED_MAX);
}
