// SPDX-License-Identifier: Apache-2.0
// Formats results as text: JSON with stable keys, and the same object as lines for people or as key,value
// CSV.
#pragma once

#include "app/store/files/csv.h"
#include "profile/program/programs.h"

#include <QByteArray>
#include <QJsonArray>
#include <QJsonObject>
#include <QMap>
#include <QStringList>

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace campanel::cli {

// Formats a number: up to 10 significant digits, decimal point.
[[nodiscard]] QByteArray number(double value);

[[nodiscard]] QJsonValue orNull(const std::optional<double>& value);

struct Column {
    const char* name = "";
    const std::vector<double>* values = nullptr; // all columns of a table have the same length
};

// Adds one field: unknown is empty, a number has up to 10 significant digits.
void addCell(store::CsvWriter& csv, const QJsonValue& value);

[[nodiscard]] QByteArray csvTable(const std::vector<Column>& columns);

// Makes a text from elsewhere, such as a name, one line: each cell of text goes through it.
[[nodiscard]] QString cellText(const QString& text);

// Formats the object. "json": as it is. "csv": key,value with keys joined by points; null is empty. "text":
// the same, aligned; lists of numbers are omitted, null is "--".
[[nodiscard]] QByteArray formatted(const QJsonObject& object, const QString& format);

// Formats a value as one cell of text; null is "--".
[[nodiscard]] QString cellOf(const QJsonValue& value);
// Formats these keys of the rows below their titles, each column as wide as its longest text.
[[nodiscard]] QByteArray rowsText(const QJsonArray& rows, const QStringList& keys,
                                  const QMap<QString, QString>& titles = {});

// Adds the net advance of a cam per cycle, and whether a person has confirmed it; nothing for other kinds.
void addAdvance(QJsonObject& object, const profile::Program& program);

[[nodiscard]] QString crcText(std::uint32_t crc); // eight hexadecimal digits

[[nodiscard]] QString fromView(std::string_view text);

} // namespace campanel::cli
