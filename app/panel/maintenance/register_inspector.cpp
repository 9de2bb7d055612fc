// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/register_inspector.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/kit/numbers.h"
#include "app/panel/words/connection_sentences.h"
#include "app/panel/words/register_words.h"

#include <QVariantMap>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

constexpr auto readPeriod = 250ms; // between the end of one round and the next: the status has priority
constexpr auto staleAfter = 1000ms;

} // namespace

RegisterInspector::RegisterInspector(Controller& controller, QObject* parent)
    : Watched(parent)
    , m_controller(controller)
{
    updateEvery(readPeriod, [this] { readVisible(); });
    connect(&m_registers, &RegisterModel::modelReset, this, [this] { select(-1); });
    connect(&m_value, &Value::setRequested, this, &RegisterInspector::write);
    m_value.setNeededLevel(Level::Service);
    connect(&controller, &Controller::connectionChanged, this, &RegisterInspector::noteConnection);
    connect(&controller, &Controller::programChanged, this, &RegisterInspector::noteProgram);
    LanguageNotifier::follow(this, [this] {
        m_outcome.clear(); // it is in the previous language
        updateSelected();
    });
}

void RegisterInspector::setGroup(const QString& group)
{
    m_group = group;
    applyFilter();
}

void RegisterInspector::setNameFilter(const QString& name)
{
    m_nameFilter = name;
    applyFilter();
}

void RegisterInspector::applyFilter()
{
    m_registers.setFilter(m_group, m_nameFilter);
    emit filterChanged();
    readVisible();
}

QString RegisterInspector::groupText() const
{
    return m_group.isEmpty() ? tr("All groups") : RegisterWords::group(m_group);
}

QVariantList RegisterInspector::groups() const
{
    QVariantList groups{QVariantMap{{u"key"_s, QString()}, {u"text"_s, tr("All groups")}}};
    for (const QString& group : m_registers.groups())
        groups << QVariantMap{{u"key"_s, group}, {u"text"_s, RegisterWords::group(group)}};
    return groups;
}

void RegisterInspector::setVisibleRows(int first, int last)
{
    if (first == m_first && last == m_last)
        return;
    m_first = first;
    m_last = last;
    m_registers.keepOnly(first, last);
    readVisible();
}

void RegisterInspector::readVisible()
{
    m_registers.markOlderThan(m_controller.now() - staleAfter);
    if (!watched() || !m_controller.isConnected() || m_pendingReads > 0)
        return;
    const auto spans = m_registers.spans(m_first, m_last);
    m_pendingReads = static_cast<int>(spans.size());
    for (const modbus::RegisterSpan& span : spans) {
        m_controller.link().readRegisters(
            {0, span.address, span.count},
            {this, [this](const link::ReadOutcome& outcome) { takeRead(outcome); }});
    }
}

void RegisterInspector::takeRead(const link::ReadOutcome& outcome)
{
    --m_pendingReads;
    const bool isRefused = outcome.error && (outcome.error->kind == modbus::LinkErrorKind::RangeNotReadable ||
                                             outcome.error->kind == modbus::LinkErrorKind::Exception);
    // After another failure the value stays and is displayed as old.
    if (outcome.end == link::ReadEnd::Done || isRefused)
        m_registers.take(outcome);
    const RegisterRow* chosen = row();
    if (chosen && chosen->address >= outcome.request.address &&
        chosen->address < outcome.request.address + outcome.request.count)
        updateSelected();
}

void RegisterInspector::noteConnection()
{
    readVisible();
    updateSelected();
}

void RegisterInspector::noteProgram()
{
    const auto& program = m_controller.program();
    m_registers.setProgram(program ? program->kind : modbus::ProgramKind::None,
                           program ? program->layout : modbus::TableLayout::None);
}

void RegisterInspector::select(int row)
{
    m_selected = m_registers.rowAt(row) ? row : -1;
    m_outcome.clear();
    m_isFailed = false;
    updateSelected();
}

QString RegisterInspector::selectedName() const
{
    return row() ? row()->name : QString();
}

QString RegisterInspector::number(double value) const
{
    return Format::joined(Format().number(value, m_value.decimals()), m_value.unit());
}

QString RegisterInspector::selectedText() const
{
    if (!row())
        return tr("Tap a register to read its description or to write a value.");
    if (!m_outcome.isEmpty())
        return m_outcome;
    const QString reason = RegisterWords::readOnlyReason(row()->group);
    if (!reason.isEmpty())
        return reason;
    return m_controller.isConnected() ? tr("Writable: %1 to %2, default %3.")
                                            .arg(number(m_value.minimum()), number(m_value.maximum()),
                                                 number(m_value.defaultValue()))
                                      : tr("There is no connection to the controller.");
}

bool RegisterInspector::writable() const
{
    return row() && RegisterWords::readOnlyReason(row()->group).isEmpty();
}

bool RegisterInspector::canWrite() const
{
    return writable() && m_controller.isConnected() && !m_isWriting;
}

void RegisterInspector::updateSelected()
{
    if (row()) {
        const modbus::RegisterInfo& info = *row()->info;
        const int decimals = RegisterWords::decimals(info);
        const auto value = m_registers.valueAt(m_selected);
        // A state has no physical value: the keypad displays its number.
        const double number = value ? value->physical.value_or(static_cast<double>(value->raw)) : unknown;
        m_value.show({row()->name,
                      QString::fromUtf8(info.unit.data(), static_cast<qsizetype>(info.unit.size())),
                      Format().number(number, decimals), info.minimum, info.maximum, info.defaultValue,
                      decimals, number, true});
    }
    emit selectionChanged();
}

void RegisterInspector::write(double value)
{
    if (!m_controller.accessCheck().require(Level::Service) || !canWrite())
        return;
    m_outcome = tr("Writing %1 …").arg(number(value));
    m_isFailed = false;
    m_isWriting = m_controller.writeParameter(
        *row()->info, value, {this, [this](const link::ParameterOutcome& outcome) { takeWritten(outcome); }});
    updateSelected();
}

void RegisterInspector::takeWritten(const link::ParameterOutcome& outcome)
{
    m_isWriting = false;
    const bool isShown = row() && row()->name.toStdString() == outcome.name;
    if (isShown) {
        m_isFailed = outcome.end != link::ParameterEnd::Done;
        m_outcome =
            m_isFailed
                ? ConnectionSentences::parameter(row()->name, outcome)
                : tr("Written and read back from the controller: %1.").arg(number(outcome.value.value_or(0)));
    }
    readVisible();
    updateSelected();
}

} // namespace campanel::panel
