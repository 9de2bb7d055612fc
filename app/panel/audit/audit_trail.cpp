// SPDX-License-Identifier: Apache-2.0
#include "app/panel/audit/audit_trail.h"

#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/kit/format.h"
#include "app/panel/maintenance/maintenance.h"
#include "app/panel/records/database_service.h"
#include "app/panel/settings/settings.h"
#include "app/panel/words/connection_sentences.h"
#include "app/program/differences.h"
#include "app/store/database/clock_mark.h"

#include <QLocale>

#include <cmath>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

// The time limit for the status with the new generation, which comes within a poll or two.
constexpr auto longestProof = 3s;

QString commandKey(modbus::Command command)
{
    switch (command) {
    case modbus::Command::Start:
        return u"command.start"_s;
    case modbus::Command::StopAtCycleEnd:
        return u"command.stop"_s;
    case modbus::Command::StopNow:
        return u"command.stop_now"_s;
    case modbus::Command::Home:
        return u"command.home"_s;
    case modbus::Command::ResetFault:
        return u"command.reset"_s;
    case modbus::Command::SaveToFlash:
        return u"command.save"_s;
    case modbus::Command::TeachMarks:
        return u"command.teach"_s;
    case modbus::Command::JogBag:
        return u"command.jog_bag"_s;
    case modbus::Command::SingleCut:
        return u"command.cut"_s;
    case modbus::Command::TakeBag:
        return u"command.take"_s;
    case modbus::Command::Measure:
        return u"command.measure"_s;
    case modbus::Command::OrderStart:
        return u"command.order"_s;
    case modbus::Command::OrderEnd:
        return u"command.order_end"_s;
    default:
        return u"command.other"_s;
    }
}

QString outcomeKey(link::ParameterEnd end)
{
    switch (end) {
    case link::ParameterEnd::Done:
        return u"done"_s;
    case link::ParameterEnd::NotSent:
        return u"not_sent"_s;
    case link::ParameterEnd::Refused:
        return u"refused"_s;
    case link::ParameterEnd::OutcomeUnknown:
        break;
    }
    return u"unknown"_s;
}

// Formats a number independently of the language: it is hashed.
QString numberText(double value)
{
    return QLocale::c().toString(value, 'g', 10);
}

QString crcText(std::uint32_t crc)
{
    return u"CRC-32 %1"_s.arg(Format::hexDigits(crc, 8));
}

QString programText(const program::Recipe& recipe, std::uint32_t crc)
{
    return u"%1 · v%2 · %3"_s.arg(QString::fromStdString(recipe.name), QString::number(recipe.version),
                                  crcText(crc));
}

QString connectionText(const ConnectionChoice& choice)
{
    if (choice.simulated)
        return u"simulated"_s;
    return u"%1 %2 8%3%4 unit %5"_s.arg(choice.portName, QString::number(choice.baud), choice.parity,
                                        QString::number(choice.stopBits), QString::number(choice.unit));
}

struct AuditedSetting {
    QString object;
    QString text;
};

// Returns what is recorded of the settings: the connection, and each setting with a label.
QList<AuditedSetting> auditedSettings(const Settings& settings)
{
    QList<AuditedSetting> audited{{u"connection"_s, connectionText(settings.connection())}};
    for (const SettingRow& row : settingTable) {
        const bool isTruth = row.form == SettingForm::Truth;
        if (row.label)
            audited << AuditedSetting{shortKeyOf(row), isTruth
                                                           ? QString::number(settings.values().isTrue(row))
                                                           : settings.values().text(row)};
    }
    return audited;
}

QString outcomeKey(Jog::End end)
{
    switch (end) {
    case Jog::End::Released:
        return u"released"_s;
    case Jog::End::Stopped:
        return u"stopped"_s;
    case Jog::End::Blocked:
    case Jog::End::BothKeys:
    case Jog::End::LeftScreen:
        break;
    }
    return u"broken_off"_s;
}

