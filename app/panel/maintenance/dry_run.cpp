// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/dry_run.h"

#include "app/panel/editor/editor.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"

#include <cmath>
#include <numbers>

using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

constexpr auto playPeriod = 33ms;
constexpr double playDegPerS = 24; // one cycle in 15 seconds, slow enough for the eye
constexpr double degPerFrame = playDegPerS * 0.033;
constexpr int bagsInSight = 5;
constexpr int manyCycles = 100; // sufficient for the picture of the film

double degAt(double x, double y)
{
    return std::atan2(x, -y) * 180 / std::numbers::pi;
}

} // namespace

DryRun::DryRun(QObject* parent)
    : QObject(parent)
    , m_timer(this)
{
    m_timer.setInterval(playPeriod);
    connect(&m_timer, &QTimer::timeout, this, [this] { turn(degPerFrame); });
    LanguageNotifier::follow(this, &DryRun::update);
}

void DryRun::follow(const Editor& editor)
{
    m_editor = &editor;
    connect(&editor, &Editor::solutionChanged, this, [this] {
        if (!available())
            setPlaying(false);
        update();
    });
    update();
}

const Solution* DryRun::solution() const
{
    return m_editor && m_editor->solution().solved ? &m_editor->solution() : nullptr;
}

bool DryRun::available() const
{
    return solution() != nullptr;
}

bool DryRun::cutter() const
{
    return available() && solution()->cutter();
}

double DryRun::timeS() const
{
    return available() ? m_masterDeg / 360 * solution()->solved->cycleS() : unknown;
}

void DryRun::setPlaying(bool isPlaying)
{
    if (isPlaying == playing() || (isPlaying && !available()))
        return;
    if (isPlaying)
        m_timer.start();
    else
        m_timer.stop();
    emit playingChanged();
}

double DryRun::syncStartMasterDeg() const
{
    return cutter() ? solution()->cutter()->angleDegAt(solution()->cutter()->cycle.tbS) : unknown;
}

double DryRun::syncEndMasterDeg() const
{
    return cutter() ? solution()->cutter()->angleDegAt(solution()->cutter()->cycle.tcS) : unknown;
}

// Returns the angle, as in the header of a download.
double DryRun::cutMasterDeg() const
{
    return (syncStartMasterDeg() + syncEndMasterDeg()) / 2;
}

double DryRun::knifeDegAt(double masterDeg) const
{
    if (!cutter())
        return unknown;
    const profile::RotaryCutter& cutter = *solution()->cutter();
    const double positionMm = cutter.motion.at(masterDeg / 360 * cutter.cycle.cycleTimeS).positionMm;
    const double travelMm = positionMm + m_cycle * cutter.cycle.strokeMm;
    return std::fmod(travelMm / cutter.machine.knifeRadiusMm * 180 / std::numbers::pi, 360);
}

bool DryRun::synchronous() const
{
    return m_masterDeg >= syncStartMasterDeg() && m_masterDeg <= syncEndMasterDeg();
}

double DryRun::bagLengthMm() const
{
    return cutter() ? solution()->cutter()->cycle.bagLengthMm : unknown;
}

double DryRun::filmPositionMm() const
{
    return (m_cycle + m_masterDeg / 360) * bagLengthMm();
}

QList<QPointF> DryRun::cuts() const
{
    QList<QPointF> cuts;
    if (!cutter())
        return cuts;
    for (int bag = -1; bag < bagsInSight; ++bag)
        cuts << QPointF(((cutMasterDeg() - m_masterDeg) / 360 + bag) * bagLengthMm(), 0);
    return cuts;
}

void DryRun::turn(double deg)
{
    if (!available() || !std::isfinite(deg))
        return;
    const double turned = m_masterDeg + deg;
    const double cycles = std::floor(turned / 360);
    m_masterDeg = turned - 360 * cycles;
    m_cycle = ((m_cycle + static_cast<int>(cycles)) % manyCycles + manyCycles) % manyCycles;
    update();
}

void DryRun::toStart()
{
    setPlaying(false);
    m_masterDeg = 0;
    m_cycle = 0;
    update();
}

void DryRun::grab(double x, double y)
{
    setPlaying(false);
    m_fingerDeg = degAt(x, y);
}

void DryRun::drag(double x, double y)
{
    const double now = degAt(x, y);
    turn(std::remainder(now - m_fingerDeg, 360));
    m_fingerDeg = now;
}

void DryRun::update()
{
    QList<FigureRow> rows;
    if (available()) {
        const Format format;
        const program::SolvedProgram& solved = *solution()->solved;
        const profile::MotionPoint at = solved.motion.at(timeS());
        rows << FigureRow{tr("Time in the cycle"), tr("%1 s").arg(format.number(timeS(), 3)), false};
        if (cutter())
            addCutterRows(rows);
        else
            rows << FigureRow{tr("Position"), format.measure(at.positionMm, 2, QStringLiteral("mm")), false}
                 << FigureRow{tr("Speed"), format.measure(at.velocityMmPerS, 1, QStringLiteral("mm/s")),
                              false};
        rows << FigureRow{tr("Acceleration"),
                          format.measure(at.accelerationMmPerS2 / 1000, 2, QStringLiteral("m/s²")), false}
             << FigureRow{tr("Pulse frequency"),
                          tr("%1 kHz").arg(format.number(at.velocityMmPerS * solved.pulsesPerMm / 1000, 2)),
                          false};
    }
    m_figures.setRows(rows);
    emit changed();
}

void DryRun::addCutterRows(QList<FigureRow>& rows) const
{
    const Format format;
    const profile::RotaryCutter& cutter = *solution()->cutter();
    const double knifeMmPerS = cutter.motion.at(timeS()).velocityMmPerS;
    const double filmMmPerS = cutter.cycle.bagLengthMm / cutter.cycle.cycleTimeS;
    rows << FigureRow{tr("Knife speed"), format.measure(knifeMmPerS, 1, QStringLiteral("mm/s")), false}
         << FigureRow{tr("Film speed"), format.measure(filmMmPerS, 1, QStringLiteral("mm/s")), false}
         << FigureRow{tr("Knife speed / film speed"),
                      tr("%1 %").arg(format.number(100 * knifeMmPerS / filmMmPerS, 1)), false}
         << FigureRow{tr("Sync window"), synchronous() ? tr("yes") : tr("no"), false};
}

} // namespace campanel::panel
