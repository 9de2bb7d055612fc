// SPDX-License-Identifier: Apache-2.0
// campanelctl fleet: the machines of a group at the plant's broker, each with the program that it has.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/report.h"
#include "app/cli/signed_file.h"
#include "app/shell/configuration.h"
#include "app/store/files/files.h"
#include "gateway/fleet.h"
#include "gateway/mqtt_line.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>
#include <QSysInfo>
#include <QTimer>
#include <QUrl>
#include <QUuid>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

using gateway::FleetMachine;
using plant::Metric;

constexpr int standardPort = 1883;
constexpr double minWaitS = 0.5;
constexpr double maxWaitS = 600;
constexpr int fleetMsPerS = 1000;
constexpr int leaveLimitMs = 2000;

// Returns the broker of the options, or of the configuration file.
tl::expected<gateway::GatewaySettings, Failure> brokerOf(const Invocation& call)
{
    gateway::GatewaySettings settings;
    settings.port = standardPort;
    settings.group = u"CamPanel"_s;
    if (call.isSet(u"config"_s) || !call.isSet(u"broker"_s)) {
        const QString file = call.isSet(u"config"_s) ? call.value(u"config"_s) : shell::configurationFile();
        const auto read =
            gateway::gatewaySettings(shell::readConfiguration(file), QSysInfo::machineHostName());
        if (!read.errors.isEmpty())
            return fail(ExitCode::File, read.errors.first());
        settings = read.settings;
    }
    if (call.isSet(u"broker"_s)) {
        const QUrl url(u"mqtt://"_s + call.value(u"broker"_s));
        if (!url.isValid() || url.host().isEmpty())
            return fail(ExitCode::Usage, u"--broker takes HOST or HOST:PORT."_s);
        settings.host = url.host();
        settings.port = url.port(settings.port);
    }
    if (call.isSet(u"group"_s))
        settings.group = call.value(u"group"_s);
    if (settings.host.isEmpty())
        return fail(ExitCode::Usage,
                    u"Name the broker: --broker HOST, or --config FILE with a section [gateway]."_s);
    if (settings.group.isEmpty() || settings.group.contains(u'/') || settings.group.contains(u'+') ||
        settings.group.contains(u'#'))
        return fail(ExitCode::Usage, u"Name the group of the machines: --group GROUP, without / + #."_s);
    return settings;
}

// Returns the CRC-32 of the signed tables; empty without --signed.
tl::expected<QList<std::uint32_t>, Failure> signedTables(const Invocation& call)
{
    QList<std::uint32_t> tables;
    if (!call.isSet(u"signed"_s))
        return tables;
    const QString place = call.value(u"signed"_s);
    if (!call.isSet(u"keys"_s) || !QFileInfo(call.value(u"keys"_s)).isDir())
        return fail(ExitCode::Usage, u"--signed needs --keys FOLDER, the folder of the public keys."_s);
    QStringList files{place};
    if (QFileInfo(place).isDir()) {
        files.clear();
        for (const QFileInfo& file : QDir(place).entryInfoList({u"*.json"_s}, QDir::Files, QDir::Name))
            files << file.filePath();
        if (files.isEmpty())
            return fail(ExitCode::File, u"%1 has no signed recipe."_s.arg(place));
    }
    const QList<store::SignerKey> keys = store::signerKeys(call.value(u"keys"_s));
    for (const QString& file : files) {
        const auto recipe = readSignedRecipe(file, keys);
        if (!recipe)
            return tl::unexpected(recipe.error());
        tables << recipe->signature.tableCrc;
    }
    return tables;
}

// Listens for a time; fails when the broker cannot be reached.
Outcome listen(const gateway::GatewaySettings& settings, int waitMs, gateway::Fleet& fleet)
{
    gateway::MqttLine line(settings,
                           u"campanelctl-%1"_s.arg(QUuid::createUuid().toString(QUuid::Id128).left(8)));
    QString failure;
    QObject context;
    QObject::connect(&line, &gateway::MqttLine::opened, &context, [&](int) {
        for (const QString& topic : fleet.topics())
            line.subscribe(topic);
        line.requestBarrier();
    });
    QObject::connect(&line, &gateway::MqttLine::barrierPassed, &context, [&] {
        line.publish({gateway::groupRebirthTopic(settings.group), "campanelctl", 1});
        QTimer::singleShot(waitMs, &context, &QCoreApplication::quit);
    });
    QObject::connect(&line, &gateway::MqttLine::received, &context,
                     [&fleet](const QString& topic, const QByteArray& bytes) { fleet.take(topic, bytes); });
    QObject::connect(&line, &gateway::MqttLine::closed, &context, [&failure](const QString& reason) {
        failure = reason;
        QCoreApplication::quit();
    });
    line.start();
    QCoreApplication::exec();
    context.disconnect();
    line.leave(0);
    (void)line.stop(leaveLimitMs);
    if (!failure.isEmpty())
        return fail(ExitCode::Link, failure);
    return {};
}

