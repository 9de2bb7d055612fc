// SPDX-License-Identifier: Apache-2.0
// Look-ups in the table of fields.
#include "profile/fields.h"

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

// Relative room for the rounding of derived values at the edge of a range.
constexpr double rangeTolerance = 1e-9;

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
    const double room = rangeTolerance * f.max;
    return std::isfinite(value) && value >= f.min - std::min(room, f.resolution() * 1e-3) &&
           value <= f.max + room;
}

double snapToGrid(Field field, double value)
{
    const FieldInfo& f = info(field);
    const double scale = std::round(1 / f.resolution());
    return std::clamp(std::round(value * scale) / scale, f.min, f.max);
}

} // namespace campanel::profile
