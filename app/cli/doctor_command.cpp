// SPDX-License-Identifier: Apache-2.0
// campanelctl doctor: finds out why there is no connection, and with --scan where a controller is.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/link_session.h"
#include "app/cli/report.h"
#include "app/panel/words/doctor_sentences.h"
#include "modbus/line/line_scan.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QSerialPortInfo>

#include <cstdio>

#include <unistd.h>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

using modbus::LineFinding;
using panel::DoctorSentences;

QString conditionKey(modbus::LineCondition condition)
{
    static const QStringList keys{u"controller"_s,         u"wrong_unit"_s, u"other_map_version"_s,
                                  u"other_device"_s,       u"garbage"_s,    u"no_bytes"_s,
                                  u"echo_only"_s,          u"refused"_s,    u"port_absent"_s,
                                  u"port_not_permitted"_s, u"port_busy"_s,  u"port_not_serial"_s,
                                  u"port_settings"_s,      u"port_gone"_s};
    return keys.value(static_cast<qsizetype>(condition));
}

// Returns the command for a shell that corrects a finding; empty when there is none.
QString remedy(const LineFinding& finding)
{
    if (!finding.group.empty())
        return QString::fromStdString(modbus::joinGroupCommand(finding.group));
    return finding.isLatencyTooLong() ? QString::fromStdString(modbus::lowerLatencyCommand(finding.port))
                                      : QString();
}

QJsonObject findingObject(const LineFinding& finding)
{
    QJsonArray holders;
    for (const modbus::PortHolder& holder : finding.holders)
        holders.append(QJsonObject{{u"process"_s, holder.processId},
                                   {u"program"_s, QString::fromStdString(holder.program)}});
    return {
        {u"condition"_s, conditionKey(finding.condition)},
        {u"port"_s, QString::fromStdString(finding.port)},
        {u"baud"_s, static_cast<qint64>(finding.line.baud)},
        {u"parity"_s, QString(QChar::fromLatin1(static_cast<char>(finding.line.parity)))},
        {u"stop_bits"_s, finding.line.stopBits},
        {u"unit"_s, finding.unit},
        {u"firmware"_s, finding.identity
                            ? QJsonValue(QString::fromStdString(finding.identity->firmwareVersion()))
                            : QJsonValue()},
        {u"bytes_seen"_s, static_cast<qint64>(finding.bytesSeen)},
        {u"stray_bytes"_s, static_cast<qint64>(finding.strayBytes)},
        {u"exception"_s,
         finding.condition == modbus::LineCondition::Refused ? QJsonValue(finding.code) : QJsonValue()},
        {u"holders"_s, holders},
        {u"group"_s, QString::fromStdString(finding.group)},
        {u"latency_timer_ms"_s, finding.latencyTimerMs ? QJsonValue(*finding.latencyTimerMs) : QJsonValue()},
        {u"sentence"_s, DoctorSentences::finding(finding)},
        {u"command"_s, remedy(finding)}};
}

// Shows the progress to a person; scripts do not get it.
void showProgress(const modbus::ScanProgress& progress)
{
    if (isatty(STDERR_FILENO) == 0)
        return;
    std::fprintf(stderr, "\r%s   ",
                 qPrintable(cellText(u"%1: %2, %3"_s.arg(
                     DoctorSentences::progress(progress), QString::fromStdString(progress.port),
                     DoctorSentences::settings(progress.line, progress.unit)))));
}

QByteArray findingsText(const std::vector<LineFinding>& findings, const QString& format)
{
    QJsonArray array;
    QString text;
    for (const LineFinding& finding : findings) {
        array.append(findingObject(finding));
        text += cellText(u"%1, %2: %3"_s.arg(QString::fromStdString(finding.port),
                                             DoctorSentences::settings(finding.line, finding.unit),
                                             DoctorSentences::finding(finding))) +
                u'\n';
        if (const QString command = remedy(finding); !command.isEmpty())
            text += u"  "_s + cellText(command) + u'\n';
    }
    return format == u"json" ? QJsonDocument(array).toJson() : text.toUtf8();
}

} // namespace

Outcome runDoctor(const Invocation& call)
{
    const bool isSearch = call.isSet(u"scan"_s);
    const auto settings = isSearch && !call.isSet(u"port"_s) ? lineSettings(call) : linkSettings(call);
    if (!settings)
        return tl::unexpected(settings.error());
    modbus::ScanPlan plan;
    plan.port = settings->port;
    plan.line = settings->line;
    plan.unit = settings->unit;
    plan.depth = isSearch ? modbus::ScanPlan::Depth::Search : modbus::ScanPlan::Depth::Diagnosis;
    if (isSearch && plan.port.empty()) {
        for (const QSerialPortInfo& port : QSerialPortInfo::availablePorts())
            plan.otherPorts.push_back(port.systemLocation().toStdString());
        if (plan.otherPorts.empty())
            return fail(ExitCode::Link, u"This computer has no serial port: plug the adapter in."_s);
    }
    modbus::LineScan scan(std::move(plan));
    while (!scan.ended()) {
        showProgress(scan.progress());
        scan.advance();
    }
    if (isatty(STDERR_FILENO) != 0)
        std::fputc('\n', stderr);
    if (const Outcome delivered = call.deliver(findingsText(scan.findings(), call.format())); !delivered)
        return delivered;
    const LineFinding* found = scan.controller();
    if (found == nullptr)
        return fail(ExitCode::Link, u"No controller was found."_s);
    if (!isSearch && found->condition == modbus::LineCondition::WrongUnit)
        return fail(ExitCode::Link, u"No controller responds at unit number %1."_s.arg(settings->unit));
    return {};
}

} // namespace campanel::cli
