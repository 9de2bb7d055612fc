/* SPDX-License-Identifier: Apache-2.0 */
/* The registers of the group `packer`. */
#include "packer/ctl_packer.h"

#include "base/ctl_words.h"

#include <string.h>

#define FULL_CIRCLE 36000u /* 0.01 degrees */
#define UM_PER_MM 1000
#define VIEW_UM 100 /* of the picture of the film */
#define NOTHING 0x8000u

_Static_assert(CTL_REG_PACKER_BAGS + CTL_BAG_REGISTERS * CTL_BAG_RECORDS == CTL_REG_PACKER_FILM_POSITION,
               "the records fill their place in the group");
_Static_assert(CTL_REG_PACKER_CUTS + CTL_VIEW_CUTS == CTL_REG_PACKER_SEEN_MARKS, "so do the cuts in view");
_Static_assert(CTL_REG_PACKER_SEEN_MARKS + CTL_VIEW_MARKS == CTL_REG_PACKER_SEEN_PRODUCTS, "so do the marks");
_Static_assert(CTL_REG_PACKER_SEEN_PRODUCTS + 2u * CTL_VIEW_PRODUCTS == CTL_REG_PACKER_KNIFE,
               "so do the products");
_Static_assert(CTL_VIEW_MARKS <= CTL_WAITING_MARKS && CTL_VIEW_PRODUCTS <= CTL_PRODUCTS,
               "as many as are shown are kept");

static uint16_t saturated16(int64_t value)
{
    if (value > INT16_MAX)
        value = INT16_MAX;
    if (value < -INT16_MAX) /* -32768 means none */
        value = -INT16_MAX;
    return (uint16_t)(value & 0xFFFF);
}

static void put(uint16_t* registers, uint32_t address, uint16_t value)
{
    registers[address - CTL_REG_PACKER_MARK_STATE] = value;
}

static void put_wide(uint16_t* registers, uint32_t address, uint64_t value)
{
    ctl_put32(&registers[address - CTL_REG_PACKER_MARK_STATE], (uint32_t)(value & 0xFFFFFFFFu));
}

static uint16_t film_um16(const ctl_packer* packer, int64_t film)
{
    return saturated16(ctl_packer_um(packer, film));
}

static void put_marks(const ctl_packer* packer, uint16_t* registers)
{
    const ctl_marks* marks = &packer->marks;
    put(registers, CTL_REG_PACKER_MARK_STATE, marks->state);
    put(registers, CTL_REG_PACKER_MARK_ERROR, film_um16(packer, packer->last_cut.error));
    put(registers, CTL_REG_PACKER_LAST_MARK, film_um16(packer, marks->error));
    put(registers, CTL_REG_PACKER_PHASE_CORRECTION, film_um16(packer, packer->phase.step));
    put(registers, CTL_REG_PACKER_LENGTH_CORRECTION, film_um16(packer, packer->phase.length));
    put_wide(registers, CTL_REG_PACKER_MARK_PITCH, (uint64_t)ctl_packer_um(packer, marks->pitch));
    put_wide(registers, CTL_REG_PACKER_MARKS, marks->followed);
    put_wide(registers, CTL_REG_PACKER_MARKS_MISSING, marks->missing);
    put_wide(registers, CTL_REG_PACKER_MARKS_FALSE, marks->unexpected);
    put(registers, CTL_REG_PACKER_TEACH_MARKS, marks->teaching.count);
    put_wide(registers, CTL_REG_PACKER_TEACH_PITCH,
             (uint64_t)ctl_packer_um(packer, ctl_marks_taught_pitch(marks)));
    put(registers, CTL_REG_PACKER_TEACH_SCATTER,
        film_um16(packer, ctl_square_root(ctl_marks_taught_variance(marks))));
    put(registers, CTL_REG_PACKER_MARKS_WAIT, (uint16_t)marks->count);
}

