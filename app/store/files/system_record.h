// SPDX-License-Identifier: Apache-2.0
// The panel's record of its system, the file system.json of its folder: the versions of software
// that ran last, and how its data has grown.
#pragma once

#include "app/store/files/file_error.h"

#include <QList>
#include <QMap>
#include <QString>

#include <optional>

namespace campanel::store {

struct DiskSample {
    qint64 day = 0; // since 1970 UTC
    qint64 bytes = 0;

    bool operator==(const DiskSample&) const = default;
};

struct SystemRecord {
    QMap<QString, QString> software; // by "panel", "gateway", "controller"
    QList<DiskSample> samples;       // one a day, oldest first

    bool operator==(const SystemRecord&) const = default;
};

// The samples of these days are kept.
inline constexpr qint64 sampledDays = 30;

// Reads the record; empty while there is none that can be read.
[[nodiscard]] SystemRecord readSystemRecord(const QString& folder);
[[nodiscard]] tl::expected<void, FileError> writeSystemRecord(const QString& folder,
                                                              const SystemRecord& record);

// Adds the size of a day, or replaces it. Days after it are of another clock and go.
void addSample(SystemRecord& record, qint64 day, qint64 bytes);
// Returns the bytes of all files below the folder.
[[nodiscard]] qint64 sizeOfFolder(const QString& folder);

// How long the disk lasts at the measured growth.
struct DiskForecast {
    // The time for which the changes of people are kept.
    static constexpr double keptYears = 5;

    qint64 freeBytes = 0;
    qint64 days = 0;                   // of the measurement
    std::optional<double> bytesPerDay; // empty: measured for less than two days
    std::optional<double> years;       // empty: not known, or the data does not grow

    [[nodiscard]] bool isShort() const { return years && *years < keptYears; }
};
[[nodiscard]] DiskForecast forecastOf(const SystemRecord& record, qint64 freeBytes);

} // namespace campanel::store
