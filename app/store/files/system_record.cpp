// SPDX-License-Identifier: Apache-2.0
#include "app/store/files/system_record.h"

#include "app/store/files/files.h"

#include <QDir>
#include <QDirIterator>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

constexpr qint64 minMeasuredDays = 2;
constexpr double daysPerYear = 365.25;
constexpr qsizetype maxVersionLength = 100;

QString recordPath(const QString& folder)
{
    return QDir(folder).filePath(u"system.json"_s);
}

} // namespace

SystemRecord readSystemRecord(const QString& folder)
{
    SystemRecord record;
    const auto bytes = readBytes(recordPath(folder));
    const QJsonObject root = bytes ? QJsonDocument::fromJson(*bytes).object() : QJsonObject();
    const QJsonObject software = root[u"software"_s].toObject();
    for (auto version = software.begin(); version != software.end(); ++version)
        record.software.insert(version.key(), version->toString().left(maxVersionLength));
    for (const QJsonValue& sample : root[u"data_bytes_by_day"_s].toArray()) {
        const qint64 day = sample[0].toInteger(-1);
        const qint64 bytesOfDay = sample[1].toInteger(-1);
        if (day > (record.samples.isEmpty() ? -1 : record.samples.last().day) && bytesOfDay >= 0)
            record.samples.append({day, bytesOfDay});
    }
    return record;
}

tl::expected<void, FileError> writeSystemRecord(const QString& folder, const SystemRecord& record)
{
    QJsonObject software;
    for (auto version = record.software.begin(); version != record.software.end(); ++version)
        software[version.key()] = version.value();
    QJsonArray samples;
    for (const DiskSample& sample : record.samples)
        samples.append(QJsonArray{sample.day, sample.bytes});
    return replaceBytes(
        recordPath(folder),
        QJsonDocument(QJsonObject{{u"software"_s, software}, {u"data_bytes_by_day"_s, samples}}).toJson());
}

void addSample(SystemRecord& record, qint64 day, qint64 bytes)
{
    record.samples.removeIf(
        [day](const DiskSample& sample) { return sample.day >= day || sample.day < day - sampledDays; });
    record.samples.append({day, bytes});
}

qint64 sizeOfFolder(const QString& folder)
{
    qint64 bytes = 0;
    QDirIterator files(folder, QDir::Files | QDir::Hidden | QDir::NoSymLinks, QDirIterator::Subdirectories);
    while (files.hasNext())
        bytes += QFileInfo(files.next()).size();
    return bytes;
}

DiskForecast forecastOf(const SystemRecord& record, qint64 freeBytes)
{
    DiskForecast forecast;
    forecast.freeBytes = freeBytes;
    if (record.samples.isEmpty())
        return forecast;
    const DiskSample& first = record.samples.first();
    const DiskSample& last = record.samples.last();
    forecast.days = last.day - first.day;
    if (forecast.days < minMeasuredDays)
        return forecast;
    forecast.bytesPerDay = double(last.bytes - first.bytes) / double(forecast.days);
    if (*forecast.bytesPerDay > 0)
        forecast.years = double(freeBytes) / *forecast.bytesPerDay / daysPerYear;
    return forecast;
}

} // namespace campanel::store
