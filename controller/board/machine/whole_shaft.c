/* SPDX-License-Identifier: Apache-2.0 */
#include "machine/whole_shaft.h"

#include "base/ctl_words.h"

#define PART_BITS 32u
#define US_PER_S 1000000u
#define SHARE_BITS 16u
#define RIPPLE ((1 << SHARE_BITS) / 100)
#define RIPPLE_STEP 2 /* in a slice: 3 Hz */

void whole_shaft_init(whole_shaft* shaft, uint32_t counts_per_s, bool drives_film)
{
    *shaft = (whole_shaft){.counts_per_s = counts_per_s, .drives_film = drives_film, .change = RIPPLE_STEP};
}

/* In lowest terms, for the shorter divisions. */
static void set_gear(whole_gear* gear, uint64_t numerator, uint64_t denominator)
{
    uint64_t common = denominator;
    for (uint64_t other = numerator % common; other != 0;) {
        const uint64_t rest = common % other;
        common = other;
        other = rest;
    }
    *gear = (whole_gear){numerator / common, denominator / common, (denominator << PART_BITS) / numerator, 0,
                         gear->at};
}

static uint32_t setting(const ctl_core* core, uint32_t address)
{
    return ctl_get32(&core->board.master[address - CTL_REG_MASTER_SOURCE]);
}

void whole_shaft_set_up(whole_shaft* shaft, const ctl_core* core, int64_t flight)
{
    const ctl_board* board = &core->board;
    const uint64_t revolution_um = setting(core, CTL_REG_MASTER_REVOLUTION);
    const uint64_t bag_um = ctl_bank_bag_um(ctl_active_bank(&core->banks));
    shaft->turn = setting(core, CTL_REG_MASTER_COUNTS);
    set_gear(&shaft->film, CTL_FINE * ctl_parameter32(board, CTL_REG_PARAMETER_FILM_PULSES) * revolution_um,
             (uint64_t)ctl_parameter32(board, CTL_REG_PARAMETER_FILM_FEED) * shaft->turn);
    set_gear(&shaft->infeed, (uint64_t)flight * revolution_um, bag_um * shaft->turn);
}

static void turn_gear(whole_gear* gear, uint64_t counts)
{
    const uint64_t sum = gear->rest + counts * gear->numerator;
    gear->at += (int64_t)(sum / gear->denominator);
    gear->rest = sum % gear->denominator;
}

static void pass_index(whole_shaft* shaft, int64_t before)
{
    const int64_t turns = shaft->counts / shaft->turn;
    if (turns == before / shaft->turn)
        return;
    shaft->indexes += 1;
    shaft->index_at = turns * shaft->turn;
}

void whole_shaft_turn(whole_shaft* shaft, uint32_t us)
{
    const uint32_t share = (uint32_t)((1 << SHARE_BITS) + shaft->faster);
    const uint64_t per_us = ((uint64_t)shaft->counts_per_s * share << (PART_BITS - SHARE_BITS)) / US_PER_S;
    const uint64_t sum = shaft->part + per_us * us;
    const int64_t before = shaft->counts;
    shaft->part = (uint32_t)sum;
    shaft->counts += (int64_t)(sum >> PART_BITS);
    shaft->faster += shaft->change;
    if (shaft->faster >= RIPPLE || shaft->faster <= -RIPPLE)
        shaft->change = -shaft->change;
    if (shaft->turn == 0)
        return;
    pass_index(shaft, before);
    turn_gear(&shaft->film, sum >> PART_BITS);
    turn_gear(&shaft->infeed, sum >> PART_BITS);
}

int64_t whole_shaft_latch(const whole_shaft* shaft, const whole_gear* gear, int64_t position)
{
    if (!shaft->latches)
        return position;
    return shaft->counts - ((gear->at - position) * (int64_t)gear->inverse >> PART_BITS);
}

void whole_shaft_read(const whole_shaft* shaft, ctl_master_input* input)
{
    *input = (ctl_master_input){shaft->counts, 0, shaft->indexes, shaft->index_at};
}
