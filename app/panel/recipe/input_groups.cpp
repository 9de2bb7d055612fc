// SPDX-License-Identifier: Apache-2.0
#include "app/panel/recipe/input_groups.h"

#include <algorithm>
#include <vector>

using namespace Qt::StringLiterals;

namespace campanel::panel {
namespace {

using profile::Field;
using program::Choice;

struct InputGroup {
    QLatin1StringView key;
    std::vector<Field> fields;
    std::vector<Choice> choices;
};

const auto& inputGroups()
{
    static const std::vector<InputGroup> groups{
        {"move"_L1,
         {Field::Distance, Field::StartSpeed, Field::EndSpeed, Field::MoveTime},
         {Choice::Duration}},
        {"curve"_L1, {Field::CamPoints}, {Choice::Law, Choice::Execution, Choice::SplineEnds}},
        {"master"_L1,
         {Field::MasterRate, Field::MasterRamp, Field::MasterRatio, Field::MasterScale},
         {Choice::MasterRampShape}},
        {"output"_L1, {Field::SlaveScale, Field::Phase}, {}},
        {"approach"_L1,
         {Field::ApproachPosition, Field::ApproachSpeed, Field::ProbeSpeed, Field::ProbeForce,
          Field::ProbeEnd},
         {}},
        {"press"_L1, {Field::PressSpeed, Field::PressPosition, Field::HoldTime, Field::ReturnSpeed}, {}},
        {"limits"_L1,
         {Field::MaxForce, Field::PositionTolerance, Field::MinStopForce, Field::MaxStopForce},
         {}},
    };
    return groups;
}

template <typename T> QString groupWith(T input, std::vector<T> InputGroup::*members)
{
    for (const InputGroup& group : inputGroups()) {
        if (std::ranges::find(group.*members, input) != (group.*members).end())
            return group.key;
    }
    return {};
}

} // namespace

QString inputGroup(Field field)
{
    return groupWith(field, &InputGroup::fields);
}

QString inputGroup(Choice choice)
{
    return groupWith(choice, &InputGroup::choices);
}

} // namespace campanel::panel
