// SPDX-License-Identifier: Apache-2.0
// The table of laws. The order is that of presentation; keys and codes never change.
#include "profile/laws/laws.h"

#include "profile/laws/cubic.h"
#include "profile/laws/cycloidal.h"
#include "profile/laws/exponential.h"
#include "profile/laws/half_modified_sine.h"
#include "profile/laws/harmonic.h"
#include "profile/laws/modified_sine.h"
#include "profile/laws/modified_trapezoid.h"
#include "profile/laws/parabolic.h"
#include "profile/laws/polynomial_4567.h"
#include "profile/laws/quintic.h"
#include "profile/laws/s_curve.h"
#include "profile/laws/trapezoid.h"

#include <algorithm>
#include <array>

namespace campanel::profile {
namespace {

using namespace detail;

// code, key, name, speed law, displacement law, symmetric, parameters, functions, strength, weakness
constexpr std::array lawTable{
    Law{LawId::Cubic,
        "cubic",
        "Cubic (paper)",
        true,
        true,
        true,
        {},
        cubicAt,
        cubicPeaks,
        cubicPieces,
        "As a speed law its acceleration is zero at both ends and peaks at only 1.5 times its mean.",
        "As a displacement law its acceleration jumps to its peak (6) at both ends, and as a speed law its "
        "jerk does."},
    Law{LawId::Quintic,
        "quintic",
        "Quintic 3-4-5",
        true,
        true,
        true,
        {},
        quinticAt,
        quinticPeaks,
        quinticPieces,
        "Speed and acceleration are zero at both ends, by one short polynomial.",
        "Its jerk steps at both ends, and a trapezoid whose ramps are longer than 22.29 % of the move needs "
        "less peak acceleration."},
    Law{LawId::Polynomial4567,
        "polynomial_4567",
        "Polynomial 4-5-6-7",
        true,
        true,
        true,
        {},
        polynomial4567At,
        polynomial4567Peaks,
        polynomial4567Pieces,
        "Speed, acceleration and jerk are all zero at both ends, so it excites little vibration.",
        "It has the highest peak speed (2.19) and peak acceleration (7.51) of the displacement laws without "
        "parameters."},
    Law{LawId::Harmonic,
        "harmonic",
        "Harmonic",
        true,
        true,
        true,
        {},
        harmonicAt,
        harmonicPeaks,
        harmonicPieces,
        "Low peak speed (1.57) and low peak acceleration (4.93) by half a cosine wave.",
        "As a displacement law it starts and ends with its full acceleration, a jolt each time."},
    Law{LawId::Cycloidal,
        "cycloidal",
        "Cycloidal",
        true,
        true,
        true,
        {},
        cycloidalAt,
        cycloidalPeaks,
        cycloidalPieces,
        "Its acceleration is one whole sine wave, smooth throughout and zero at both ends.",
        "Its peak speed (2) and peak acceleration (6.28) are high, and its jerk steps at both ends."},
    Law{LawId::ModifiedSine,
        "modified_sine",
        "Modified sine",
        true,
        true,
        true,
        {},
        modifiedSineAt,
        modifiedSinePeaks,
        modifiedSinePieces,
        "Low peak speed (1.76) with moderate peak acceleration (5.53) and no jump of acceleration: it suits "
        "large inertia.",
        "Its jerk steps at both ends and has the highest finite peak (69.5) of the laws without parameters."},
    Law{LawId::ModifiedTrapezoid,
        "modified_trapezoid",
        "Modified trapezoid",
        true,
        true,
        true,
        {},
        modifiedTrapezoidAt,
        modifiedTrapezoidPeaks,
        modifiedTrapezoidPieces,
        "The lowest peak acceleration (4.89) of the laws without parameters whose acceleration does not "
        "jump.",
        "Its peak speed (2) and peak jerk (61.4) are high, and its jerk steps at both ends."},
    Law{LawId::Parabolic,
        "parabolic",
        "Parabolic",
        true,
        true,
        true,
        {},
        parabolicAt,
        parabolicPeaks,
        parabolicPieces,
        "The lowest peak acceleration (4) that a move from rest to rest can have.",
        "As a displacement law its acceleration jumps at both ends and in the middle, and its peak speed (2) "
        "is high."},
    Law{LawId::Trapezoid, "trapezoid", "Trapezoid", true, true, true, trapezoidParameters, trapezoidAt,
        trapezoidPeaks, trapezoidPieces,
        "No law has a lower peak speed at the same peak acceleration; the ramp fraction trades one for the "
        "other.",
        "As a displacement law its acceleration jumps at both ends of both ramps, so its jerk has no bound."},
    Law{LawId::SCurve, "s_curve", "Seven-segment S", true, true, true, sCurveParameters, sCurveAt,
        sCurvePeaks, sCurvePieces,
        "Its acceleration does not jump, and both its peak and that of the jerk can be set.",
        "Its jerk steps at every joint of its segments, and the smaller the jerk share the higher it is."},
    Law{LawId::Exponential, "exponential", "Exponential", true, false, false, exponentialParameters,
        exponentialAt, exponentialPeaks, exponentialPieces,
        "It accelerates hardest at low speed, where a motor has most torque to give, and least near the end "
        "speed.",
        "Its acceleration jumps at both ends, at the low speed the more the larger k is."},
    Law{LawId::HalfModifiedSine,
        "half_modified_sine",
        "Half modified sine",
        true,
        false,
        false,
        {},
        halfModifiedSineAt,
        halfModifiedSinePeaks,
        halfModifiedSinePieces,
        "Its acceleration is zero at both ends and peaks at only 1.57 times its mean.",
        "It is not symmetric: from rest it travels 0.568 of end speed times time; and its jerk steps at both "
        "ends."},
};

} // namespace

std::span<const Law> laws()
{
    return lawTable;
}

const Law* findLaw(std::string_view key)
{
    const auto found =
        std::find_if(lawTable.begin(), lawTable.end(), [key](const Law& law) { return law.key == key; });
    return found == lawTable.end() ? nullptr : &*found;
}

const Law* findLaw(LawId id)
{
    const auto found =
        std::find_if(lawTable.begin(), lawTable.end(), [id](const Law& law) { return law.id == id; });
    return found == lawTable.end() ? nullptr : &*found;
}

LawParameters defaultParameters(const Law& law)
{
    LawParameters parameters{};
    for (std::size_t i = 0; i < law.parameters.size(); ++i)
        parameters[i] = law.parameters[i].defaultValue;
    return parameters;
}

} // namespace campanel::profile
