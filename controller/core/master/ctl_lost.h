/* SPDX-License-Identifier: Apache-2.0 */
/* An encoder that cannot be trusted: its input saw a change of A and B at once, its index mark is not where
 * its counts say, or its counts jump. */
#ifndef CTL_LOST_H
#define CTL_LOST_H

#include "base/ctl_port.h"

#ifdef __cplusplus
extern "C" {
#endif

/* No fault. */
#define CTL_LOST_NONE 0xFFFFu

typedef struct {
    uint32_t errors;   /* of the input, as far as they were seen */
    uint32_t indexes;  /* the same of index marks */
    bool knows_index;  /* `index_at` is one of them */
    int64_t index_at;  /* counts */
    int64_t index_off; /* counts by which the last one was off its place */
    int64_t last;      /* counts */
} ctl_lost;

/* Begins to watch. */
void ctl_lost_reset(ctl_lost* lost, const ctl_master_input* input);
/* Forgets where the index mark was, after it was off its place. */
void ctl_lost_forgive(ctl_lost* lost, uint32_t limit);
/* Handles what the input reports, of an encoder of `counts` per revolution whose index mark may be off by
 * `limit` counts, 0: it has none. Returns CTL_FAULT_BIT_MASTER_..., or CTL_LOST_NONE. */
uint16_t ctl_lost_watch(ctl_lost* lost, const ctl_master_input* input, uint32_t counts, uint32_t limit);

#ifdef __cplusplus
}
#endif

#endif