QString outcomeKey(Homing::Result result)
{
    switch (result) {
    case Homing::Result::Done:
        return u"done"_s;
    case Homing::Result::Stopped:
        return u"stopped"_s;
    case Homing::Result::Failed:
        return u"failed"_s;
    case Homing::Result::None:
    case Homing::Result::UnderWay:
    case Homing::Result::Interrupted:
        break;
    }
    return u"unknown"_s;
}

// Returns the position of an axis; empty while it is unknown.
QString pulsesText(double pulses)
{
    return std::isnan(pulses) ? QString() : u"%1 pulses"_s.arg(numberText(pulses));
}

} // namespace

AuditTrail::AuditTrail(DatabaseService& records, const Parts& parts, QObject* parent)
    : QObject(parent)
    , m_records(records)
    , m_parts(parts)
    , m_wallClock(&QDateTime::currentMSecsSinceEpoch)
{
    m_proofTimer.setSingleShot(true);
    m_proofTimer.setInterval(longestProof);
    connect(&m_proofTimer, &QTimer::timeout, this, [this] { proveDownload(true); });
}

void AuditTrail::open()
{
    watchCommands();
    watchParameters();
    watchDownloads();
    watchSettings();
    watchSimulation();
    watchManual();
    watchLine();
    connect(&m_parts.access, &Access::happened, this, [this](const Access::Event& event) {
        note({.what = event.what,
              .object = event.object,
              .before = event.before,
              .after = event.after,
              .outcome = event.outcome});
    });
}

store::AuditEntry AuditTrail::signedNow(store::AuditEntry entry) const
{
    entry.timeMs = m_wallClock();
    entry.who = m_parts.access.userName();
    entry.level = m_parts.access.level();
    return entry;
}

void AuditTrail::note(const store::AuditEntry& noted)
{
    append(signedNow(noted));
}

QString AuditTrail::activeProgram() const
{
    const auto& program = m_parts.controller.program();
    return program ? QString::fromStdString(program->recipe.name) : QString();
}

void AuditTrail::noteOutside(store::AuditEntry noted)
{
    noted.timeMs = m_wallClock();
    append(noted);
}

void AuditTrail::append(const store::AuditEntry& entry)
{
    m_records.store().run(
        this,
        [entry, clock = m_records.clockState()](store::Database& database) {
            return store::newestRecordMs(database).and_then([&](qint64 newestMs) {
                store::AuditEntry marked = entry;
                marked.isClockDoubtful = store::isTimeDoubtful(entry.timeMs, newestMs, clock);
                return store::appendAudit(database, marked);
            });
        },
        [this](const tl::expected<store::AuditRow, store::StoreError>& row) {
            if (row)
                emit appended(*row);
            else
                m_records.reportError(row.error());
        });
}

void AuditTrail::watchCommands()
{
    connect(&m_parts.controller, &Controller::commandSending, this, &AuditTrail::noteSending);
    connect(&m_parts.controller, &Controller::commandEnded, this,
            [this](const link::CommandOutcome& outcome) {
                const auto sent = m_commands.find(outcome.id);
                if (sent == m_commands.end())
                    return;
                store::AuditEntry ended = *sent;
                m_commands.erase(sent);
                ended.outcome = ConnectionSentences::outcomeKey(outcome);
                append(ended);
            });
}

void AuditTrail::noteSending(const link::CommandRequest& request)
{
    m_commands.insert(request.id,
                      signedNow({.what = commandKey(request.command), .object = activeProgram()}));
}

