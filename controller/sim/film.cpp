// SPDX-License-Identifier: Apache-2.0
#include "film.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace campanel::controller {
namespace {

constexpr double twoPi = 2.0 * std::numbers::pi;
// The number of Newton steps from a guess that differs by the stretch: 0.5 %, then 1e-7, then nothing.
constexpr int inversions = 3;
constexpr double giveS = 0.01; // time constant of the film between roll and jaws

} // namespace

// The slow stretch varies between 0 and its maximum, in waves that are not a multiple of any bag length.
Film::Film(const FilmOptions& options, std::uint64_t seed)
    : m_options(options)
    , m_slipRandom(seed)
    , m_markRandom(seed ^ 0x9E3779B97F4A7C15u)
{
    std::uniform_real_distribution<double> phase(0.0, twoPi);
    m_waves = {Wave{0.35 * options.stretch, 503'000.0, phase(m_markRandom)},
               Wave{0.15 * options.stretch, 191'000.0, phase(m_markRandom)}};
}

double Film::stretched(double materialMm) const
{
    double length = materialMm * (1.0 + 0.5 * m_options.stretch);
    for (const Wave& wave : m_waves)
        length -= wave.share * wave.lengthMm / twoPi *
                  (std::cos(twoPi * materialMm / wave.lengthMm + wave.phase) - std::cos(wave.phase));
    return length + m_options.stretchStep * std::max(0.0, materialMm - m_options.stretchStepM * mmPerM);
}

double Film::materialMm(double drawnMm) const
{
    double material = drawnMm;
    for (int i = 0; i < inversions; ++i)
        material -= stretched(material) - drawnMm;
    return material;
}

double Film::bagsAt(double drawnMm) const
{
    return (materialMm(drawnMm) - m_firstMm) / (m_bagMm * (1.0 + m_options.printError));
}

double Film::offMarkMm(double materialMm) const
{
    const double pitch = m_bagMm * (1.0 + m_options.printError);
    return std::remainder(materialMm - m_firstMm, pitch);
}

void Film::load(double bagMm, double toFirstCutMm, double rollMm)
{
    if (bagMm == m_bagMm || !(bagMm > 0.0))
        return;
    const double drawn = m_bagMm > 0.0 ? drawnMm(rollMm) : rollMm;
    m_slipAtKnotMm = drawn - rollMm + m_behindMm;
    m_slipBeforeMm = m_slipAtKnotMm;
    m_slipAfterMm = m_slipAtKnotMm;
    m_knotMm = rollMm;
    m_bagMm = bagMm;
    m_firstMm = materialMm(drawn + toFirstCutMm) + m_options.misplacedMm;
    // The first mark that has not reached the sensor.
    const double pitch = bagMm * (1.0 + m_options.printError);
    m_mark = static_cast<std::int64_t>(
        std::floor((materialMm(drawn + m_options.markDistanceMm) - m_firstMm) / pitch));
    m_seen.clear();
    m_prints.clear();
    if (m_printsThere != 0)
        m_seen.push_back({rollMm, false});
    m_printsThere = 0;
    nextMark();
}

void Film::pull(double mm)
{
    m_slipAtKnotMm += mm;
    m_slipBeforeMm += mm;
    m_slipAfterMm += mm;
}

void Film::nextMark()
{
    const double pitch = m_bagMm * (1.0 + m_options.printError);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    ++m_mark;
    const double mark = stretched(m_firstMm + static_cast<double>(m_mark) * pitch) - m_options.markDistanceMm;
    m_markDrawnMm = mark + m_options.markNoiseMm * m_normal(m_markRandom);
    if (share(m_markRandom) >= m_options.marksMissing)
        print(m_markDrawnMm, m_options.markWidthMm);
    if (m_options.marksFalse > 0.0 && share(m_markRandom) < m_options.marksFalse)
        print(mark - pitch * share(m_markRandom), m_options.falseWidthMm);
    if (m_options.printAtMm > 0.0)
        print(m_markDrawnMm + m_options.printAtMm, m_options.printWidthMm);
}

void Film::print(double drawnMm, double widthMm)
{
    m_prints.emplace(drawnMm, 1);
    m_prints.emplace(drawnMm + widthMm, -1);
}

double Film::drawnMm(double rollMm) const
{
    const double part = (rollMm - m_knotMm) / m_bagMm;
    const double slip = part < 0.0 ? m_slipAtKnotMm + part * (m_slipAtKnotMm - m_slipBeforeMm)
                                   : m_slipAtKnotMm + part * (m_slipAfterMm - m_slipAtKnotMm);
    const double step = m_stepToMm - m_stepFromMm;
    const double share = step > 0.0 ? std::clamp((rollMm - m_stepFromMm) / step, 0.0, 1.0) : 1.0;
    return rollMm + slip - (m_behindBeforeMm + share * (m_behindMm - m_behindBeforeMm));
}

void Film::seePrints(double rollMm)
{
    const double drawn = drawnMm(rollMm);
    while (m_markDrawnMm <= drawn)
        nextMark();
    while (!m_prints.empty() && m_prints.begin()->first <= drawn) {
        const auto [at, change] = *m_prints.begin();
        const bool wasOn = m_printsThere != 0;
        m_prints.erase(m_prints.begin());
        m_printsThere += change;
        const bool isOn = m_printsThere != 0;
        if (isOn != wasOn)
            m_seen.push_back({rollMm - (drawn - at), isOn});
    }
}

void Film::drawTo(double rollMm, double acceleration)
{
    if (!(m_bagMm > 0.0))
        return;
    m_stepFromMm = m_stepToMm;
    m_stepToMm = rollMm;
    m_behindBeforeMm = m_behindMm;
    m_behindMm = m_options.slipPerAcceleration * acceleration;
    while (rollMm >= m_knotMm + m_bagMm) {
        seePrints(m_knotMm + m_bagMm);
        m_knotMm += m_bagMm;
        m_slipBeforeMm = m_slipAtKnotMm;
        m_slipAtKnotMm = m_slipAfterMm;
        m_slipAfterMm += m_options.slipMm * m_normal(m_slipRandom);
    }
    seePrints(rollMm);
}

double FilmAcceleration::step(double speed, double stepS)
{
    m_follower += (speed - m_follower) * (1.0 - std::exp(-stepS / giveS));
    return (speed - m_follower) / giveS;
}

bool Film::takeEdge(Edge& edge)
{
    if (m_seen.empty())
        return false;
    edge = m_seen.front();
    m_seen.pop_front();
    return true;
}

} // namespace campanel::controller
