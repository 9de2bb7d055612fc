// SPDX-License-Identifier: Apache-2.0
// campanelctl versions: the software and the program that run, the open recipe, and how long the disk lasts.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/link_session.h"
#include "app/cli/report.h"
#include "app/store/files/system_record.h"
#include "app/store/recipes/recipe_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStorageInfo>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

QJsonValue orUnknown(const QString& version)
{
    return version.isEmpty() ? QJsonValue() : QJsonValue(version);
}

QJsonObject diskObject(const store::DiskForecast& forecast)
{
    constexpr double bytesPerMegabyte = 1e6;
    constexpr double bytesPerGigabyte = 1e9;
    QJsonObject object{{u"free_gb"_s, double(forecast.freeBytes) / bytesPerGigabyte},
                       {u"measured_days"_s, forecast.days},
                       {u"growth_mb_per_day"_s, forecast.bytesPerDay
                                                    ? QJsonValue(*forecast.bytesPerDay / bytesPerMegabyte)
                                                    : QJsonValue()},
                       {u"years"_s, orNull(forecast.years)}};
    if (forecast.isShort())
        object[u"warning"_s] =
            u"The disk lasts for less than five years. Free some disk space, or use a larger disk."_s;
    return object;
}

// Adds what the panel has left in the folder of its data: the versions that ran last, and the open recipe.
Outcome addData(QJsonObject& object, const QString& folder)
{
    if (!QFileInfo(folder).isDir())
        return fail(ExitCode::File,
                    u"%1 is not a folder. Name the folder of the panel's data."_s.arg(folder));
    const store::SystemRecord record = store::readSystemRecord(folder);
    object[u"panel"_s] = orUnknown(record.software.value(u"panel"_s));
    object[u"gateway"_s] = orUnknown(record.software.value(u"gateway"_s));
    if (const auto recipe = store::readRecipe(QDir(folder).filePath(u"recipe.json"_s)))
        object[u"open_recipe"_s] =
            QJsonObject{{u"name"_s, QString::fromStdString(recipe->name)}, {u"version"_s, recipe->version}};
    object[u"disk"_s] = diskObject(store::forecastOf(record, QStorageInfo(folder).bytesAvailable()));
    return {};
}

// Adds what the controller says.
Outcome addController(QJsonObject& object, const Invocation& call)
{
    auto session = LinkSession::open(call);
    if (!session)
        return tl::unexpected(session.error());
    const modbus::Identity& identity = session->identity();
    object[u"controller"_s] = QJsonObject{
        {u"firmware"_s, QString::fromStdString(identity.firmwareVersion())},
        {u"register_map"_s, u"%1.%2"_s.arg(identity.mapMajor).arg(identity.mapMinor)},
        {u"unique_id"_s, QString::number(identity.uniqueId, 16).toUpper().rightJustified(16, u'0')}};
    const auto status = session->status();
    if (!status)
        return tl::unexpected(status.error());
    if (!status->activeCrc)
        return {};
    QJsonObject program{{u"kind"_s, QJsonValue()},
                        {u"name"_s, QJsonValue()},
                        {u"version"_s, QJsonValue()},
                        {u"generation"_s, static_cast<qint64>(status->generation)},
                        {u"crc32"_s, crcText(*status->activeCrc)}};
    const auto active = session->activeProgram();
    if (active && *active) {
        const program::Recipe& recipe = (*active)->recipe;
        program[u"kind"_s] = fromView(program::kindInfo(recipe.kind()).key);
        program[u"name"_s] = QString::fromStdString(recipe.name);
        program[u"version"_s] = recipe.version;
    }
    object[u"active_program"_s] = program;
    return active ? Outcome() : tl::unexpected(active.error());
}

// Says plainly what is not known.
QJsonObject inWords(QJsonObject object)
{
    for (auto value = object.begin(); value != object.end(); ++value) {
        if (value->isNull())
            *value = u"unknown"_s;
        else if (value->isObject())
            *value = inWords(value->toObject());
    }
    return object;
}

} // namespace

Outcome runVersions(const Invocation& call)
{
    QJsonObject object{{u"campanelctl"_s, QCoreApplication::applicationVersion()},
                       {u"panel"_s, QJsonValue()},
                       {u"gateway"_s, QJsonValue()},
                       {u"controller"_s, QJsonValue()},
                       {u"active_program"_s, QJsonValue()},
                       {u"open_recipe"_s, QJsonValue()},
                       {u"disk"_s, QJsonValue()}};
    if (call.isSet(u"data"_s)) {
        if (const Outcome added = addData(object, call.value(u"data"_s)); !added)
            return added;
    }
    const Outcome asked = call.isSet(u"port"_s) ? addController(object, call) : Outcome();
    const QString format = call.format();
    if (const Outcome delivered =
            call.deliver(formatted(format == u"json" ? object : inWords(object), format));
        !delivered)
        return delivered;
    return asked;
}

} // namespace campanel::cli
