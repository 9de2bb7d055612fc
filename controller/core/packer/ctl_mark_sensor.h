/* SPDX-License-Identifier: Apache-2.0 */
/* The print at the mark sensor, from its beginning to its end. Its width decides whether it is a mark: where
 * no width is asked for, its beginning is enough. Lengths in 1/256 pulse of the film motor. */
#ifndef CTL_MARK_SENSOR_H
#define CTL_MARK_SENSOR_H

#include "packer/ctl_edges.h"
#include "packer/ctl_marks.h"

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    int64_t narrowest; /* 0: any */
    int64_t widest;    /* 0: any */
    bool there;
    bool waits;    /* it is not known whether the print is a mark */
    ctl_edge edge; /* of its beginning */
} ctl_mark_sensor;

/* Handles the beginning of a print, which is in `edge` but for what becomes of it. */
void ctl_mark_sensor_begin(ctl_mark_sensor* sensor, ctl_marks* marks);
/* Handles a print that waits, with the film at `film`. */
void ctl_mark_sensor_watch(ctl_mark_sensor* sensor, ctl_marks* marks, int64_t film);
/* Handles its end there; its edge is complete. */
void ctl_mark_sensor_end(ctl_mark_sensor* sensor, ctl_marks* marks, int64_t film);

#ifdef __cplusplus
}
#endif

#endif
