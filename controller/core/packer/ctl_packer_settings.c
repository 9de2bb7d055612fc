/* SPDX-License-Identifier: Apache-2.0 */
/* The lengths of a packing line that follow from its parameters and its program. They cost many divisions, so
 * that they are computed for a start, for a change of program, and in a slice with little else to do after
 * the panel has written a parameter. */
#include "packer/ctl_packer.h"

#include "base/ctl_words.h"
#include "engine/ctl_step.h"

#include <stddef.h>

/* The maximum error of a mark that counts as slip. */
#define JUMP_UM 600
#define TENTH_UM 100 /* of a mm */
#define ROWS_AT_A_TIME 8u
#define FULL_CIRCLE 36000 /* 0.01 degrees */
#define RATIO_BITS 20u
#define FIVE_DEGREES 500

static uint16_t parameter(const ctl_packer* packer, uint32_t address)
{
    return ctl_parameter16(packer->board, address);
}

static int64_t length_limit(const ctl_packer* packer, int64_t bag)
{
    return bag * parameter(packer, CTL_REG_PARAMETER_LENGTH_LIMIT) / 10000;
}

int64_t ctl_packer_length_limit(const ctl_packer* packer)
{
    return length_limit(packer, packer->bag);
}

static int64_t film_um(const ctl_packer* packer, uint32_t address)
{
    return ctl_packer_film(packer, parameter(packer, address));
}

/* The same of a parameter in 0.1 mm. */
static int64_t film_tenths(const ctl_packer* packer, uint32_t address)
{
    return ctl_packer_film(packer, (int64_t)parameter(packer, address) * TENTH_UM);
}

static ctl_mark_settings mark_settings(const ctl_packer* packer, int64_t bag)
{
    return (ctl_mark_settings){
        .nominal = bag,
        .distance =
            ctl_packer_film(packer, (int64_t)ctl_parameter32(packer->board, CTL_REG_PARAMETER_MARK_DISTANCE) +
                                        ctl_parameter32(packer->board, CTL_REG_PARAMETER_MARK_OFFSET) +
                                        ctl_trim_um(packer->board, CTL_REG_HAND_CUT)),
        .window = film_um(packer, CTL_REG_PARAMETER_MARK_WINDOW),
        .jump = ctl_packer_film(packer, JUMP_UM),
        .masking = film_tenths(packer, CTL_REG_PARAMETER_MARK_MASKING),
        .max_difference = length_limit(packer, bag),
        .phase_gain = parameter(packer, CTL_REG_PARAMETER_PHASE_GAIN),
        .length_gain = parameter(packer, CTL_REG_PARAMETER_LENGTH_GAIN),
        .missing_limit = parameter(packer, CTL_REG_PARAMETER_MARK_MISSING_LIMIT),
    };
}

static void read_marks(ctl_packer* packer)
{
    packer->settings.marks = mark_settings(packer, packer->bag);
}

static int64_t clearance(const ctl_packer* packer)
{
    return film_um(packer, CTL_REG_PARAMETER_CUT_CLEARANCE);
}

static void read_clearance(ctl_packer* packer)
{
    packer->settings.clearance = clearance(packer);
}

static void read_phase(ctl_packer* packer)
{
    packer->settings.phase = (ctl_phase_limits){packer->bag, ctl_packer_length_limit(packer),
                                                film_um(packer, CTL_REG_PARAMETER_PHASE_LIMIT)};
}

static int64_t shaft_angle(const ctl_packer* packer, uint32_t address)
{
    return (int64_t)ctl_bank_revolution_pulses(packer->bank, 1) * parameter(packer, address) / FULL_CIRCLE;
}

static void read_jaws(ctl_packer* packer)
{
    packer->settings.jaws_before = shaft_angle(packer, CTL_REG_PARAMETER_JAWS_BEFORE);
    packer->settings.jaws_behind = shaft_angle(packer, CTL_REG_PARAMETER_JAWS_BEHIND);
}

