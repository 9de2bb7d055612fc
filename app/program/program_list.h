// SPDX-License-Identifier: Apache-2.0
// The list that a kind may have beside its numbers: the knots or the segments of a cam. Its registers follow
// the rows of the table.
#pragma once

#include "profile/cam/csv_reader.h"
#include "profile/cam/csv_writer.h"
#include "profile/model/refusal.h"
#include "profile/program/programs.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace campanel::program {

// Access to the list of a program, which must be of the kind.
struct ListInfo {
    std::string_view key; // in the recipe file
    std::string_view name;
    std::string_view countRegister;
    std::size_t (*size)(const profile::Program& program) = nullptr;
    bool (*isEqual)(const profile::Program& one, const profile::Program& other) = nullptr;
    // Rounds to register values, and closes a closing error: the controller compares the advance with the
    // list. A value far beyond any range is unchanged, so that its refusal names it.
    void (*quantise)(profile::Program& program) = nullptr;
    void (*append)(const profile::Program& program, std::vector<std::uint16_t>& registers) = nullptr;
    void (*read)(std::span<const std::uint16_t> registers, profile::Program& program) = nullptr;
    // As CSV text. Text that cannot be read leaves the program unchanged.
    std::span<const std::string_view> (*csvColumns)() = nullptr;
    std::string (*writeCsv)(const profile::Program& program, const profile::CsvDialect& dialect) = nullptr;
    std::optional<profile::CsvError> (*readCsv)(std::string_view text, profile::Program& program) = nullptr;
    // Returns the first fault of the entries; `index` is the entry.
    std::optional<profile::Refusal> (*check)(const profile::Program& program) = nullptr;
    // The lowest and the highest slave position of the entries, mm.
    std::pair<double, double> (*slaveRangeMm)(const profile::Program& program) = nullptr;
};

extern const ListInfo knotList;
extern const ListInfo segmentList;

} // namespace campanel::program
