// SPDX-License-Identifier: Apache-2.0
#include "app/panel/reports/service_bundle.h"

#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/kit/format.h"
#include "app/panel/maintenance/figures_csv.h"
#include "app/panel/maintenance/frame_list.h"
#include "app/panel/maintenance/line_figures.h"
#include "app/panel/records/database_service.h"
#include "app/panel/settings/settings.h"
#include "app/program/program_image.h"
#include "app/program/table/table_columns.h"
#include "app/store/logs/alarm_log.h"
#include "app/store/logs/audit_log.h"
#include "app/store/recipes/recipe_json.h"

#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSysInfo>
#include <QTimer>

#include <chrono>
#include <span>
#include <vector>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

constexpr qint64 daysOfLogs = 7;
constexpr std::chrono::milliseconds screenDelay{500}; // until the alarm is on the screen

QByteArray readMe()
{
    return QByteArray(R"(CamPanel service bundle

about.json               when it was made, by which CamPanel, on which system
recipe.json              the recipe that is open on the panel, with the machine's data
table.csv                the table that this recipe makes; not there when a limit forbids it
controller.json          who the controller is, what it runs, what the panel last proved
alarms.csv               alarms of the last 7 days, newest first
audit.csv                changes of the last 7 days, newest first, with the hashes of the chain
link_figures.csv         exchanges, errors and times of the line
link_24_hours.csv        the same minute by minute
parameters.csv           the parameters of the controller; not there without a connection
frames.txt               the last frames of the line
trace.csv                every status of the last 10 seconds
trace_before_fault.csv   the 10 seconds before the last fault since the panel started; not there without one
frames_before_fault.txt  the last frames before that fault
screen_at_fault.png      the screen half a second after that fault

All times are UTC. The tables have commas and decimal points in any language. The texts in controller.json are in the language of the panel.
)");
}

// Returns the ranges without gaps in which the register table has parameters.
std::vector<modbus::RegisterSpan> parameterSpans()
{
    constexpr int maxRegisters = 100; // in one request
    std::vector<modbus::RegisterSpan> spans;
    for (const modbus::RegisterInfo& info : modbus::registers()) {
        if (!modbus::isMachineData(info))
            continue;
        const bool follows = !spans.empty() && spans.back().address + spans.back().count == info.address &&
                             spans.back().count + info.count <= maxRegisters;
        if (follows)
            spans.back().count = static_cast<std::uint16_t>(spans.back().count + info.count);
        else
            spans.push_back({info.address, info.count});
    }
    return spans;
}

QByteArray framesText(const QList<modbus::FrameRecord>& frames)
{
    return QByteArray::fromStdString(
        modbus::framesText(std::span(frames.constData(), static_cast<std::size_t>(frames.size()))));
}

QJsonValue checksum(const std::optional<std::uint32_t>& crc)
{
    return crc ? QJsonValue(Format::hexDigits(*crc, 8)) : QJsonValue(QJsonValue::Null);
}

} // namespace

ServiceBundle::ServiceBundle(const Parts& parts, QObject* parent)
    : QObject(parent)
    , m_parts(parts)
    , m_wallClock([] { return QDateTime::currentDateTime(); })
{
    connect(&parts.controller.link(), &link::Link::statusReceived, this,
            [this](const link::StatusBatch& batch) {
                for (const link::StatusSample& sample : batch.samples) {
                    if (m_trace.add(sample))
                        recordFault();
                }
            });
}

void ServiceBundle::setBusy(bool isBusy)
{
    m_isBusy = isBusy;
    emit busyChanged();
}

void ServiceBundle::make()
{
    if (m_isBusy)
        return;
    setBusy(true);
    m_parts.frames.readOnce(this, [this](const QList<modbus::FrameRecord>& frames) { m_frames = frames; });
    m_parts.figures.readOnce(this, [this](const link::FiguresReport& report) { readParameters(report); });
}

void ServiceBundle::recordFault()
{
    m_faultFrames.clear();
    m_faultScreen.clear();
    m_parts.frames.readOnce(this,
                            [this](const QList<modbus::FrameRecord>& frames) { m_faultFrames = frames; });
    if (m_screen)
        QTimer::singleShot(screenDelay, this, [this] { m_faultScreen = m_screen(); });
}

void ServiceBundle::readParameters(const link::FiguresReport& figures)
{
    m_parameters.emplace(u"parameter,value", store::CsvDialect());
    const std::vector<modbus::RegisterSpan> spans =
        m_parts.controller.isConnected() ? parameterSpans() : std::vector<modbus::RegisterSpan>();
    m_pendingReads = static_cast<int>(spans.size());
    if (spans.empty())
        gather(figures);
    for (const modbus::RegisterSpan& span : spans) {
        m_parts.controller.link().readRegisters(
            {0, span.address, span.count}, {this, [this, figures](const link::ReadOutcome& outcome) {
                                                for (const modbus::NamedValue& value : modbus::namedValues(
                                                         outcome.request.address, outcome.registers))
                                                    m_parameters->text(QString::fromStdString(value.name()))
                                                        .value(QString::fromStdString(value.text()))
                                                        .endLine();
                                                if (--m_pendingReads == 0)
                                                    gather(figures);
                                            }});
    }
}

