/* SPDX-License-Identifier: Apache-2.0 */
#include "machine/whole_machine.h"

#include "base/ctl_words.h"

#define REVOLUTION 10000 /* pulses, while there is no program */
#define START_ANGLE 300  /* degrees from the index mark */
#define INDEX_SHARE 100  /* the mark covers its sensor for this part of a turn */
#define TOUCH_UM 75000   /* upper side of the work piece, below the upper position */
#define STIFFNESS_N_PER_MM 200
#define UM_PER_MM 1000
#define ENABLE (1u << CTL_OUTPUT_BIT_DRIVE_ENABLE)

static void take_pulses(void* context, const ctl_train* train)
{
    whole_machine* machine = context;
    if (machine->is_enabled)
        machine->position += train->direction * (int64_t)train->count;
}

static void take_feed(void* context, ctl_axis axis, int64_t from, int64_t to)
{
    whole_line* line = &((whole_machine*)context)->line;
    const int64_t way = ctl_whole_pulses(to) - ctl_whole_pulses(from);
    if (axis == CTL_AXIS_FILM)
        line->film += way;
    else
        line->infeed += way;
}

static int64_t encoder(void* context)
{
    return ((const whole_machine*)context)->position;
}

static bool take_index(void* context, int64_t* encoder_at_mark)
{
    whole_machine* machine = context;
    const bool passed = machine->index_passed;
    machine->index_passed = false;
    *encoder_at_mark = machine->index_at;
    return passed;
}

static int32_t force(void* context)
{
    const whole_machine* machine = context;
    const int64_t depth = machine->position - machine->press.top - machine->press.touch;
    return machine->has_press && depth > 0 ? (int32_t)(depth * machine->press.force_16 >> 16) : 0;
}

/* Pulses behind the last index mark, times parts. */
static int64_t behind_mark(const whole_machine* machine)
{
    const int64_t turn = (int64_t)machine->turn;
    const int64_t way = (machine->position - machine->mark) * machine->parts;
    return way - whole_floor(way, turn) * turn;
}

static uint16_t inputs(void* context)
{
    return ((const whole_machine*)context)->inputs;
}

static uint16_t levels(const whole_machine* machine)
{
    uint32_t bits = whole_line_inputs(&machine->line);
    if (!machine->has_press && behind_mark(machine) < (int64_t)machine->turn / INDEX_SHARE)
        bits |= 1u << CTL_INPUT_BIT_INDEX_MARK;
    return (uint16_t)bits;
}

static void outputs(void* context, uint32_t levels)
{
    whole_machine* machine = context;
    machine->outputs = levels;
    machine->is_enabled = (levels & ENABLE) != 0;
}

void whole_machine_init(whole_machine* machine, whole_disturbance disturbance)
{
    *machine = (whole_machine){.turn = REVOLUTION, .parts = 1, .is_enabled = true};
    machine->mark = -(int64_t)REVOLUTION * START_ANGLE / 360;
    whole_line_init(&machine->line, disturbance);
}

void whole_machine_connect(whole_machine* machine, ctl_port* port)
{
    port->context = machine;
    port->pulses = take_pulses;
    port->feed = take_feed;
    port->encoder = encoder;
    port->index = take_index;
    port->force = force;
    port->inputs = inputs;
    port->outputs = outputs;
    whole_line_connect(port);
}

/* Sets the pulses from mark to mark; the shaft keeps its angle. */
static void turn_by(whole_machine* machine, uint64_t turn, uint32_t parts)
{
    const int64_t behind = behind_mark(machine);
    const int64_t angle = behind * REVOLUTION / (int64_t)machine->turn;
    machine->turn = turn;
    machine->parts = parts;
    machine->mark = machine->position - (int64_t)turn * angle / REVOLUTION / parts;
}

static void set_up_press(whole_machine* machine, const ctl_bank* bank)
{
    const uint32_t feed_um = ctl_get32(&bank->registers[CTL_OFFSET_PRESS_FEED]);
    const uint32_t pulses = ctl_get32(&bank->registers[CTL_OFFSET_PRESS_PULSES_PER_MOTOR_REV]);
    machine->press.top = machine->position;
    machine->press.touch = (int64_t)TOUCH_UM * pulses / feed_um;
    machine->press.force_16 = (uint32_t)(((uint64_t)feed_um * STIFFNESS_N_PER_MM << 16) / UM_PER_MM / pulses);
}

static void set_up(whole_machine* machine, const ctl_core* core)
{
    const ctl_bank* bank = ctl_active_bank(&core->banks);
    const bool has_knife = ctl_bank_kind(bank) == CTL_PROGRAM_KIND_ROTARY_CUTTER;
    const uint32_t parts = has_knife ? bank->registers[CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR] : 1u;
    const uint64_t turn =
        has_knife ? (uint64_t)ctl_get32(&bank->registers[CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV]) *
                        bank->registers[CTL_OFFSET_PROGRAM_GEAR_NUMERATOR]
                  : ctl_bank_revolution_pulses(bank, 1);
    if (turn != machine->turn || parts != machine->parts)
        turn_by(machine, turn, parts);
    const bool had_press = machine->has_press;
    machine->has_press = ctl_bank_kind(bank) == CTL_PROGRAM_KIND_PRESS;
    if (machine->has_press && !had_press)
        set_up_press(machine, bank);
    whole_line_set_up(&machine->line, core, machine->mark);
}

static void pass_index(whole_machine* machine)
{
    const int64_t turn = (int64_t)machine->turn;
    const int64_t turns = whole_floor((machine->position - machine->mark) * machine->parts, turn);
    if (turns <= whole_floor((machine->before - machine->mark) * machine->parts, turn))
        return;
    machine->index_passed = true;
    machine->index_at = machine->mark + turns * turn / machine->parts;
}

void whole_machine_follow(whole_machine* machine, ctl_core* core)
{
    if (core->banks.has_active && core->banks.generation != machine->generation) {
        machine->generation = core->banks.generation;
        set_up(machine, core);
    }
    if (machine->position != machine->before)
        pass_index(machine);
    whole_line_follow(&machine->line, core, machine->before, machine->position);
    machine->before = machine->position;
    machine->inputs = levels(machine);
}
