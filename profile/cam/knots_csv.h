// SPDX-License-Identifier: Apache-2.0
// Knots of a cam as CSV text. Pure functions of text; files are the business of others.
#pragma once

#include "profile/program/programs.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace campanel::profile {

enum class CsvExpectation : std::uint8_t {
    Header,       // "master_deg,slave_mm" or the same with a semicolon
    TwoValues,    // master and slave, with the separator of the header
    Number,       // a finite number
    DecimalPoint, // the decimal sign of the numbers before, a point
    DecimalComma, // the same, a comma
    Knots,        // at least one line of values
    Utf8,         // text; the file is UTF-16, or not text at all
};

struct CsvError {
    int line = 1; // from 1
    CsvExpectation expected = CsvExpectation::Header;
    std::string found; // the line or the field as it stands there, at most 40 bytes; '?' for what has no sign

    bool operator==(const CsvError&) const = default;
};

// One English sentence.
[[nodiscard]] std::string describe(const CsvError& error);

// A header line, then one line per knot: "master_deg,slave_mm" in degrees and mm. With the header's separator
// a semicolon the decimal sign may be a comma, the same one throughout. Lines end with LF or CRLF; empty
// lines, spaces around values and a UTF-8 byte order mark are passed over. Whether the knots make a cam is
// checkKnots' question.
[[nodiscard]] tl::expected<std::vector<Knot>, CsvError> readKnotsCsv(std::string_view text);

// The line, from 1, that holds knot `index` of a text that readKnotsCsv() has read; that of the last knot
// when there are fewer.
[[nodiscard]] int lineOfKnot(std::string_view text, std::size_t index);

// The shortest numbers that read back exactly the same, comma and point, LF.
[[nodiscard]] std::string writeKnotsCsv(std::span<const Knot> knots);

} // namespace campanel::profile
