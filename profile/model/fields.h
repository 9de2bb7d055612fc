// SPDX-License-Identifier: Apache-2.0
// Every number that a person can enter: stable id (also the key in the recipe file), unit, range, default and
// decimals. The panel, the command line and the validation of recipes use this table.
#pragma once

#include "text/marked.h"

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
    std::string_view id; // key in the recipe file
    // Its register in the bank's header, behind the prefix of the kind: "program." + "bag_length". Empty: it
    // is in the recipe file alone, and only the panel checks it.
    std::string_view registerName;
    std::string_view group;  // of the inputs, for a screen too small for all of them; empty: none
    std::string_view name;   // label
    std::string_view symbol; // in formulas
    std::string_view unit;   // empty: dimensionless
    double min = 0;
    double max = 0;
    double defaultValue = 0;
    int decimals = 0; // decimal places that a person can enter
    // For a number of machine or film: its meaning, where to find it and the effect of a wrong value.
    std::string_view help{};
    bool isUnknownAtZero = false; // optional data of a machine, without a value while it is 0
    bool isForOperators = false;  // an operator may change it; all others need a technician

    // Returns the smallest step that a person can enter: 10^-decimals.
    [[nodiscard]] constexpr double resolution() const
    {
        double step = 1;
        for (int i = 0; i < decimals; ++i)
            step /= 10;
        return step;
    }
};

// Columns that few rows have.
[[nodiscard]] constexpr FieldInfo unknownAtZero(FieldInfo row)
{
    row.isUnknownAtZero = true;
    return row;
}

[[nodiscard]] constexpr FieldInfo forOperators(FieldInfo row)
{
    row.isForOperators = true;
    return row;
}

