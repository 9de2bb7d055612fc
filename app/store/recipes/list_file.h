// SPDX-License-Identifier: Apache-2.0
// The list of a cam, knots or segments, as a CSV file: reads, writes, and lists the files at the exchange
// places. All functions wait for the disk.
#pragma once

#include "app/store/files/csv.h"
#include "app/store/files/exchange_places.h"
#include "app/store/files/file_error.h"
#include "profile/model/refusal.h"
#include "profile/program/programs.h"

#include <QDateTime>

#include <tl/expected.hpp>

#include <optional>

namespace campanel::store {

// Reads the list of a cam into the program, which is unchanged after an error. Errors are whole sentences in
// the language of the program, with file and line.
[[nodiscard]] tl::expected<void, QString> readListCsv(const QString& path, profile::Program& program);
[[nodiscard]] tl::expected<void, QString> writeListCsv(const profile::Program& program, const QString& path);

// A file with its contents, for a preview before the import.
struct ListOffer {
    QString path;
    QString placeName;
    QDateTime changed;
    profile::Program program; // with the list of the file
    QString problem;          // the reason why it cannot be read; a whole sentence
    // The reason why its list is not a valid cam, and the line, from 1, of the wrong entry.
    std::optional<profile::Refusal> refusal;
    int refusedLine = 0;
    bool isNotice = false; // `problem` tells which files of the place `path` are missing

    [[nodiscard]] bool isUsable() const { return problem.isEmpty() && !refusal; }
};

// Returns the CSV files of the places, newest first, each as the list of this cam.
[[nodiscard]] QList<ListOffer> offeredLists(const QList<Place>& places, const profile::Program& cam);

// Writes a new file named after the recipe; no file is ever replaced. Returns the path, or a sentence as
// error.
[[nodiscard]] tl::expected<QString, QString> exportList(const profile::Program& cam,
                                                        const QString& recipeName, const Place& place,
                                                        const CsvDialect& dialect = {});

// Returns the path that exportList() will use.
[[nodiscard]] QString exportPath(const QString& recipeName, const Place& place);

} // namespace campanel::store
