/* SPDX-License-Identifier: Apache-2.0 */
/* Records of the product eye, for the measurement of its dead time: each edge has its place in the infeed's
 * pitch and the infeed's speed at that time. A record is worked out in later slices that have nothing else to
 * do. */
#ifndef CTL_EYE_EDGES_H
#define CTL_EYE_EDGES_H

#include "ctl_registers.h"
#include "packer/ctl_past.h"

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_EYE_REGISTERS 4u

typedef struct {
    int64_t at;       /* infeed position of the edge, 1/256 pulse */
    ctl_past_way way; /* of the infeed before the edge was latched */
    uint16_t dead_us; /* that was taken off */
    bool covered;     /* a product begins */
} ctl_eye_edge;

typedef struct {
    ctl_eye_edge waiting; /* for its record */
    bool waits;
    uint32_t stage;  /* of the work on it */
    uint32_t number; /* records since power-up */
    uint16_t records[CTL_EYE_REGISTERS * CTL_EYE_RECORDS];
} ctl_eye_edges;

/* Takes an edge; one that comes while another one waits has no record. */
void ctl_eye_edges_add(ctl_eye_edges* edges, const ctl_eye_edge* edge);
/* Does a piece of the work, for products that are `flight` apart on the infeed, 1/256 pulse. */
void ctl_eye_edges_work(ctl_eye_edges* edges, int64_t flight);
/* Writes the registers of the group `eye`. */
void ctl_eye_edges_registers(const ctl_eye_edges* edges, uint16_t* registers);

#ifdef __cplusplus
}
#endif

#endif
