/* SPDX-License-Identifier: Apache-2.0 */
/* A press among the states of the machine: one Start is one stroke, then Ready; after a force fault the ram
 * is up again before the state is Fault. */
#include "motion/ctl_motion.h"

#include <stddef.h>

bool ctl_motion_is_press(const ctl_motion* motion)
{
    return motion->banks->has_active &&
           ctl_bank_layout(ctl_active_bank(motion->banks)) == CTL_TABLE_LAYOUT_PRESS_STAGES;
}

void ctl_motion_take_top(ctl_motion* motion)
{
    motion->origin = motion->actual;
    motion->homed = true;
}

int32_t ctl_motion_press_force(const ctl_motion* motion)
{
    return motion->board->port.force != NULL ? motion->board->port.force(motion->board->port.context) : 0;
}

bool ctl_motion_force_forbids(const ctl_motion* motion)
{
    const int32_t force = ctl_motion_press_force(motion);
    return ctl_motion_is_press(motion) && force > 0 &&
           (uint32_t)force >= ctl_press_row_of(ctl_active_bank(motion->banks), CTL_PRESS_PRESS).force;
}

static ctl_press_reading read_press(const ctl_motion* motion)
{
    const ctl_port* port = &motion->board->port;
    const int64_t fine =
        port->scale != NULL ? port->scale(port->context) : port->encoder(port->context) * CTL_PRESS_FINE;
    const ctl_press_reading reading = {fine - motion->origin * CTL_PRESS_FINE, ctl_motion_press_force(motion),
                                       motion->board->now_us, !motion->board->catching_up};
    return reading;
}

void ctl_motion_begin_stroke(ctl_motion* motion)
{
    const ctl_press_reading reading = read_press(motion);
    ctl_press_begin(&motion->press, ctl_active_bank(motion->banks), motion->board->config.timer_clock_hz,
                    &reading);
}

void ctl_motion_slice_stroke(ctl_motion* motion, const ctl_pace* pace)
{
    ctl_press* press = &motion->press;
    const ctl_press_reading reading = read_press(motion);
    motion->commanded += ctl_press_slice(press, &reading, pace->ticks, pace);
    if (press->stage != CTL_PRESS_STAGE_STANDING)
        return;
    motion->cycle_count += 1;
    if (press->fault != CTL_PRESS_NO_FAULT)
        ctl_motion_fault(motion, press->fault);
    else
        ctl_motion_stand(motion);
}