QJsonValue jsonOf(const plant::MetricValue& value)
{
    if (const auto* whole = std::get_if<std::int64_t>(&value))
        return QJsonValue(qint64(*whole));
    if (const auto* text = std::get_if<QString>(&value))
        return *text;
    return QJsonValue();
}

std::optional<std::uint32_t> crcOf(const FleetMachine& machine)
{
    const auto* crc = std::get_if<std::int64_t>(&machine.value(Metric::RecipeCrc));
    if (!machine.isOnline || !crc)
        return std::nullopt;
    return static_cast<std::uint32_t>(*crc);
}

QJsonObject rowOf(const FleetMachine& machine, const QList<std::uint32_t>& tables)
{
    const auto crc = crcOf(machine);
    const auto known = [&machine](Metric metric) {
        return machine.isOnline ? jsonOf(machine.value(metric)) : QJsonValue();
    };
    const QDateTime since = QDateTime::fromMSecsSinceEpoch(machine.crcSinceMs).toUTC();
    QJsonObject row{{u"machine"_s, machine.node},
                    {u"online"_s, machine.isOnline},
                    {u"recipe"_s, known(Metric::RecipeName)},
                    {u"version"_s, known(Metric::RecipeVersion)},
                    {u"table_crc32"_s, crc ? QJsonValue(crcText(*crc)) : QJsonValue()},
                    {u"generation"_s, known(Metric::RecipeGeneration)},
                    {u"since_utc"_s, crc ? QJsonValue(since.toString(Qt::ISODate)) : QJsonValue()}};
    if (!tables.isEmpty())
        row[u"table_is_a_signed_one"_s] = crc ? QJsonValue(tables.contains(*crc)) : QJsonValue();
    return row;
}

// Returns the keys of a row, in the order of the columns.
QStringList columnsOf(const QJsonArray& rows)
{
    QStringList keys{u"machine"_s,    u"recipe"_s,    u"version"_s, u"table_crc32"_s,
                     u"generation"_s, u"since_utc"_s, u"online"_s};
    if (rows.first().toObject().contains(u"table_is_a_signed_one"_s))
        keys << u"table_is_a_signed_one"_s;
    return keys;
}

QByteArray fleetText(const QJsonArray& rows)
{
    return rowsText(rows, columnsOf(rows),
                    {{u"table_crc32"_s, u"CRC-32"_s},
                     {u"since_utc"_s, u"since (UTC)"_s},
                     {u"table_is_a_signed_one"_s, u"signed table"_s}});
}

QByteArray fleetCsv(const QJsonArray& rows)
{
    const QStringList keys = columnsOf(rows);
    store::CsvWriter csv(keys.join(u','), {});
    for (const QJsonValue& row : rows) {
        for (const QString& key : keys)
            addCell(csv, row.toObject().value(key));
        csv.endLine();
    }
    return csv.bytes();
}

// Names the machines that do not report a signed table.
Outcome judge(const QJsonArray& rows)
{
    QStringList others;
    for (const QJsonValue& row : rows) {
        if (!row.toObject().value(u"table_is_a_signed_one"_s).toBool())
            others << cellOf(row.toObject().value(u"machine"_s));
    }
    if (others.isEmpty())
        return {};
    return fail(ExitCode::Refused, u"%1 of %2 machines do not report a signed table: %3."_s.arg(others.size())
                                       .arg(rows.size())
                                       .arg(others.join(u", "_s)));
}

} // namespace

Outcome runFleet(const Invocation& call)
{
    const auto broker = brokerOf(call);
    if (!broker)
        return tl::unexpected(broker.error());
    bool isNumber = false;
    const double waitS = call.value(u"wait"_s).toDouble(&isNumber);
    if (!isNumber || !(waitS >= minWaitS && waitS <= maxWaitS))
        return fail(ExitCode::Usage, u"--wait takes 0.5 to 600 seconds."_s);
    const auto tables = signedTables(call);
    if (!tables)
        return tl::unexpected(tables.error());
    gateway::Fleet fleet(broker->group);
    if (const auto heard = listen(*broker, static_cast<int>(waitS * fleetMsPerS), fleet); !heard)
        return heard;
    QJsonArray rows;
    for (const FleetMachine& machine : fleet.machines())
        rows.append(rowOf(machine, *tables));
    if (rows.isEmpty())
        return fail(ExitCode::Link, u"No machine of the group %1 has answered at %2. Check --group, or wait "
                                    "longer with --wait."_s.arg(broker->group, broker->host));
    const QString format = call.format();
    const QByteArray text = format == u"json"  ? formatted({{u"machines"_s, rows}}, format)
                            : format == u"csv" ? fleetCsv(rows)
                                               : fleetText(rows);
    if (const auto delivered = call.deliver(text); !delivered || tables->isEmpty())
        return delivered;
    return judge(rows);
}

} // namespace campanel::cli
