/* SPDX-License-Identifier: Apache-2.0 */
#include "master/ctl_lost.h"

#include "ctl_registers.h"

/* More counts in a slice are a jump: 16 million a second. */
#define MAX_COUNTS 4096

static int64_t size_of(int64_t value)
{
    return value < 0 ? -value : value;
}

void ctl_lost_reset(ctl_lost* lost, const ctl_master_input* input)
{
    *lost = (ctl_lost){.errors = input->errors, .indexes = input->indexes, .last = input->counts};
}

void ctl_lost_forgive(ctl_lost* lost, uint32_t limit)
{
    if (size_of(lost->index_off) <= (int64_t)limit)
        return;
    lost->knows_index = false;
    lost->index_off = 0;
}

/* The difference from the nearest whole number of revolutions. */
static int64_t off_place(int64_t way, int64_t counts)
{
    const int64_t rest = way % counts;
    if (size_of(rest) * 2 <= counts)
        return rest;
    return rest < 0 ? rest + counts : rest - counts;
}

static void pass_index(ctl_lost* lost, int64_t at, uint32_t counts)
{
    if (!lost->knows_index)
        lost->index_at = at;
    lost->knows_index = true;
    lost->index_off = off_place(at - lost->index_at, counts);
}

uint16_t ctl_lost_watch(ctl_lost* lost, const ctl_master_input* input, uint32_t counts, uint32_t limit)
{
    const bool jumps = size_of(input->counts - lost->last) > MAX_COUNTS;
    const bool disturbed = input->errors != lost->errors;
    lost->last = input->counts;
    lost->errors = input->errors;
    if (input->indexes != lost->indexes && limit != 0)
        pass_index(lost, input->index_at, counts);
    lost->indexes = input->indexes;
    if (jumps)
        return CTL_FAULT_BIT_MASTER_SPEED;
    if (disturbed)
        return CTL_FAULT_BIT_MASTER_SIGNAL;
    return size_of(lost->index_off) > (int64_t)limit && limit != 0 ? CTL_FAULT_BIT_MASTER_COUNTS
                                                                   : CTL_LOST_NONE;
}
