/* SPDX-License-Identifier: Apache-2.0 */
#include "packer/ctl_mark_sensor.h"

#include "ctl_registers.h"

/* As soon as the width up to here allows it. */
static void judge(ctl_mark_sensor* sensor, ctl_marks* marks, int64_t width, bool ended)
{
    ctl_edge* edge = &sensor->edge;
    if (sensor->widest != 0 && width > sensor->widest)
        edge->verdict = ctl_marks_reject(marks, edge->at, CTL_MARK_VERDICT_TOO_WIDE);
    else if (ended && width < sensor->narrowest)
        edge->verdict = ctl_marks_reject(marks, edge->at, CTL_MARK_VERDICT_TOO_NARROW);
    else if (ended || (sensor->widest == 0 && width >= sensor->narrowest))
        edge->verdict = ctl_marks_see(marks, edge->at);
    else
        return;
    edge->off = marks->off;
    sensor->waits = false;
}

void ctl_mark_sensor_begin(ctl_mark_sensor* sensor, ctl_marks* marks)
{
    sensor->there = true;
    sensor->waits = true;
    judge(sensor, marks, 0, false);
}

void ctl_mark_sensor_watch(ctl_mark_sensor* sensor, ctl_marks* marks, int64_t film)
{
    judge(sensor, marks, film - sensor->edge.at, false);
}

void ctl_mark_sensor_end(ctl_mark_sensor* sensor, ctl_marks* marks, int64_t film)
{
    sensor->edge.width = film - sensor->edge.at;
    if (sensor->waits)
        judge(sensor, marks, sensor->edge.width, true);
    sensor->there = false;
}
