/* SPDX-License-Identifier: Apache-2.0 */
#include "machine/whole_line.h"

#include "base/ctl_words.h"
#include "engine/ctl_step.h"
#include "machine/whole_machine.h"

#include <stddef.h>

#define FULL_CIRCLE 36000
#define PPM 1000000
#define PRODUCT_SHARE 60   /* of a bag, per cent */
#define MISPLACED_SHARE 35 /* of a bag, per cent */
#define MARK_UM 5000       /* length of a printed mark */

int64_t whole_floor(int64_t value, int64_t divisor)
{
    const int64_t quotient = value / divisor;
    return value % divisor < 0 ? quotient - 1 : quotient;
}

static whole_line* line_of(void* context)
{
    return &((whole_machine*)context)->line;
}

static int64_t film_position(void* context)
{
    return line_of(context)->film * CTL_FINE;
}

static int64_t infeed_position(void* context)
{
    return line_of(context)->infeed * CTL_FINE;
}

static bool take_mark(void* context, int64_t* film_at_edge, bool* covered)
{
    whole_line* line = line_of(context);
    if (!line->has_knife)
        return false;
    const int64_t edge = line->mark_there ? line->next_mark + line->mark_length : line->next_mark;
    if (edge > line->film * CTL_FINE)
        return false;
    if (line->mark_there)
        line->next_mark += line->bag + line->bag * line->disturbance.stretch_ppm / PPM;
    line->mark_there = !line->mark_there;
    *film_at_edge = whole_shaft_latch(&line->shaft, &line->shaft.film, edge);
    *covered = line->mark_there;
    return true;
}

static bool every(uint32_t number, uint32_t period)
{
    return period != 0 && number % period == period - 1u;
}

/* Where the edge of the next product is that comes to the eye. */
static int64_t next_edge(whole_line* line)
{
    while (!line->covered && every(line->number, line->disturbance.missing_every))
        line->number += 1;
    int64_t place = line->first_product + line->flight * line->number;
    if (every(line->number, line->disturbance.misplaced_every))
        place += line->flight * MISPLACED_SHARE / 100;
    return line->covered ? place + line->product : place;
}

static bool take_edge(void* context, int64_t* infeed_at_edge, bool* covered)
{
    whole_line* line = line_of(context);
    if (!line->has_knife)
        return false;
    if (line->edge > line->infeed * CTL_FINE)
        return false;
    line->covered = !line->covered;
    if (!line->covered)
        line->number += 1;
    *infeed_at_edge = whole_shaft_latch(&line->shaft, &line->shaft.infeed, line->edge);
    *covered = line->covered;
    line->edge = next_edge(line);
    return true;
}

void whole_line_init(whole_line* line, whole_disturbance disturbance)
{
    *line = (whole_line){.disturbance = disturbance, .fresh_film = -1};
}

void whole_line_connect(ctl_port* port)
{
    port->film = film_position;
    port->infeed = infeed_position;
    port->mark = take_mark;
    port->eye = take_edge;
}

static void read_shaft(void* context, uint16_t signal, ctl_master_input* input)
{
    (void)signal;
    whole_shaft_read(&line_of(context)->shaft, input);
}

static void latch_shaft(void* context, bool on)
{
    line_of(context)->shaft.latches = on;
}

void whole_line_connect_shaft(ctl_port* port)
{
    port->master = read_shaft;
    port->latch_master = latch_shaft;
}

/* Pulses of the table from the start of its cycle to a master angle. */
static int64_t pulses_at(const ctl_bank* bank, uint32_t angle)
{
    uint64_t ticks = (uint64_t)ctl_bank_cycle_ticks(bank) * angle / FULL_CIRCLE;
    int64_t sum = 0;
    for (uint32_t i = 0; i < ctl_bank_row_count(bank) && ticks != 0; ++i) {
        const ctl_row row = ctl_step_row(bank, i);
        const uint64_t part = ticks < row.ticks ? ticks : row.ticks;
        sum += (int64_t)(row.pulses * part / row.ticks);
        ticks -= part;
    }
    return sum;
}

/* The film is printed for the program's bags, and its next mark lies so that the cuts are in register. */
static void set_up_film(whole_line* line, const ctl_core* core, uint32_t angle)
{
    const int64_t distance =
        ctl_packer_film(&core->packer, ctl_parameter32(&core->board, CTL_REG_PARAMETER_MARK_DISTANCE));
    const int64_t first_cut = line->film * CTL_FINE + line->bag * angle / FULL_CIRCLE;
    line->next_mark = first_cut - distance + (distance / line->bag + 1) * line->bag;
    line->mark_there = false;
}