QByteArray ServiceBundle::about() const
{
    return QJsonDocument(QJsonObject{{u"program"_s, u"CamPanel "_s + QCoreApplication::applicationVersion()},
                                     {u"made"_s, m_wallClock().toUTC().toString(Qt::ISODate)},
                                     {u"system"_s, QSysInfo::prettyProductName()},
                                     {u"kernel"_s, QSysInfo::kernelVersion()},
                                     {u"processor"_s, QSysInfo::currentCpuArchitecture()},
                                     {u"qt"_s, QString::fromLatin1(qVersion())}})
        .toJson();
}

QByteArray ServiceBundle::controller() const
{
    const Controller& controller = m_parts.controller;
    QJsonObject object{{u"machine"_s, controller.settings().machineName()},
                       {u"connection"_s, controller.connectionText()},
                       {u"port"_s, controller.portName()},
                       {u"simulated"_s, controller.simulated()},
                       {u"state"_s, controller.stateText()},
                       {u"alarm"_s, controller.alarmText()}};
    if (const auto& identity = controller.identity()) {
        object[u"serial_number"_s] = Format::hexDigits(identity->uniqueId, 16);
        object[u"firmware"_s] = QString::fromStdString(identity->firmwareVersion());
        object[u"register_map"_s] = u"%1.%2"_s.arg(identity->mapMajor).arg(identity->mapMinor);
        object[u"row_capacity"_s] = identity->rowCapacity;
        object[u"timer_clock_hz"_s] = static_cast<qint64>(identity->timerClockHz);
        object[u"max_pulse_frequency_hz"_s] = static_cast<qint64>(identity->maxPulseFrequencyHz);
    }
    if (const auto& status = controller.status()) {
        object[u"generation"_s] = static_cast<qint64>(status->generation);
        object[u"active_crc32"_s] = checksum(status->activeCrc);
        object[u"saved_crc32"_s] = checksum(status->savedCrc);
        object[u"uptime_s"_s] = static_cast<qint64>(status->uptimeS);
    }
    const ProgramProof& proof = *m_parts.editor.programDownload()->proof();
    object[u"active_program"_s] = proof.activeText();
    object[u"saved_program"_s] = proof.savedText();
    object[u"proof"_s] = proof.text();
    return QJsonDocument(object).toJson();
}

void ServiceBundle::gather(const link::FiguresReport& figures)
{
    const link::SteadyTime moment = m_parts.controller.now();
    const QDateTime timeOfDay = m_wallClock();
    Entries entries{{u"README.txt"_s, readMe(), {}},
                    {u"about.json"_s, about(), {}},
                    {u"recipe.json"_s, store::toJson(m_parts.editor.recipe()), {}},
                    {u"controller.json"_s, controller(), {}},
                    {u"trace.csv"_s, StatusTrace::csv(m_trace.latest(), moment, timeOfDay), {}},
                    {u"link_figures.csv"_s, figuresCsv(figures.figures), {}},
                    {u"link_24_hours.csv"_s, stripCsv(figures.figures), {}}};
    if (!m_trace.beforeFault().empty())
        entries << store::ArchiveEntry{
            u"trace_before_fault.csv"_s, StatusTrace::csv(m_trace.beforeFault(), moment, timeOfDay), {}};
    if (m_parameters->rows() > 0)
        entries << store::ArchiveEntry{u"parameters.csv"_s, m_parameters->bytes(), {}};
    if (!m_frames.isEmpty())
        entries << store::ArchiveEntry{u"frames.txt"_s, framesText(m_frames), {}};
    if (!m_faultFrames.isEmpty())
        entries << store::ArchiveEntry{u"frames_before_fault.txt"_s, framesText(m_faultFrames), {}};
    if (!m_faultScreen.isEmpty())
        entries << store::ArchiveEntry{u"screen_at_fault.png"_s, m_faultScreen, {}};
    const qint64 sinceMs = timeOfDay.addDays(-daysOfLogs).toMSecsSinceEpoch();
    m_parts.records.store().run(
        this,
        [sinceMs](store::Database& database) -> tl::expected<Entries, store::StoreError> {
            const store::LogFilter since{.fromMs = sinceMs};
            const auto alarms = store::alarmTable().csv(database, since);
            if (!alarms)
                return tl::unexpected(alarms.error());
            return store::auditTable().csv(database, since).map([&alarms](const store::LogCsv& audit) {
                return Entries{{u"alarms.csv"_s, alarms->bytes, {}}, {u"audit.csv"_s, audit.bytes, {}}};
            });
        },
        [this, entries](const tl::expected<Entries, store::StoreError>& logs) {
            // The bundle is useful without the logs; the panel reports elsewhere that they cannot be read.
            if (!logs)
                m_parts.records.reportError(logs.error());
            offer(entries + logs.value_or(Entries()));
        });
}

void ServiceBundle::offer(Entries entries)
{
    const QString name = tr("CamPanel service %1", "name of a file")
                             .arg(m_parts.controller.settings().fileStamp(m_wallClock()));
    m_parts.files.offer(
        {{name, u"zip"_s, {}, [entries, recipe = m_parts.editor.recipe()](const QString& path) {
              Entries all = entries;
              if (const auto image = program::buildProgram(recipe))
                  all << store::ArchiveEntry{
                      u"table.csv"_s,
                      QByteArray::fromStdString(program::tableCsv(program::tableColumns(*image))),
                      {}};
              return store::writeArchive(path, all);
          }}});
    setBusy(false);
    emit offered();
}

} // namespace campanel::panel
