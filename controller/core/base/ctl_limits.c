/* SPDX-License-Identifier: Apache-2.0 */
#include "base/ctl_limits.h"

#include "base/ctl_words.h"
#include "ctl_registers.h"

typedef struct {
    uint16_t address;
    uint16_t words; /* 1 or 2; SIGNED: one, signed */
    int64_t minimum;
    int64_t maximum;
    int64_t initial; /* of parameters */
} limit;

#define SIGNED 0u
#define LIMIT(name, words) {CTL_REG_##name, words, CTL_MIN_##name, CTL_MAX_##name, CTL_DEFAULT_##name},
static const limit limits[] = {CTL_LIMITS(LIMIT)};

#define LIMIT_COUNT (sizeof limits / sizeof limits[0])

static int64_t value_at(const uint16_t* at, uint32_t words)
{
    if (words == SIGNED)
        return (int16_t)*at;
    return words == 2 ? ctl_get32(at) : *at;
}

/* The first limit of this address or behind it: they stand in the order of their addresses. */
static uint32_t first_from(uint32_t address)
{
    uint32_t first = 0;
    uint32_t end = LIMIT_COUNT;
    while (first < end) {
        const uint32_t middle = (first + end) / 2u;
        if (limits[middle].address < address)
            first = middle + 1u;
        else
            end = middle;
    }
    return first;
}

bool ctl_within_limits(const uint16_t* values, uint32_t base, uint32_t count)
{
    for (uint32_t i = first_from(base); i < LIMIT_COUNT && limits[i].address - base < count; ++i) {
        const uint16_t* at = &values[limits[i].address - base];
        const int64_t value = value_at(at, limits[i].words);
        if (value < limits[i].minimum || value > limits[i].maximum)
            return false;
    }
    return true;
}

void ctl_reset_to_defaults(uint16_t* values, uint32_t base, uint32_t count)
{
    for (uint32_t i = first_from(base); i < LIMIT_COUNT && limits[i].address - base < count; ++i) {
        const limit* row = &limits[i];
        uint16_t* at = &values[row->address - base];
        if (row->words == 2)
            ctl_put32(at, (uint32_t)row->initial);
        else
            *at = (uint16_t)row->initial;
    }
}

bool ctl_parameters_valid(const uint16_t* parameter)
{
    return ctl_within_limits(parameter, CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT, CTL_GROUP_PARAMETER);
}

void ctl_parameters_reset(uint16_t* parameter)
{
    ctl_reset_to_defaults(parameter, CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT, CTL_GROUP_PARAMETER);
}
