/* SPDX-License-Identifier: Apache-2.0 */
/* A press among the states of the machine: one Start is one stroke, then Ready; after a force fault the ram
 * is up again before the state is Fault. */
#include "ctl_core.h"
#include "motion/ctl_motion.h"

#include <stddef.h>

bool ctl_motion_is_press(const ctl_core* core)
{
    return core->banks.has_active && ctl_bank_layout(ctl_active_bank(core)) == CTL_TABLE_LAYOUT_PRESS_STAGES;
}

void ctl_motion_take_top(ctl_core* core)
{
    core->motion.origin = core->motion.actual;
    core->motion.homed = true;
}

int32_t ctl_motion_press_force(const ctl_core* core)
{
    return core->port.force != NULL ? core->port.force(core->port.context) : 0;
}

bool ctl_motion_force_forbids(const ctl_core* core)
{
    const int32_t force = ctl_motion_press_force(core);
    return ctl_motion_is_press(core) && force > 0 &&
           (uint32_t)force >= ctl_press_row_of(ctl_active_bank(core), CTL_PRESS_PRESS).force;
}

static ctl_press_reading read_press(const ctl_core* core)
{
    const ctl_port* port = &core->port;
    const int64_t fine =
        port->scale != NULL ? port->scale(port->context) : port->encoder(port->context) * CTL_PRESS_FINE;
    const ctl_press_reading reading = {fine - core->motion.origin * CTL_PRESS_FINE,
                                       ctl_motion_press_force(core), core->now_us, !core->catching_up};
    return reading;
}

void ctl_motion_begin_stroke(ctl_core* core)
{
    const ctl_press_reading reading = read_press(core);
    ctl_press_begin(&core->motion.press, ctl_active_bank(core), core->config.timer_clock_hz, &reading);
}

void ctl_motion_slice_stroke(ctl_core* core, uint32_t ticks)
{
    ctl_motion* motion = &core->motion;
    ctl_press* press = &motion->press;
    const ctl_press_reading reading = read_press(core);
    ctl_motion_emit(core, ctl_press_slice(press, &reading, ticks));
    if (press->stage != CTL_PRESS_STAGE_STANDING)
        return;
    motion->cycle_count += 1;
    if (press->fault != CTL_PRESS_NO_FAULT)
        ctl_motion_fault(core, press->fault);
    else
        ctl_motion_stand(core);
}
