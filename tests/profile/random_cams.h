// SPDX-License-Identifier: Apache-2.0
// Seeded random point cams over wide ranges, on the grids of their fields; some are feasible, some are not.
#pragma once

#include "profile/cam/point_cam.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace campanel::profile::test {

struct CamRecipe {
    PointCamProgram program;
    Machine machine;
};

class RandomCams {
public:
    explicit RandomCams(unsigned seed)
        : m_random(seed)
    {
    }

    CamRecipe next()
    {
        CamRecipe recipe;
        PointCamProgram& p = recipe.program;
        Machine& m = recipe.machine;
        p.knots = knots(pick(5) == 0);
        p.ends = static_cast<SplineEnds>(pick(3));
        p.masterRateRevPerMin = onGrid(Field::MasterRate, -300, 300);
        p.masterRatio = pick(2) == 0 ? 1 : onGrid(Field::MasterRatio, 0.1, 10);
        p.masterScale = pick(2) == 0 ? 1 : onGrid(Field::MasterScale, 0.5, 2);
        p.slaveScale = pick(2) == 0 ? 1 : onGrid(Field::SlaveScale, -3, 3);
        p.phaseDeg = pick(2) == 0 ? 0 : onGrid(Field::Phase, -360, 360);
        p.camPoints = 100 + static_cast<int>(pick(1901));
        m.pulsesPerMotorRev = 1000 + static_cast<int>(pick(20000));
        m.feedMmPerMotorRev = onGrid(Field::FeedPerMotorRev, 1, 500);
        m.maxMotorRpm = onGrid(Field::MaxMotorRpm, 1000, 6000);
        m.maxPulseFrequencyHz = pick(2) == 0 ? 200000 : 500000;
        m.maxAccelerationMmPerS2 = onGrid(Field::MaxAcceleration, 1000, 200000);
        m.frictionNm = onGrid(Field::Friction, 0, 0.3);
        m.maxTorqueNm = 1.33;
        m.ratedTorqueNm = pick(3) == 0 ? 0 : onGrid(Field::RatedTorque, 0.05, 1);
        m.inertiaKgCm2 = 0.2;
        return recipe;
    }

    std::size_t pick(std::size_t count)
    {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(m_random);
    }
    double uniform(double from, double to)
    {
        return std::uniform_real_distribution<double>(from, to)(m_random);
    }

private:
    // Returns a few waves with some scatter, with or without a net advance, and occasionally invalid knots.
    std::vector<Knot> knots(bool isProgressive)
    {
        const std::size_t count = 5 + pick(96);
        std::vector<double> angles{0, camCycleDeg};
        while (angles.size() < count)
            angles.push_back(std::round(uniform(0.1, 359.9) * 1e4) / 1e4);
        std::sort(angles.begin(), angles.end());
        if (pick(4) != 0) // at least half of an even spacing apart
            for (std::size_t i = 0; i < count; ++i)
                angles[i] =
                    std::round((angles[i] + 360.0 * static_cast<double>(i) / static_cast<double>(count - 1)) *
                               5e3) /
                    1e4;
        const double height = uniform(1, 100);
        const double waves = static_cast<double>(1 + pick(3)) / 57.29577951308232;
        const double advance = isProgressive ? uniform(-500, 500) : 0;
        std::vector<Knot> knots;
        for (const double angle : angles)
            knots.push_back({angle, std::round((height * std::sin(waves * angle) + advance * angle / 360 +
                                                uniform(-0.01, 0.01) * height) *
                                               1e3) /
                                        1e3});
        if (!isProgressive && pick(10) != 0)
            knots.back().slaveMm = knots.front().slaveMm;
        if (pick(20) == 0)
            std::swap(knots[pick(count)], knots[pick(count)]);
        return knots;
    }

    double onGrid(Field field, double from, double to) { return snapToGrid(field, uniform(from, to)); }

    std::mt19937 m_random;
};

} // namespace campanel::profile::test
