// SPDX-License-Identifier: Apache-2.0
// The lists of members for each structure of inputs: a new input is one row.
#include "profile/program/programs.h"

#include "profile/model/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace campanel::profile {
namespace {

// A number in a structure of inputs: a measure or a count.
template <typename P> struct Member {
    Field field = Field::BagLength;
    double P::*real = nullptr;
    int P::*count = nullptr;
};

constexpr std::array<Member<PositionMoveProgram>, 3> positionMoveMembers{{
    {Field::Distance, &PositionMoveProgram::distanceMm, nullptr},
    {Field::MoveTime, &PositionMoveProgram::timeS, nullptr},
    {Field::CamPoints, nullptr, &PositionMoveProgram::camPoints},
}};

constexpr std::array<Member<SpeedMoveProgram>, 5> speedMoveMembers{{
    {Field::StartSpeed, &SpeedMoveProgram::startSpeedMmPerS, nullptr},
    {Field::EndSpeed, &SpeedMoveProgram::endSpeedMmPerS, nullptr},
    {Field::MoveTime, &SpeedMoveProgram::timeS, nullptr},
    {Field::Distance, &SpeedMoveProgram::distanceMm, nullptr},
    {Field::CamPoints, nullptr, &SpeedMoveProgram::camPoints},
}};

template <typename Cam>
constexpr std::array<Member<Cam>, 7> camMembers{{
    {Field::MasterRate, &Cam::masterRateRevPerMin, nullptr},
    {Field::MasterRamp, &Cam::masterRampS, nullptr},
    {Field::MasterRatio, &Cam::masterRatio, nullptr},
    {Field::MasterScale, &Cam::masterScale, nullptr},
    {Field::SlaveScale, &Cam::slaveScale, nullptr},
    {Field::Phase, &Cam::phaseDeg, nullptr},
    {Field::CamPoints, nullptr, &Cam::camPoints},
}};

constexpr std::array<Member<PressProgram>, 13> pressMembers{{
    {Field::ApproachPosition, &PressProgram::approachPositionMm, nullptr},
    {Field::ApproachSpeed, &PressProgram::approachSpeedMmPerS, nullptr},
    {Field::ProbeSpeed, &PressProgram::probeSpeedMmPerS, nullptr},
    {Field::ProbeForce, &PressProgram::probeForceN, nullptr},
    {Field::ProbeEnd, &PressProgram::probeEndMm, nullptr},
    {Field::PressSpeed, &PressProgram::pressSpeedMmPerS, nullptr},
    {Field::PressPosition, &PressProgram::pressPositionMm, nullptr},
    {Field::HoldTime, &PressProgram::holdTimeS, nullptr},
    {Field::ReturnSpeed, &PressProgram::returnSpeedMmPerS, nullptr},
    {Field::MaxForce, &PressProgram::maxForceN, nullptr},
    {Field::PositionTolerance, &PressProgram::positionToleranceMm, nullptr},
    {Field::MinStopForce, &PressProgram::minStopForceN, nullptr},
    {Field::MaxStopForce, &PressProgram::maxStopForceN, nullptr},
}};

constexpr const auto& membersOf(const PositionMoveProgram&)
{
    return positionMoveMembers;
}

constexpr const auto& membersOf(const SpeedMoveProgram&)
{
    return speedMoveMembers;
}

constexpr const auto& membersOf(const PointCamProgram&)
{
    return camMembers<PointCamProgram>;
}

constexpr const auto& membersOf(const SegmentCamProgram&)
{
    return camMembers<SegmentCamProgram>;
}

constexpr const auto& membersOf(const PressProgram&)
{
    return pressMembers;
}

template <typename P> const Member<P>* memberOf(const P& program, Field field)
{
    const auto& members = membersOf(program);
    const auto found = std::find_if(members.begin(), members.end(),
                                    [field](const Member<P>& member) { return member.field == field; });
    return found == members.end() ? nullptr : &*found;
}

template <typename P> double numberOf(const P& program, Field field)
{
    const Member<P>* member = memberOf(program, field);
    if (member == nullptr)
        return std::numeric_limits<double>::quiet_NaN();
    return member->real != nullptr ? program.*(member->real) : program.*(member->count);
}

template <typename P> void setNumber(P& program, Field field, double value)
{
    const Member<P>* member = memberOf(program, field);
    if (member == nullptr)
        return;
    if (member->real != nullptr)
        program.*(member->real) = value;
    else
        program.*(member->count) = wholeOf(value);
}

} // namespace

double value(const PositionMoveProgram& program, Field field)
{
    return numberOf(program, field);
}

void setValue(PositionMoveProgram& program, Field field, double value)
{
    setNumber(program, field, value);
}

double value(const SpeedMoveProgram& program, Field field)
{
    return numberOf(program, field);
}

void setValue(SpeedMoveProgram& program, Field field, double value)
{
    setNumber(program, field, value);
}

double value(const PointCamProgram& program, Field field)
{
    return numberOf(program, field);
}

void setValue(PointCamProgram& program, Field field, double value)
{
    setNumber(program, field, value);
}

double value(const PressProgram& program, Field field)
{
    return numberOf(program, field);
}

void setValue(PressProgram& program, Field field, double value)
{
    setNumber(program, field, value);
}

double value(const SegmentCamProgram& program, Field field)
{
    return numberOf(program, field);
}

void setValue(SegmentCamProgram& program, Field field, double value)
{
    setNumber(program, field, value);
}

} // namespace campanel::profile
