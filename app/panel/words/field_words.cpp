// SPDX-License-Identifier: Apache-2.0
// The short display names of the fields.
#include "app/panel/words/recipe_words.h"

namespace campanel::panel {

using profile::Field;

QString RecipeWords::fieldName(Field field)
{
    switch (field) {
    case Field::BagLength:
        return tr("Bag length");
    case Field::Rate:
        return tr("Rate");
    case Field::BaseSpeed:
        return tr("Base speed v_a");
    case Field::FilmSpeed:
        return tr("Film speed v_b");
    case Field::K1:
        return tr("Ratio k1");
    case Field::K2:
        return tr("Ratio k2");
    case Field::K3:
        return tr("Ratio k3");
    case Field::K4:
        return tr("Ratio k4");
    case Field::SyncRatio:
        return tr("Sync ratio");
    case Field::SlicesPerRamp:
        return tr("Slices per ramp");
    case Field::KnifeRadius:
        return tr("Knife radius R");
    case Field::Knives:
        return tr("Knives N");
    case Field::PulsesPerMotorRev:
        return tr("Pulses per motor rev. K");
    case Field::GearNumerator:
        return tr("Gear Z, motor revs");
    case Field::GearDenominator:
        return tr("Gear Z, knife revs");
    case Field::MaxMotorRpm:
        return tr("Max. motor speed");
    case Field::MaxKnifeAcceleration:
        return tr("Max. acceleration");
    case Field::MaxPulseFrequency:
        return tr("Max. pulse frequency");
    case Field::MaxRate:
        return tr("Max. rate");
    case Field::TimerClock:
        return tr("Timer clock");
    case Field::TimerBits:
        return tr("Timer width");
    case Field::RowCapacity:
        return tr("Rows in the controller");
    case Field::FeedPerMotorRev:
        return tr("Feed per motor rev.");
    case Field::MaxAcceleration:
        return tr("Max. acceleration");
    case Field::MaxTorque:
        return tr("Max. motor torque");
    case Field::Inertia:
        return tr("Inertia at the motor");
    case Field::Friction:
        return tr("Friction at the motor");
    case Field::Distance:
        return tr("Distance");
    case Field::MoveTime:
        return tr("Time");
    case Field::StartSpeed:
        return tr("Start speed");
    case Field::EndSpeed:
        return tr("End speed");
    case Field::CamPoints:
        return tr("Table intervals");
    case Field::MasterRate:
        return tr("Master speed");
    case Field::MasterRamp:
        return tr("Master ramp");
    case Field::MasterRatio:
        return tr("Master revs/cycle");
    case Field::MasterScale:
        return tr("Master scale");
    case Field::SlaveScale:
        return tr("Slave scale");
    case Field::Phase:
        return tr("Phase");
    case Field::ApproachPosition:
        return tr("Approach to");
    case Field::ApproachSpeed:
        return tr("Approach speed");
    case Field::ProbeSpeed:
        return tr("Probe speed");
    case Field::ProbeForce:
        return tr("Probe force");
    case Field::ProbeEnd:
        return tr("Contact before");
    case Field::PressSpeed:
        return tr("Press speed");
    case Field::PressPosition:
        return tr("Press to");
    case Field::HoldTime:
        return tr("Hold time");
    case Field::ReturnSpeed:
        return tr("Return speed");
    case Field::MaxForce:
        return tr("Max. force");
    case Field::PositionTolerance:
        return tr("Stop tolerance");
    case Field::MinStopForce:
        return tr("Min. force at stop");
    case Field::MaxStopForce:
        return tr("Max. force at stop");
    case Field::ContactAngle:
        return tr("Jaw contact angle");
    case Field::MinSealTime:
        return tr("Min. seal time");
    case Field::RampPosition:
        return tr("Ramps, slow to gentle");
    case Field::RatedTorque:
        return tr("Rated motor torque");
    case Field::NaturalFrequency:
        return tr("Natural frequency");
    case Field::DampingRatio:
        return tr("Damping ratio");
    }
    return {};
}

} // namespace campanel::panel
