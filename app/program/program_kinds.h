// SPDX-License-Identifier: Apache-2.0
// The table of program kinds: key, inputs, data of the machine, layouts of its table. Recipe files,
// registers, the command line and the panel use it, so that a kind is added in one place.
#pragma once

#include "app/program/program_list.h"

#include "modbus/map/protocol.h"
#include "profile/program/programs.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace campanel::program {

// The inputs that are not numbers.
enum class Choice : std::uint8_t { Law, Duration, Execution, SplineEnds, MasterRampShape, Ratios };

struct ChoiceOption {
    std::string_view key; // in the recipe file
    std::uint16_t code = 0;
    std::string_view name;
};

struct ChoiceInfo {
    Choice choice = Choice::Law;
    std::string_view id;           // key in the recipe file
    std::string_view registerName; // as of a field; empty: not sent, or the layout of the table says it
    std::string_view group;        // as of a field
    std::string_view name;
    std::span<const ChoiceOption> options; // empty for the law, whose options are the table of laws
};

struct KindInfo {
    profile::ProgramKind kind = profile::ProgramKind::RotaryCutter;
    std::string_view key; // in the recipe file
    std::string_view name;
    std::span<const profile::Field> programFields;
    std::span<const profile::Field> machineFields; // entered by a person
    std::span<const ChoiceInfo> choices;
    std::string_view registerPrefix; // prefix of its inputs in the bank's header
    std::span<const modbus::TableLayout> layouts;
    modbus::EndBehavior end = modbus::EndBehavior::Repeat; // of its table
    // A new recipe: its name, its inputs, and the data of a machine that differ from the defaults.
    std::string_view defaultName;
    profile::Program (*defaultProgram)() = nullptr;
    void (*adaptMachine)(profile::Machine& machine) = nullptr;
    const ListInfo* list = nullptr; // only for a cam
};

[[nodiscard]] std::span<const KindInfo> kinds();
[[nodiscard]] const KindInfo& kindInfo(profile::ProgramKind kind);
// Returns the kind with this key, or null.
[[nodiscard]] const KindInfo* findKind(std::string_view key);

// Returns the name and the options of the choice for this kind; no options when the kind does not have it.
[[nodiscard]] ChoiceInfo choiceInfo(profile::ProgramKind kind, Choice choice);
// Returns true when the law may be chosen for this kind.
[[nodiscard]] bool isLawOf(profile::ProgramKind kind, const profile::Law& law);

// Access inputs of any program. `field` and `choice` must be among those of its kind.
[[nodiscard]] double value(const profile::Program& program, profile::Field field);
void setValue(profile::Program& program, profile::Field field, double value); // counts are rounded
[[nodiscard]] std::uint16_t choice(const profile::Program& program, Choice choice);
void setChoice(profile::Program& program, Choice choice, std::uint16_t code);
// Returns the parameters of its law; null for a kind without one.
[[nodiscard]] const profile::LawParameters* lawParameters(const profile::Program& program);
[[nodiscard]] profile::LawParameters* lawParameters(profile::Program& program);

// Returns true when the present settings of the program use the value: the fastest move does not use a given
// time.
[[nodiscard]] bool isRead(const profile::Program& program, profile::Field field);

} // namespace campanel::program
