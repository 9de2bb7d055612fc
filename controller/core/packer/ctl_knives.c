/* SPDX-License-Identifier: Apache-2.0 */
#include "packer/ctl_knives.h"

#include "ctl_registers.h"

_Static_assert(CTL_REG_PARAMETER_KNIFE_12 - CTL_REG_PARAMETER_KNIFE_2 + 2u == CTL_KNIVES,
               "the places of the knives follow each other");

void ctl_knives_reset(ctl_knives* knives, uint32_t count)
{
    knives->count = count;
    knives->next = 0;
    knives->last = 0;
    knives->in_film = 0;
}

void ctl_knives_cut(ctl_knives* knives)
{
    knives->last = knives->next;
    knives->next = knives->next + 1u < knives->count ? knives->next + 1u : 0u;
}

int32_t ctl_knives_next_um(const ctl_knives* knives, const ctl_board* board)
{
    if (knives->next == 0 || knives->next >= CTL_KNIVES)
        return 0;
    return (int16_t)ctl_parameter16(board, CTL_REG_PARAMETER_KNIFE_2 + knives->next - 1u);
}