inline constexpr std::array fields{
    forOperators(FieldInfo{Field::BagLength, "bag_length_mm", "bag_length", "",
                           CAMPANEL_TEXT("Recipe", "Bag length"), "L", "mm", 10, 2000, 250, 1}),
    forOperators(FieldInfo{Field::Rate, "rate_bags_per_min", "rate", "", CAMPANEL_TEXT("Recipe", "Rate"), "n",
                           "bags/min", 1, 600, 60, 1}),
    FieldInfo{Field::BaseSpeed, "base_speed_mm_per_s", "base_speed", "",
              CAMPANEL_TEXT("Recipe", "Base speed v_a"), "v_a", "mm/s", 0, 10000, 445.4, 1},
    FieldInfo{Field::FilmSpeed, "film_speed_mm_per_s", "film_speed", "",
              CAMPANEL_TEXT("Recipe", "Film speed v_b"), "v_b", "mm/s", 0.1, 10000, 250, 1},
    FieldInfo{Field::K1, "k1", "k1", "", CAMPANEL_TEXT("Recipe", "Ratio k1"), "k1", "", 1.0001, 1000, 4, 4},
    FieldInfo{Field::K2, "k2", "k2", "", CAMPANEL_TEXT("Recipe", "Ratio k2"), "k2", "", 1.0001, 1000, 2.5, 4},
    FieldInfo{Field::K3, "k3", "k3", "", CAMPANEL_TEXT("Recipe", "Ratio k3"), "k3", "", 1.0001, 1000, 1.6667,
              4},
    FieldInfo{Field::K4, "k4", "k4", "", CAMPANEL_TEXT("Recipe", "Ratio k4"), "k4", "", 1.0001, 1000, 1.3333,
              4},
    FieldInfo{Field::SyncRatio, "sync_ratio", "sync_ratio", "", CAMPANEL_TEXT("Recipe", "Sync ratio"), "c",
              "", 0.5, 2, 1, 3},
    FieldInfo{Field::SlicesPerRamp, "slices_per_ramp", "ramp_slices", "",
              CAMPANEL_TEXT("Recipe", "Slices per ramp"), "m", "", 1, 1000, 60, 0},
    FieldInfo{Field::KnifeRadius, "knife_radius_mm", "knife_radius", "",
              CAMPANEL_TEXT("Recipe", "Knife radius R"), "R", "mm", 5, 1000, 60, 2,
              CAMPANEL_TEXT("Recipe", "Distance from the shaft's center to the knife edge: half of the "
                                      "diameter measured at the edge. All knife speeds refer to the edge.")},
    FieldInfo{Field::Knives, "knives", "knives", "", CAMPANEL_TEXT("Recipe", "Knives N"), "N", "", 1, 12, 1,
              0,
              CAMPANEL_TEXT(
                  "Recipe",
                  "Number of knives on the shaft, evenly spaced. Each bag turns the shaft by one knife.")},
    FieldInfo{Field::PulsesPerMotorRev, "pulses_per_motor_rev", "pulses_per_motor_rev", "",
              CAMPANEL_TEXT("Recipe", "Pulses per motor rev. K"), "K", "", 1, 10000000, 10000, 0,
              CAMPANEL_TEXT("Recipe", "Pulses per motor revolution, as set in the servo drive's electronic "
                                      "gear. A wrong value makes all bags too long or too short.")},
    FieldInfo{Field::GearNumerator, "gear_numerator", "gear_numerator", "",
              CAMPANEL_TEXT("Recipe", "Gear Z, motor revs"), "Z1", "", 1, 65535, 1, 0,
              CAMPANEL_TEXT("Recipe", "Motor revolutions for the knife shaft revolutions below, see the "
                                      "gear's nameplate: 7 and 3 for a gear of 7:3.")},
    FieldInfo{Field::GearDenominator, "gear_denominator", "gear_denominator", "",
              CAMPANEL_TEXT("Recipe", "Gear Z, knife revs"), "Z2", "", 1, 65535, 1, 0,
              CAMPANEL_TEXT("Recipe", "Knife shaft revolutions for the motor revolutions above.")},
    FieldInfo{Field::MaxMotorRpm, "max_motor_rpm", "", "", CAMPANEL_TEXT("Recipe", "Max. motor speed"),
              "rpm_max", "r/min", 1, 20000, 3000, 0,
              CAMPANEL_TEXT("Recipe",
                            "Maximum motor speed, see the motor's nameplate. No recipe exceeds this speed.")},
    FieldInfo{Field::MaxKnifeAcceleration, "max_knife_acceleration_mm_per_s2", "", "",
              CAMPANEL_TEXT("Recipe", "Max. acceleration"), "a_max", "mm/s^2", 1, 10000000, 50000, 0,
              CAMPANEL_TEXT("Recipe", "Maximum acceleration without vibration or loss of position. Start "
                                      "with a low value, and raise it as the following error allows.")},
    FieldInfo{Field::MaxPulseFrequency, "max_pulse_frequency_hz", "", "",
              CAMPANEL_TEXT("Recipe", "Max. pulse frequency"), "f_max", "Hz", 1000, 4000000, 200000, 0,
              CAMPANEL_TEXT("Recipe", "Maximum pulse frequency of the drive's input, see its manual. The "
                                      "controller has its own limit.")},
    FieldInfo{Field::MaxRate, "max_rate_bags_per_min", "", "", CAMPANEL_TEXT("Recipe", "Max. rate"), "n_max",
              "bags/min", 1, 600, 400, 1,
              CAMPANEL_TEXT("Recipe",
                            "Maximum rate that sealing time and infeed allow, independent of the knife.")},
    FieldInfo{Field::TimerClock, "timer_clock_hz", "", "", CAMPANEL_TEXT("Recipe", "Timer clock"), "f_clk",
              "Hz", 100000, 60000000, 8000000, 0},
    FieldInfo{Field::TimerBits, "timer_bits", "", "", CAMPANEL_TEXT("Recipe", "Timer width"), "bits", "bit",
              8, 32, 16, 0},
    FieldInfo{Field::RowCapacity, "row_capacity", "", "", CAMPANEL_TEXT("Recipe", "Rows in the controller"),
              "rows", "", 5, 65535, 2048, 0},
    // Axes other than the knife axis, and their programs.
    FieldInfo{
        Field::FeedPerMotorRev, "feed_mm_per_motor_rev", "feed", "",
        CAMPANEL_TEXT("Recipe", "Feed per motor rev."), "p", "mm", 0.01, 10000, 100, 3,
        CAMPANEL_TEXT("Recipe", "Travel of the axis per motor revolution, including gear and spindle.")},
    FieldInfo{Field::MaxAcceleration, "max_acceleration_mm_per_s2", "max_acceleration", "",
              CAMPANEL_TEXT("Recipe", "Max. acceleration"), "a_max", "mm/s^2", 1, 10000000, 50000, 0,
              CAMPANEL_TEXT("Recipe", "Maximum acceleration without vibration or loss of position. Start "
                                      "with a low value, and raise it as the following error allows.")},
    // Torque and inertia are unknown while they are 0.
    unknownAtZero(FieldInfo{
        Field::MaxTorque, "max_torque_nm", "", "", CAMPANEL_TEXT("Recipe", "Max. motor torque"), "M_max",
        "Nm", 0, 10000, 0, 3,
        CAMPANEL_TEXT("Recipe",
                      "Peak torque of the motor, see the motor's nameplate. 0: unknown, no limit.")}),
    unknownAtZero(FieldInfo{
        Field::Inertia, "inertia_kg_cm2", "inertia", "", CAMPANEL_TEXT("Recipe", "Inertia at the motor"), "J",
        "kg cm^2", 0, 100000, 0, 3,
        CAMPANEL_TEXT("Recipe", "Total inertia of motor, gear and load at the motor. CamPanel uses the "
                                "inertia to estimate the torque of a motion. 0: unknown.")}),
    FieldInfo{
        Field::Friction, "friction_nm", "friction", "", CAMPANEL_TEXT("Recipe", "Friction at the motor"),
        "M_f", "Nm", 0, 1000, 0, 3,
        CAMPANEL_TEXT("Recipe", "Friction torque at the motor while the axis turns slowly and steadily.")},
    FieldInfo{Field::Distance, "distance_mm", "distance", "move", CAMPANEL_TEXT("Recipe", "Distance"), "S",
              "mm", -1000000, 1000000, 6000, 3},
    FieldInfo{Field::MoveTime, "time_s", "time", "move", CAMPANEL_TEXT("Recipe", "Time"), "T", "s", 0.01, 600,
              1, 3},
    FieldInfo{Field::StartSpeed, "start_speed_mm_per_s", "start_speed", "move",
              CAMPANEL_TEXT("Recipe", "Start speed"), "V0", "mm/s", -100000, 100000, 0, 1},
    FieldInfo{Field::EndSpeed, "end_speed_mm_per_s", "end_speed", "move",
              CAMPANEL_TEXT("Recipe", "End speed"), "V1", "mm/s", -100000, 100000, 9000, 1},
    FieldInfo{Field::CamPoints, "cam_points", "cam_points", "curve",
              CAMPANEL_TEXT("Recipe", "Table intervals"), "N", "", 100, 2000, 100, 0},
    FieldInfo{Field::MasterRate, "master_rate_rev_per_min", "master_rate", "master",
              CAMPANEL_TEXT("Recipe", "Master speed"), "n_m", "r/min", -1000, 1000, 60, 1},
    FieldInfo{Field::MasterRamp, "master_ramp_s", "master_ramp", "master",
              CAMPANEL_TEXT("Recipe", "Master ramp"), "T_r", "s", 0.05, 60, 0.8, 2},
    FieldInfo{Field::MasterRatio, "master_ratio", "master_ratio", "master",
              CAMPANEL_TEXT("Recipe", "Master revs/cycle"), "i", "", 0.01, 1000, 1, 3},
    FieldInfo{Field::MasterScale, "master_scale", "master_scale", "master",
              CAMPANEL_TEXT("Recipe", "Master scale"), "x", "", 0.01, 100, 1, 3},
    FieldInfo{Field::SlaveScale, "slave_scale", "slave_scale", "output",
              CAMPANEL_TEXT("Recipe", "Slave scale"), "y", "", -100, 100, 1, 3},
    FieldInfo{Field::Phase, "phase_deg", "phase", "output", CAMPANEL_TEXT("Recipe", "Phase"), "phi", "deg",
              -360, 360, 0, 1},
    FieldInfo{Field::ApproachPosition, "approach_position_mm", "approach_position", "approach",
              CAMPANEL_TEXT("Recipe", "Approach to"), "s_B", "mm", 0, 1000, 60, 2},
    FieldInfo{Field::ApproachSpeed, "approach_speed_mm_per_s", "approach_speed", "approach",
              CAMPANEL_TEXT("Recipe", "Approach speed"), "v_AB", "mm/s", 40, 100, 80, 1},
    FieldInfo{Field::ProbeSpeed, "probe_speed_mm_per_s", "probe_speed", "approach",
              CAMPANEL_TEXT("Recipe", "Probe speed"), "v_BC", "mm/s", 2, 5, 4, 1},
    FieldInfo{Field::ProbeForce, "probe_force_n", "probe_force", "approach",
              CAMPANEL_TEXT("Recipe", "Probe force"), "F_C", "N", 10, 60000, 200, 0},
    FieldInfo{Field::ProbeEnd, "probe_end_mm", "probe_end", "approach",
              CAMPANEL_TEXT("Recipe", "Contact before"), "s_C", "mm", 0, 1000, 90, 2},
    FieldInfo{Field::PressSpeed, "press_speed_mm_per_s", "press_speed", "press",
              CAMPANEL_TEXT("Recipe", "Press speed"), "v_CD", "mm/s", 5, 15, 10, 1},
    FieldInfo{Field::PressPosition, "press_position_mm", "press_position", "press",
              CAMPANEL_TEXT("Recipe", "Press to"), "s_D", "mm", 0, 1000, 100, 2},
    FieldInfo{Field::HoldTime, "hold_time_s", "hold_time", "press", CAMPANEL_TEXT("Recipe", "Hold time"),
              "t_DE", "s", 0, 60, 0.5, 2},
    FieldInfo{Field::ReturnSpeed, "return_speed_mm_per_s", "return_speed", "press",
              CAMPANEL_TEXT("Recipe", "Return speed"), "v_EF", "mm/s", 1, 200, 80, 1},
    FieldInfo{Field::MaxForce, "max_force_n", "max_force", "limits", CAMPANEL_TEXT("Recipe", "Max. force"),
              "F_max", "N", 10, 60000, 8000, 0},
    FieldInfo{Field::PositionTolerance, "position_tolerance_mm", "position_tolerance", "limits",
              CAMPANEL_TEXT("Recipe", "Stop tolerance"), "e", "mm", 0.01, 10, 0.02, 2},
    FieldInfo{Field::MinStopForce, "min_stop_force_n", "min_stop_force", "limits",
              CAMPANEL_TEXT("Recipe", "Min. force at stop"), "F_min", "N", 0, 60000, 1000, 0},
    FieldInfo{Field::MaxStopForce, "max_stop_force_n", "max_stop_force", "limits",
              CAMPANEL_TEXT("Recipe", "Max. force at stop"), "F_top", "N", 0, 60000, 6000, 0},
    // The sealing jaws of a rotary cutter: 0 is a thin knife, and a film without a required seal time.
    FieldInfo{Field::ContactAngle, "contact_angle_deg", "", "", CAMPANEL_TEXT("Recipe", "Jaw contact angle"),
              "theta_c", "deg", 0, 180, 0, 1,
              CAMPANEL_TEXT(
                  "Recipe",
                  "Angle of the knife shaft over which the sealing jaws touch the film: their arc divided by "
                  "the knife radius. 0 is a thin knife, without checks of window and seal time.")},
    FieldInfo{
        Field::MinSealTime, "min_seal_time_ms", "", "", CAMPANEL_TEXT("Recipe", "Min. seal time"),
        "t_min", "ms", 0, 10000, 0, 0,
        CAMPANEL_TEXT("Recipe",
                      "Minimum time of the jaws on the film, see the film's data sheet. The panel limits the "
                      "rate accordingly. The controller does not store this value. 0: no minimum.")},
    // The ramps of a rotary cutter: 0 the slowest motor, 50 the coolest, 100 the gentlest.
    FieldInfo{Field::RampPosition, "ramp_position_percent", "", "",
              CAMPANEL_TEXT("Recipe", "Ramps, slow to gentle"), "p", "%", 0, 100, 100, 0},
    unknownAtZero(FieldInfo{
        Field::RatedTorque,
        "rated_torque_nm", "", "", CAMPANEL_TEXT("Recipe", "Rated motor torque"), "M_n", "Nm", 0, 10000, 0, 3,
        CAMPANEL_TEXT("Recipe", "Continuous torque of the motor, see the motor's nameplate. The RMS "
                                "torque of a cycle stays below it. 0: unknown, no limit.")}),
    unknownAtZero(
        FieldInfo{Field::NaturalFrequency, "natural_frequency_hz", "", "",
                  CAMPANEL_TEXT("Recipe", "Natural frequency"), "f_0", "Hz", 0, 1000, 0, 1,
                  CAMPANEL_TEXT("Recipe", "Lowest natural frequency of the shaft behind the motor, from a "
                                          "measurement or the drive's analysis. 0: unknown.")}),
    FieldInfo{Field::DampingRatio, "damping_ratio", "", "", CAMPANEL_TEXT("Recipe", "Damping ratio"), "zeta",
              "", 0.001, 0.9, 0.05, 3,
              CAMPANEL_TEXT("Recipe", "Damping of this vibration as a share of critical damping. 0.05 is "
                                      "usual for a shaft with gear.")},
};

[[nodiscard]] constexpr const FieldInfo& info(Field field)
{
    return fields[static_cast<std::size_t>(field)];
}

// Returns the field with this id, or nothing.
[[nodiscard]] std::optional<Field> fieldById(std::string_view id);

// Returns true when the value is finite and inside the field's range, with a tolerance for the rounding of
// derived values.
[[nodiscard]] bool inRange(Field field, double value);

// Returns the nearest value on the field's grid that is inside its range.
[[nodiscard]] double snapToGrid(Field field, double value);

} // namespace campanel::profile