static void read_jam(ctl_packer* packer)
{
    const int32_t five =
        (int32_t)((uint64_t)ctl_bank_revolution_pulses(packer->bank, 1) * FIVE_DEGREES / FULL_CIRCLE);
    const ctl_jam_settings settings = {
        .on = parameter(packer, CTL_REG_PARAMETER_JAM_DETECTION) != 0,
        .reports = packer->board->port.torque != NULL,
        .from = -(int32_t)shaft_angle(packer, CTL_REG_PARAMETER_JAM_CLOSING) - five,
        .to = (int32_t)packer->settings.jaws_behind + five,
        .five = five,
        .margin = parameter(packer, CTL_REG_PARAMETER_JAM_MARGIN),
    };
    ctl_jam_set(&packer->jam, &settings);
    packer->settings.jam_back = shaft_angle(packer, CTL_REG_PARAMETER_JAM_BACK);
}

static void read_sizes(ctl_packer* packer)
{
    packer->mark_sensor.narrowest = film_um(packer, CTL_REG_PARAMETER_MARK_WIDTH_MIN);
    packer->mark_sensor.widest = film_um(packer, CTL_REG_PARAMETER_MARK_WIDTH_MAX);
    packer->products.settings.maximum = film_tenths(packer, CTL_REG_PARAMETER_PRODUCT_LENGTH_MAX);
}

/* The knife's way to its cut, some rows at a time. */
static void sum_up_to_cut(ctl_packer* packer)
{
    ctl_packer_settings* settings = &packer->settings;
    for (uint32_t i = 0; i < ROWS_AT_A_TIME && settings->ticks != 0; ++i) {
        const ctl_row row = ctl_step_row(packer->bank, settings->row++);
        const uint32_t ticks = row.ticks < settings->ticks ? row.ticks : settings->ticks;
        packer->cut_pulses +=
            ticks == row.ticks ? row.pulses : (uint32_t)((uint64_t)row.pulses * ticks / row.ticks);
        settings->ticks -= ticks;
    }
}

/* The first ones are what a start needs at once. */
static void (*const pieces[])(ctl_packer* packer) = {read_clearance,
                                                     read_marks,
                                                     read_phase,
                                                     ctl_packer_read_cut_trim,
                                                     ctl_packer_read_length_trim,
                                                     ctl_packer_read_product_trim,
                                                     read_sizes,
                                                     read_jaws,
                                                     read_jam};
#define PIECES (sizeof pieces / sizeof pieces[0])
#define PIECES_OF_A_START 2u

bool ctl_packer_is_set(const ctl_packer* packer)
{
    return packer->settings.done == PIECES && packer->settings.ticks == 0;
}

bool ctl_packer_refresh_settings(ctl_packer* packer)
{
    ctl_packer_settings* settings = &packer->settings;
    if (settings->writes != packer->board->parameter_writes) {
        settings->writes = packer->board->parameter_writes;
        settings->done = 0;
    }
    if (settings->done != PIECES) {
        pieces[settings->done++](packer);
        return true;
    }
    if (settings->ticks == 0)
        return false;
    sum_up_to_cut(packer);
    return true;
}

void ctl_packer_read_settings(ctl_packer* packer)
{
    packer->busy = true;
    packer->settings.writes = packer->board->parameter_writes;
    for (packer->settings.done = 0; packer->settings.done != PIECES_OF_A_START; packer->settings.done += 1)
        pieces[packer->settings.done](packer);
}

void ctl_packer_take_settings(ctl_packer* packer)
{
    const ctl_packer_lengths* lengths = &packer->lengths;
    packer->busy = true;
    packer->settings.writes = lengths->writes;
    packer->settings.clearance = lengths->clearance;
    packer->settings.marks = lengths->marks;
    packer->settings.done = PIECES_OF_A_START;
}

static void prepare_ticks(const ctl_packer* packer, const ctl_bank* bank, ctl_packer_lengths* lengths)
{
    (void)packer;
    lengths->cycle = ctl_bank_cycle_ticks(bank);
    lengths->engage = ctl_packer_ticks_at(bank, CTL_OFFSET_BANK_SYNC_START);
    lengths->release = ctl_packer_ticks_at(bank, CTL_OFFSET_BANK_SYNC_END);
    lengths->cut = ctl_packer_ticks_at(bank, CTL_OFFSET_BANK_CUT_ANGLE);
}

