// SPDX-License-Identifier: Apache-2.0
// Recipes for tests: the one of the paper's check values, and seeded random ones over wide ranges.
#pragma once

#include "profile/cutter/rotary_cutter.h"
#include "profile/laws/laws.h"

#include <algorithm>
#include <array>
#include <random>

namespace campanel::profile::test {

struct Recipe {
    RotaryCutterProgram program;
    Machine machine;
};

// Returns the recipe with R = 60 mm, one knife, k = 4, 2.5, 5/3, 4/3, cubic, K = 10000, Z = 1.
inline Recipe checkRecipe(double bagLengthMm = 250, double rateBagsPerMin = 60)
{
    Recipe recipe;
    recipe.program.bagLengthMm = bagLengthMm;
    recipe.program.rateBagsPerMin = rateBagsPerMin;
    recipe.program.k = {4, 2.5, 5.0 / 3, 4.0 / 3};
    return recipe;
}

inline constexpr std::array<std::array<Field, 2>, 6> allPairs{{{Field::BagLength, Field::Rate},
                                                               {Field::BaseSpeed, Field::Rate},
                                                               {Field::FilmSpeed, Field::Rate},
                                                               {Field::BagLength, Field::BaseSpeed},
                                                               {Field::BagLength, Field::FilmSpeed},
                                                               {Field::BaseSpeed, Field::FilmSpeed}}};

// Random recipes with values on the grids of their fields; some are feasible, some are not.
class RandomRecipes {
public:
    explicit RandomRecipes(unsigned seed)
        : m_random(seed)
    {
    }

    Recipe next()
    {
        Recipe recipe;
        RotaryCutterProgram& p = recipe.program;
        Machine& m = recipe.machine;
        p.pinned = allPairs[pick(6)];
        p.bagLengthMm = onGrid(Field::BagLength, 20, 700);
        p.rateBagsPerMin = onGrid(Field::Rate, 5, 400);
        p.baseSpeedMmPerS = onGrid(Field::BaseSpeed, 0, 2000);
        p.filmSpeedMmPerS = onGrid(Field::FilmSpeed, 10, 2000);
        std::array<double, 4> ends{uniform(0.02, 0.98), uniform(0.02, 0.98), uniform(0.02, 0.98),
                                   uniform(0.02, 0.98)};
        std::sort(ends.begin(), ends.end());
        for (std::size_t i = 0; i < ends.size(); ++i)
            p.k[i] = snapToGrid(Field::K1, 1 / ends[i]);
        const Law& law = laws()[pick(laws().size())];
        p.speedLaw = law.id;
        for (std::size_t i = 0; i < law.parameters.size(); ++i)
            p.speedLawParameters[i] = uniform(law.parameters[i].min, law.parameters[i].max);
        p.syncRatio = pick(3) == 0 ? onGrid(Field::SyncRatio, 0.9, 1.1) : 1;
        p.slicesPerRamp = 1 + static_cast<int>(pick(200));
        m.knifeRadiusMm = onGrid(Field::KnifeRadius, 30, 150);
        m.knives = 1 + static_cast<int>(pick(4));
        m.pulsesPerMotorRev =
            pick(4) == 0 ? 100 + static_cast<int>(pick(900)) : 1000 + static_cast<int>(pick(20000));
        m.gearNumerator = 1 + static_cast<int>(pick(20));
        m.gearDenominator = 1 + static_cast<int>(pick(7));
        m.maxKnifeAccelerationMmPerS2 = onGrid(Field::MaxKnifeAcceleration, 5000, 200000);
        m.maxPulseFrequencyHz = pick(2) == 0 ? 200000 : 500000;
        addMotor(m);
        return recipe;
    }

    double uniform(double from, double to)
    {
        return std::uniform_real_distribution<double>(from, to)(m_random);
    }
    std::size_t pick(std::size_t count)
    {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(m_random);
    }

private:
    // Some machines know their motor and their shaft.
    void addMotor(Machine& m)
    {
        if (pick(2) == 0) {
            m.inertiaKgCm2 = onGrid(Field::Inertia, 0.5, 20);
            m.frictionNm = onGrid(Field::Friction, 0, 0.3);
            m.maxTorqueNm = pick(3) == 0 ? 0 : onGrid(Field::MaxTorque, 0.5, 20);
            m.ratedTorqueNm = pick(3) == 0 ? 0 : onGrid(Field::RatedTorque, 0.3, 10);
        }
        if (pick(4) == 0)
            m.naturalFrequencyHz = onGrid(Field::NaturalFrequency, 1, 50);
    }
    double onGrid(Field field, double from, double to) { return snapToGrid(field, uniform(from, to)); }

    std::mt19937 m_random;
};

} // namespace campanel::profile::test
