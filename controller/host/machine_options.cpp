// SPDX-License-Identifier: Apache-2.0
#include "machine_options.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace campanel::controller {
namespace {

template <auto Part, auto Member> double& numberOf(MachineOptions& options)
{
    return options.*Part.*Member;
}

using Drive = DriveOptions;
using Jaw = JawOptions;
using Report = ReportOptions;
using Film = FilmOptions;
using Products = ProductOptions;
using Press = PressOptions;
using Sensors = SensorOptions;
using Shaft = ShaftOptions;

constexpr std::array optionTable{
    MachineOption{"film-slip", "MM", "standard deviation of the film's slip per bag", 0, 10,
                  numberOf<&MachineOptions::film, &Film::slipMm>},
    MachineOption{"film-stretch", "SHARE", "maximum slow stretch of the film; half of it is constant", 0, 0.1,
                  numberOf<&MachineOptions::film, &Film::stretch>},
    MachineOption{"film-stretch-step", "SHARE", "step of the stretch", -0.1, 0.1,
                  numberOf<&MachineOptions::film, &Film::stretchStep>},
    MachineOption{"film-stretch-step-after", "M", "film length before this step", 0, 1e6,
                  numberOf<&MachineOptions::film, &Film::stretchStepM>},
    MachineOption{"film-misplaced", "MM", "initial offset of film to marks", -1000, 1000,
                  numberOf<&MachineOptions::film, &Film::misplacedMm>},
    MachineOption{"film-slip-per-acceleration", "MM", "film behind its roll per m/s^2 of acceleration", 0, 1,
                  numberOf<&MachineOptions::film, &Film::slipPerAcceleration>},
    MachineOption{"sensor-delay-ms", "MS", "delay of mark sensor and product eye", 0, 50,
                  numberOf<&MachineOptions::sensors, &Sensors::delayMs>},
    MachineOption{"sensor-scatter-ms", "MS", "standard deviation of this delay from edge to edge", 0, 10,
                  numberOf<&MachineOptions::sensors, &Sensors::scatterMs>},
    MachineOption{"sensor-off-later-ms", "MS", "additional delay of the end of a mark or product", 0, 10,
                  numberOf<&MachineOptions::sensors, &Sensors::offLaterMs>},
    MachineOption{"mark-noise", "MM", "standard deviation of the mark sensor", 0, 10,
                  numberOf<&MachineOptions::film, &Film::markNoiseMm>},
    MachineOption{"marks-missing", "P", "share of the marks that the sensor misses", 0, 1,
                  numberOf<&MachineOptions::film, &Film::marksMissing>},
    MachineOption{"marks-false", "P", "share of the bags with a false mark", 0, 1,
                  numberOf<&MachineOptions::film, &Film::marksFalse>},
    MachineOption{"mark-width", "MM", "width of the printed marks", 0.5, 100,
                  numberOf<&MachineOptions::film, &Film::markWidthMm>},
    MachineOption{"false-mark-width", "MM", "width of false marks", 0.5, 100,
                  numberOf<&MachineOptions::film, &Film::falseWidthMm>},
    MachineOption{"print-at", "MM", "another print so far behind each mark; 0: none", 0, 2000,
                  numberOf<&MachineOptions::film, &Film::printAtMm>},
    MachineOption{"print-width", "MM", "width of this print", 0.5, 100,
                  numberOf<&MachineOptions::film, &Film::printWidthMm>},
    MachineOption{"mark-distance", "MM", "actual film length between mark sensor and knife", 10, 5000,
                  numberOf<&MachineOptions::film, &Film::markDistanceMm>},
    MachineOption{"print-error", "SHARE", "error of the printed mark distance, as a share of the bag length",
                  -0.1, 0.1, numberOf<&MachineOptions::film, &Film::printError>},
    MachineOption{"film-feed", "MM", "actual film per revolution of the film motor", 1, 2000,
                  [](MachineOptions& options) -> double& { return options.filmFeedMm; }},
    MachineOption{"film-pulses", "N", "actual pulses per revolution of the film motor", 100, 1e6,
                  [](MachineOptions& options) -> double& { return options.filmPulses; }},
    MachineOption{"flight-pulses", "N", "actual pulses of the infeed motor per product", 100, 1e7,
                  [](MachineOptions& options) -> double& { return options.flightPulses; }},
    MachineOption{"knife-pulses", "N",
                  "actual pulses per turn of the knife's shaft; 0: what the program says", 0, 1e7,
                  [](MachineOptions& options) -> double& { return options.knifePulses; }},
    MachineOption{"reversed", "BITS",
                  "sum of the axes whose motors turn the other way: 1 knife, 2 film, 4 infeed", 0, 7,
                  [](MachineOptions& options) -> double& { return options.reversed; }},
    MachineOption{"index-scatter", "DEG", "standard deviation of the index marks of film and infeed", 0, 10,
                  [](MachineOptions& options) -> double& { return options.indexScatterDegrees; }},
    MachineOption{"knife-off", "MM", "place of the second of several knives behind its own, along the film",
                  -5, 5, [](MachineOptions& options) -> double& { return options.knifeOffMm; }},
    MachineOption{"product-length", "MM", "mean length of the products; 0: 0.6 of the bag length", 0, 2000,
                  numberOf<&MachineOptions::products, &Products::lengthMm>},
    MachineOption{"product-length-scatter", "MM", "standard deviation of the product length", 0, 100,
                  numberOf<&MachineOptions::products, &Products::lengthScatterMm>},
    MachineOption{"product-scatter", "MM", "standard deviation of the product position on the infeed", 0, 100,
                  numberOf<&MachineOptions::products, &Products::scatterMm>},
    MachineOption{"product-lay-slip", "MM",
                  "standard deviation of their slip on the film, which the eye does not see", 0, 100,
                  numberOf<&MachineOptions::products, &Products::laySlipMm>},
    MachineOption{"product-eye-noise", "MM", "standard deviation of the product eye", 0, 10,
                  numberOf<&MachineOptions::products, &Products::eyeNoiseMm>},
    MachineOption{"product-missing", "P", "share of missing products", 0, 1,
                  numberOf<&MachineOptions::products, &Products::missing>},
    MachineOption{"product-misplaced", "P", "share of products misplaced by up to 0.45 of a bag length", 0, 1,
                  numberOf<&MachineOptions::products, &Products::misplaced>},
    MachineOption{"products-joined", "P", "share of products that hang together with the next one", 0, 1,
                  numberOf<&MachineOptions::products, &Products::joined>},
    MachineOption{"work-piece", "MM", "height of the work piece of a press, below the upper position", 0,
                  1000, numberOf<&MachineOptions::press, &Press::workPieceMm>},
    MachineOption{"work-piece-scatter", "MM", "standard deviation of the work-piece height per stroke", 0,
                  100, numberOf<&MachineOptions::press, &Press::workPieceScatterMm>},
    MachineOption{"work-piece-missing", "P", "share of strokes without a work piece", 0, 1,
                  numberOf<&MachineOptions::press, &Press::missing>},
    MachineOption{"work-piece-stiffness", "N", "force per mm of travel into the work piece", 0, 1e6,
                  numberOf<&MachineOptions::press, &Press::stiffnessNPerMm>},
    MachineOption{"press-backlash", "MM", "play between motor and ram", 0, 10,
                  numberOf<&MachineOptions::press, &Press::backlashMm>},
    MachineOption{"press-lead-error", "R", "ram lead error, ratio", -0.1, 0.1,
                  numberOf<&MachineOptions::press, &Press::leadError>},
    MachineOption{"press-screw-error", "MM", "error within each turn of the screw, plus and minus", 0, 1,
                  numberOf<&MachineOptions::press, &Press::screwErrorMm>},
    MachineOption{"press-drift", "MM", "standard deviation of the thermal drift of the ram per stroke", 0, 1,
                  numberOf<&MachineOptions::press, &Press::driftMm>},
    MachineOption{"drive-inertia", "KGM2", "inertia at the shaft of the main drive, for its torque", 0, 100,
                  numberOf<&MachineOptions::drive, &Drive::inertiaKgM2>},
    MachineOption{"drive-friction", "NM", "friction at the shaft of the main drive", 0, 1000,
                  numberOf<&MachineOptions::drive, &Drive::frictionNm>},
    MachineOption{"drive-rated-torque", "NM", "rated torque at the shaft of the main drive", 0.001, 1000,
                  numberOf<&MachineOptions::drive, &Drive::ratedTorqueNm>},
    MachineOption{"friction-drift", "SHARE", "share by which it rises and falls in ten minutes", 0, 1,
                  numberOf<&MachineOptions::drive, &Drive::frictionDrift>},
    MachineOption{"torque-every-ms", "MS", "time between two reports of its torque; 0: at once", 0, 100,
                  numberOf<&MachineOptions::report, &Report::everyMs>},
    MachineOption{"torque-step", "P", "resolution of the reported torque, percent of the rated one", 0.01, 10,
                  numberOf<&MachineOptions::report, &Report::stepPercent>},
    MachineOption{"torque-noise", "P", "standard deviation of the reported torque", 0, 20,
                  numberOf<&MachineOptions::report, &Report::noisePercent>},
    MachineOption{"seal-torque", "NM", "largest torque of a seal", 0, 100,
                  numberOf<&MachineOptions::jaws, &Jaw::sealNm>},
    MachineOption{"jams", "P", "share of cuts with something between the jaws", 0, 1,
                  numberOf<&MachineOptions::jaws, &Jaw::jams>},
    MachineOption{"jam-stiffness", "N", "its force per mm of the knife's way", 0.1, 1000,
                  numberOf<&MachineOptions::jaws, &Jaw::stiffnessNPerMm>},
    MachineOption{"jam-touch", "DEG", "shaft angle before the cut at which it is touched", 0, 90,
                  numberOf<&MachineOptions::jaws, &Jaw::touchDegrees>},
    MachineOption{"master-revolution", "MM", "film per revolution of the line's encoder", 1, 10000,
                  numberOf<&MachineOptions::shaft, &Shaft::revolutionMm>},
    MachineOption{"master-acceleration", "MM", "acceleration of the line, mm/s^2", 1, 100000,
                  numberOf<&MachineOptions::shaft, &Shaft::accelerationMmPerS2>},
    MachineOption{"master-ripple", "SHARE", "ripple of the line's speed", 0, 0.5,
                  numberOf<&MachineOptions::shaft, &Shaft::ripple>},
    MachineOption{"master-ripple-hz", "HZ", "frequency of this ripple", 0.01, 200,
                  numberOf<&MachineOptions::shaft, &Shaft::rippleHz>},
    MachineOption{"master-wave", "SHARE", "slow wave of the line's speed, over 10 s", 0, 0.5,
                  numberOf<&MachineOptions::shaft, &Shaft::wave>},
    MachineOption{"master-jitter", "COUNTS", "maximum error of an edge of the line's encoder", 0, 10,
                  numberOf<&MachineOptions::shaft, &Shaft::jitterCounts>},
};

// Returns the shortest form.
std::string numberText(double value)
{
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    return {text.data(), end.ptr};
}

} // namespace

std::span<const MachineOption> machineOptions()
{
    return optionTable;
}

std::string machineHelp()
{
    constexpr std::size_t textColumn = 23;
    MachineOptions defaults;
    std::string help;
    for (const MachineOption& option : optionTable) {
        std::string line("  --");
        line.append(option.name).append(" ").append(option.unit);
        line.resize(std::max(line.size() + 2, textColumn), ' ');
        line.append(option.text).append(", ").append(numberText(option.minimum)).append("..");
        line.append(numberText(option.maximum)).append(" (").append(numberText(option.member(defaults)));
        help.append(line).append(")\n");
    }
    return help;
}

} // namespace campanel::controller
