// SPDX-License-Identifier: Apache-2.0
// A packing machine's film, invented; see demo_packing.h.
#include "app/main/demo_packing.h"

#include "app/link/link_values.h"

#include <cmath>
#include <random>
#include <string_view>
#include <utility>

namespace campanel::panel {
namespace {

using Trouble = DemoFilm::Trouble;

constexpr std::uint16_t nothing = 0x8000;
constexpr double sensorMm = 900;
constexpr double stepsPerMm = 10; // resolution of the picture
constexpr double umPerMm = 1000;
constexpr double meanMm = 0.02;
constexpr double scatterMm = 0.03;
constexpr double markErrorMm = 0.04;
constexpr double productMm = 150;
constexpr double misplacedMm = 90; // offset of the product at the cut
constexpr int misplacedBag = 0;    // bag number before the knife
constexpr int missedMark = 2;
constexpr int missingProduct = 3;
constexpr double filmSavedM = 37.25;

class Registers {
public:
    void put(std::string_view name, std::uint32_t value, std::size_t at = 0)
    {
        const modbus::RegisterSpan span = *modbus::findSpan(name);
        const std::size_t index = span.address - modbus::packerAddress + at;
        m_values[index] = static_cast<std::uint16_t>(value);
    }
    void putWide(std::string_view name, std::uint32_t value)
    {
        put(name, value >> 16);
        put(name, value & 0xFFFFU, 1);
    }
    void putMm(std::string_view name, double mm, std::size_t at = 0)
    {
        put(name, static_cast<std::uint32_t>(std::lround(umPerMm * mm)), at);
    }
    // Writes a place in the picture; `special` is its last bit.
    void putPlace(std::string_view name, std::size_t at, double mm, bool special = false)
    {
        const auto steps = static_cast<std::uint32_t>(std::lround(stepsPerMm * mm));
        put(name, (steps & 0xFFFEU) | (special ? 1U : 0U), at);
    }
    std::vector<std::uint16_t> take() { return std::move(m_values); }

private:
    std::vector<std::uint16_t> m_values = std::vector<std::uint16_t>(modbus::packerRegisters);
};

void putBags(Registers& registers, std::uint32_t newest)
{
    registers.putWide("packer.bag_number", newest);
    for (std::uint32_t bag = newest - modbus::bagRecords + 1; bag <= newest; ++bag) {
        const std::size_t at = 4 * (bag % modbus::bagRecords);
        registers.putMm("packer.bags", demoDeviationMm(bag), at);
        registers.putMm("packer.bags", demoDeviationMm(bag + 1) + markErrorMm, at + 1);
        registers.put("packer.bags", 1U << 8 | 1U, at + 3); // one length, tracked
    }
}

void putFilm(Registers& registers, const DemoFilm& film)
{
    const double toCutMm = film.bagMm * (1 - film.cycleShare);
    registers.putWide(
        "packer.film_position",
        static_cast<std::uint32_t>(umPerMm * film.bagMm * (film.bags % 1000 + film.cycleShare)));
    const bool isAcross = film.trouble == Trouble::ProductAcross;
    for (std::size_t i = 0; i < modbus::findSpan("packer.cuts")->count; ++i)
        registers.putPlace("packer.cuts", i, toCutMm + static_cast<double>(i) * film.bagMm,
                           isAcross && i == misplacedBag);
    const std::size_t marks = modbus::findSpan("packer.seen_marks")->count;
    for (std::size_t i = 0; i < marks; ++i) {
        const double atMm = toCutMm + static_cast<double>(i) * film.bagMm;
        if (atMm > sensorMm || film.trouble == Trouble::MarksLost)
            registers.put("packer.seen_marks", nothing, i);
        else
            registers.putPlace("packer.seen_marks", i, atMm, i == missedMark);
    }
    const std::size_t products = modbus::findSpan("packer.seen_products")->count / 2;
    for (std::size_t i = 0; i < products; ++i) {
        const int bag = static_cast<int>(i) - 1; // the first one is past the knife
        const double offMm = isAcross && bag == misplacedBag ? misplacedMm : 0;
        const double leadMm = toCutMm + bag * film.bagMm - (film.bagMm - productMm) / 2 - productMm + offMm;
        const bool isThere = bag != missingProduct && leadMm < sensorMm;
        if (isThere)
            registers.putPlace("packer.seen_products", 2 * i, leadMm);
        else
            registers.put("packer.seen_products", nothing, 2 * i);
        registers.putPlace("packer.seen_products", 2 * i + 1, leadMm + productMm);
    }
}

} // namespace

double demoDeviationMm(std::uint32_t bag)
{
    std::mt19937 random(bag);
    std::normal_distribution<double> deviation(meanMm, scatterMm);
    return std::round(umPerMm * deviation(random)) / umPerMm;
}

std::vector<std::uint16_t> demoPacker(const DemoFilm& film)
{
    Registers registers;
    const bool areMarksLost = film.trouble == Trouble::MarksLost;
    const auto state = areMarksLost ? modbus::MarkState::Searching : modbus::MarkState::Tracking;
    registers.put("packer.mark_state", static_cast<std::uint32_t>(state));
    registers.putMm("packer.mark_error", markErrorMm);
    registers.putWide("packer.mark_pitch", static_cast<std::uint32_t>(umPerMm * (film.bagMm + 0.31)));
    registers.putMm("packer.phase_correction", -0.012);
    registers.putMm("packer.length_correction", 0.31);
    registers.putMm("packer.film_following_error", 0.18);
    registers.putWide("packer.marks", film.bags + 3);
    registers.putWide("packer.marks_missing", areMarksLost ? 7 : 2);
    registers.putWide("packer.marks_false", 1);
    registers.putWide("packer.products", film.bags - 147);
    registers.putWide("packer.cuts_skipped", 9);
    registers.putWide("packer.empty_bags", 149);
    registers.putWide("packer.film_saved", static_cast<std::uint32_t>(umPerMm * filmSavedM));
    const bool isAcross = film.trouble == Trouble::ProductAcross;
    const auto skip = isAcross ? modbus::SkipCause::ProductAcross : modbus::SkipCause::NoProduct;
    registers.put("packer.last_skip", static_cast<std::uint32_t>(skip));
    registers.put("packer.knife_gate", static_cast<std::uint32_t>(isAcross ? modbus::GateState::Standing
                                                                           : modbus::GateState::Running));
    putBags(registers, film.bags);
    putFilm(registers, film);
    return registers.take();
}

} // namespace campanel::panel
