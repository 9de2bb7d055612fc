// SPDX-License-Identifier: Apache-2.0
#include "app/panel/editor/knot_model.h"

#include "app/panel/kit/format.h"

#include <algorithm>
#include <cmath>

namespace campanel::panel {

namespace {

constexpr double cycleDeg = 360;

// Returns the share of the cycle on the time axis at which the master passes this angle of the cam.
double shareOf(const profile::PointCamProgram& program, double masterDeg)
{
    const double behind = (masterDeg - program.phaseDeg) / cycleDeg;
    const bool isWhole = std::floor(behind) == behind;
    // The first knot is at the start of the axis and the last one at its end.
    const double share = isWhole && masterDeg >= cycleDeg ? 1 : behind - std::floor(behind);
    return program.masterRateRevPerMin < 0 ? 1 - share : share;
}

} // namespace

KnotModel::KnotModel(QObject* parent)
    : QObject(parent)
{
    connect(&m_master, &EditorField::setRequested, this, [this](double value) {
        moveSelected({value, at(m_selected).slaveMm});
    });
    connect(&m_slave, &EditorField::setRequested, this, [this](double value) {
        moveSelected({at(m_selected).masterDeg, value});
    });
}

void KnotModel::show(const std::optional<profile::PointCamProgram>& program, double cycleS)
{
    if (!program && !m_program)
        return; // still another kind: nothing to report
    m_program = program;
    m_cycleS = cycleS;
    m_selected = std::clamp(m_selected, 0, std::max(count() - 1, 0));
    showRows();
    showFields();
    emit changed();
}

void KnotModel::showRows()
{
    const Format format;
    QList<KnotRow> rows;
    for (int i = 0; i < count(); ++i)
        rows << KnotRow{i + 1, format.compact(at(i).masterDeg, 1, 4), format.compact(at(i).slaveMm, 1, 3),
                        i == m_selected};
    m_rows.setRows(rows);
}

void KnotModel::showFields()
{
    if (count() == 0)
        return;
    const Format format;
    const auto last = static_cast<std::size_t>(count() - 1);
    const auto selected = static_cast<std::size_t>(m_selected);
    const auto& knots = m_program->knots;
    FieldView view;
    view.label = tr("Knot %1, master").arg(m_selected + 1);
    view.unit = QStringLiteral("°");
    view.decimals = 1;
    view.value = view.defaultValue = knots[selected].masterDeg;
    view.text = format.compact(view.value, 1, 4);
    const bool isEnd = selected == 0 || selected == last;
    view.minimum = isEnd ? view.value : knots[selected - 1].masterDeg + profile::minKnotSpacingDeg;
    view.maximum = isEnd ? view.value : knots[selected + 1].masterDeg - profile::minKnotSpacingDeg;
    m_master.show(view);
    view.label = tr("Knot %1, slave").arg(m_selected + 1);
    view.unit = QStringLiteral("mm");
    view.decimals = 3;
    view.value = view.defaultValue = knots[selected].slaveMm;
    view.text = format.compact(view.value, 1, 3);
    view.minimum = -profile::maxSlaveMm;
    view.maximum = profile::maxSlaveMm;
    m_slave.show(view);
}

bool KnotModel::isValid() const
{
    return m_program && !profile::checkKnots(m_program->knots);
}

int KnotModel::count() const
{
    return m_program ? static_cast<int>(m_program->knots.size()) : 0;
}

void KnotModel::select(int index)
{
    if (index < 0 || index >= count() || index == m_selected)
        return;
    m_selected = index;
    showRows();
    showFields();
    emit changed();
}

QList<double> KnotModel::times() const
{
    QList<double> times;
    for (int i = 0; i < count(); ++i)
        times << m_cycleS * shareOf(*m_program, at(i).masterDeg);
    return times;
}

QString KnotModel::wrapText() const
{
    if (!isValid())
        return {};
    const profile::WrapCheck wrap = profile::wrapCheck(*m_program);
    const Format format;
    if (wrap.isSmooth)
        return wrap.advanceMm == 0 ? tr("The cycle closes smoothly.")
                                   : tr("The cycle closes smoothly and advances by %1 mm.")
                                         .arg(format.compact(wrap.advanceMm, 0, 3));
    return tr("At the end of the cycle: position jumps by %1 mm, speed by %2 mm/°, acceleration by %3 mm/°².")
        .arg(format.compact(wrap.positionMm, 0, 3), format.compact(wrap.speedMmPerDeg, 0, 4),
             format.compact(wrap.accelerationMmPerDeg2, 0, 5));
}

bool KnotModel::canRepair() const
{
    return isValid() && !profile::wrapCheck(*m_program).isSmooth;
}

bool KnotModel::canRemove() const
{
    return isValid() && m_selected > 0 && m_selected + 1 < count() &&
           m_program->knots.size() > profile::minKnots;
}

void KnotModel::moveSelected(const profile::Knot& wanted)
{
    if (!isValid())
        return;
    profile::PointCamProgram program = *m_program;
    profile::moveKnot(program, static_cast<std::size_t>(m_selected), wanted);
    emit edited(program);
}

void KnotModel::beginDrag(int index)
{
    if (index < 0 || index >= count() || !isValid())
        return;
    select(index);
    m_beforeDrag = m_program;
}

void KnotModel::drag(double seconds, double mm)
{
    if (!m_beforeDrag || m_cycleS <= 0)
        return;
    profile::PointCamProgram program = *m_beforeDrag;
    const profile::Knot& knot = program.knots[static_cast<std::size_t>(m_selected)];
    const double sign = program.masterRateRevPerMin < 0 ? -1 : 1;
    const double scale = program.slaveScale == 0 ? 1 : program.slaveScale;
    const profile::Knot wanted{knot.masterDeg + sign * seconds / m_cycleS * cycleDeg,
                               knot.slaveMm + mm / scale};
    profile::moveKnot(program, static_cast<std::size_t>(m_selected), wanted);
    emit dragged(program);
}

void KnotModel::endDrag()
{
    if (m_beforeDrag)
        emit dragEnded();
    m_beforeDrag.reset();
}

void KnotModel::insert(double seconds)
{
    if (!isValid() || m_cycleS <= 0)
        return;
    const double share = seconds / m_cycleS;
    const double deg =
        (m_program->masterRateRevPerMin < 0 ? 1 - share : share) * cycleDeg + m_program->phaseDeg;
    insertAt(deg - cycleDeg * std::floor(deg / cycleDeg));
}

void KnotModel::insertAfterSelected()
{
    if (!isValid())
        return;
    const int first = std::min(m_selected, count() - 2);
    insertAt((at(first).masterDeg + at(first + 1).masterDeg) / 2);
}

void KnotModel::insertAt(double masterDeg)
{
    profile::PointCamProgram program = *m_program;
    const auto index = profile::insertKnot(program, masterDeg);
    if (!index)
        return;
    m_selected = static_cast<int>(*index);
    emit edited(program);
}

void KnotModel::removeSelected()
{
    if (!isValid())
        return;
    profile::PointCamProgram program = *m_program;
    if (profile::removeKnot(program, static_cast<std::size_t>(m_selected)))
        emit edited(program);
}

void KnotModel::repairWrap()
{
    if (isValid())
        emit edited(profile::repaired(*m_program));
}

} // namespace campanel::panel
