// SPDX-License-Identifier: Apache-2.0
// Searches in the table of fields.
#include "profile/model/fields.h"

#include "profile/model/bounds.h"

#include <algorithm>
#include <cmath>

namespace campanel::profile {
namespace {

constexpr bool indexedByField()
{
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (static_cast<std::size_t>(fields[i].field) != i)
            return false;
    }
    return true;
}
static_assert(indexedByField(), "fields must stand in the order of enum Field");

// The tolerance for derived values at the limits of a range: this share of the upper limit, but always less
// than a person can enter.
constexpr double rangeTolerance = 1e-9;
constexpr double resolutionShare = 1e-3; // share of the smallest step

constexpr auto rangeRoom = [] {
    std::array<double, fields.size()> room{};
    for (std::size_t i = 0; i < fields.size(); ++i)
        room[i] = minOf(rangeTolerance * fields[i].max, resolutionShare * fields[i].resolution());
    return room;
}();

} // namespace

std::optional<Field> fieldById(std::string_view id)
{
    const auto found =
        std::find_if(fields.begin(), fields.end(), [id](const FieldInfo& f) { return f.id == id; });
    if (found == fields.end())
        return std::nullopt;
    return found->field;
}

bool inRange(Field field, double value)
{
    const FieldInfo& f = info(field);
    const double room = rangeRoom[static_cast<std::size_t>(field)];
    return std::isfinite(value) && value >= f.min - room && value <= f.max + room;
}

double snapToGrid(Field field, double value)
{
    const FieldInfo& f = info(field);
    const double scale = std::round(1 / f.resolution());
    return clamped(std::round(value * scale) / scale, f.min, f.max);
}

} // namespace campanel::profile
