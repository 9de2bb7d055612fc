// SPDX-License-Identifier: Apache-2.0
// Knots of a point cam as a CSV file (format: profile/cam/knots_csv.h): read, written, and offered from the
// places where files are exchanged. Everything here waits for the disk.
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

// Errors are whole sentences in the language of the program, with file and line.
[[nodiscard]] tl::expected<std::vector<profile::Knot>, QString> readKnots(const QString& path);
[[nodiscard]] tl::expected<void, QString> writeKnots(std::span<const profile::Knot> knots,
                                                     const QString& path);

// A file that can be looked at before anything is taken from it.
struct KnotsOffer {
    QString path;
    QString placeName;
    QDateTime changed;
    std::vector<profile::Knot> knots; // as they stand in the file
    QString problem;                  // why it cannot be read; a whole sentence
    // Why its knots make no cam, and the line, from 1, of the knot that is wrong.
    std::optional<profile::Refusal> refusal;
    int refusedLine = 0;

    [[nodiscard]] bool isUsable() const { return problem.isEmpty() && !refusal; }
};

// The CSV files of the places, newest first.
[[nodiscard]] QList<KnotsOffer> offeredKnots(const QList<Place>& places);

// Writes a new file under a name made of the recipe's; no file is ever replaced. The path, or a sentence.
[[nodiscard]] tl::expected<QString, QString> exportKnots(std::span<const profile::Knot> knots,
                                                         const QString& recipeName, const Place& place);

// The path that exportKnots() will write to.
[[nodiscard]] QString exportPath(const QString& recipeName, const Place& place);

} // namespace campanel::store
