// SPDX-License-Identifier: Apache-2.0
#include "app/panel/editor/cam_handles.h"

#include "profile/cam/cam_cycle.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace campanel::panel {

namespace {

using profile::camCycleDeg;

// Returns the share of the cycle on the time axis at which the master passes this angle of the cam.
double shareOf(const profile::CamMaster& master, double masterDeg)
{
    const double behind = (masterDeg - master.phaseDeg) / camCycleDeg;
    const bool isWhole = std::floor(behind) == behind;
    // The beginning of the cycle is at the start of the axis and its end at the end of it.
    const double share = isWhole && masterDeg >= camCycleDeg ? 1 : behind - std::floor(behind);
    return master.masterRateRevPerMin < 0 ? 1 - share : share;
}

} // namespace

CamHandles::CamHandles(QObject* parent)
    : QObject(parent)
{
}

void CamHandles::show(const profile::Program& program, double cycleS, bool isOfKind)
{
    if (!isOfKind && !m_program)
        return; // still another kind: nothing to report
    m_program = isOfKind ? std::optional(program) : std::nullopt;
    m_cycleS = cycleS;
    m_selected = std::clamp(m_selected, 0, std::max(count() - 1, 0));
    showSelection();
    emit changed();
}

void CamHandles::select(int index)
{
    if (index < 0 || index >= count() || index == m_selected)
        return;
    m_selected = index;
    showSelection();
    emit changed();
}

QList<double> CamHandles::times() const
{
    QList<double> times;
    for (int i = 0; i < count(); ++i)
        times << m_cycleS * shareOf(*profile::camMaster(*m_program), masterDegOf(*m_program, i));
    return times;
}

QList<double> CamHandles::selection() const
{
    if (count() == 0)
        return {};
    const profile::CamMaster& master = *profile::camMaster(*m_program);
    double from = m_cycleS * shareOf(master, startDegOf(*m_program, m_selected));
    double to = m_cycleS * shareOf(master, masterDegOf(*m_program, m_selected));
    if (master.masterRateRevPerMin < 0)
        std::swap(from, to);
    if (from <= to)
        return {from, to};
    return {from, m_cycleS, 0, to};
}

void CamHandles::beginDrag(int index)
{
    if (index < 0 || index >= count() || !canEdit())
        return;
    select(index);
    m_beforeDrag = m_program;
}

void CamHandles::drag(double seconds, double mm)
{
    if (!m_beforeDrag || m_cycleS <= 0)
        return;
    profile::Program program = *m_beforeDrag;
    const profile::CamMaster& master = *profile::camMaster(program);
    const double sign = master.masterRateRevPerMin < 0 ? -1 : 1;
    const double scale = master.slaveScale == 0 ? 1 : master.slaveScale;
    moveBy(program, m_selected, sign * seconds / m_cycleS * camCycleDeg, mm / scale);
    emit dragged(program);
}

void CamHandles::endDrag()
{
    if (m_beforeDrag)
        emit dragEnded();
    m_beforeDrag.reset();
}

std::optional<double> CamHandles::masterDegAt(double seconds) const
{
    if (!canEdit() || m_cycleS <= 0)
        return std::nullopt;
    const profile::CamMaster& master = *profile::camMaster(*m_program);
    const double share = seconds / m_cycleS;
    const double deg = (master.masterRateRevPerMin < 0 ? 1 - share : share) * camCycleDeg + master.phaseDeg;
    return deg - camCycleDeg * std::floor(deg / camCycleDeg);
}

} // namespace campanel::panel
