// SPDX-License-Identifier: Apache-2.0
// The table of the recipe's inputs and their registers in the bank's header: it connects profile and
// registers.
#pragma once

#include "app/program/program_kinds.h"

#include "modbus/map/register_map.h"

#include <array>
#include <string_view>

namespace campanel::program {

// The register of a field. `suffix` follows the register prefix of the kind: "program." + "bag_length".
struct RegisterField {
    std::string_view suffix;
    profile::Field field = profile::Field::BagLength;
};

struct RegisterChoice {
    std::string_view suffix;
    Choice choice = Choice::Law;
};

inline constexpr std::array registerFields{
    RegisterField{"bag_length", profile::Field::BagLength},
    RegisterField{"rate", profile::Field::Rate},
    RegisterField{"base_speed", profile::Field::BaseSpeed},
    RegisterField{"film_speed", profile::Field::FilmSpeed},
    RegisterField{"k1", profile::Field::K1},
    RegisterField{"k2", profile::Field::K2},
    RegisterField{"k3", profile::Field::K3},
    RegisterField{"k4", profile::Field::K4},
    RegisterField{"sync_ratio", profile::Field::SyncRatio},
    RegisterField{"ramp_slices", profile::Field::SlicesPerRamp},
    RegisterField{"knife_radius", profile::Field::KnifeRadius},
    RegisterField{"knives", profile::Field::Knives},
    RegisterField{"pulses_per_motor_rev", profile::Field::PulsesPerMotorRev},
    RegisterField{"gear_numerator", profile::Field::GearNumerator},
    RegisterField{"gear_denominator", profile::Field::GearDenominator},
    RegisterField{"feed", profile::Field::FeedPerMotorRev},
    RegisterField{"inertia", profile::Field::Inertia},
    RegisterField{"friction", profile::Field::Friction},
    RegisterField{"max_acceleration", profile::Field::MaxAcceleration},
    RegisterField{"distance", profile::Field::Distance},
    RegisterField{"time", profile::Field::MoveTime},
    RegisterField{"start_speed", profile::Field::StartSpeed},
    RegisterField{"end_speed", profile::Field::EndSpeed},
    RegisterField{"cam_points", profile::Field::CamPoints},
    RegisterField{"master_rate", profile::Field::MasterRate},
    RegisterField{"master_ratio", profile::Field::MasterRatio},
    RegisterField{"master_scale", profile::Field::MasterScale},
    RegisterField{"slave_scale", profile::Field::SlaveScale},
    RegisterField{"phase", profile::Field::Phase},
    RegisterField{"master_ramp", profile::Field::MasterRamp},
    RegisterField{"approach_position", profile::Field::ApproachPosition},
    RegisterField{"approach_speed", profile::Field::ApproachSpeed},
    RegisterField{"probe_speed", profile::Field::ProbeSpeed},
    RegisterField{"probe_force", profile::Field::ProbeForce},
    RegisterField{"probe_end", profile::Field::ProbeEnd},
    RegisterField{"press_speed", profile::Field::PressSpeed},
    RegisterField{"press_position", profile::Field::PressPosition},
    RegisterField{"hold_time", profile::Field::HoldTime},
    RegisterField{"return_speed", profile::Field::ReturnSpeed},
    RegisterField{"max_force", profile::Field::MaxForce},
    RegisterField{"position_tolerance", profile::Field::PositionTolerance},
    RegisterField{"min_stop_force", profile::Field::MinStopForce},
    RegisterField{"max_stop_force", profile::Field::MaxStopForce},
};

// The inputs without a register: they are in the recipe's file alone. The panel checks them, the controller
// does not need them.
inline constexpr std::array fileFields{profile::Field::MinSealTime, profile::Field::RampPosition};

inline constexpr std::array registerChoices{
    RegisterChoice{"law", Choice::Law},
    RegisterChoice{"duration", Choice::Duration},
    RegisterChoice{"ends", Choice::SplineEnds},
    RegisterChoice{"ramp_shape", Choice::MasterRampShape},
};

// The registers of the law parameters, for every kind with a law.
inline constexpr std::array<std::string_view, profile::maxLawParameters> lawParameterSuffixes{
    "law_parameter1", "law_parameter2"};

// Returns the register units per unit of the field; the master's ramp is in ms in its register.
[[nodiscard]] constexpr double registerUnits(profile::Field field)
{
    return field == profile::Field::MasterRamp ? 1000 : 1;
}

// Returns the register of this input in the header of this kind, or null when the header does not have it.
[[nodiscard]] const modbus::RegisterInfo* registerOf(const KindInfo& kind, std::string_view suffix);

} // namespace campanel::program
