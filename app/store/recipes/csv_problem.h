// SPDX-License-Identifier: Apache-2.0
// Why a CSV file of a cam cannot be read, in whole sentences. Internal to app/store.
#pragma once

#include "app/store/files/file_error.h"
#include "profile/cam/csv_reader.h"

#include <span>
#include <string_view>

namespace campanel::store {

// Says that the file could not be opened, read or written.
[[nodiscard]] QString csvNotOpened(const FileError& error);
// Names the line, what was expected and what was found; `columns` are those of the header.
[[nodiscard]] QString csvProblem(const profile::CsvError& error, const QString& path,
                                 std::span<const std::string_view> columns);

} // namespace campanel::store
