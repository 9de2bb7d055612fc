/* SPDX-License-Identifier: Apache-2.0 */
#include "packer/ctl_edges.h"

#include "base/ctl_words.h"
#include "packer/ctl_feed.h"

#include <string.h>

_Static_assert(CTL_REG_SENSOR_MARKS - CTL_REG_SENSOR_MARK_NUMBER == 2u, "the records follow their number");
_Static_assert(CTL_EDGE_REGISTERS* CTL_EDGE_RECORDS + 2u == CTL_GROUP_SENSOR, "and fill the group");

/* 1 um/us is 10 000 x 0.1 mm/s. */
#define SPEED_OF_UM_PER_US 10000
/* 0.1 mm/s in a microsecond are 100 000 mm/s^2; the speeds are half of both ways' times apart. */
#define ACCELERATION (2 * 100000)

#define LENGTH_UM 10 /* of a distance or width in a record */

enum {
    RECORD_AT,
    RECORD_OFF = 2,
    RECORD_SPEED,
    RECORD_ACCELERATION,
    RECORD_VERDICT,
    RECORD_DEAD,
    RECORD_WIDTH
};

void ctl_edges_add(ctl_edges* edges, const ctl_edge* edge)
{
    if (edges->count < CTL_EDGES_WAITING)
        edges->waiting[edges->count++] = *edge;
}

static int32_t speed_of(const ctl_past_way* way, uint32_t feed_um, uint32_t pulses)
{
    if (way->us == 0)
        return 0;
    const int64_t scaled = (int64_t)way->way * feed_um * SPEED_OF_UM_PER_US;
    return (int32_t)(scaled / ((int64_t)pulses * CTL_FINE * way->us));
}

/* A parabola through the three positions: its slope at the newest one, and its curvature. */
static void finish(ctl_edges* edges, const ctl_edge* edge, uint16_t* record)
{
    const int32_t change = edges->speeds[0] - edges->speeds[1];
    const int32_t both_us = (int32_t)(edge->newer.us + edge->older.us);
    const int32_t us = both_us == 0 ? 1 : both_us;
    const int64_t speed = edges->speeds[0] + (int64_t)change * (int32_t)edge->newer.us / us;
    record[RECORD_SPEED] = ctl_saturated16(speed);
    record[RECORD_ACCELERATION] = ctl_saturated16((int64_t)change * ACCELERATION / us);
    record[RECORD_VERDICT] = edge->verdict;
    record[RECORD_DEAD] = edge->dead_us;
    edges->number += 1;
    edges->count -= 1;
    memmove(&edges->waiting[0], &edges->waiting[1], edges->count * sizeof edges->waiting[0]);
}

void ctl_edges_work(ctl_edges* edges, uint32_t feed_um, uint32_t pulses)
{
    if (edges->count == 0)
        return;
    const ctl_edge* edge = &edges->waiting[0];
    uint16_t* record = &edges->records[CTL_EDGE_REGISTERS * ((edges->number + 1u) % CTL_EDGE_RECORDS)];
    switch (edges->stage++) {
    case 0:
        ctl_put32(&record[RECORD_AT],
                  (uint32_t)((uint64_t)ctl_feed_um(edge->at, feed_um, pulses) & 0xFFFFFFFFu));
        break;
    case 1:
        record[RECORD_OFF] = ctl_saturated16(ctl_feed_um(edge->off, feed_um, pulses) / LENGTH_UM);
        break;
    case 2:
        edges->speeds[0] = speed_of(&edge->newer, feed_um, pulses);
        break;
    case 3:
        record[RECORD_WIDTH] = ctl_saturated16(ctl_feed_um(edge->width, feed_um, pulses) / LENGTH_UM);
        break;
    case 4:
        edges->speeds[1] = speed_of(&edge->older, feed_um, pulses);
        break;
    default:
        finish(edges, edge, record);
        edges->stage = 0;
        break;
    }
}

void ctl_edges_registers(const ctl_edges* edges, uint16_t* registers)
{
    ctl_put32(registers, edges->number);
    memcpy(&registers[2], edges->records, sizeof edges->records);
}
