// SPDX-License-Identifier: Apache-2.0
// The explanations of the machine's numbers, for the person who enters them.
#include "app/panel/words/recipe_words.h"

namespace campanel::panel {

using profile::Field;

QString RecipeWords::machineHelp(Field field)
{
    switch (field) {
    case Field::KnifeRadius:
        return tr("Distance from the shaft's center to the knife edge: half of the diameter measured at the "
                  "edge. All knife speeds refer to the edge.");
    case Field::Knives:
        return tr("Number of knives on the shaft, evenly spaced. Each bag turns the shaft by one knife.");
    case Field::PulsesPerMotorRev:
        return tr("Pulses per motor revolution, as set in the servo drive's electronic gear. A wrong value "
                  "makes all bags too long or too short.");
    case Field::GearNumerator:
        return tr("Motor revolutions for the knife shaft revolutions below, see the gear's nameplate: 7 and "
                  "3 for a gear of 7:3.");
    case Field::GearDenominator:
        return tr("Knife shaft revolutions for the motor revolutions above.");
    case Field::MaxMotorRpm:
        return tr("Maximum motor speed, see the motor's nameplate. No recipe exceeds this speed.");
    case Field::MaxKnifeAcceleration:
    case Field::MaxAcceleration:
        return tr("Maximum acceleration without vibration or loss of position. Start with a low value, and "
                  "raise it as the following error allows.");
    case Field::MaxPulseFrequency:
        return tr("Maximum pulse frequency of the drive's input, see its manual. The controller has its own "
                  "limit.");
    case Field::MaxRate:
        return tr("Maximum rate that sealing time and infeed allow, independent of the knife.");
    case Field::ContactAngle:
        return tr("Angle of the knife shaft over which the sealing jaws touch the film: their arc divided by "
                  "the knife radius. 0 is a thin knife, without checks of window and seal time.");
    case Field::MinSealTime:
        return tr(
            "Minimum time of the jaws on the film, see the film's data sheet. The panel limits the rate "
            "accordingly. The controller does not store this value. 0: no minimum.");
    case Field::FeedPerMotorRev:
        return tr("Travel of the axis per motor revolution, including gear and spindle.");
    case Field::MaxTorque:
        return tr("Peak torque of the motor, see the motor's nameplate. 0: unknown, no limit.");
    case Field::Inertia:
        return tr("Total inertia of motor, gear and load at the motor. CamPanel uses the inertia to estimate "
                  "the torque of a motion. 0: unknown.");
    case Field::Friction:
        return tr("Friction torque at the motor while the axis turns slowly and steadily.");
    case Field::RatedTorque:
        return tr(
            "Continuous torque of the motor, see the motor's nameplate. The RMS torque of a cycle stays "
            "below it. 0: unknown, no limit.");
    case Field::NaturalFrequency:
        return tr("Lowest natural frequency of the shaft behind the motor, from a measurement or the drive's "
                  "analysis. 0: unknown.");
    case Field::DampingRatio:
        return tr("Damping of this vibration as a share of critical damping. 0.05 is usual for a shaft with "
                  "gear.");
    default:
        return {};
    }
}

} // namespace campanel::panel
