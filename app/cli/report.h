// SPDX-License-Identifier: Apache-2.0
// Results as text: JSON with stable keys, and the same object as lines for people or as key,value CSV.
#pragma once

#include <QByteArray>
#include <QJsonObject>

#include <optional>
#include <string_view>
#include <vector>

namespace campanel::cli {

// A number in CSV: up to 10 significant digits, point as decimal mark.
[[nodiscard]] QByteArray number(double value);

// null when unknown.
[[nodiscard]] QJsonValue orNull(const std::optional<double>& value);

struct Column {
    const char* name = "";
    const std::vector<double>* values = nullptr; // all columns of one table are equally long
};

[[nodiscard]] QByteArray csvTable(const std::vector<Column>& columns);

// "json": the object. "csv": key,value with keys joined by points. "text": the same, aligned; lists of
// numbers are left out, null is "--".
[[nodiscard]] QByteArray formatted(const QJsonObject& object, const QString& format);

[[nodiscard]] QString fromView(std::string_view text);

} // namespace campanel::cli