/* The laying place is half a flight from the start of the infeed's count; a product comes there at the cut.
 */
static void prepare_ways(const ctl_packer* packer, const ctl_bank* bank, ctl_packer_lengths* lengths)
{
    lengths->bag = ctl_packer_film(packer, ctl_bank_bag_um(bank));
    lengths->way_to_cut =
        (int64_t)((uint64_t)lengths->bag * bank->registers[CTL_OFFSET_BANK_CUT_ANGLE] / FULL_CIRCLE);
    lengths->flight = (int64_t)ctl_parameter32(packer->board, CTL_REG_PARAMETER_FLIGHT_PULSES) * CTL_FINE;
    lengths->ahead =
        (int64_t)((uint64_t)lengths->flight * lengths->cut / lengths->cycle) - lengths->flight / 2;
    lengths->clearance = clearance(packer);
}

static void prepare_wheel(const ctl_packer* packer, const ctl_bank* bank, ctl_packer_lengths* lengths)
{
    (void)packer;
    (void)bank;
    lengths->per_tick = (lengths->bag << CTL_WHEEL_FINE) / lengths->cycle;
    lengths->per_film = ((int64_t)lengths->cycle << CTL_WHEEL_FINE) / lengths->bag;
}

static void prepare_marks(const ctl_packer* packer, const ctl_bank* bank, ctl_packer_lengths* lengths)
{
    (void)bank;
    lengths->marks = mark_settings(packer, lengths->bag);
}

/* Whole bags and a half, the nearest to the parameter: products lie in the middle between two cuts. */
static int64_t product_distance(const ctl_packer* packer, int64_t bag)
{
    const int64_t wanted =
        ctl_packer_film(packer, ctl_parameter32(packer->board, CTL_REG_PARAMETER_PRODUCT_DISTANCE));
    return wanted / bag * bag + bag / 2;
}

static void prepare_products(const ctl_packer* packer, const ctl_bank* bank, ctl_packer_lengths* lengths)
{
    (void)bank;
    const uint64_t pitch_um = ctl_parameter32(packer->board, CTL_REG_PARAMETER_FLIGHT_PITCH);
    const uint64_t pitch_film = (uint64_t)ctl_packer_film(packer, (int64_t)pitch_um);
    const int64_t flight = lengths->flight;
    lengths->products = (ctl_product_settings){
        .flight = flight,
        .lay = flight / 2,
        .eye = (int64_t)(ctl_parameter32(packer->board, CTL_REG_PARAMETER_EYE_DISTANCE) * (uint64_t)flight /
                         pitch_um),
        .ratio = (pitch_film << RATIO_BITS) / (uint64_t)flight,
        .distance = product_distance(packer, lengths->bag),
    };
}

static void (*const length_pieces[])(const ctl_packer* packer, const ctl_bank* bank,
                                     ctl_packer_lengths* lengths) = {
    prepare_ticks, prepare_ways, prepare_wheel, prepare_marks, prepare_products};
#define LENGTH_PIECES (sizeof length_pieces / sizeof length_pieces[0])

bool ctl_packer_prepare(ctl_packer* packer, const ctl_bank* bank, uint32_t crc)
{
    ctl_packer_lengths* lengths = &packer->lengths;
    if (lengths->crc != crc || lengths->writes != packer->board->parameter_writes) {
        lengths->crc = crc;
        lengths->writes = packer->board->parameter_writes;
        lengths->done = 0;
    }
    if (lengths->done == LENGTH_PIECES)
        return false;
    length_pieces[lengths->done++](packer, bank, lengths);
    return true;
}

bool ctl_packer_is_prepared(const ctl_packer* packer, uint32_t crc)
{
    const ctl_packer_lengths* lengths = &packer->lengths;
    return packer->bank == NULL || (lengths->crc == crc && lengths->done == LENGTH_PIECES &&
                                    lengths->writes == packer->board->parameter_writes);
}
