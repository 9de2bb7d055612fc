/* SPDX-License-Identifier: Apache-2.0 */
#include "packer/ctl_eye_edges.h"

#include "base/ctl_words.h"

#include <string.h>

_Static_assert(CTL_REG_EYE_EDGES - CTL_REG_EYE_EDGE_NUMBER == 2u, "the records follow their number");
_Static_assert(CTL_EYE_REGISTERS* CTL_EYE_RECORDS + 2u == CTL_GROUP_EYE, "and fill the group");

#define PITCH_BITS 16u
/* A pitch in a microsecond is so many 0.001 pitches per second. */
#define SPEED_OF_PITCH_PER_US 1000000000

enum { RECORD_PLACE, RECORD_SPEED, RECORD_COVERED, RECORD_DEAD };

void ctl_eye_edges_add(ctl_eye_edges* edges, const ctl_eye_edge* edge)
{
    if (edges->waits)
        return;
    edges->waiting = *edge;
    edges->waits = true;
}

static uint16_t speed_of(const ctl_past_way* way, int64_t flight)
{
    if (way->us == 0 || way->way <= 0)
        return 0;
    const int64_t speed = (int64_t)way->way * SPEED_OF_PITCH_PER_US / (flight * way->us);
    return speed > UINT16_MAX ? UINT16_MAX : (uint16_t)speed;
}

static void finish(ctl_eye_edges* edges, uint16_t* record)
{
    record[RECORD_COVERED] = edges->waiting.covered ? 1u : 0u;
    record[RECORD_DEAD] = edges->waiting.dead_us;
    edges->number += 1;
    edges->waits = false;
}

void ctl_eye_edges_work(ctl_eye_edges* edges, int64_t flight)
{
    if (!edges->waits || flight == 0)
        return;
    ctl_eye_edge* edge = &edges->waiting;
    uint16_t* record = &edges->records[CTL_EYE_REGISTERS * ((edges->number + 1u) % CTL_EYE_RECORDS)];
    switch (edges->stage++) {
    case 0:
        edge->at %= flight;
        if (edge->at < 0)
            edge->at += flight;
        break;
    case 1:
        record[RECORD_PLACE] = (uint16_t)(((uint64_t)edge->at << PITCH_BITS) / (uint64_t)flight);
        break;
    case 2:
        record[RECORD_SPEED] = speed_of(&edge->way, flight);
        break;
    default:
        finish(edges, record);
        edges->stage = 0;
        break;
    }
}

void ctl_eye_edges_registers(const ctl_eye_edges* edges, uint16_t* registers)
{
    ctl_put32(registers, edges->number);
    memcpy(&registers[2], edges->records, sizeof edges->records);
}
