/* SPDX-License-Identifier: Apache-2.0 */
/* Turns one axis slowly, for a measurement; the state is that of a jog. */
#include "motion/ctl_motion.h"

#include "base/ctl_words.h"

#define HUNDREDTHS 100

_Static_assert(CTL_REG_MEASURE_BAG - CTL_REG_MEASURE_STATE + 2u == CTL_GROUP_MEASURE,
               "ctl_measure_registers() fills the group");

int64_t ctl_motion_turn(const ctl_motion* motion, uint16_t axis)
{
    if (axis == CTL_MEASURED_AXIS_FILM)
        return (int64_t)ctl_parameter32(motion->board, CTL_REG_PARAMETER_FILM_PULSES) * CTL_FINE;
    if (axis == CTL_MEASURED_AXIS_INFEED)
        return (int64_t)ctl_parameter32(motion->board, CTL_REG_PARAMETER_FLIGHT_PULSES) * CTL_FINE;
    return (int64_t)ctl_bank_revolution_pulses(ctl_active_bank(motion->banks), 1) * CTL_FINE;
}

void ctl_motion_measure(ctl_motion* motion, uint16_t axis, uint16_t turns)
{
    int64_t stale_mark;
    (void)motion->board->port.index(motion->board->port.context, &stale_mark);
    ctl_motion_begin_manual(motion, ctl_parameter32(motion->board, CTL_REG_PARAMETER_HOME_FREQUENCY), 1);
    if (axis != CTL_MEASURED_AXIS_KNIFE)
        ctl_packer_begin_by_hand(motion->packer, ctl_active_bank(motion->banks), motion->banks->active_crc);
    ctl_measure_begin(&motion->measure, axis, turns, ctl_motion_turn(motion, axis));
    motion->measures = true;
    motion->state = CTL_STATE_JOGGING;
}

/* Marks count at full speed: before it an input's delay is another way. */
static void look_for_mark(ctl_motion* motion)
{
    ctl_measure* measure = &motion->measure;
    const bool steady = motion->ramp.speed == motion->ramp.full;
    if (measure->axis == CTL_MEASURED_AXIS_KNIFE) {
        int64_t at = 0;
        if (motion->board->port.index(motion->board->port.context, &at) && steady)
            ctl_measure_mark(measure, at * CTL_FINE);
        return;
    }
    const bool is_film = measure->axis == CTL_MEASURED_AXIS_FILM;
    const uint32_t bit = is_film ? CTL_INPUT_BIT_FILM_INDEX : CTL_INPUT_BIT_INFEED_INDEX;
    const bool on = (*motion->inputs & 1u << bit) != 0;
    if (on && !measure->on && steady)
        ctl_measure_mark(measure, is_film ? motion->packer->film_actual : motion->packer->infeed_actual);
    measure->on = on;
}

static void move_axis(ctl_motion* motion, const ctl_pace* pace, uint32_t travelled)
{
    ctl_measure* measure = &motion->measure;
    if (measure->axis == CTL_MEASURED_AXIS_KNIFE) {
        ctl_measure_move(measure,
                         (int64_t)ctl_motion_move_by_hand(motion, *pace, travelled, UINT64_MAX) * CTL_FINE);
        return;
    }
    const uint64_t sum = (uint64_t)travelled * motion->manual_hz * CTL_FINE + measure->rest;
    const uint32_t clock_hz = motion->board->config.timer_clock_hz;
    const int64_t way = (int64_t)(sum / clock_hz);
    measure->rest = sum % clock_hz;
    ctl_packer_feed_by_hand(motion->packer,
                            measure->axis == CTL_MEASURED_AXIS_FILM ? CTL_AXIS_FILM : CTL_AXIS_INFEED, way);
    ctl_measure_move(measure, way);
}

void ctl_motion_slice_measure(ctl_motion* motion, const ctl_pace* pace)
{
    ctl_measure* measure = &motion->measure;
    if (ctl_heartbeat_lost(motion->heartbeat, motion->board))
        ctl_measure_end(measure, CTL_REFUSAL_HEARTBEAT_LOST);
    if (measure->axis == CTL_MEASURED_AXIS_KNIFE && ctl_motion_force_forbids(motion))
        ctl_measure_end(measure, CTL_REFUSAL_NONE);
    look_for_mark(motion);
    move_axis(motion, pace,
              ctl_measure_moves(measure) ? ctl_ramp_up(&motion->ramp, pace->ticks)
                                         : ctl_ramp_down(&motion->ramp, pace->ticks));
    if (ctl_measure_moves(measure) || motion->ramp.speed != 0)
        return;
    motion->measures = false;
    motion->heartbeat->jog_blocked = true; /* a key that is held then must be let go first */
    ctl_motion_stand(motion);
}

void ctl_measure_registers(const ctl_motion* motion, uint16_t* registers)
{
    const ctl_measure* measure = &motion->measure;
    const ctl_packer* packer = motion->packer;
    const bool counted = measure->turns != 0;
    const int64_t divisor = (int64_t)CTL_FINE * (counted ? measure->turns : 1);
    const int64_t sum = counted ? (measure->last - measure->first) * HUNDREDTHS : 0;
    const int64_t spread = counted ? (measure->longest - measure->shortest) * HUNDREDTHS : 0;
    registers[0] = measure->state;
    registers[1] = measure->axis;
    registers[2] = measure->turns;
    registers[3] = measure->reason;
    ctl_put32(&registers[4], (uint32_t)((sum + divisor / 2) / divisor));
    ctl_put32(&registers[6], (uint32_t)(spread / CTL_FINE));
    ctl_put32(&registers[8], (uint32_t)((packer->bag_film * HUNDREDTHS + CTL_FINE / 2) / CTL_FINE));
    ctl_put32(&registers[10], packer->bags);
}
