/* SPDX-License-Identifier: Apache-2.0 */
#include "motion/ctl_measure.h"

#include "ctl_registers.h"

#define MISSING_TURNS 4 /* without a mark */
#define SMALL_PART 4    /* of a turn */

void ctl_measure_begin(ctl_measure* measure, uint16_t axis, uint16_t turns, int64_t turn)
{
    *measure = (ctl_measure){
        .state = CTL_MEASURE_STATE_MOVING,
        .axis = axis,
        .wanted = turns,
        .on = true, /* a mark that is there now has no edge */
        .turn = turn,
        .left = turns == 0 ? turn / SMALL_PART : MISSING_TURNS * turn,
        .shortest = INT64_MAX,
    };
}

void ctl_measure_mark(ctl_measure* measure, int64_t at)
{
    if (!ctl_measure_moves(measure) || measure->wanted == 0)
        return;
    const int64_t way = at - measure->last;
    measure->left = MISSING_TURNS * measure->turn;
    measure->last = at;
    if (!measure->marked) {
        measure->marked = true;
        measure->first = at;
        return;
    }
    measure->turns = (uint16_t)(measure->turns + 1u);
    measure->shortest = way < measure->shortest ? way : measure->shortest;
    measure->longest = way > measure->longest ? way : measure->longest;
    if (measure->turns == measure->wanted)
        measure->state = CTL_MEASURE_STATE_DONE;
}

void ctl_measure_move(ctl_measure* measure, int64_t way)
{
    measure->left -= way;
    if (measure->left > 0 || !ctl_measure_moves(measure))
        return;
    if (measure->wanted == 0)
        measure->state = CTL_MEASURE_STATE_DONE;
    else
        ctl_measure_end(measure, CTL_REFUSAL_NO_INDEX_MARK);
}

void ctl_measure_end(ctl_measure* measure, uint16_t reason)
{
    if (!ctl_measure_moves(measure))
        return;
    measure->state = CTL_MEASURE_STATE_ENDED;
    measure->reason = reason;
}

bool ctl_measure_moves(const ctl_measure* measure)
{
    return measure->state == CTL_MEASURE_STATE_MOVING;
}
