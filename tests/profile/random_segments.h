// SPDX-License-Identifier: Apache-2.0
// Seeded random cams of segments over wide ranges, on the grids of their fields; some are feasible, some are
// not.
#pragma once

#include "profile/segments/segment_edit.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace campanel::profile::test {

struct SegmentRecipe {
    SegmentCamProgram program;
    Machine machine;
};

class RandomSegments {
public:
    explicit RandomSegments(unsigned seed)
        : m_random(seed)
    {
    }

    SegmentRecipe next()
    {
        SegmentRecipe recipe;
        SegmentCamProgram& p = recipe.program;
        Machine& m = recipe.machine;
        p.segments = segments(pick(4) == 0);
        p.masterRateRevPerMin = onGrid(Field::MasterRate, -200, 200);
        p.masterRatio = pick(2) == 0 ? 1 : onGrid(Field::MasterRatio, 0.1, 10);
        p.masterScale = pick(2) == 0 ? 1 : onGrid(Field::MasterScale, 0.5, 2);
        p.slaveScale = pick(2) == 0 ? 1 : onGrid(Field::SlaveScale, -3, 3);
        p.phaseDeg = pick(2) == 0 ? 0 : onGrid(Field::Phase, -360, 360);
        p.camPoints = 100 + static_cast<int>(pick(1901));
        m.pulsesPerMotorRev = 1000 + static_cast<int>(pick(20000));
        m.feedMmPerMotorRev = onGrid(Field::FeedPerMotorRev, 1, 500);
        m.maxMotorRpm = onGrid(Field::MaxMotorRpm, 1000, 6000);
        m.maxAccelerationMmPerS2 = onGrid(Field::MaxAcceleration, 1000, 200000);
        m.frictionNm = onGrid(Field::Friction, 0, 0.3);
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
    std::vector<CamSegment> segments(bool isProgressive)
    {
        const std::size_t count = 1 + pick(pick(5) == 0 ? maxSegments : 8);
        std::vector<double> weights(count);
        double sum = 0;
        for (double& weight : weights)
            sum += weight = uniform(0.2, 2);
        const auto motions = segmentMotions();
        const double height = uniform(1, 100);
        std::vector<CamSegment> segments;
        double deg = 0;
        for (std::size_t i = 0; i < count; ++i) {
            CamSegment segment;
            segment.fromDeg = deg;
            deg = i + 1 == count ? camCycleDeg : deg + weights[i] / sum * camCycleDeg;
            segment.toDeg = deg;
            const SegmentMotionInfo& motion = motions[pick(motions.size())];
            segment.motion = motion.motion;
            segment.endMm = uniform(-height, height);
            for (SegmentBoundary* boundary : {&segment.start, &segment.end})
                *boundary = {uniform(-1, 1) * height / 100, uniform(-1, 1) * height / 2000};
            for (std::size_t each = 0; motion.law != nullptr && each < motion.law->parameters.size();
                 ++each) {
                const LawParameterInfo& range = motion.law->parameters[each];
                segment.lawParameters[each] = uniform(range.min, range.max);
            }
            segments.push_back(segment);
        }
        if (!isProgressive)
            segments.back().endMm = pick(3) == 0 ? uniform(-0.01, 0.01) * height : 0;
        return onSegmentGrid(segments);
    }

    double onGrid(Field field, double from, double to) { return snapToGrid(field, uniform(from, to)); }

    std::mt19937 m_random;
};

} // namespace campanel::profile::test
