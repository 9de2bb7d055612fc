// SPDX-License-Identifier: Apache-2.0
// A packing machine's film, made up; see demo_packing.h.
#include "tests/looks/demo_packing.h"

#include "modbus/map/codec.h"
#include "modbus/map/mark_edges.h"
#include "tests/support/packer_image.h"

#include <cmath>
#include <random>
#include <unordered_map>

namespace campanel::looks {
namespace {

using Trouble = DemoFilm::Trouble;

constexpr std::uint16_t nothing = 0x8000;
constexpr double sensorMm = 900;
constexpr double stepsPerMm = 10; // of the picture
constexpr double umPerMm = 1000;
constexpr double meanMm = 0.02;
constexpr double scatterMm = 0.03;
constexpr double markErrorMm = 0.04;
constexpr double productMm = 150;
constexpr double misplacedMm = 90; // the product across, by which it lies too far back
constexpr int misplacedBag = 0;    // of those before the knife
constexpr int missedMark = 2;
constexpr int missingProduct = 3;
constexpr double filmSavedM = 37.25;
constexpr double printedMm = 0.31; // the marks are farther apart than the bag is long
constexpr std::uint32_t marksToMissing = 11;
constexpr std::uint32_t marksToMisplaced = 5;
constexpr double misplacedMarkMm = 9.4; // behind its window
constexpr double edgeStepsPerMm = 100;
constexpr double bandFromDeg = -45; // of the knife's torque, from the cut
constexpr double bandToDeg = 10;
constexpr double stepsPerPercent = 10;

// Sets one place of the film picture; `isSpecial` is its last bit.
void setPlace(test::PackerImage& image, const char* name, std::size_t index, double mm,
              bool isSpecial = false)
{
    const auto steps = static_cast<std::uint32_t>(std::lround(stepsPerMm * mm));
    image.setRaw(name, index, static_cast<std::uint16_t>((steps & 0xFFFEU) | (isSpecial ? 1U : 0U)));
}

std::uint16_t micrometres(double mm)
{
    return static_cast<std::uint16_t>(std::lround(umPerMm * mm));
}

std::size_t countOf(const char* name)
{
    return modbus::findRegister(name)->count;
}

void setBags(test::PackerImage& image, std::uint32_t newest)
{
    image.set("packer.bag_number", newest);
    for (std::uint32_t bag = newest - modbus::bagRecords + 1; bag <= newest; ++bag) {
        const std::size_t at = 4 * (bag % modbus::bagRecords);
        image.setRaw("packer.bags", at, micrometres(demoDeviationMm(bag)));
        image.setRaw("packer.bags", at + 1, micrometres(demoDeviationMm(bag + 1) + markErrorMm));
        image.setRaw("packer.bags", at + 3, 1U << 8 | 1U); // of one length, by its mark
    }
}

void setFilm(test::PackerImage& image, const DemoFilm& film)
{
    const double toCutMm = film.bagMm * (1 - film.cycleShare);
    image.set("packer.film_position", film.bagMm * (film.bags % 1000 + film.cycleShare));
    const bool isAcross = film.trouble == Trouble::ProductAcross;
    for (std::size_t i = 0; i < countOf("packer.cuts"); ++i)
        setPlace(image, "packer.cuts", i, toCutMm + static_cast<double>(i) * film.bagMm,
                 isAcross && i == misplacedBag);
    const std::size_t marks = countOf("packer.seen_marks");
    for (std::size_t i = 0; i < marks; ++i) {
        const double atMm = toCutMm + static_cast<double>(i) * film.bagMm;
        if (atMm > sensorMm || film.trouble == Trouble::MarksLost || film.trouble == Trouble::NotStarted)
            image.setRaw("packer.seen_marks", i, nothing);
        else
            setPlace(image, "packer.seen_marks", i, atMm, i == missedMark);
    }
    const std::size_t products = countOf("packer.seen_products") / 2;
    for (std::size_t i = 0; i < products; ++i) {
        const int bag = static_cast<int>(i) - 1; // the first one is past the knife
        const double offMm = isAcross && bag == misplacedBag ? misplacedMm : 0;
        const double leadMm = toCutMm + bag * film.bagMm - (film.bagMm - productMm) / 2 - productMm + offMm;
        const bool isThere = bag != missingProduct && leadMm < sensorMm;
        if (isThere)
            setPlace(image, "packer.seen_products", 2 * i, leadMm);
        else
            image.setRaw("packer.seen_products", 2 * i, nothing);
        setPlace(image, "packer.seen_products", 2 * i + 1, leadMm + productMm);
    }
}

} // namespace

double demoDeviationMm(std::uint32_t bag)
{
    static std::unordered_map<std::uint32_t, double> known; // a generator for each bag takes long to seed
    const auto [place, isNew] = known.try_emplace(bag, 0);
    if (isNew) {
        std::mt19937 random(bag);
        std::normal_distribution<double> deviation(meanMm, scatterMm);
        place->second = std::round(umPerMm * deviation(random)) / umPerMm;
    }
    return place->second;
}

std::vector<std::uint16_t> demoEdges(const DemoFilm& film)
{
    std::vector<std::uint16_t> registers(modbus::sensorRegisters);
    const auto setWide = [&registers](std::size_t at, std::uint32_t value) {
        registers[at] = static_cast<std::uint16_t>(value >> 16U);
        registers[at + 1] = static_cast<std::uint16_t>(value);
    };
    setWide(0, film.bags);
    for (std::uint32_t back = 0; back < modbus::edgeRecords; ++back) {
        const std::uint32_t edge = film.bags - back;
        const std::size_t at = 2 + 8 * (edge % modbus::edgeRecords);
        const bool isMisplaced = edge % marksToMisplaced == 2;
        const double offMm = isMisplaced ? misplacedMarkMm : demoDeviationMm(edge);
        const std::uint32_t mark = edge + edge / marksToMissing;
        setWide(at, static_cast<std::uint32_t>(
                        std::llround(umPerMm * (mark % 1'000'000 * (film.bagMm + printedMm) + offMm))));
        registers[at + 2] = static_cast<std::uint16_t>(std::lround(edgeStepsPerMm * offMm));
        registers[at + 5] = static_cast<std::uint16_t>(isMisplaced ? modbus::MarkVerdict::OutsideWindow
                                                                   : modbus::MarkVerdict::Taken);
    }
    return registers;
}

std::vector<std::uint16_t> demoJam(modbus::JamState state, bool hasJammed)
{
    std::vector<std::uint16_t> registers(modbus::jamRegisters);
    const auto put = [&registers](const char* name, double value, std::size_t at = 0) {
        const modbus::RegisterInfo& info = modbus::registerNamed(name);
        registers[info.address - modbus::jamAddress + at] =
            static_cast<std::uint16_t>(std::lround(value / info.scale));
    };
    const bool isSlow = state == modbus::JamState::TooSlow;
    put("jam.state", static_cast<double>(state));
    put("jam.interval", isSlow ? 10 : 1);
    put("jam.band_from", bandFromDeg);
    put("jam.band_to", bandToDeg);
    put("jam.residue_number", 12, 1);
    put("jam.residue", 0.18);
    if (hasJammed) {
        put("jam.number", 2);
        put("jam.source", static_cast<double>(modbus::JamSource::Torque));
        put("jam.angle", -16.4);
        put("jam.torque", 71.2);
        put("jam.limit", 40.1);
        put("jam.run_on", 7.9);
    }
    for (std::size_t part = 0; part < modbus::jamBins && !isSlow; ++part) {
        const double deg = bandFromDeg + (bandToDeg - bandFromDeg) * (static_cast<double>(part) + 0.5) /
                                             static_cast<double>(modbus::jamBins);
        const double expected = 30 - 0.15 * deg + 22 * std::exp(-deg * deg / 40);
        put("jam.expected", stepsPerPercent * expected, part); // blocks have no scale
        put("jam.width", stepsPerPercent * (5 + 0.08 * expected), part);
    }
    return registers;
}

std::vector<std::uint16_t> demoPacker(const DemoFilm& film)
{
    test::PackerImage image;
    const bool areMarksLost = film.trouble == Trouble::MarksLost;
    const auto state = areMarksLost                          ? modbus::MarkState::Searching
                       : film.trouble == Trouble::NotStarted ? modbus::MarkState::Off
                                                             : modbus::MarkState::Tracking;
    image.set("packer.mark_state", static_cast<std::uint32_t>(state));
    image.set("packer.mark_error", markErrorMm);
    image.set("packer.mark_pitch", film.bagMm + printedMm);
    image.set("packer.phase_correction", -0.012);
    image.set("packer.length_correction", 0.31);
    image.set("packer.film_following_error", 0.18);
    image.set("packer.marks", film.bags + 3);
    image.set("packer.marks_missing", areMarksLost ? 7 : 2);
    image.set("packer.marks_false", 1);
    image.set("packer.products", film.bags - 147);
    image.set("packer.cuts_skipped", 9);
    image.set("packer.empty_bags", 149);
    image.set("packer.film_saved", filmSavedM);
    const bool isAcross = film.trouble == Trouble::ProductAcross;
    const auto skip = isAcross ? modbus::SkipCause::ProductAcross : modbus::SkipCause::NoProduct;
    image.set("packer.last_skip", static_cast<std::uint32_t>(skip));
    image.set("packer.knife_gate", static_cast<std::uint32_t>(isAcross ? modbus::GateState::Standing
                                                                       : modbus::GateState::Running));
    setBags(image, film.bags);
    setFilm(image, film);
    return image.registers();
}

} // namespace campanel::looks
