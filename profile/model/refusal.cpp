// SPDX-License-Identifier: Apache-2.0
// The ids and names of limits.
#include "profile/model/refusal.h"

#include "profile/model/text.h"
#include "text/marked.h"

#include <array>

namespace campanel::profile {

namespace {

struct LimitRow {
    std::string_view id;
    std::string_view name{};
};

// In the order of the enum.
constexpr auto limitRows = std::to_array<LimitRow>({
    {"field_range",
     CAMPANEL_TEXT("Recipe", "knife speed")}, // of the speeds in a recipe, for the fastest rate
    {"pinned_pair"},
    {"law_unknown"},
    {"law_parameter"},
    {"ratio_order"},
    {"stroke_cannot_close", CAMPANEL_TEXT("Recipe", "knife stroke")},
    {"motor_speed", CAMPANEL_TEXT("Recipe", "motor speed")},
    {"knife_acceleration", CAMPANEL_TEXT("Recipe", "acceleration")},
    {"pulse_frequency", CAMPANEL_TEXT("Recipe", "pulse frequency")},
    {"machine_rate", CAMPANEL_TEXT("Recipe", "max. rate")},
    {"row_capacity", CAMPANEL_TEXT("Recipe", "table rows")},
    {"too_few_pulses"},
    {"axis_acceleration", CAMPANEL_TEXT("Recipe", "acceleration")},
    {"motor_torque", CAMPANEL_TEXT("Recipe", "motor torque")},
    {"no_motion"},
    {"distance_too_short"},
    {"distance_sign"},
    {"knot_count"},
    {"knot_order"},
    {"knot_spacing"},
    {"knot_range"},
    {"knot_ends"},
    {"overshoot"},
    {"wrap_jump"},
    {"stage_order"},
    {"force_order"},
    {"master_too_fast"},
    {"table_range"},
    {"reversal"},
    {"speed_error"},
    {"ramp_too_long"},
    {"jaw_window", CAMPANEL_TEXT("Recipe", "sync window")},
    {"seal_time", CAMPANEL_TEXT("Recipe", "seal time")},
    {"rms_torque", CAMPANEL_TEXT("Recipe", "RMS torque")},
    {"natural_frequency", CAMPANEL_TEXT("Recipe", "natural frequency")},
    {"segment_count"},
    {"segment_range"},
    {"segment_width"},
    {"segment_overlap"},
    {"segment_gap"},
    {"segment_ends"},
    {"segment_motion"},
    {"joint_jump"},
});
static_assert(limitRows.size() == static_cast<std::size_t>(Limit::JointJump) + 1);

} // namespace

std::string_view limitId(Limit limit)
{
    return limitRows[static_cast<std::size_t>(limit)].id;
}

std::string_view limitName(Limit limit)
{
    return limitRows[static_cast<std::size_t>(limit)].name;
}

std::string describe(const Refusal& refusal)
{
    return detail::concat({limitId(refusal.limit), ": ", info(refusal.field).id, " ",
                           detail::significantText(refusal.actual), ", allowed ",
                           detail::significantText(refusal.allowed), " ", refusal.unit});
}

} // namespace campanel::profile
