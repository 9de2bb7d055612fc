// SPDX-License-Identifier: Apache-2.0
// The kinds of program as one table: key, inputs, data of the machine. Recipe files, registers, the command
// line and the panel read it, so that a kind is added in one place.
#pragma once

#include "profile/program/programs.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace campanel::program {

// Inputs that are not numbers.
enum class Choice : std::uint8_t { Law, Duration, Execution, SplineEnds, MasterRampShape };

struct ChoiceOption {
    std::string_view key; // in the recipe file
    std::uint16_t code = 0;
};

struct ChoiceInfo {
    Choice choice = Choice::Law;
    std::string_view id;                   // key in the recipe file
    std::span<const ChoiceOption> options; // none for the law, whose options are the table of laws
};

struct KindInfo {
    profile::ProgramKind kind = profile::ProgramKind::RotaryCutter;
    std::string_view key; // in the recipe file
    std::span<const profile::Field> programFields;
    std::span<const profile::Field> machineFields; // that a person enters
    std::span<const Choice> choices;
    std::string_view registerPrefix; // of its inputs in the bank's header
};

[[nodiscard]] std::span<const KindInfo> kinds();
[[nodiscard]] const KindInfo& kindInfo(profile::ProgramKind kind);
// The kind with this key, or null.
[[nodiscard]] const KindInfo* findKind(std::string_view key);

// How this kind names the choice and what it offers.
[[nodiscard]] ChoiceInfo choiceInfo(profile::ProgramKind kind, Choice choice);
// True when the law may be chosen for this kind.
[[nodiscard]] bool isLawOf(profile::ProgramKind kind, const profile::Law& law);

// Inputs of any program. `field` and `choice` must be among those of its kind.
[[nodiscard]] double value(const profile::Program& program, profile::Field field);
void setValue(profile::Program& program, profile::Field field, double value); // counts are rounded
[[nodiscard]] std::uint16_t choice(const profile::Program& program, Choice choice);
void setChoice(profile::Program& program, Choice choice, std::uint16_t code);
// Parameters of its law; null for a kind without one.
[[nodiscard]] const profile::LawParameters* lawParameters(const profile::Program& program);
[[nodiscard]] profile::LawParameters* lawParameters(profile::Program& program);

// True when the value is read by this program as it is set: a given time is not read by the fastest move.
[[nodiscard]] bool isRead(const profile::Program& program, profile::Field field);

} // namespace campanel::program
