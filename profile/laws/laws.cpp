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
#include "text/marked.h"

#include <algorithm>
#include <array>

namespace campanel::profile {
namespace {

using namespace detail;

// code, key, name, speed law, displacement law, symmetric, parameters, functions, strength, weakness
constexpr std::array lawTable{
    Law{LawId::Cubic,
        "cubic",
        CAMPANEL_TEXT("Recipe", "Cubic"),
        true,
        true,
        true,
        {},
        cubicAt,
        cubicPeaks,
        cubicPieces,
        CAMPANEL_TEXT(
            "Recipe",
            "As a speed law, acceleration is zero at both ends and peaks at only 1.5 times its mean."),
        CAMPANEL_TEXT("Recipe", "As a displacement law, acceleration jumps to its peak (6) at both ends; as "
                                "a speed law, jerk does.")},
    Law{LawId::Quintic,
        "quintic",
        CAMPANEL_TEXT("Recipe", "Quintic 3-4-5"),
        true,
        true,
        true,
        {},
        quinticAt,
        quinticPeaks,
        quinticPieces,
        CAMPANEL_TEXT("Recipe", "Speed and acceleration are zero at both ends, with a short polynomial."),
        CAMPANEL_TEXT(
            "Recipe",
            "Jerk jumps at both ends; a trapezoid with ramps above 22.29 % of the move needs less peak "
            "acceleration.")},
    Law{LawId::Polynomial4567,
        "polynomial_4567",
        CAMPANEL_TEXT("Recipe", "Polynomial 4-5-6-7"),
        true,
        true,
        true,
        {},
        polynomial4567At,
        polynomial4567Peaks,
        polynomial4567Pieces,
        CAMPANEL_TEXT("Recipe",
                      "Speed, acceleration and jerk are zero at both ends, which excites little vibration."),
        CAMPANEL_TEXT("Recipe", "This law has the highest peak speed (2.19) and peak acceleration (7.51) of "
                                "the displacement laws "
                                "without parameters.")},
    Law{LawId::Harmonic,
        "harmonic",
        CAMPANEL_TEXT("Recipe", "Harmonic"),
        true,
        true,
        true,
        {},
        harmonicAt,
        harmonicPeaks,
        harmonicPieces,
        CAMPANEL_TEXT("Recipe",
                      "Half a cosine wave gives a low peak speed (1.57) and a low peak acceleration (4.93)."),
        CAMPANEL_TEXT("Recipe", "As a displacement law, full acceleration at start and end causes jolts.")},
    Law{LawId::Cycloidal,
        "cycloidal",
        CAMPANEL_TEXT("Recipe", "Cycloidal"),
        true,
        true,
        true,
        {},
        cycloidalAt,
        cycloidalPeaks,
        cycloidalPieces,
        CAMPANEL_TEXT("Recipe", "Acceleration is one full sine wave: smooth, and zero at both ends."),
        CAMPANEL_TEXT("Recipe",
                      "Peak speed (2) and peak acceleration (6.28) are high, and jerk jumps at both ends.")},
    Law{LawId::ModifiedSine,
        "modified_sine",
        CAMPANEL_TEXT("Recipe", "Modified sine"),
        true,
        true,
        true,
        {},
        modifiedSineAt,
        modifiedSinePeaks,
        modifiedSinePieces,
        CAMPANEL_TEXT(
            "Recipe",
            "Low peak speed (1.76), moderate peak acceleration (5.53) and continuous acceleration suit large "
            "inertia."),
        CAMPANEL_TEXT("Recipe", "Jerk jumps at both ends and has the highest finite peak (69.5) of the laws "
                                "without parameters.")},
    Law{LawId::ModifiedTrapezoid,
        "modified_trapezoid",
        CAMPANEL_TEXT("Recipe", "Modified trapezoid"),
        true,
        true,
        true,
        {},
        modifiedTrapezoidAt,
        modifiedTrapezoidPeaks,
        modifiedTrapezoidPieces,
        CAMPANEL_TEXT("Recipe", "This law has the lowest peak acceleration (4.89) of the laws without "
                                "parameters and acceleration "
                                "jumps."),
        CAMPANEL_TEXT("Recipe",
                      "Peak speed (2) and peak jerk (61.4) are high, and jerk jumps at both ends.")},
    Law{LawId::Parabolic,
        "parabolic",
        CAMPANEL_TEXT("Recipe", "Parabolic"),
        true,
        true,
        true,
        {},
        parabolicAt,
        parabolicPeaks,
        parabolicPieces,
        CAMPANEL_TEXT("Recipe", "This law has the lowest possible peak acceleration (4) from rest to rest."),
        CAMPANEL_TEXT(
            "Recipe",
            "As a displacement law, acceleration jumps at both ends and in the middle, and peak speed (2) is "
            "high.")},
    Law{LawId::Trapezoid, "trapezoid", CAMPANEL_TEXT("Recipe", "Trapezoid"), true, true, true,
        trapezoidParameters, trapezoidAt, trapezoidPeaks, trapezoidPieces,
        CAMPANEL_TEXT("Recipe", "At the same peak acceleration, no law has a lower peak speed; the ramp "
                                "fraction trades one for the "
                                "other."),
        CAMPANEL_TEXT(
            "Recipe",
            "As a displacement law, acceleration jumps at both ends of both ramps, so jerk is unbounded.")},
    Law{LawId::SCurve, "s_curve", CAMPANEL_TEXT("Recipe", "Seven-segment S"), true, true, true,
        sCurveParameters, sCurveAt, sCurvePeaks, sCurvePieces,
        CAMPANEL_TEXT("Recipe", "Acceleration does not jump; the peaks of acceleration and jerk can be set."),
        CAMPANEL_TEXT(
            "Recipe",
            "Jerk jumps at every joint of the segments; a smaller jerk share means a higher jerk.")},
    Law{LawId::Exponential, "exponential", CAMPANEL_TEXT("Recipe", "Exponential"), true, false, false,
        exponentialParameters, exponentialAt, exponentialPeaks, exponentialPieces,
        CAMPANEL_TEXT("Recipe", "Acceleration is highest at low speed, where the motor has the most torque, "
                                "and lowest near the end "
                                "speed."),
        CAMPANEL_TEXT("Recipe",
                      "Acceleration jumps at both ends; a larger k increases the jump at the low speed.")},
    Law{LawId::HalfModifiedSine,
        "half_modified_sine",
        CAMPANEL_TEXT("Recipe", "Half modified sine"),
        true,
        false,
        false,
        {},
        halfModifiedSineAt,
        halfModifiedSinePeaks,
        halfModifiedSinePieces,
        CAMPANEL_TEXT("Recipe", "Acceleration is zero at both ends and peaks at only 1.57 times its mean."),
        CAMPANEL_TEXT(
            "Recipe",
            "The law is not symmetric: from rest, the travel is 0.568 of end speed times time; jerk jumps at "
            "both ends.")},
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

const LawParameterInfo* findLawParameter(std::string_view id)
{
    for (const Law& law : lawTable) {
        for (const LawParameterInfo& parameter : law.parameters) {
            if (parameter.id == id)
                return &parameter;
        }
    }
    return nullptr;
}

LawParameters defaultParameters(const Law& law)
{
    LawParameters parameters{};
    for (std::size_t i = 0; i < law.parameters.size(); ++i)
        parameters[i] = law.parameters[i].defaultValue;
    return parameters;
}

} // namespace campanel::profile
