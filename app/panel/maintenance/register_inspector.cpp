// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/register_inspector.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
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

RegisterInspector::RegisterInspector(Controller& machine, QObject* parent)
    : QObject(parent)
    , m_machine(machine)
{
    m_readTimer.setInterval(readPeriod);
    connect(&m_readTimer, &QTimer::timeout, this, &RegisterInspector::readVisible);
    connect(&m_registers, &RegisterModel::modelReset, this, [this] { select(-1); });
    connect(&machine.link(), &link::Link::registersRead, this, &RegisterInspector::takeRead);
    connect(&machine, &Controller::parameterEnded, this, &RegisterInspector::takeWritten);
    connect(&machine, &Controller::connectionChanged, this, &RegisterInspector::noteConnection);
    connect(&machine, &Controller::programChanged, this, &RegisterInspector::noteProgram);
}

void RegisterInspector::setWatched(bool isWatched)
{
    if (m_isWatched == isWatched)
        return;
    m_isWatched = isWatched;
    if (isWatched)
        m_readTimer.start();
    else
        m_readTimer.stop();
    readVisible();
    emit watchedChanged();
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
    m_registers.markOlderThan(m_machine.now() - staleAfter);
    if (!m_isWatched || !m_machine.isConnected() || !m_reads.isEmpty())
        return;
    QList<link::ReadRequest> requests;
    for (const modbus::RegisterSpan& span : m_registers.spans(m_first, m_last))
        requests << link::ReadRequest{m_machine.nextReadId(), span.address, span.count};
    for (const link::ReadRequest& request : requests)
        m_reads.insert(request.id);
    for (const link::ReadRequest& request : requests)
        m_machine.link().readRegisters(request);
}

void RegisterInspector::takeRead(const link::ReadOutcome& outcome)
{
    if (!m_reads.remove(outcome.request.id))
        return;
    const bool isRefused = outcome.error && (outcome.error->kind == modbus::LinkErrorKind::RangeNotReadable ||
                                             outcome.error->kind == modbus::LinkErrorKind::Exception);
    // After another failure the value stays and is displayed as old.
    if (outcome.end == link::ReadEnd::Done || isRefused)
        m_registers.take(outcome);
    const RegisterRow* chosen = row();
    if (chosen && chosen->address >= outcome.request.address &&
        chosen->address < outcome.request.address + outcome.request.count)
        emit selectionChanged();
}

void RegisterInspector::noteConnection()
{
    readVisible();
    emit selectionChanged();
}

void RegisterInspector::noteProgram()
{
    const auto& program = m_machine.program();
    m_registers.setProgram(program ? program->header.kind : modbus::ProgramKind::None,
                           program ? static_cast<modbus::TableLayout>(program->header.layout)
                                   : modbus::TableLayout::None);
}

void RegisterInspector::select(int row)
{
    m_selected = m_registers.rowAt(row) ? row : -1;
    m_outcome.clear();
    m_isFailed = false;
    emit selectionChanged();
}

QString RegisterInspector::selectedName() const
{
    return row() ? row()->name : QString();
}

QString RegisterInspector::number(double value) const
{
    const QString text = Format().number(value, decimals());
    return unit().isEmpty() ? text : text + u' ' + unit();
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
    return m_machine.isConnected() ? tr("Writable: %1 to %2, default %3.")
                                         .arg(number(minimum()), number(maximum()), number(defaultValue()))
                                   : tr("There is no connection to the controller.");
}

bool RegisterInspector::writable() const
{
    return row() && RegisterWords::readOnlyReason(row()->group).isEmpty();
}

bool RegisterInspector::canWrite() const
{
    return writable() && m_machine.isConnected() && m_writeId == 0;
}

QString RegisterInspector::unit() const
{
    return row()
               ? QString::fromUtf8(row()->info->unit.data(), static_cast<qsizetype>(row()->info->unit.size()))
               : QString();
}

QString RegisterInspector::valueText() const
{
    const auto value = m_registers.valueAt(m_selected);
    // A state has no physical value: the keypad displays its number.
    return value ? Format().number(value->physical.value_or(static_cast<double>(value->raw)), decimals())
                 : Format::unknownText();
}

double RegisterInspector::minimum() const
{
    return row() ? row()->info->minimum : 0;
}

double RegisterInspector::maximum() const
{
    return row() ? row()->info->maximum : 0;
}

double RegisterInspector::defaultValue() const
{
    return row() ? row()->info->defaultValue : 0;
}

int RegisterInspector::decimals() const
{
    return row() ? RegisterWords::decimals(*row()->info) : 0;
}

QString RegisterInspector::check(double value) const
{
    if (value >= minimum() && value <= maximum())
        return {};
    return tr("From %1 to %2.").arg(number(minimum()), number(maximum()));
}

void RegisterInspector::write(double value)
{
    if (!canWrite() || !check(value).isEmpty() || !m_machine.accessCheck().require(Level::Service))
        return;
    m_outcome = tr("Writing %1 …").arg(number(value));
    m_isFailed = false;
    m_writeId = m_machine.writeParameter(row()->name.toLatin1().constData(), value);
    emit selectionChanged();
}

void RegisterInspector::takeWritten(const link::ParameterOutcome& outcome)
{
    if (m_writeId == 0 || outcome.id != m_writeId)
        return;
    m_writeId = 0;
    const bool isShown = row() && row()->name.toStdString() == outcome.name;
    if (isShown) {
        m_isFailed = outcome.end != link::ParameterEnd::Done;
        m_outcome =
            m_isFailed
                ? ConnectionSentences::parameter(row()->name, outcome)
                : tr("Written and read back from the controller: %1.").arg(number(outcome.value.value_or(0)));
    }
    readVisible();
    emit selectionChanged();
}

void RegisterInspector::retranslate()
{
    m_outcome.clear();
    m_registers.retranslate();
    emit filterChanged();
    emit selectionChanged();
}

} // namespace campanel::panel
