// SPDX-License-Identifier: Apache-2.0
// One row per law. Order is the order of presentation; keys and codes never change.
#include "profile/laws.h"

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

//             code                      key                  name               speed displ. symm.
constexpr std::array table{
    Law{LawId::Cubic, "cubic", "Cubic (paper)", true, true, true, {}, cubicAt, cubicPeaks},
    Law{LawId::Quintic, "quintic", "Quintic 3-4-5", true, true, true, {}, quinticAt, quinticPeaks},
    Law{LawId::Polynomial4567,
        "polynomial_4567",
        "Polynomial 4-5-6-7",
        true,
        true,
        true,
        {},
        polynomial4567At,
        polynomial4567Peaks},
    Law{LawId::Harmonic, "harmonic", "Harmonic", true, true, true, {}, harmonicAt, harmonicPeaks},
    Law{LawId::Cycloidal, "cycloidal", "Cycloidal", true, true, true, {}, cycloidalAt, cycloidalPeaks},
    Law{LawId::ModifiedSine,
        "modified_sine",
        "Modified sine",
        true,
        true,
        true,
        {},
        modifiedSineAt,
        modifiedSinePeaks},
    Law{LawId::ModifiedTrapezoid,
        "modified_trapezoid",
        "Modified trapezoid",
        true,
        true,
        true,
        {},
        modifiedTrapezoidAt,
        modifiedTrapezoidPeaks},
    Law{LawId::Parabolic, "parabolic", "Parabolic", true, true, true, {}, parabolicAt, parabolicPeaks},
    Law{LawId::Trapezoid, "trapezoid", "Trapezoid", true, true, true, trapezoidParameters, trapezoidAt,
        trapezoidPeaks},
    Law{LawId::SCurve, "s_curve", "Seven-segment S", true, true, true, sCurveParameters, sCurveAt,
        sCurvePeaks},
    Law{LawId::Exponential, "exponential", "Exponential", true, false, false, exponentialParameters,
        exponentialAt, exponentialPeaks},
    Law{LawId::HalfModifiedSine,
        "half_modified_sine",
        "Half modified sine",
        true,
        false,
        false,
        {},
        halfModifiedSineAt,
        halfModifiedSinePeaks},
};

} // namespace

std::span<const Law> laws()
{
    return table;
}

const Law* findLaw(std::string_view key)
{
    const auto found =
        std::find_if(table.begin(), table.end(), [key](const Law& law) { return law.key == key; });
    return found == table.end() ? nullptr : &*found;
}

const Law* findLaw(LawId id)
{
    const auto found =
        std::find_if(table.begin(), table.end(), [id](const Law& law) { return law.id == id; });
    return found == table.end() ? nullptr : &*found;
}

LawParameters defaultParameters(const Law& law)
{
    LawParameters parameters{};
    for (std::size_t i = 0; i < law.parameters.size(); ++i)
        parameters[i] = law.parameters[i].defaultValue;
    return parameters;
}

} // namespace campanel::profile
