/* SPDX-License-Identifier: Apache-2.0 */
/* Checks whether a packing line can run a program with these parameters; tells how fast its axes are. */
#include "packer/ctl_packer.h"

#include "base/ctl_words.h"

#include <stddef.h>

/* In tenths of a cycle: the sealing window at most; in parts of it: each ramp beside it at least. */
#define WIDEST_WINDOW 9u
#define SHORTEST_RAMP 40u
#define MAX_FLIGHTS_TO_EYE 8u
#define US_PER_S 1000000u
#define TENTH_UM 100u /* of a mm */

static uint16_t parameter(const ctl_packer* packer, uint32_t address)
{
    return ctl_parameter16(packer->board, address);
}

uint32_t ctl_packer_eye_dead_us(const ctl_packer* packer)
{
    const uint16_t begin = parameter(packer, CTL_REG_PARAMETER_EYE_DEAD_TIME);
    const uint16_t end = parameter(packer, CTL_REG_PARAMETER_EYE_END_DEAD_TIME);
    return begin > end ? begin : end;
}

/* The eye must have seen the place of a product before the film is told to wait for it, and before it is told
 * to go on. */
static bool eye_too_near(const ctl_packer* packer, const ctl_bank* bank)
{
    const uint64_t cycle = ctl_bank_cycle_ticks(bank);
    const uint64_t cut = ctl_packer_ticks_at(bank, CTL_OFFSET_BANK_CUT_ANGLE);
    const uint64_t to_slow = cycle + cycle / 2u + cut - ctl_packer_ticks_at(bank, CTL_OFFSET_BANK_SYNC_END);
    const uint64_t to_gain = cycle / 2u + cut + ctl_packer_ticks_at(bank, CTL_OFFSET_BANK_SYNC_START);
    const uint64_t dead =
        (uint64_t)ctl_packer_eye_dead_us(packer) * packer->board->config.timer_clock_hz / US_PER_S;
    const int16_t forward = ctl_trim_um(packer->board, CTL_REG_HAND_PRODUCT);
    const uint64_t back = forward < 0 ? cycle * (uint64_t)-forward / ctl_bank_bag_um(bank) : 0u;
    const uint64_t cycles = (to_slow > to_gain ? to_slow : to_gain) + cycle / 10u + dead + back;
    const uint64_t pitch = ctl_parameter32(packer->board, CTL_REG_PARAMETER_FLIGHT_PITCH);
    const uint64_t eye = ctl_parameter32(packer->board, CTL_REG_PARAMETER_EYE_DISTANCE);
    return eye * cycle < pitch * cycles || eye > pitch * MAX_FLIGHTS_TO_EYE;
}

static bool no_room(const ctl_bank* bank)
{
    const uint32_t cycle = ctl_bank_cycle_ticks(bank);
    const uint32_t engage = ctl_packer_ticks_at(bank, CTL_OFFSET_BANK_SYNC_START);
    const uint32_t release = ctl_packer_ticks_at(bank, CTL_OFFSET_BANK_SYNC_END);
    const uint32_t cut = ctl_packer_ticks_at(bank, CTL_OFFSET_BANK_CUT_ANGLE);
    return cut < engage || cut > release || release <= engage || cycle - release < cycle / SHORTEST_RAMP ||
           engage < cycle / SHORTEST_RAMP || release - engage > cycle / 10u * WIDEST_WINDOW;
}

/* Returns the pulses per second at full speed of an axis that feeds `feed` / 256 pulses per cycle. */
static uint64_t full_speed_hz(const ctl_packer* packer, const ctl_bank* bank, uint64_t feed)
{
    return feed / CTL_FINE * packer->board->config.timer_clock_hz / ctl_bank_cycle_ticks(bank);
}

/* The same with `part` / `whole` more in a correction. */
static uint64_t max_hz(uint64_t hz, uint32_t part, uint32_t whole)
{
    return hz + hz * part / whole;
}

/* A bag is corrected by at most a tenth of its length or its limits, beside the sealing window; 3 x^2 - 2 x^3
 * is at most 1.5 times as steep as its mean. */
