// SPDX-License-Identifier: Apache-2.0
// The formulas with their numbers, for each pair of inputs.
#include "profile/cutter/explain.h"

#include "profile/cutter/jaw.h"
#include "profile/cutter/limits.h"
#include "profile/cutter/ratios.h"
#include "profile/laws/laws.h"
#include "profile/model/text.h"
#include "profile/model/torque.h"

#include <cmath>

namespace campanel::profile {
namespace {

using detail::concat;
using detail::significantText;

std::string n(double value)
{
    return significantText(value);
}

std::string product(double a, double b)
{
    return concat({n(a), " * ", n(b)});
}

Explanation explainBagLength(const RotaryCutter& cutter)
{
    const CycleNumbers& c = cutter.cycle;
    return {"L = v_b T / c",
            concat({product(c.filmSpeedMmPerS, c.cycleTimeS), " / ", n(cutter.program.syncRatio)}),
            c.bagLengthMm, "mm"};
}

Explanation explainRate(const RotaryCutter& cutter)
{
    const CycleNumbers& c = cutter.cycle;
    const double w = c.weightS / c.cycleTimeS;
    const double ratio = cutter.program.syncRatio;
    Explanation e{"", "", c.rateBagsPerMin, "bags/min"};
    if (!isPinned(cutter.program, Field::BaseSpeed)) {
        e.formula = "n = 60 v_b / (c L)";
        e.numbers = concat({product(60, c.filmSpeedMmPerS), " / (", product(ratio, c.bagLengthMm), ")"});
    } else if (!isPinned(cutter.program, Field::FilmSpeed)) {
        e.formula = "n = 60 v_a (1 - w) / (h - c L w), w = W / T";
        e.numbers = concat({product(60, c.baseSpeedMmPerS), " * (1 - ", n(w), ") / (", n(c.strokeMm), " - ",
                            product(ratio, c.bagLengthMm), " * ", n(w), ")"});
    } else {
        e.formula = "n = 60 (v_a (1 - w) + v_b w) / h, w = W / T";
        e.numbers = concat({"60 * (", n(c.baseSpeedMmPerS), " * (1 - ", n(w), ") + ",
                            product(c.filmSpeedMmPerS, w), ") / ", n(c.strokeMm)});
    }
    return e;
}

Explanation explainBaseSpeed(const RotaryCutter& cutter)
{
    const CycleNumbers& c = cutter.cycle;
    return {"v_a = (h - v_b W) / (T - W)",
            concat({"(", n(c.strokeMm), " - ", product(c.filmSpeedMmPerS, c.weightS), ") / (",
                    n(c.cycleTimeS), " - ", n(c.weightS), ")"}),
            c.baseSpeedMmPerS, "mm/s"};
}

Explanation explainFilmSpeed(const RotaryCutter& cutter)
{
    const CycleNumbers& c = cutter.cycle;
    if (isPinned(cutter.program, Field::BagLength)) {
        return {"v_b = c L / T",
                concat({product(cutter.program.syncRatio, c.bagLengthMm), " / ", n(c.cycleTimeS)}),
                c.filmSpeedMmPerS, "mm/s"};
    }
    return {"v_b = (h - v_a (T - W)) / W",
            concat({"(", n(c.strokeMm), " - ", n(c.baseSpeedMmPerS), " * (", n(c.cycleTimeS), " - ",
                    n(c.weightS), ")) / ", n(c.weightS)}),
            c.filmSpeedMmPerS, "mm/s"};
}

Explanation explainWeight(const RotaryCutter& cutter)
{
    const CycleNumbers& c = cutter.cycle;
    const double travel = findLaw(cutter.program.speedLaw)->at(1, cutter.program.speedLawParameters).integral;
    return {"W = (tc - tb) + G(1) ((tb - ta) + (td - tc))",
            concat({"(", n(c.tcS), " - ", n(c.tbS), ") + ", n(travel), " * ((", n(c.tbS), " - ", n(c.taS),
                    ") + (", n(c.tdS), " - ", n(c.tcS), "))"}),
            c.weightS, "s"};
}

Explanation explainRpm(const RotaryCutter& cutter)
{
    const Machine& m = cutter.machine;
    const Peaks peak = peaks(cutter);
    return {"60 Z max(v_a, v_b) / (2 pi R)",
            concat({"60 * ", n(m.gearNumerator), " / ", n(m.gearDenominator), " * ", n(peak.speedMmPerS),
                    " / (2 pi * ", n(m.knifeRadiusMm), ")"}),
            peak.motorRpm, "r/min"};
}

Explanation explainAcceleration(const RotaryCutter& cutter)
{
    const CycleNumbers& c = cutter.cycle;
    const double cv = findLaw(cutter.program.speedLaw)->peaks(cutter.program.speedLawParameters).cv;
    const bool there = c.tbS - c.taS <= c.tdS - c.tcS;
    return {there ? "Cv |v_b - v_a| / (tb - ta)" : "Cv |v_b - v_a| / (td - tc)",
            concat({n(cv), " * |", n(c.filmSpeedMmPerS), " - ", n(c.baseSpeedMmPerS), "| / (",
                    n(there ? c.tbS : c.tdS), " - ", n(there ? c.taS : c.tcS), ")"}),
            peaks(cutter).accelerationMmPerS2, "mm/s^2"};
}

Explanation explainFrequency(const RotaryCutter& cutter)
{
    const Machine& m = cutter.machine;
    const Peaks peak = peaks(cutter);
    return {"K Z max(v_a, v_b) / (2 pi R)",
            concat({n(m.pulsesPerMotorRev), " * ", n(m.gearNumerator), " / ", n(m.gearDenominator), " * ",
                    n(peak.speedMmPerS), " / (2 pi * ", n(m.knifeRadiusMm), ")"}),
            peak.pulseFrequencyHz, "Hz"};
}

Explanation explainWindow(const RotaryCutter& cutter)
{
    const CycleNumbers& c = cutter.cycle;
    return {"360 v_b (tc - tb) / (2 pi R)",
            concat({product(360, c.filmSpeedMmPerS), " * (", n(c.tcS), " - ", n(c.tbS), ") / (2 pi * ",
                    n(cutter.machine.knifeRadiusMm), ")"}),
            windowDeg(c, cutter.machine), "deg"};
}

Explanation explainSealTime(const RotaryCutter& cutter)
{
    const CycleNumbers& c = cutter.cycle;
    const Machine& m = cutter.machine;
    return {"1000 A / v_b, A = 2 pi R theta_c / 360",
            concat({"1000 * 2 pi * ", product(m.knifeRadiusMm, m.contactAngleDeg), " / 360 / ",
                    n(c.filmSpeedMmPerS)}),
            sealTimeMs(c, m), "ms"};
}

Explanation explainRms(const RotaryCutter& cutter)
{
    const CycleNumbers& c = cutter.cycle;
    const double slope = lawSpeedSquare(*findLaw(cutter.program.speedLaw), cutter.program.speedLawParameters);
    return {"|v_b - v_a| sqrt(I2 (1/(tb - ta) + 1/(td - tc)) / T)",
            concat({"|", n(c.filmSpeedMmPerS), " - ", n(c.baseSpeedMmPerS), "| * sqrt(", n(slope), " * (1/(",
                    n(c.tbS), " - ", n(c.taS), ") + 1/(", n(c.tdS), " - ", n(c.tcS), ")) / ", n(c.cycleTimeS),
                    ")"}),
            rmsAcceleration(c, cutter.program), "mm/s^2"};
}

Explanation explainSpeedRatio(const RotaryCutter& cutter)
{
    const CycleNumbers& c = cutter.cycle;
    return {"k0 = v_b / v_a", concat({n(c.filmSpeedMmPerS), " / ", n(c.baseSpeedMmPerS)}), c.speedRatio, ""};
}

// Eq. (7) of the paper, v_a = r omega, with the knife-tip radius as the base circle.
Explanation explainBaseCircle(const RotaryCutter& cutter)
{
    const double radius = cutter.machine.knifeRadiusMm;
    return {"omega = v_a / R", concat({n(cutter.cycle.baseSpeedMmPerS), " / ", n(radius)}),
            cutter.cycle.baseSpeedMmPerS / radius, "rad/s"};
}

// The factor from mm/s^2 at the knife to Nm at the motor.
std::string loadNumbers(const Machine& m)
{
    return concat({n(m.inertiaKgCm2), " * 1e-4 * ", n(m.gearNumerator), " / ", n(m.gearDenominator), " / ",
                   n(m.knifeRadiusMm)});
}

Explanation explainTorque(const RotaryCutter& cutter)
{
    const Peaks peak = peaks(cutter);
    const bool slows = peak.torqueTimeS == peak.extremes.slowingTimeS;
    return {slows ? "J Z a / R - M_f" : "J Z a / R + M_f",
            concat({loadNumbers(cutter.machine), " * ",
                    n(slows ? peak.extremes.slowingMmPerS2 : peak.extremes.speedingMmPerS2),
                    slows ? " - " : " + ", n(cutter.machine.frictionNm)}),
            peak.torqueNm, "Nm"};
}

Explanation explainRmsTorque(const RotaryCutter& cutter)
{
    return {"sqrt((J Z / R)^2 a_rms^2 + M_f^2)",
            concat({"sqrt((", loadNumbers(cutter.machine), ")^2 * ",
                    n(std::sqrt(squareAcceleration(cutter.cycle, cutter.program))), "^2 + ",
                    n(cutter.machine.frictionNm), "^2)"}),
            peaks(cutter).rmsTorqueNm, "Nm"};
}

Explanation explainSealError(const RotaryCutter& cutter)
{
    const Machine& m = cutter.machine;
    return {"max e - min e, e'' + 2 zeta w e' + w^2 e = -a - 2 zeta w v, w = 2 pi f_0",
            concat({"f_0 = ", n(m.naturalFrequencyHz), " Hz, zeta = ", n(m.dampingRatio),
                    ", T = ", n(cutter.cycle.cycleTimeS), " s, ", n(cutter.cycle.tbS), " .. ",
                    n(cutter.cycle.tcS), " s"}),
            sealErrorMm(cutter), "mm"};
}

Explanation explainPinned(const RotaryCutter& cutter, Field field)
{
    const double given = value(cutter.program, field);
    return {std::string(info(field).symbol), n(given), given, info(field).unit};
}

} // namespace

Explanation explain(const RotaryCutter& cutter, CutterQuantity quantity)
{
    const auto pinnedOr = [&](Field field, Explanation (*derived)(const RotaryCutter&)) {
        return isPinned(cutter.program, field) ? explainPinned(cutter, field) : derived(cutter);
    };
    switch (quantity) {
    case CutterQuantity::BagLength:
        return pinnedOr(Field::BagLength, explainBagLength);
    case CutterQuantity::Rate:
        return pinnedOr(Field::Rate, explainRate);
    case CutterQuantity::BaseSpeed:
        return pinnedOr(Field::BaseSpeed, explainBaseSpeed);
    case CutterQuantity::FilmSpeed:
        return pinnedOr(Field::FilmSpeed, explainFilmSpeed);
    case CutterQuantity::Weight:
        return explainWeight(cutter);
    case CutterQuantity::PeakMotorRpm:
        return explainRpm(cutter);
    case CutterQuantity::PeakAcceleration:
        return explainAcceleration(cutter);
    case CutterQuantity::PeakFrequency:
        return explainFrequency(cutter);
    case CutterQuantity::SyncWindow:
        return explainWindow(cutter);
    case CutterQuantity::SealTime:
        return explainSealTime(cutter);
    case CutterQuantity::RmsAcceleration:
        return explainRms(cutter);
    case CutterQuantity::SpeedRatio:
        return explainSpeedRatio(cutter);
    case CutterQuantity::BaseCircleSpeed:
        return explainBaseCircle(cutter);
    case CutterQuantity::PeakTorque:
        return explainTorque(cutter);
    case CutterQuantity::RmsTorque:
        return explainRmsTorque(cutter);
    case CutterQuantity::SealError:
        return explainSealError(cutter);
    }
    return {};
}

} // namespace campanel::profile
