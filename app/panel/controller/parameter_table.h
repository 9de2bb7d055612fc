// SPDX-License-Identifier: Apache-2.0
// The parameters of the controller that a tile shows, by their names in the register table, which has unit,
// limits and default.
#pragma once

#include <QtGlobal>

#include <array>
#include <string_view>

namespace campanel::panel {

struct ParameterRow {
    std::string_view name;
    const char* label;
};

inline constexpr std::array parameterTable{
    ParameterRow{"parameter.jog_frequency",
                 QT_TRANSLATE_NOOP("campanel::panel::ParameterField", "Jog speed")},
    ParameterRow{"parameter.home_frequency",
                 QT_TRANSLATE_NOOP("campanel::panel::ParameterField", "Reference run speed")},
};

} // namespace campanel::panel
