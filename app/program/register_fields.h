// SPDX-License-Identifier: Apache-2.0
// The recipe's inputs and their registers in the bank's header: it connects profile and registers.
#pragma once

#include "app/program/program_kinds.h"

#include "modbus/map/register_map.h"

#include <array>
#include <span>
#include <string_view>

namespace campanel::program {

// An input and its register in the header of a kind.
struct RegisterField {
    profile::Field field = profile::Field::BagLength;
    const modbus::RegisterInfo* info = nullptr;
    double perUnit = 1; // register units per unit of the field: a time in s may be in ms in its register
};

// Returns the inputs of this kind that the header has, in the order of the fields.
[[nodiscard]] std::span<const RegisterField> registerFields(const KindInfo& kind);

// The registers of the law parameters, for every kind with a law.
inline constexpr std::array<std::string_view, profile::maxLawParameters> lawParameterSuffixes{
    "law_parameter1", "law_parameter2"};

// Returns the register in the header of this kind, or null when the header does not have it; `suffix` follows
// the register prefix of the kind: "program." + "bag_length".
[[nodiscard]] const modbus::RegisterInfo* registerOf(const KindInfo& kind, std::string_view suffix);

} // namespace campanel::program