// Records jogging, tried outputs and homing: the first two are held keys, and the result of homing comes long
// after its command.
void AuditTrail::watchManual()
{
    connect(m_parts.maintenance.jog(), &Jog::begun, this, [this](int direction, double position) {
        note({.what = direction > 0 ? u"command.jog_forward"_s : u"command.jog_reverse"_s,
              .object = activeProgram(),
              .before = pulsesText(position)});
    });
    connect(m_parts.maintenance.jog(), &Jog::ended, this, [this](int, Jog::End end, double position) {
        note({.what = u"command.jog_end"_s,
              .object = activeProgram(),
              .after = pulsesText(position),
              .outcome = outcomeKey(end)});
    });
    connect(m_parts.maintenance.homing(), &Homing::ended, this, [this](Homing::Result result) {
        note({.what = u"command.home_end"_s, .object = activeProgram(), .outcome = outcomeKey(result)});
    });
    connect(
        m_parts.maintenance.measurement(), &AxisMeasurement::ended, this,
        [this](const QString& subject, const QString& result, const QString& outcome) {
            note({.what = u"command.measure_end"_s, .object = subject, .after = result, .outcome = outcome});
        });
    connect(m_parts.maintenance.measurement(), &AxisMeasurement::taken, this,
            [this](const QString& subject, double before, double after) {
                note({.what = u"wizard.axis"_s,
                      .object = subject,
                      .before = numberText(before),
                      .after = numberText(after),
                      .outcome = u"done"_s});
            });
    connect(m_parts.maintenance.outputTry(), &OutputTry::begun, this, [this](const QString& output) {
        note({.what = u"command.try_output"_s, .object = activeProgram(), .after = output});
    });
    connect(m_parts.maintenance.outputTry(), &OutputTry::ended, this,
            [this](const QString& output, Jog::End end) {
                note({.what = u"command.try_output_end"_s,
                      .object = activeProgram(),
                      .before = output,
                      .outcome = outcomeKey(end)});
            });
}

void AuditTrail::watchParameters()
{
    connect(&m_parts.controller, &Controller::parameterWriting, this, &AuditTrail::noteWriting);
    connect(&m_parts.controller, &Controller::parameterWritten, this, &AuditTrail::noteWritten);
    connect(m_parts.maintenance.packing()->wizard(), &MarkWizard::changed, this, &AuditTrail::noteWizard);
}

// Reads the value just before the new one is written: an earlier reading may be outdated. The writes of one
// parameter end in their order.
void AuditTrail::noteWriting(const QString& name, double value)
{
    m_writes << signedNow({.what = u"parameter.write"_s, .object = name, .after = numberText(value)});
    m_parts.controller.link().exchange({0, name.toStdString(), std::nullopt},
                                       {this, [this, name](const link::ParameterOutcome& outcome) {
                                            const auto written = findWrite(name);
                                            if (outcome.value && written != m_writes.end())
                                                written->before = numberText(*outcome.value);
                                        }});
}

QList<store::AuditEntry>::iterator AuditTrail::findWrite(const QString& name)
{
    return std::ranges::find(m_writes, name, &store::AuditEntry::object);
}

void AuditTrail::noteWritten(const link::ParameterOutcome& outcome)
{
    const auto written = findWrite(QString::fromStdString(outcome.name));
    if (written == m_writes.end())
        return;
    store::AuditEntry ended = *written;
    m_writes.erase(written);
    ended.outcome = outcomeKey(outcome.end);
    if (outcome.value)
        ended.readBack = numberText(*outcome.value);
    append(ended);
}

void AuditTrail::noteWizard()
{
    const MarkWizard& wizard = *m_parts.maintenance.packing()->wizard();
    const int step = static_cast<int>(wizard.step());
    if (step == m_wizardStep)
        return;
    m_wizardStep = step;
    if (wizard.step() != MarkWizard::Step::Done && wizard.step() != MarkWizard::Step::Failed)
        return;
    note({.what = u"wizard.marks"_s,
          .object = u"parameter.mark_distance"_s,
          .before = wizard.oldText(),
          .after = wizard.newText(),
          .outcome = wizard.step() == MarkWizard::Step::Done ? u"done"_s : u"off_target"_s});
}

void AuditTrail::watchDownloads()
{
    connect(&m_parts.editor, &Editor::downloadBegun, this, &AuditTrail::beginDownload);
    connect(&m_parts.editor, &Editor::downloadEnded, this, &AuditTrail::endDownload);
    connect(&m_parts.controller, &Controller::savedChanged, this, [this] { proveDownload(false); });
    connect(&m_parts.controller, &Controller::programChanged, this, [this] { proveDownload(false); });
}

