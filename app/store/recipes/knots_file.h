// SPDX-License-Identifier: Apache-2.0
// The knots of a point cam as a CSV file (format: profile/knots_csv.h): reads, writes, and lists the files at
// the exchange places. All functions wait for the disk.
#pragma once

#include "app/store/files/exchange_places.h"
#include "app/store/files/file_error.h"
#include "profile/model/refusal.h"
#include "profile/program/programs.h"

#include <QDateTime>

#include <tl/expected.hpp>

#include <optional>
#include <span>
#include <vector>

namespace campanel::store {

// Reads the knots. Errors are whole sentences in the language of the program, with file and line.
[[nodiscard]] tl::expected<std::vector<profile::Knot>, QString> readKnots(const QString& path);
[[nodiscard]] tl::expected<void, QString> writeKnots(std::span<const profile::Knot> knots,
                                                     const QString& path);

// A file with its contents, for a preview before the import.
struct KnotsOffer {
    QString path;
    QString placeName;
    QDateTime changed;
    std::vector<profile::Knot> knots; // as read from the file
    QString problem;                  // the reason why it cannot be read; a whole sentence
    // The reason why its knots are not a valid cam, and the line, from 1, of the wrong knot.
    std::optional<profile::Refusal> refusal;
    int refusedLine = 0;

    [[nodiscard]] bool isUsable() const { return problem.isEmpty() && !refusal; }
};

// Returns the CSV files of the places, newest first.
[[nodiscard]] QList<KnotsOffer> offeredKnots(const QList<Place>& places);

// Writes a new file named after the recipe; no file is ever replaced. Returns the path, or a sentence as
// error.
[[nodiscard]] tl::expected<QString, QString> exportKnots(std::span<const profile::Knot> knots,
                                                         const QString& recipeName, const Place& place);

// Returns the path that exportKnots() will use.
[[nodiscard]] QString exportPath(const QString& recipeName, const Place& place);

} // namespace campanel::store
