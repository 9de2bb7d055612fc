/* SPDX-License-Identifier: Apache-2.0 */
/* Moves cut, length and product to where the operator's hand wants them: the film through the phase, behind a
 * sealing window, the infeed from the start of the master's cycle, so that no axis has a step of its speed.
 */
#include "packer/ctl_packer.h"

/* Before the next product is laid, the infeed moves by this part of a flight: half as fast as where it finds
 * its places. */
#define INFEED_SHARE 32
/* The product stays within this part of a bag from its middle. */
#define PRODUCT_SHARE 4

static int64_t limited(int64_t value, int64_t limit)
{
    if (value > limit)
        return limit;
    return value < -limit ? -limit : value;
}

static int64_t size_of(int64_t value)
{
    return value < 0 ? -value : value;
}

static int64_t film_of(const ctl_packer* packer, int64_t um)
{
    return um == 0 ? 0 : ctl_packer_film(packer, um);
}

int64_t ctl_packer_bag_um(const ctl_packer* packer)
{
    const int64_t bag_um = ctl_bank_bag_um(packer->bank);
    return ctl_packer_tracks(packer) ? bag_um : bag_um + ctl_trim_um(packer->board, CTL_REG_HAND_LENGTH);
}

void ctl_packer_read_cut_trim(ctl_packer* packer)
{
    packer->settings.cut = film_of(packer, ctl_trim_um(packer->board, CTL_REG_HAND_CUT));
}

/* A cut that is moved by hand in the same bag stays within what is allowed to one out of register. */
void ctl_packer_read_length_trim(ctl_packer* packer)
{
    const ctl_phase_limits* limits = &packer->settings.phase;
    const int64_t um = (int16_t)ctl_parameter16(packer->board, CTL_REG_PARAMETER_LENGTH_TRIM);
    const int64_t length = film_of(packer, um + ctl_trim_um(packer->board, CTL_REG_HAND_LENGTH));
    const bool unused = length == 0 || ctl_packer_tracks(packer);
    packer->settings.length = unused ? 0
                                     : limited(length, ctl_phase_max(limits, CTL_PHASE_FAST) -
                                                           ctl_phase_max(limits, CTL_PHASE_BY_HAND));
}

/* On their way to the knife longer bags add to the distance of the product from its cut, so that it is laid
 * later by as much. Without marks the cut moves away from the products to come, too: the film on which they
 * are laid moves with it. */
void ctl_packer_read_product_trim(ctl_packer* packer)
{
    ctl_packer_settings* settings = &packer->settings;
    int64_t forward = film_of(packer, ctl_trim_um(packer->board, CTL_REG_HAND_PRODUCT));
    if (!ctl_packer_tracks(packer))
        forward += settings->cut;
    if (settings->length != 0)
        forward -= packer->products.settings.distance * settings->length / packer->bag;
    settings->product =
        forward == 0 ? 0 : limited(forward, packer->bag / PRODUCT_SHARE) * packer->flight / packer->bag;
}

/* With marks the place of the cut is part of their distance. Far from it the cut is out of register. */
static int64_t move_marks(ctl_packer* packer)
{
    ctl_marks* marks = &packer->marks;
    const ctl_phase_limits* limits = &packer->settings.phase;
    const int64_t wanted = packer->settings.marks.distance - marks->settings.distance;
    if (wanted == 0)
        return 0;
    if (size_of(wanted) > ctl_phase_max(limits, CTL_PHASE_FAST))
        ctl_packer_leave_register(packer, packer->bag);
    const bool tracks = marks->state == CTL_MARK_STATE_TRACKING;
    const int64_t step = tracks ? limited(wanted, ctl_phase_max(limits, CTL_PHASE_BY_HAND)) : wanted;
    ctl_marks_move(marks, step);
    packer->last_cut.mark_at += step;
    return tracks ? step : 0;
}

int64_t ctl_packer_move_cut(ctl_packer* packer)
{
    const int64_t cut = packer->settings.cut;
    if (ctl_packer_tracks(packer)) {
        packer->cut_in_film = cut;
        return ctl_marks_follow(&packer->marks) ? move_marks(packer) : 0;
    }
    if (cut == packer->cut_in_film)
        return 0;
    const int64_t step =
        limited(cut - packer->cut_in_film, ctl_phase_max(&packer->settings.phase, CTL_PHASE_BY_HAND));
    packer->cut_in_film += step;
    return step;
}

int64_t ctl_packer_next_move(const ctl_packer* packer)
{
    const ctl_packer_settings* settings = &packer->settings;
    const int64_t way = ctl_packer_tracks(packer) ? settings->marks.distance - packer->marks.settings.distance
                                                  : settings->cut - packer->cut_in_film;
    return size_of(limited(way, ctl_phase_max(&settings->phase, CTL_PHASE_FAST))) + size_of(settings->length);
}

void ctl_packer_move_products(ctl_packer* packer)
{
    if (packer->settings.product == packer->product_in_infeed || packer->infeed.span != 0 || packer->wheel.on)
        return;
    const int64_t step =
        limited(packer->settings.product - packer->product_in_infeed, packer->flight / INFEED_SHARE);
    packer->product_in_infeed += step;
    ctl_feed_correct(&packer->infeed, step, packer->cut);
}
