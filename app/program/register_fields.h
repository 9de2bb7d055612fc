// SPDX-License-Identifier: Apache-2.0
// Which input of a recipe is kept in which register of the bank's header: the table where profile and
// registers meet.
#pragma once

#include "profile/fields.h"

#include <array>
#include <string_view>

namespace campanel::program {

struct RegisterField {
    std::string_view registerName;
    profile::Field field = profile::Field::BagLength;
};

inline constexpr std::array registerFields{
    RegisterField{"program.bag_length", profile::Field::BagLength},
    RegisterField{"program.rate", profile::Field::Rate},
    RegisterField{"program.base_speed", profile::Field::BaseSpeed},
    RegisterField{"program.film_speed", profile::Field::FilmSpeed},
    RegisterField{"program.k1", profile::Field::K1},
    RegisterField{"program.k2", profile::Field::K2},
    RegisterField{"program.k3", profile::Field::K3},
    RegisterField{"program.k4", profile::Field::K4},
    RegisterField{"program.sync_ratio", profile::Field::SyncRatio},
    RegisterField{"program.ramp_slices", profile::Field::SlicesPerRamp},
    RegisterField{"program.knife_radius", profile::Field::KnifeRadius},
    RegisterField{"program.knives", profile::Field::Knives},
    RegisterField{"program.pulses_per_motor_rev", profile::Field::PulsesPerMotorRev},
    RegisterField{"program.gear_numerator", profile::Field::GearNumerator},
    RegisterField{"program.gear_denominator", profile::Field::GearDenominator},
};

} // namespace campanel::program
