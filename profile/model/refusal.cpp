// SPDX-License-Identifier: Apache-2.0
// The ids of limits.
#include "profile/model/refusal.h"

#include "profile/model/text.h"

#include <array>

namespace campanel::profile {

std::string_view limitId(Limit limit)
{
    static constexpr auto ids = std::to_array<std::string_view>(
        {"field_range",       "pinned_pair",         "law_unknown",       "law_parameter",
         "ratio_order",       "stroke_cannot_close", "motor_speed",       "knife_acceleration",
         "pulse_frequency",   "machine_rate",        "row_capacity",      "too_few_pulses",
         "axis_acceleration", "motor_torque",        "no_motion",         "distance_too_short",
         "distance_sign",     "knot_count",          "knot_order",        "knot_spacing",
         "knot_range",        "knot_ends",           "overshoot",         "wrap_jump",
         "stage_order",       "force_order",         "master_too_fast",   "table_range",
         "reversal",          "speed_error",         "ramp_too_long",     "jaw_window",
         "seal_time",         "rms_torque",          "natural_frequency", "segment_count",
         "segment_range",     "segment_width",       "segment_overlap",   "segment_gap",
         "segment_ends",      "segment_motion",      "joint_jump"});
    return ids[static_cast<std::size_t>(limit)];
}

std::string describe(const Refusal& refusal)
{
    return detail::concat({limitId(refusal.limit), ": ", info(refusal.field).id, " ",
                           detail::significantText(refusal.actual), ", allowed ",
                           detail::significantText(refusal.allowed), " ", refusal.unit});
}

} // namespace campanel::profile
