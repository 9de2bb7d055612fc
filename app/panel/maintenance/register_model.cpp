// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/register_model.h"

#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/register_words.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::panel {

RegisterModel::RegisterModel(QObject* parent)
    : QAbstractListModel(parent)
{
    rebuild();
    LanguageNotifier::follow(this, [this] {
        if (count() > 0)
            emit dataChanged(index(0), index(count() - 1));
    });
}

QList<RegisterRow> RegisterModel::allRows() const
{
    QList<RegisterRow> rows;
    for (const modbus::RegisterInfo& info : modbus::registers()) {
        if (info.type != modbus::RegisterType::Block && info.appliesTo(m_kind, m_layout))
            rows << RegisterRow{&info, info.address, RegisterWords::name(info).section(u'.', 0, 0),
                                RegisterWords::name(info)};
    }
    const auto addBank = [&rows](const QString& group, quint16 base, modbus::ProgramKind kind,
                                 modbus::TableLayout layout) {
        for (const modbus::RegisterInfo& info : modbus::bankFields()) {
            if (info.type != modbus::RegisterType::Block && info.appliesTo(kind, layout))
                rows << RegisterRow{&info, static_cast<quint16>(base + info.address), group,
                                    RegisterWords::name(info)};
        }
    };
    addBank(u"active"_s, modbus::activeBankBase, m_kind, m_layout);
    // The kind of the staged program is unknown.
    addBank(u"staged"_s, modbus::stagedBankBase, modbus::ProgramKind::None, modbus::TableLayout::None);
    return rows;
}

void RegisterModel::rebuild()
{
    beginResetModel();
    m_shown.clear();
    for (const RegisterRow& row : allRows()) {
        const bool isWanted = (m_group.isEmpty() || row.group == m_group) &&
                              (m_name.isEmpty() || row.name.contains(m_name, Qt::CaseInsensitive));
        if (isWanted)
            m_shown << Shown{row, std::nullopt, {}, false, false};
    }
    endResetModel();
    emit countChanged();
}

void RegisterModel::setProgram(modbus::ProgramKind kind, modbus::TableLayout layout)
{
    if (kind == m_kind && layout == m_layout)
        return;
    m_kind = kind;
    m_layout = layout;
    rebuild();
}

void RegisterModel::setFilter(const QString& group, const QString& name)
{
    if (group == m_group && name == m_name)
        return;
    m_group = group;
    m_name = name;
    rebuild();
}

QStringList RegisterModel::groups() const
{
    QStringList groups;
    for (const RegisterRow& row : allRows()) {
        if (!groups.contains(row.group))
            groups << row.group;
    }
    return groups;
}

const RegisterRow* RegisterModel::rowAt(int row) const
{
    return row >= 0 && row < count() ? &m_shown[row].row : nullptr;
}

std::optional<modbus::NamedValue> RegisterModel::valueAt(int row) const
{
    return row >= 0 && row < count() ? m_shown[row].value : std::nullopt;
}

QList<modbus::RegisterSpan> RegisterModel::spans(int first, int last) const
{
    QList<modbus::RegisterSpan> spans;
    for (int i = std::max(0, first); i <= last && i < count(); ++i) {
        const RegisterRow& row = m_shown[i].row;
        const bool isNext = !spans.isEmpty() && spans.last().address + spans.last().count == row.address &&
                            spans.last().count + row.info->count <= modbus::readbackRegisters;
        if (isNext)
            spans.last().count = static_cast<std::uint16_t>(spans.last().count + row.info->count);
        else
            spans << modbus::RegisterSpan{row.address, row.info->count};
    }
    return spans;
}

void RegisterModel::take(const link::ReadOutcome& outcome)
{
    const int begin = outcome.request.address;
    const int end = begin + outcome.request.count;
    for (int i = 0; i < count(); ++i) {
        Shown& shown = m_shown[i];
        const int at = shown.row.address;
        if (at < begin || at + shown.row.info->count > end)
            continue;
        shown.isUnreadable = outcome.registers.empty();
        shown.value.reset();
        if (!shown.isUnreadable) {
            const std::span<const std::uint16_t> run(outcome.registers);
            const auto values = modbus::namedValues(
                shown.row.address, run.subspan(static_cast<std::size_t>(at - begin), shown.row.info->count),
                m_kind, m_layout);
            if (!values.empty())
                shown.value = values.front();
        }
        shown.readAt = outcome.receivedAt;
        shown.isStale = false;
        emit dataChanged(index(i), index(i));
    }
}

void RegisterModel::keepOnly(int first, int last)
{
    for (int i = 0; i < count(); ++i) {
        if (i >= first && i <= last)
            continue;
        m_shown[i].value.reset();
        m_shown[i].isUnreadable = false;
    }
}

void RegisterModel::markOlderThan(link::SteadyTime time)
{
    for (int i = 0; i < count(); ++i) {
        Shown& shown = m_shown[i];
        if (!shown.value || shown.isStale || shown.readAt >= time)
            continue;
        shown.isStale = true;
        emit dataChanged(index(i), index(i), {StaleRole});
    }
}

int RegisterModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : count();
}

QString RegisterModel::note(const Shown& shown) const
{
    return QStringList{RegisterWords::group(shown.row.group), RegisterWords::address(shown.row.address),
                       RegisterWords::type(*shown.row.info)}
        .join(u" · "_s);
}

QVariant RegisterModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Shown& shown = m_shown[index.row()];
    switch (role) {
    case NameRole:
        return shown.row.name;
    case NoteRole:
        return note(shown);
    case ValueRole:
        return shown.value          ? RegisterWords::value(*shown.value)
               : shown.isUnreadable ? tr("cannot be read")
                                    : Format::unknownText();
    case RawRole:
        return shown.value ? RegisterWords::raw(*shown.value) : QString();
    case WritableRole:
        return RegisterWords::readOnlyReason(shown.row.group).isEmpty();
    case KnownRole:
        return shown.value.has_value();
    case StaleRole:
        return shown.isStale;
    default:
        return {};
    }
}

QHash<int, QByteArray> RegisterModel::roleNames() const
{
    return {{NameRole, "name"},         {NoteRole, "note"},   {ValueRole, "value"}, {RawRole, "raw"},
            {WritableRole, "writable"}, {KnownRole, "known"}, {StaleRole, "stale"}};
}

} // namespace campanel::panel
