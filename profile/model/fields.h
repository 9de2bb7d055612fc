// SPDX-License-Identifier: Apache-2.0
// Every number that a person can enter: stable id (also the key in the recipe file), unit, range, default and
// decimals. The panel, the command line and the validation of recipes use this table.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace campanel::profile {

enum class Field : std::uint8_t {
    BagLength,
    Rate,
    BaseSpeed,
    FilmSpeed,
    K1,
    K2,
    K3,
    K4,
    SyncRatio,
    SlicesPerRamp,
    KnifeRadius,
    Knives,
    PulsesPerMotorRev,
    GearNumerator,
    GearDenominator,
    MaxMotorRpm,
    MaxKnifeAcceleration,
    MaxPulseFrequency,
    MaxRate,
    TimerClock,
    TimerBits,
    RowCapacity,
    FeedPerMotorRev,
    MaxAcceleration,
    MaxTorque,
    Inertia,
    Friction,
    Distance,
    MoveTime,
    StartSpeed,
    EndSpeed,
    CamPoints,
    MasterRate,
    MasterRamp,
    MasterRatio,
    MasterScale,
    SlaveScale,
    Phase,
    ApproachPosition,
    ApproachSpeed,
    ProbeSpeed,
    ProbeForce,
    ProbeEnd,
    PressSpeed,
    PressPosition,
    HoldTime,
    ReturnSpeed,
    MaxForce,
    PositionTolerance,
    MinStopForce,
    MaxStopForce,
    ContactAngle,
    MinSealTime,
    RampPosition,
    // Optional machine data of every axis but the press's; 0 is unknown.
    RatedTorque,
    NaturalFrequency,
    DampingRatio,
};

struct FieldInfo {
    Field field = Field::BagLength;
    std::string_view id;     // key in the recipe file
    std::string_view name;   // English name
    std::string_view symbol; // in formulas
    std::string_view unit;   // empty: dimensionless
    double min = 0;
    double max = 0;
    double defaultValue = 0;
    int decimals = 0; // decimal places that a person can enter

    // Returns the smallest step that a person can enter: 10^-decimals.
    [[nodiscard]] constexpr double resolution() const
    {
        double step = 1;
        for (int i = 0; i < decimals; ++i)
            step /= 10;
        return step;
    }
};

