/* SPDX-License-Identifier: Apache-2.0 */
#include "signal/ctl_coder.h"

#include <stddef.h>

#define US_PER_MS 1000u
#define UM_PER_UNIT 100
#define RING (CTL_CODER_PRODUCTS - 1u)
#define MAX_CUTS 32u /* between knife and product; the farthest is sought no longer */

static uint16_t setting(const ctl_packer* packer, uint32_t address)
{
    return packer->board->signal[address - CTL_REG_SIGNAL_START_BUTTON_CONTACT];
}

/* Returns where the film is at the next cut, or was at the last one while none is planned. */
static int64_t next_cut(const ctl_packer* packer)
{
    return packer->next.command + packer->next.lag;
}

bool ctl_coder_is_aimed(const ctl_coder* coder, const ctl_packer* packer)
{
    return coder->passed == coder->count ||
           (coder->aimed && coder->cut == next_cut(packer) && coder->expected == packer->marks.expected &&
            coder->writes == packer->board->parameter_writes);
}

/* Returns where the mark of the cut near `cut` belongs, which the sensor need not have seen yet. */
static int64_t mark_of(const ctl_packer* packer, int64_t cut)
{
    const ctl_marks* marks = &packer->marks;
    const ctl_mark* mark = ctl_marks_near(marks, cut, packer->bag / 2);
    if (mark != NULL)
        return mark->at;
    int64_t at = marks->expected + marks->settings.distance;
    while (at + marks->pitch / 2 < cut)
        at += marks->pitch;
    return at;
}

/* Returns where so many cuts behind the next one are made: they come to their marks by so much at each cut.
 */
static int64_t align(const ctl_packer* packer, int64_t cut, uint32_t cuts)
{
    const int64_t way = mark_of(packer, cut) - cut;
    const int64_t limit = (int64_t)cuts * ctl_phase_max(&packer->settings.phase, CTL_PHASE_FAST);
    return way > limit ? cut + limit : way < -limit ? cut - limit : cut + way;
}

/* The cuts behind the next one are at their marks, or a bag apart. */
static int64_t end_of_bag(const ctl_packer* packer, int64_t middle)
{
    const int64_t bag = packer->bag + packer->settings.length;
    int64_t cut = next_cut(packer);
    uint32_t cuts = 0;
    for (; cut <= middle && cuts < MAX_CUTS; ++cuts)
        cut += bag;
    if (cuts != 0)
        return ctl_marks_follow(&packer->marks) ? align(packer, cut, cuts) : cut;
    for (; cut - bag > middle && cuts < MAX_CUTS; ++cuts)
        cut -= bag;
    return cut;
}

void ctl_coder_aim(ctl_coder* coder, const ctl_packer* packer)
{
    if (coder->writes != packer->board->parameter_writes) {
        coder->writes = packer->board->parameter_writes;
        coder->place =
            ctl_packer_film(packer, (int16_t)setting(packer, CTL_REG_SIGNAL_CODER_PLACE) * UM_PER_UNIT);
    }
    coder->cut = next_cut(packer);
    coder->expected = packer->marks.expected;
    coder->end = end_of_bag(packer, coder->at[(coder->first + coder->passed) & RING]);
    coder->aimed = true;
}

/* Takes the products that were laid on the film in this slice. */
static void take_products(ctl_coder* coder, const ctl_products* products)
{
    uint32_t fresh = products->total - coder->seen;
    coder->seen = products->total;
    if (fresh > products->laid_count)
        fresh = products->laid_count;
    for (uint32_t i = products->laid_count - fresh; i < products->laid_count; ++i) {
        const ctl_product* laid = &products->laid[i];
        if (coder->count == CTL_CODER_PRODUCTS) {
            coder->owed += 1u;
            continue;
        }
        coder->at[(coder->first + coder->count) & RING] = laid->lead + (laid->trail - laid->lead) / 2;
        coder->count += 1u;
    }
}

/* Handles the film at this position. */
static void pass(ctl_coder* coder, int64_t film)
{
    if (coder->aimed && coder->passed < coder->count && film >= coder->end) {
        coder->at[(coder->first + coder->passed) & RING] = coder->end;
        coder->passed += 1u;
        coder->aimed = false;
    }
    if (coder->passed == 0 && !coder->aimed)
        return;
    const int64_t end = coder->passed != 0 ? coder->at[coder->first] : coder->end;
    if (film < end - coder->place)
        return;
    if (coder->passed != 0)
        coder->passed -= 1u;
    else
        coder->aimed = false;
    coder->first = (coder->first + 1u) & RING;
    coder->count -= 1u;
    coder->owed += 1u;
}

/* Returns true when the output changes. */
static bool give_pulses(ctl_coder* coder, const ctl_packer* packer)
{
    const uint32_t passed_us = (uint32_t)packer->board->now_us - coder->since_us;
    if (coder->on) {
        const uint32_t length_us = US_PER_MS * setting(packer, CTL_REG_SIGNAL_CODER_PULSE);
        if (passed_us < length_us && (coder->owed == 0 || passed_us < CTL_CODER_SHORTEST_US))
            return false;
    } else {
        coder->rested = coder->rested || passed_us >= CTL_CODER_SHORTEST_US;
        if (!coder->rested || coder->owed == 0)
            return false;
        coder->owed -= 1u;
        coder->pulses += 1u;
    }
    coder->on = !coder->on;
    coder->rested = false;
    coder->since_us = (uint32_t)packer->board->now_us;
    return true;
}

/* The output changes at the end of the slice: where the film is nearest to the place then, half a slice's way
 * before or behind it. */
bool ctl_coder_slice(ctl_coder* coder, const ctl_packer* packer)
{
    const int64_t way = packer->film_actual - coder->film;
    coder->film = packer->film_actual;
    if (packer->products.total != coder->seen)
        take_products(coder, &packer->products);
    if (coder->count != 0)
        pass(coder, packer->film_actual + way / 2);
    return (coder->on || coder->owed != 0 || !coder->rested) && give_pulses(coder, packer);
}
