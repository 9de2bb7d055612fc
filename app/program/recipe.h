// SPDX-License-Identifier: Apache-2.0
// A recipe: the operator's unit of work. Name, version, the inputs of the program and the machine it is for.
#pragma once

#include "profile/machine.h"
#include "profile/rotary_cutter.h"

#include "modbus/blocks.h"

#include <array>
#include <cstddef>
#include <string>

namespace campanel::program {

// A name travels with the program into the controller; it has room for this many bytes of UTF-8.
inline constexpr std::size_t longestNameBytes = 32;
inline constexpr int largestVersion = 65535;

// The defaults are a bag of 250 mm at 60 a minute with a knife of 60 mm.
struct Recipe {
    std::string name = "Biscuit 250";
    int version = 1;
    profile::RotaryCutterProgram program;
    profile::Machine machine;
};

// The inputs that belong to a program, and the data of the machine that a person enters; in the order in
// which they are shown and stored. What comes from the controller's identity is in neither.
inline constexpr std::array programFields{profile::Field::BagLength, profile::Field::Rate,
                                          profile::Field::BaseSpeed, profile::Field::FilmSpeed,
                                          profile::Field::K1,        profile::Field::K2,
                                          profile::Field::K3,        profile::Field::K4,
                                          profile::Field::SyncRatio, profile::Field::SlicesPerRamp};
inline constexpr std::array machineFields{profile::Field::KnifeRadius,
                                          profile::Field::Knives,
                                          profile::Field::PulsesPerMotorRev,
                                          profile::Field::GearNumerator,
                                          profile::Field::GearDenominator,
                                          profile::Field::MaxMotorRpm,
                                          profile::Field::MaxKnifeAcceleration,
                                          profile::Field::MaxPulseFrequency,
                                          profile::Field::MaxRate};
// Of these four, two are pinned; in the order of the bits of program.pinned.
inline constexpr std::array pinnableFields{profile::Field::BagLength, profile::Field::Rate,
                                           profile::Field::BaseSpeed, profile::Field::FilmSpeed};

[[nodiscard]] bool isProgramField(profile::Field field);
[[nodiscard]] double value(const Recipe& recipe, profile::Field field);
void setValue(Recipe& recipe, profile::Field field, double value);

// The inputs as the registers hold them, so that recipe -> registers -> recipe -> registers is identical. A
// value that no register can hold is left as it is; buildProgram() refuses it. Unpinned cycle values become
// 0.
[[nodiscard]] Recipe quantised(const Recipe& recipe);

// The machine with the timer and table size of this controller, and its output stage as a limit.
[[nodiscard]] profile::Machine withController(const profile::Machine& machine,
                                              const modbus::Identity& controller);

} // namespace campanel::program