static bool too_fast(const ctl_packer* packer, const ctl_bank* bank)
{
    const uint32_t cycle = ctl_bank_cycle_ticks(bank);
    const uint32_t outside = cycle - ctl_packer_ticks_at(bank, CTL_OFFSET_BANK_SYNC_END) +
                             ctl_packer_ticks_at(bank, CTL_OFFSET_BANK_SYNC_START);
    const uint64_t bag = (uint64_t)ctl_packer_film(packer, ctl_bank_bag_um(bank));
    const uint64_t flight =
        (uint64_t)ctl_parameter32(packer->board, CTL_REG_PARAMETER_FLIGHT_PULSES) * CTL_FINE;
    const uint32_t limit = packer->board->config.max_pulse_hz;
    return max_hz(full_speed_hz(packer, bank, bag), cycle / 20u * 3u, outside) > limit ||
           max_hz(full_speed_hz(packer, bank, flight), 3u, 2u * CTL_INFEED_CYCLES) > limit;
}

/* A product has its pulse of the date coder only when it is on the film. */
static bool coder_too_far(const ctl_packer* packer, uint32_t bag_um)
{
    const int32_t place_um =
        (int16_t)packer->board->signal[CTL_REG_SIGNAL_CODER_PLACE - CTL_REG_SIGNAL_START_BUTTON_CONTACT] *
        (int32_t)TENTH_UM;
    const uint32_t distance_um = ctl_parameter32(packer->board, CTL_REG_PARAMETER_PRODUCT_DISTANCE);
    return place_um > 0 && (uint32_t)place_um > distance_um - distance_um % bag_um + bag_um / 2u;
}

uint16_t ctl_packer_refusal(const ctl_packer* packer, const ctl_bank* bank)
{
    if (!ctl_packer_drives(packer, bank))
        return CTL_REFUSAL_NONE;
    const uint32_t bag = ctl_bank_bag_um(bank);
    if (no_room(bank))
        return CTL_REFUSAL_NO_ROOM_TO_CORRECT;
    if (too_fast(packer, bank))
        return CTL_REFUSAL_FEED_TOO_FAST;
    if ((parameter(packer, CTL_REG_PARAMETER_JAWS_BEFORE) == 0) !=
        (parameter(packer, CTL_REG_PARAMETER_JAWS_BEHIND) == 0))
        return CTL_REFUSAL_JAWS_EXCLUDE_CUT;
    if (parameter(packer, CTL_REG_PARAMETER_MARK_TRACKING) != 0) {
        const uint64_t distance = ctl_parameter32(packer->board, CTL_REG_PARAMETER_MARK_DISTANCE) +
                                  (uint64_t)ctl_parameter32(packer->board, CTL_REG_PARAMETER_MARK_OFFSET);
        if (distance > (uint64_t)bag * (CTL_WAITING_MARKS - 3u))
            return CTL_REFUSAL_SENSOR_TOO_FAR;
        const uint32_t window = parameter(packer, CTL_REG_PARAMETER_MARK_WINDOW);
        if (4u * window > bag)
            return CTL_REFUSAL_MARK_WINDOW_TOO_WIDE;
        const uint16_t widest = parameter(packer, CTL_REG_PARAMETER_MARK_WIDTH_MAX);
        if (widest != 0 && parameter(packer, CTL_REG_PARAMETER_MARK_WIDTH_MIN) > widest)
            return CTL_REFUSAL_NO_MARK_WIDTH_ALLOWED;
        const uint32_t masking = parameter(packer, CTL_REG_PARAMETER_MARK_MASKING) * TENTH_UM;
        if (masking != 0 && masking + window >= bag)
            return CTL_REFUSAL_MARK_MASKING_TOO_LONG;
    }
    if (coder_too_far(packer, bag))
        return CTL_REFUSAL_CODER_TOO_FAR;
    return eye_too_near(packer, bank) ? CTL_REFUSAL_EYE_TOO_NEAR : CTL_REFUSAL_NONE;
}

ctl_line_speed ctl_packer_full_speed(const ctl_packer* packer, const ctl_bank* bank)
{
    const int64_t film = ctl_packer_film(packer, ctl_bank_bag_um(bank));
    const uint64_t flight =
        (uint64_t)ctl_parameter32(packer->board, CTL_REG_PARAMETER_FLIGHT_PULSES) * CTL_FINE;
    const ctl_line_speed speed = {(int64_t)full_speed_hz(packer, bank, (uint64_t)film),
                                  (int64_t)full_speed_hz(packer, bank, flight)};
    return speed;
}