void AuditTrail::beginDownload(const program::ProgramImage& image)
{
    proveDownload(true);
    Download download;
    download.crc = image.crc;
    store::AuditEntry whole = signedNow({.what = u"program.download"_s,
                                         .object = QString::fromStdString(image.recipe.name),
                                         .after = programText(image.recipe, image.crc)});
    const auto& active = m_parts.controller.program();
    const auto& status = m_parts.controller.status();
    if (active)
        whole.before = programText(active->recipe, status && status->activeCrc ? *status->activeCrc : 0);
    download.entries << whole;
    if (active) {
        for (const program::Difference& difference :
             program::differences(active->registers, image.registers)) {
            const auto name = difference.info->name;
            const bool isText = !difference.textA.empty() || !difference.textB.empty();
            download.entries << signedNow(
                {.what = u"program.value"_s,
                 .object = QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size())),
                 .before = isText ? QString::fromStdString(difference.textA) : numberText(difference.a),
                 .after = isText ? QString::fromStdString(difference.textB) : numberText(difference.b)});
        }
    }
    m_download = download;
    m_isDownloadProven = false;
}

void AuditTrail::endDownload(const link::DownloadReport& report)
{
    if (!m_download)
        return;
    if (report.stage == link::DownloadStage::Active) {
        m_isDownloadProven = true;
        m_proofTimer.start();
        proveDownload(false);
        return;
    }
    store::AuditEntry failed = m_download->entries.first();
    failed.outcome = report.stage == link::DownloadStage::Canceled ? u"canceled"_s : u"failed"_s;
    m_download.reset();
    append(failed);
}

// Completes the entry with the controller's status after the download. `isLast`: the status did not come in
// time.
void AuditTrail::proveDownload(bool isLast)
{
    if (!m_download || !m_isDownloadProven)
        return;
    const auto& status = m_parts.controller.status();
    const bool isTold = status && status->activeCrc == m_download->crc;
    if (!isTold && !isLast)
        return;
    m_proofTimer.stop();
    const Download done = *std::exchange(m_download, std::nullopt);
    for (store::AuditEntry each : done.entries) {
        if (isTold)
            each.readBack = u"generation %1 · %2"_s.arg(status->generation).arg(crcText(done.crc));
        append(each);
    }
}

void AuditTrail::watchSettings()
{
    for (const AuditedSetting& setting : auditedSettings(m_parts.settings))
        m_settings << setting.text;
    connect(&m_parts.settings, &Settings::changed, this, &AuditTrail::noteSettings);
}

void AuditTrail::noteSettings()
{
    const QList<AuditedSetting> now = auditedSettings(m_parts.settings);
    for (qsizetype i = 0; i < now.size(); ++i) {
        if (m_settings[i] == now[i].text)
            continue;
        note({.what = u"setting.change"_s,
              .object = now[i].object,
              .before = std::exchange(m_settings[i], now[i].text),
              .after = now[i].text});
    }
}

void AuditTrail::noteExport(const QStringList& paths, const QString& problem)
{
    note({.what = u"export.write"_s,
          .object = paths.value(0),
          .after = paths.size() > 1 ? u"%1 files"_s.arg(paths.size()) : QString(),
          .outcome = problem.isEmpty() ? u"done"_s : u"failed"_s});
}

void AuditTrail::watchLine()
{
    connect(m_parts.maintenance.doctor(), &LinkDoctor::begun, this, [this](bool isSearch) {
        note({.what = isSearch ? u"line.search"_s : u"line.diagnose"_s, .object = u"connection"_s});
    });
    connect(m_parts.maintenance.figures(), &LineFigures::wasReset, this,
            [this] { note({.what = u"line.reset"_s}); });
}

void AuditTrail::watchSimulation()
{
    SimulatedFaults& faults = *m_parts.maintenance.simulatedFaults();
    connect(&faults, &SimulatedFaults::changed, this, [this, &faults] {
        const QString now = faults.rulesInForce().join(u"; "_s);
        if (now == m_faults)
            return;
        note({.what = u"setting.change"_s,
              .object = u"simulated_faults"_s,
              .before = std::exchange(m_faults, now),
              .after = now});
    });
}

} // namespace campanel::panel