static void put_counts(const ctl_packer* packer, uint16_t* registers)
{
    put_wide(registers, CTL_REG_PACKER_PRODUCTS, packer->products.total);
    put_wide(registers, CTL_REG_PACKER_CUTS_SKIPPED, packer->skipped);
    put_wide(registers, CTL_REG_PACKER_EMPTY_BAGS, packer->empty);
    put_wide(registers, CTL_REG_PACKER_FILM_SAVED, packer->saved_um / UM_PER_MM);
    put(registers, CTL_REG_PACKER_LAST_SKIP, packer->last_skip);
    put(registers, CTL_REG_PACKER_SKIPS_IN_A_ROW, (uint16_t)(packer->skips_in_row & 0xFFFFu));
    put_wide(registers, CTL_REG_PACKER_CORRECTIONS_LIMITED, packer->phase.limited);
    put_wide(registers, CTL_REG_PACKER_BAG_NUMBER, packer->bags);
    memcpy(&registers[CTL_REG_PACKER_BAGS - CTL_REG_PACKER_MARK_STATE], packer->records,
           sizeof packer->records);
}

/* Returns a distance to the knife in 0.1 mm; bit 0 is a flag. */
static uint16_t view(const ctl_packer* packer, int64_t at, bool special)
{
    const int64_t tenths = ctl_packer_um(packer, at - packer->film_actual) / VIEW_UM;
    return (uint16_t)((saturated16(tenths) & 0xFFFEu) | (special ? 1u : 0u));
}

/* Writes the next cuts: the planned one, then those of the waiting marks or the bag length. */
static void put_cuts(const ctl_packer* packer, uint16_t* registers)
{
    const int64_t clearance =
        ctl_packer_film(packer, ctl_parameter16(packer->board, CTL_REG_PARAMETER_CUT_CLEARANCE));
    int64_t at = packer->next.command + packer->next.lag;
    if (at < packer->film_actual) /* made already, the next one is not planned yet */
        at += packer->bag;
    for (uint32_t i = 0; i < CTL_VIEW_CUTS; ++i) {
        const ctl_mark* mark =
            packer->next.tracked ? ctl_marks_near(&packer->marks, at, packer->bag / 4) : NULL;
        if (mark != NULL)
            at = mark->at;
        const bool left_out = ctl_parameter16(packer->board, CTL_REG_PARAMETER_ANTI_CUT) != 0 &&
                              ctl_products_across(&packer->products, at, clearance);
        put(registers, CTL_REG_PACKER_CUTS + i, view(packer, at, left_out));
        at += packer->bag;
    }
}

static void put_view(const ctl_packer* packer, uint16_t* registers)
{
    put_wide(registers, CTL_REG_PACKER_FILM_POSITION, (uint64_t)ctl_packer_um(packer, packer->film_actual));
    put_cuts(packer, registers);
    for (uint32_t i = 0; i < CTL_VIEW_MARKS && i < packer->marks.count; ++i) {
        const ctl_mark* mark = ctl_marks_waiting(&packer->marks, i);
        put(registers, CTL_REG_PACKER_SEEN_MARKS + i, view(packer, mark->at, !mark->seen));
    }
    for (uint32_t i = 0; i < CTL_VIEW_PRODUCTS && i < packer->products.laid_count; ++i) {
        const ctl_product* product = &packer->products.laid[i];
        put(registers, CTL_REG_PACKER_SEEN_PRODUCTS + 2u * i, view(packer, product->lead, false));
        put(registers, CTL_REG_PACKER_SEEN_PRODUCTS + 2u * i + 1u, view(packer, product->trail, false));
    }
}

void ctl_packer_registers(const ctl_packer* packer, uint16_t* registers)
{
    memset(registers, 0, CTL_GROUP_PACKER * sizeof registers[0]);
    for (uint32_t at = CTL_REG_PACKER_CUTS; at < CTL_REG_PACKER_SEEN_PRODUCTS + 2u * CTL_VIEW_PRODUCTS; ++at)
        put(registers, at, NOTHING);
    if (packer->bank == NULL)
        return;
    put_marks(packer, registers);
    put_counts(packer, registers);
    put(registers, CTL_REG_PACKER_FILM_ANGLE,
        (uint16_t)((uint64_t)packer->film.phase * FULL_CIRCLE / packer->film.cycle));
    put(registers, CTL_REG_PACKER_KNIFE_GATE, packer->knife_gate.state);
    put(registers, CTL_REG_PACKER_FILM_GATE, packer->film_gate.state);
    put(registers, CTL_REG_PACKER_FILM_FOLLOWING_ERROR,
        film_um16(packer, packer->film_sent * CTL_FINE - packer->film_actual));
    put_view(packer, registers);
    put(registers, CTL_REG_PACKER_KNIFE, (uint16_t)(packer->knives.last + 1u));
    put(registers, CTL_REG_PACKER_THREADING, packer->threading ? 1u : 0u);
}
