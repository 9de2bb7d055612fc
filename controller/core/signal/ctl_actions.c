/* SPDX-License-Identifier: Apache-2.0 */
#include "signal/ctl_actions.h"

#define INPUT(name) (1u << CTL_INPUT_BIT_##name)
#define AT_CYCLE_END (INPUT(STOP_BUTTON) | INPUT(NEXT_MACHINE) | INPUT(CODER))
#define ENDS_A_RUN (INPUT(EMERGENCY_STOP) | INPUT(DOOR) | AT_CYCLE_END)

void ctl_actions_init(ctl_actions* actions, const ctl_io* io)
{
    actions->inputs = io->inputs;
}

void ctl_actions_slice(ctl_actions* actions, const ctl_io* io, ctl_motion* motion)
{
    const uint32_t pressed = io->inputs & ~(uint32_t)actions->inputs;
    actions->inputs = io->inputs;
    if ((pressed & AT_CYCLE_END) != 0)
        ctl_motion_stop_unattended(motion);
    if ((pressed & INPUT(DOOR)) != 0)
        ctl_measure_end(&motion->measure, CTL_REFUSAL_DOOR_OPEN);
    /* The film is threaded with the door open, so that a jog goes on. */
    if ((pressed & INPUT(DOOR)) != 0 && motion->state != CTL_STATE_JOGGING && !ctl_motion_standstill(motion))
        ctl_motion_emergency_stop(motion);
    if ((pressed & (INPUT(START_BUTTON) | INPUT(BAG_BUTTON))) != 0) {
        actions->wants = (pressed & INPUT(BAG_BUTTON)) != 0 ? CTL_COMMAND_JOG_BAG : CTL_COMMAND_START;
        actions->presses += 1;
    }
    if ((pressed & ENDS_A_RUN) != 0)
        actions->wants = CTL_COMMAND_NONE;
}