/* Products come under the eye so that the middle of each is laid at the cut's angle. */
static void set_up_infeed(whole_line* line, const ctl_core* core, uint32_t angle, int64_t bag_um)
{
    const ctl_board* board = &core->board;
    const int64_t pitch_um = ctl_parameter32(board, CTL_REG_PARAMETER_FLIGHT_PITCH);
    const int64_t eye_um = ctl_parameter32(board, CTL_REG_PARAMETER_EYE_DISTANCE);
    line->flight = (int64_t)ctl_parameter32(board, CTL_REG_PARAMETER_FLIGHT_PULSES) * CTL_FINE;
    line->product = line->flight * (bag_um * PRODUCT_SHARE / 100) / pitch_um;
    const int64_t place =
        line->flight * angle / FULL_CIRCLE - line->flight * eye_um / pitch_um - line->product / 2;
    const int64_t here = line->infeed * CTL_FINE;
    line->first_product = place + (whole_floor(here - place, line->flight) + 1) * line->flight;
    line->number = 0;
    line->covered = false;
    line->edge = next_edge(line);
}

void whole_line_set_up(whole_line* line, const ctl_core* core, int64_t mark)
{
    const ctl_bank* bank = ctl_active_bank(&core->banks);
    line->has_knife = ctl_bank_kind(bank) == CTL_PROGRAM_KIND_ROTARY_CUTTER;
    line->cut_before = false;
    if (!line->has_knife)
        return;
    const uint16_t* header = bank->registers;
    const uint32_t angle = header[CTL_OFFSET_BANK_CUT_ANGLE];
    const int64_t bag_um = ctl_get32(&header[CTL_OFFSET_PROGRAM_BAG_LENGTH]);
    line->stroke = (uint64_t)ctl_get32(&header[CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV]) *
                   header[CTL_OFFSET_PROGRAM_GEAR_NUMERATOR];
    line->parts = (uint32_t)header[CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR] * header[CTL_OFFSET_PROGRAM_KNIVES];
    line->first_cut = mark + pulses_at(bank, angle);
    line->bag = ctl_packer_film(&core->packer, bag_um);
    line->mark_length = ctl_packer_film(&core->packer, MARK_UM);
    set_up_film(line, core, angle);
    set_up_infeed(line, core, angle, bag_um);
    if (line->shaft.counts_per_s != 0)
        whole_shaft_set_up(&line->shaft, core, line->flight);
}

/* Cuts from the first one to this position of the main drive. */
static int64_t cuts_until(const whole_line* line, int64_t position)
{
    return whole_floor((position - line->first_cut) * line->parts, (int64_t)line->stroke);
}

static void pass_cut(whole_line* line, int64_t before, int64_t now)
{
    const int64_t cuts = cuts_until(line, now);
    if (now == before || cuts <= cuts_until(line, before))
        return;
    const int64_t at = line->first_cut + cuts * (int64_t)line->stroke / line->parts;
    line->fresh_film = line->film_before * CTL_FINE +
                       (line->film - line->film_before) * CTL_FINE * (at - before) / (now - before);
}

void whole_line_turn_shaft(whole_line* line, uint32_t us)
{
    whole_shaft* shaft = &line->shaft;
    if (shaft->counts_per_s == 0)
        return;
    whole_shaft_turn(shaft, us);
    if (!shaft->drives_film)
        return;
    line->film = whole_floor(shaft->film.at, CTL_FINE);
    line->infeed = whole_floor(shaft->infeed.at, CTL_FINE);
}

void whole_line_follow(whole_line* line, ctl_core* core, int64_t before, int64_t now)
{
    if (line->has_knife)
        pass_cut(line, before, now);
    line->film_before = line->film;
    const int64_t film = line->fresh_film;
    line->fresh_film = -1;
    if (core->motion.manual &&
        !core->motion.in_phase) { /* the knife was turned by hand: the bag's length says nothing */
        line->cut_before = false;
        return;
    }
    if (film < 0)
        return;
    ctl_on_cut(core, whole_shaft_latch(&line->shaft, &line->shaft.film, film));
    if (line->cut_before)
        ctl_on_bag_cut(core, (uint32_t)ctl_packer_um(&core->packer, film - line->cut_film));
    line->cut_film = film;
    line->cut_before = true;
}

uint16_t whole_line_inputs(const whole_line* line)
{
    uint32_t levels = 0;
    if (line->has_knife && line->covered)
        levels |= 1u << CTL_INPUT_BIT_PRODUCT_EYE;
    if (line->has_knife && line->mark_there)
        levels |= 1u << CTL_INPUT_BIT_MARK_SENSOR;
    return (uint16_t)levels;
}
