/* SPDX-License-Identifier: Apache-2.0 */
/* Records of the mark sensor, for a person and for the estimate of its dead time: each edge has its place,
 * the film's motion at that time and what became of it. A record costs four divisions, so that it is worked
 * out in later slices that have nothing else to do. */
#ifndef CTL_EDGES_H
#define CTL_EDGES_H

#include "ctl_registers.h"
#include "packer/ctl_past.h"

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_EDGE_REGISTERS 8u
#define CTL_EDGES_WAITING 4u

/* Lengths in 1/256 pulse of the film motor. */
typedef struct {
    int64_t at;         /* film position of the mark */
    int64_t off;        /* from the nearest expected position */
    int64_t width;      /* of the mark, 0: unknown */
    ctl_past_way newer; /* of the film before the edge was latched, */
    ctl_past_way older; /* and before that */
    uint16_t verdict;   /* CTL_MARK_VERDICT_... */
    uint16_t dead_us;   /* that was taken off */
} ctl_edge;

typedef struct {
    ctl_edge waiting[CTL_EDGES_WAITING]; /* for their records, the oldest first */
    uint32_t count;
    uint32_t stage;    /* of the work on the first one */
    int32_t speeds[2]; /* 0.1 mm/s: newer, older */
    uint32_t number;   /* records since power-up */
    uint16_t records[CTL_EDGE_REGISTERS * CTL_EDGE_RECORDS];
} ctl_edges;

/* Takes an edge; one too many at a time has no record. */
void ctl_edges_add(ctl_edges* edges, const ctl_edge* edge);
/* Does a piece of the work, on a film of `feed_um` for `pulses` of its motor. */
void ctl_edges_work(ctl_edges* edges, uint32_t feed_um, uint32_t pulses);
/* Writes the registers of the group `sensor`. */
void ctl_edges_registers(const ctl_edges* edges, uint16_t* registers);

#ifdef __cplusplus
}
#endif

#endif
