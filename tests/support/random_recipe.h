// SPDX-License-Identifier: Apache-2.0
// Random recipes of any kind for tests: every field, choice, law parameter, knot and segment, about half of
// them within the limits of their machine.
#pragma once

#include "app/program/recipe.h"
#include "profile/laws/laws.h"
#include "profile/segments/segment_edit.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace campanel::test {

class RandomRecipes {
public:
    explicit RandomRecipes(unsigned seed)
        : m_random(seed)
    {
    }

    double between(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(m_random);
    }
    int below(int count) { return static_cast<int>(m_random() % static_cast<unsigned>(count)); }

    // Returns a recipe with values around those of the default recipe, on their grids.
    program::Recipe around(profile::ProgramKind kind)
    {
        program::Recipe recipe = program::defaultRecipe(kind);
        recipe.version = 1 + below(program::maxVersion);
        recipe.name = "Recipe " + std::to_string(below(1000));
        const program::KindInfo& info = program::kindInfo(kind);
        for (const profile::Field field : info.programFields) {
            if (!recipe.isCutter() || program::isRead(recipe.program, field))
                vary(recipe, field);
        }
        for (const profile::Field field : info.machineFields)
            vary(recipe, field);
        for (const program::ChoiceInfo& choice : info.choices)
            choose(recipe, choice);
        if (auto* cam = std::get_if<profile::PointCamProgram>(&recipe.program))
            cam->knots = knots();
        if (auto* cam = std::get_if<profile::SegmentCamProgram>(&recipe.program))
            cam->segments = segments();
        if (auto* press = std::get_if<profile::PressProgram>(&recipe.program)) {
            if (press->minStopForceN > press->maxStopForceN)
                std::swap(press->minStopForceN, press->maxStopForceN);
        }
        return recipe;
    }

    // Returns any recipe that can be entered.
    program::Recipe anywhere(profile::ProgramKind kind)
    {
        program::Recipe recipe = around(kind);
        const program::KindInfo& info = program::kindInfo(kind);
        for (const auto fields : {info.programFields, info.machineFields}) {
            for (const profile::Field field : fields)
                program::setValue(
                    recipe, field,
                    profile::snapToGrid(field, between(profile::info(field).min, profile::info(field).max)));
        }
        return recipe;
    }

private:
    void vary(program::Recipe& recipe, profile::Field field)
    {
        using profile::Field;
        double value = program::value(recipe, field) * between(0.7, 1.2);
        switch (field) {
        case Field::Distance:
        case Field::EndSpeed:
            value *= below(4) == 0 ? -0.3 : 0.6;
            break;
        case Field::StartSpeed:
            value = below(2) == 0 ? 0 : between(-500, 500);
            break;
        case Field::MoveTime:
            value = between(0.8, 4);
            break;
        case Field::MasterRate:
            value *= below(2) == 0 ? -1 : 1;
            break;
        case Field::SlaveScale:
            value = between(-2, 2);
            break;
        case Field::Phase:
            value = below(2) == 0 ? 0 : between(-360, 360);
            break;
        case Field::CamPoints:
            value = 100 + below(400);
            break;
        case Field::MaxMotorRpm:
        case Field::MaxAcceleration:
        case Field::MaxPulseFrequency:
        case Field::MaxTorque:
        case Field::PressPosition: // after the probe end, whatever its value
        case Field::MaxForce:
            value = program::value(recipe, field) * between(1, 1.2);
            break;
        case Field::K1:
        case Field::K2:
        case Field::K3:
        case Field::K4:
            value = program::value(recipe, field) * between(0.95, 1.05);
            break;
        case Field::Knives:
        case Field::GearNumerator:
        case Field::GearDenominator:
            return;
        default:
            break;
        }
        program::setValue(recipe, field, profile::snapToGrid(field, value));
    }

    void choose(program::Recipe& recipe, const program::ChoiceInfo& info)
    {
        if (info.choice != program::Choice::Law) {
            const auto option = static_cast<std::size_t>(below(static_cast<int>(info.options.size())));
            program::setChoice(recipe.program, info.choice, info.options[option].code);
            return;
        }
        std::vector<const profile::Law*> laws;
        for (const profile::Law& law : profile::laws()) {
            if (program::isLawOf(recipe.kind(), law))
                laws.push_back(&law);
        }
        const profile::Law& law = *laws[static_cast<std::size_t>(below(static_cast<int>(laws.size())))];
        program::setChoice(recipe.program, info.choice, static_cast<std::uint16_t>(law.id));
        profile::LawParameters& values = *program::lawParameters(recipe.program);
        values = profile::defaultParameters(law);
        for (std::size_t i = 0; i < law.parameters.size(); ++i) {
            const profile::LawParameterInfo& parameter = law.parameters[i];
            const double middle = (parameter.min + parameter.max) / 2;
            values[i] = between(middle - (middle - parameter.min) / 2, middle + (parameter.max - middle) / 2);
        }
    }

    std::vector<profile::Knot> knots()
    {
        const int count = 5 + below(12);
        const double closing = below(3) == 0 ? between(-20, 20) : 0;
        std::vector<profile::Knot> knots;
        for (int i = 0; i < count; ++i) {
            const double at = static_cast<double>(i) / (count - 1);
            const bool isEnd = i == 0 || i + 1 == count;
            const double deg = 360 * at + (isEnd ? 0 : between(-0.2, 0.2) * 360 / (count - 1));
            const double rise = 25 - 25 * std::cos(2 * std::acos(-1.0) * at) + closing * at;
            knots.push_back({deg, rise});
        }
        return knots;
    }

    // Returns a closed cam of dwells, laws and polynomials that start and end at rest.
    std::vector<profile::CamSegment> segments()
    {
        const int count = 2 + below(7);
        std::vector<profile::CamSegment> segments;
        for (int i = 0; i < count; ++i) {
            profile::CamSegment segment;
            segment.fromDeg = i == 0 ? 0 : segments.back().toDeg;
            segment.toDeg = i + 1 == count ? 360 : 360.0 * (i + between(0.8, 1.2)) / count;
            segment.endMm = i + 1 == count ? 0 : between(-10, 10);
            const auto motions = profile::segmentMotions();
            const profile::SegmentMotionInfo* motion = &motions[0];
            do
                motion = &motions[static_cast<std::size_t>(below(static_cast<int>(motions.size())))];
            while (motion->motion == profile::SegmentMotion::ConstantSpeed);
            segment.motion = motion->motion;
            if (motion->law != nullptr)
                segment.lawParameters = profile::defaultParameters(*motion->law);
            segments.push_back(segment);
        }
        return profile::onSegmentGrid(segments);
    }

    std::mt19937 m_random;
};

} // namespace campanel::test
