// SPDX-License-Identifier: Apache-2.0
#include "line_statements.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace campanel::controller {
namespace {

constexpr double usualMmPerS = 250.0;
constexpr double noisyShare = 0.02; // of the edges

struct Statement {
    std::string_view name;
    double minimum = 0.0;
    double maximum = 0.0;
    std::optional<double> usual; // without a number
    void (*apply)(LineShaft& shaft, double value) = nullptr;
};

constexpr std::array statements{
    Statement{"start", -1000.0, 10'000.0, usualMmPerS,
              [](LineShaft& shaft, double value) { shaft.setSpeed(value); }},
    Statement{"stop", 0.0, 0.0, 0.0, [](LineShaft& shaft, double) { shaft.setSpeed(0.0); }},
    Statement{"slip", 0.0, 1.0, {}, [](LineShaft& shaft, double value) { shaft.setSlip(value); }},
    Statement{"lose",
              0.0,
              1000.0,
              {},
              [](LineShaft& shaft, double value) { shaft.setLost(static_cast<std::uint32_t>(value)); }},
    Statement{"swap", 0.0, 1.0, {}, [](LineShaft& shaft, double value) { shaft.setReversed(value != 0.0); }},
    Statement{"noise",
              0.0,
              1.0,
              {},
              [](LineShaft& shaft, double value) { shaft.setNoise(value != 0.0 ? noisyShare : 0.0); }},
    Statement{"jump", 0.0, 0.0, 0.0, [](LineShaft& shaft, double) { shaft.jump(); }},
};

std::optional<double> parseValue(std::string_view text)
{
    if (text == "on" || text == "off")
        return text == "on" ? 1.0 : 0.0;
    double value = 0.0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool isWhole = parsed.ec == std::errc() && parsed.ptr == text.data() + text.size();
    return isWhole ? std::optional(value) : std::nullopt;
}

} // namespace

bool applyLineStatement(std::string_view text, LineShaft& shaft)
{
    const std::size_t end = text.find(' ');
    const auto statement = std::ranges::find(statements, text.substr(0, end), &Statement::name);
    if (!shaft.hasEncoder() || statement == statements.end())
        return false;
    const auto value = end == std::string_view::npos ? statement->usual : parseValue(text.substr(end + 1));
    // A comparison that a NaN does not pass.
    if (!value || !(*value >= statement->minimum && *value <= statement->maximum))
        return false;
    statement->apply(shaft, *value);
    return true;
}

} // namespace campanel::controller
