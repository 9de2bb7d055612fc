// SPDX-License-Identifier: Apache-2.0
// A law is a normalised transition g: [0,1] -> [0,1] with g(0) = 0 and g(1) = 1, given by closed formulas. A
// speed law changes one speed to another: v = v0 + (v1 - v0) g(t / duration).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace campanel::profile {

// Stable codes: the controller stores them beside the table.
enum class LawId : std::uint16_t {
    Cubic = 1,
    Quintic = 2,
    Polynomial4567 = 3,
    Harmonic = 4,
    Cycloidal = 5,
    ModifiedSine = 6,
    ModifiedTrapezoid = 7,
    Parabolic = 8,
    Trapezoid = 9,
    SCurve = 10,
    Exponential = 11,
    HalfModifiedSine = 12,
};

inline constexpr std::size_t maxLawParameters = 2;
using LawParameters = std::array<double, maxLawParameters>;

// g, its first three derivatives and its integral G from 0 to x.
struct LawPoint {
    double g = 0;
    double g1 = 0;
    double g2 = 0;
    double g3 = 0;
    double integral = 0;
};

// The maxima of |g'|, |g''|, |g'''| (Cv, Ca, Cj; infinite where g'' has a step inside), and the first x of
// the maxima of |g'| and |g''|.
struct LawPeaks {
    double cv = 0;
    double ca = 0;
    double cj = 0;
    double cvAt = 0;
    double caAt = 0;
};

// The smooth pieces of a law: it is smooth between 0, the joints and 1. Bounds of |g'''| and |g''''| there
// are g3 and g4. Unused joints are 1.
struct LawPieces {
    std::array<double, 6> joints{1, 1, 1, 1, 1, 1}; // ascending
    double g3 = 0;
    double g4 = 0;
};

struct LawParameterInfo {
    std::string_view id; // key in the recipe file
    std::string_view name;
    double min = 0;
    double max = 0;
    double defaultValue = 0;
    int decimals = 0;
};

struct Law {
    LawId id = LawId::Cubic;
    std::string_view key; // in the recipe file
    std::string_view name;
    bool isSpeedLaw = false;
    bool isDisplacementLaw = false;
    bool isSymmetric = false; // g(x) = 1 - g(1 - x), so that G(1) = 1/2
    std::span<const LawParameterInfo> parameters;
    LawPoint (*at)(double x, const LawParameters& parameters) = nullptr; // x in [0,1]
    LawPeaks (*peaks)(const LawParameters& parameters) = nullptr;
    LawPieces (*pieces)(const LawParameters& parameters) = nullptr;
    std::string_view strength; // one English sentence each
    std::string_view weakness;
};

} // namespace campanel::profile
