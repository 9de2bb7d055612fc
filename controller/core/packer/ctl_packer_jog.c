/* SPDX-License-Identifier: Apache-2.0 */
/* By hand: film and infeed fed alone, the bag of a jog, the cut of a knife that moves alone, the bag that a
 * person wants. */
#include "packer/ctl_packer.h"

#define SAME_PLACE_UM 1000 /* two cuts nearer than this make no bag */

uint16_t ctl_packer_cut_refusal(const ctl_packer* packer, const ctl_bank* bank)
{
    if (!ctl_packer_drives(packer, bank))
        return CTL_REFUSAL_NO_BAGS;
    return ctl_packer_active(packer) &&
                   ctl_products_across(&packer->products, packer->film_actual, packer->settings.clearance)
               ? CTL_REFUSAL_PRODUCT_AT_KNIFE
               : CTL_REFUSAL_NONE;
}

bool ctl_packer_cuts_next(const ctl_packer* packer)
{
    const uint16_t film = packer->film_gate.state;
    const uint16_t knife = packer->knife_gate.state;
    return packer->film.phase < packer->cut &&
           (film == CTL_GATE_STATE_RUNNING || film == CTL_GATE_STATE_CATCHING_UP) &&
           (knife == CTL_GATE_STATE_RUNNING || knife == CTL_GATE_STATE_CATCHING_UP);
}

void ctl_packer_feed_by_hand(ctl_packer* packer, ctl_axis axis, int64_t way)
{
    ctl_feed* feed = axis == CTL_AXIS_FILM ? &packer->film : &packer->infeed;
    feed->start += way;
}

void ctl_packer_note_bag(ctl_packer* packer, int64_t film)
{
    packer->bag_film = packer->cut_known ? film - packer->last_cut.at : 0;
    packer->cut_known = true;
}

void ctl_packer_scrap_next(ctl_packer* packer)
{
    packer->scrapped = true;
}

void ctl_packer_take_next(ctl_packer* packer)
{
    packer->takes = true;
}

void ctl_packer_cut_alone(ctl_packer* packer)
{
    packer->alone = true;
}

void ctl_packer_on_cut_alone(ctl_packer* packer, int64_t film)
{
    ctl_last_cut* last = &packer->last_cut;
    const int64_t way_um = ctl_packer_um(packer, film - last->at);
    ctl_knives_cut(&packer->knives);
    packer->no_bag = last->bags != 0 && way_um < SAME_PLACE_UM && way_um > -SAME_PLACE_UM;
    if (packer->no_bag)
        return;
    ctl_packer_note_bag(packer, film);
    *last = (ctl_last_cut){
        .at = film,
        .mark_at = film,
        .pitch = packer->bag,
        .had_products = ctl_products_cut(&packer->products, film) != 0,
        .scrap = true,
        .burned = packer->burned != 0,
        .jammed = packer->jammed != 0,
        .bags = 1,
        .command = film,
        .set_um = way_um,
    };
    packer->burned -= packer->burned != 0 ? 1u : 0u;
    packer->jammed -= packer->jammed != 0 ? 1u : 0u;
    packer->scrapped = true;
    packer->skips_in_row = 0;
    packer->cut_before = false;
}
