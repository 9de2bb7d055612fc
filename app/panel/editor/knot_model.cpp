// SPDX-License-Identifier: Apache-2.0
#include "app/panel/editor/knot_model.h"

#include "app/panel/kit/format.h"
#include "app/panel/words/cam_sentences.h"

#include <algorithm>

namespace campanel::panel {

KnotModel::KnotModel(QObject* parent)
    : CamHandles(parent)
{
    connect(&m_master, &EditorField::setRequested, this, [this](double value) {
        if (canEdit()) // the keypad may outlive the cam: Undo brings another kind back
            moveSelected({value, at(selected()).slaveMm});
    });
    connect(&m_slave, &EditorField::setRequested, this, [this](double value) {
        if (canEdit())
            moveSelected({at(selected()).masterDeg, value});
    });
}

int KnotModel::listSize(const profile::Program& program) const
{
    return static_cast<int>(std::get<profile::PointCamProgram>(program).knots.size());
}

bool KnotModel::isValid(const profile::Program& program) const
{
    return !profile::checkKnots(std::get<profile::PointCamProgram>(program).knots);
}

double KnotModel::masterDegOf(const profile::Program& program, int index) const
{
    return std::get<profile::PointCamProgram>(program).knots[static_cast<std::size_t>(index)].masterDeg;
}

void KnotModel::moveBy(profile::Program& program, int index, double deg, double mm) const
{
    auto& moved = std::get<profile::PointCamProgram>(program);
    const profile::Knot knot = moved.knots[static_cast<std::size_t>(index)];
    profile::moveKnot(moved, static_cast<std::size_t>(index), {knot.masterDeg + deg, knot.slaveMm + mm});
}

void KnotModel::showSelection()
{
    const Format format;
    QList<KnotRow> rows;
    for (int i = 0; i < count(); ++i)
        rows << KnotRow{i + 1, format.compact(at(i).masterDeg, 1, 4),
                        format.compactAmount(at(i).slaveMm, 1, 3, QStringLiteral("mm")), i == selected()};
    m_rows.setRows(rows);
    showFields();
}

void KnotModel::showFields()
{
    if (count() == 0)
        return;
    const Format format;
    const auto last = static_cast<std::size_t>(count() - 1);
    const auto index = static_cast<std::size_t>(selected());
    const auto& knots = cam().knots;
    FieldView view;
    view.label = tr("Knot %1, master").arg(selected() + 1);
    view.unit = QStringLiteral("°");
    view.decimals = 1;
    view.value = view.defaultValue = knots[index].masterDeg;
    view.text = format.compact(view.value, 1, 4);
    const bool isEnd = index == 0 || index == last;
    view.minimum = isEnd ? view.value : knots[index - 1].masterDeg + profile::minMasterSpacingDeg;
    view.maximum = isEnd ? view.value : knots[index + 1].masterDeg - profile::minMasterSpacingDeg;
    m_master.show(view);
    view.label = tr("Knot %1, position").arg(selected() + 1);
    view.unit = QStringLiteral("mm");
    view.decimals = 3;
    view.value = view.defaultValue = knots[index].slaveMm;
    view.text = format.compactAmount(view.value, 1, 3, view.unit);
    view.minimum = -profile::maxSlaveMm;
    view.maximum = profile::maxSlaveMm;
    m_slave.show(view);
}

QString KnotModel::wrapText() const
{
    if (!canEdit())
        return {};
    const profile::WrapCheck wrap = profile::wrapCheck(cam());
    const Format format;
    const QString end =
        wrap.isSmooth
            ? tr("The cycle closes smoothly.")
            : tr("At the end of the cycle: speed jumps by %1, acceleration by %2.")
                  .arg(format.compactMeasure(wrap.speedMmPerDeg, 0, 4, QStringLiteral("mm/°")),
                       format.compactMeasure(wrap.accelerationMmPerDeg2, 0, 5, QStringLiteral("mm/°²")));
    return QStringLiteral("%1 %2").arg(end, CamSentences::ends(cam())).trimmed();
}

bool KnotModel::canRepair() const
{
    return canEdit() && !profile::wrapCheck(cam()).isSmooth;
}

bool KnotModel::canRemove() const
{
    return canEdit() && selected() > 0 && selected() + 1 < count() && cam().knots.size() > profile::minKnots;
}

void KnotModel::moveSelected(const profile::Knot& wanted)
{
    if (!canEdit())
        return;
    profile::PointCamProgram moved = cam();
    profile::moveKnot(moved, static_cast<std::size_t>(selected()), wanted);
    emit edited(moved);
}

void KnotModel::insert(double seconds)
{
    if (const auto masterDeg = masterDegAt(seconds))
        insertAt(*masterDeg);
}

void KnotModel::insertAfterSelected()
{
    if (!canEdit())
        return;
    const int first = std::min(selected(), count() - 2);
    insertAt((at(first).masterDeg + at(first + 1).masterDeg) / 2);
}

void KnotModel::insertAt(double masterDeg)
{
    profile::PointCamProgram moved = cam();
    const auto index = profile::insertKnot(moved, masterDeg);
    if (!index)
        return;
    setSelected(static_cast<int>(*index));
    emit edited(moved);
}

void KnotModel::removeSelected()
{
    if (!canEdit())
        return;
    profile::PointCamProgram moved = cam();
    if (profile::removeKnot(moved, static_cast<std::size_t>(selected())))
        emit edited(moved);
}

void KnotModel::repairWrap()
{
    if (canEdit())
        emit edited(profile::repaired(cam()));
}

} // namespace campanel::panel
