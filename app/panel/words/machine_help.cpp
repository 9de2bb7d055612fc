// SPDX-License-Identifier: Apache-2.0
// The explanations of the machine's numbers, for the person who enters them.
#include "app/panel/words/recipe_words.h"

namespace campanel::panel {

using profile::Field;

QString RecipeWords::machineHelp(Field field)
{
    switch (field) {
    case Field::KnifeRadius:
        return tr("From the middle of the shaft to the edge of the knife. Measure the diameter at the edge "
                  "and halve it. All speeds "
                  "of the knife are those of this edge.");
    case Field::Knives:
        return tr("Knives on the shaft, evenly spread. Each bag turns the shaft by one knife.");
    case Field::PulsesPerMotorRev:
        return tr("Pulses for one turn of the motor, as the electronic gear of the servo drive is set. A "
                  "wrong number makes all "
                  "bags too long or too short.");
    case Field::GearNumerator:
        return tr("Turns of the motor for the turns of the knife's shaft below, as the gear's plate says: 7 "
                  "and 3 for a gear of 7:3.");
    case Field::GearDenominator:
        return tr("Turns of the knife's shaft for the turns of the motor above.");
    case Field::MaxMotorRpm:
        return tr("The largest speed of the motor, from its plate. No recipe goes beyond it.");
    case Field::MaxKnifeAcceleration:
    case Field::MaxAcceleration:
        return tr("What motor and mechanics bear without shaking or losing their position. Begin low, and "
                  "raise it when the following "
                  "error allows.");
    case Field::MaxPulseFrequency:
        return tr("The largest pulse frequency of the drive's input, from its manual. The controller has a "
                  "limit of its own.");
    case Field::MaxRate:
        return tr("What sealing time and infeed allow, whatever the knife could do.");
    case Field::FeedPerMotorRev:
        return tr("How far the axis moves in one turn of the motor, gear and spindle included.");
    case Field::MaxTorque:
        return tr("The torque that the motor gives for a moment, from its plate.");
    case Field::Inertia:
        return tr("Motor, gear and load together, seen from the motor. With it the torque of a motion is "
                  "estimated.");
    case Field::Friction:
        return tr("The torque that turns the axis slowly and steadily, seen from the motor.");
    default:
        return {};
    }
}

} // namespace campanel::panel