inline constexpr std::array fields{
    FieldInfo{Field::BagLength, "bag_length_mm", "Bag length", "L", "mm", 10, 2000, 250, 1},
    FieldInfo{Field::Rate, "rate_bags_per_min", "Rate", "n", "bags/min", 1, 600, 60, 1},
    FieldInfo{Field::BaseSpeed, "base_speed_mm_per_s", "Base speed", "v_a", "mm/s", 0, 10000, 445.4, 1},
    FieldInfo{Field::FilmSpeed, "film_speed_mm_per_s", "Film speed", "v_b", "mm/s", 0.1, 10000, 250, 1},
    FieldInfo{Field::K1, "k1", "Ratio k1", "k1", "", 1.0001, 1000, 4, 4},
    FieldInfo{Field::K2, "k2", "Ratio k2", "k2", "", 1.0001, 1000, 2.5, 4},
    FieldInfo{Field::K3, "k3", "Ratio k3", "k3", "", 1.0001, 1000, 1.6667, 4},
    FieldInfo{Field::K4, "k4", "Ratio k4", "k4", "", 1.0001, 1000, 1.3333, 4},
    FieldInfo{Field::SyncRatio, "sync_ratio", "Sync ratio", "c", "", 0.5, 2, 1, 3},
    FieldInfo{Field::SlicesPerRamp, "slices_per_ramp", "Slices per ramp", "m", "", 1, 1000, 60, 0},
    FieldInfo{Field::KnifeRadius, "knife_radius_mm", "Knife radius", "R", "mm", 5, 1000, 60, 2},
    FieldInfo{Field::Knives, "knives", "Knives", "N", "", 1, 12, 1, 0},
    FieldInfo{Field::PulsesPerMotorRev, "pulses_per_motor_rev", "Pulses per motor revolution", "K", "", 1,
              10000000, 10000, 0},
    FieldInfo{Field::GearNumerator, "gear_numerator", "Gear ratio, motor revolutions", "Z1", "", 1, 65535, 1,
              0},
    FieldInfo{Field::GearDenominator, "gear_denominator", "Gear ratio, knife revolutions", "Z2", "", 1, 65535,
              1, 0},
    FieldInfo{Field::MaxMotorRpm, "max_motor_rpm", "Largest motor speed", "rpm_max", "r/min", 1, 20000, 3000,
              0},
    FieldInfo{Field::MaxKnifeAcceleration, "max_knife_acceleration_mm_per_s2", "Largest knife acceleration",
              "a_max", "mm/s^2", 1, 10000000, 50000, 0},
    FieldInfo{Field::MaxPulseFrequency, "max_pulse_frequency_hz", "Largest pulse frequency", "f_max", "Hz",
              1000, 4000000, 200000, 0},
    FieldInfo{Field::MaxRate, "max_rate_bags_per_min", "Largest rate", "n_max", "bags/min", 1, 600, 400, 1},
    FieldInfo{Field::TimerClock, "timer_clock_hz", "Timer clock", "f_clk", "Hz", 100000, 60000000, 8000000,
              0},
    FieldInfo{Field::TimerBits, "timer_bits", "Timer width", "bits", "bit", 8, 32, 16, 0},
    FieldInfo{Field::RowCapacity, "row_capacity", "Table rows of the controller", "rows", "", 5, 65535, 2048,
              0},
    // Axes other than the knife axis, and their programs.
    FieldInfo{Field::FeedPerMotorRev, "feed_mm_per_motor_rev", "Feed per motor revolution", "p", "mm", 0.01,
              10000, 100, 3},
    FieldInfo{Field::MaxAcceleration, "max_acceleration_mm_per_s2", "Largest acceleration", "a_max", "mm/s^2",
              1, 10000000, 50000, 0},
    // Torque and inertia are unknown while they are 0.
    FieldInfo{Field::MaxTorque, "max_torque_nm", "Largest motor torque", "M_max", "Nm", 0, 10000, 0, 3},
    FieldInfo{Field::Inertia, "inertia_kg_cm2", "Inertia at the motor", "J", "kg cm^2", 0, 100000, 0, 3},
    FieldInfo{Field::Friction, "friction_nm", "Friction at the motor", "M_f", "Nm", 0, 1000, 0, 3},
    FieldInfo{Field::Distance, "distance_mm", "Distance", "S", "mm", -1000000, 1000000, 6000, 3},
    FieldInfo{Field::MoveTime, "time_s", "Time", "T", "s", 0.01, 600, 1, 3},
    FieldInfo{Field::StartSpeed, "start_speed_mm_per_s", "Start speed", "V0", "mm/s", -100000, 100000, 0, 1},
    FieldInfo{Field::EndSpeed, "end_speed_mm_per_s", "End speed", "V1", "mm/s", -100000, 100000, 9000, 1},
    FieldInfo{Field::CamPoints, "cam_points", "Intervals of the cam table", "N", "", 100, 2000, 100, 0},
    FieldInfo{Field::MasterRate, "master_rate_rev_per_min", "Master speed", "n_m", "r/min", -1000, 1000, 60,
              1},
    FieldInfo{Field::MasterRamp, "master_ramp_s", "Ramp of the master", "T_r", "s", 0.05, 60, 0.8, 2},
    FieldInfo{Field::MasterRatio, "master_ratio", "Master revolutions per cam cycle", "i", "", 0.01, 1000, 1,
              3},
    FieldInfo{Field::MasterScale, "master_scale", "Master scale", "x", "", 0.01, 100, 1, 3},
    FieldInfo{Field::SlaveScale, "slave_scale", "Slave scale", "y", "", -100, 100, 1, 3},
    FieldInfo{Field::Phase, "phase_deg", "Phase", "phi", "deg", -360, 360, 0, 1},
    FieldInfo{Field::ApproachPosition, "approach_position_mm", "Approach to", "s_B", "mm", 0, 1000, 60, 2},
    FieldInfo{Field::ApproachSpeed, "approach_speed_mm_per_s", "Approach speed", "v_AB", "mm/s", 40, 100, 80,
              1},
    FieldInfo{Field::ProbeSpeed, "probe_speed_mm_per_s", "Probe speed", "v_BC", "mm/s", 2, 5, 4, 1},
    FieldInfo{Field::ProbeForce, "probe_force_n", "Probe force", "F_C", "N", 10, 60000, 200, 0},
    FieldInfo{Field::ProbeEnd, "probe_end_mm", "Touch at the latest at", "s_C", "mm", 0, 1000, 90, 2},
    FieldInfo{Field::PressSpeed, "press_speed_mm_per_s", "Press speed", "v_CD", "mm/s", 5, 15, 10, 1},
    FieldInfo{Field::PressPosition, "press_position_mm", "Press to", "s_D", "mm", 0, 1000, 100, 2},
    FieldInfo{Field::HoldTime, "hold_time_s", "Hold", "t_DE", "s", 0, 60, 0.5, 2},
    FieldInfo{Field::ReturnSpeed, "return_speed_mm_per_s", "Return speed", "v_EF", "mm/s", 1, 200, 80, 1},
    FieldInfo{Field::MaxForce, "max_force_n", "Largest force", "F_max", "N", 10, 60000, 8000, 0},
    FieldInfo{Field::PositionTolerance, "position_tolerance_mm", "Tolerance of the stop position", "e", "mm",
              0.01, 10, 0.02, 2},
    FieldInfo{Field::MinStopForce, "min_stop_force_n", "Least force at the stop", "F_min", "N", 0, 60000,
              1000, 0},
    FieldInfo{Field::MaxStopForce, "max_stop_force_n", "Most force at the stop", "F_top", "N", 0, 60000, 6000,
              0},
    // The sealing jaws of a rotary cutter: 0 is a thin knife, and a film without a required seal time.
    FieldInfo{Field::ContactAngle, "contact_angle_deg", "Contact angle of the jaws", "theta_c", "deg", 0, 180,
              0, 1},
    FieldInfo{Field::MinSealTime, "min_seal_time_ms", "Minimum seal time", "t_min", "ms", 0, 10000, 0, 0},
    // The ramps of a rotary cutter: 0 the slowest motor, 50 the coolest, 100 the gentlest.
    FieldInfo{Field::RampPosition, "ramp_position_percent", "Ramps from slowest to gentlest", "p", "%", 0,
              100, 100, 0},
    FieldInfo{Field::RatedTorque, "rated_torque_nm", "Rated motor torque", "M_n", "Nm", 0, 10000, 0, 3},
    FieldInfo{Field::NaturalFrequency, "natural_frequency_hz", "Natural frequency", "f_0", "Hz", 0, 1000, 0,
              1},
    FieldInfo{Field::DampingRatio, "damping_ratio", "Damping ratio", "zeta", "", 0.001, 0.9, 0.05, 3},
};

[[nodiscard]] constexpr const FieldInfo& info(Field field)
{
    return fields[static_cast<std::size_t>(field)];
}

// Returns true when the field has no value while it is 0: optional data of a machine.
[[nodiscard]] constexpr bool isUnknownAtZero(Field field)
{
    return field == Field::MaxTorque || field == Field::RatedTorque || field == Field::Inertia ||
           field == Field::NaturalFrequency;
}

// Returns the field with this id, or nothing.
[[nodiscard]] std::optional<Field> fieldById(std::string_view id);

// Returns true when the value is finite and inside the field's range, with a tolerance for the rounding of
// derived values.
[[nodiscard]] bool inRange(Field field, double value);

// Returns the nearest value on the field's grid that is inside its range.
[[nodiscard]] double snapToGrid(Field field, double value);

} // namespace campanel::profile
