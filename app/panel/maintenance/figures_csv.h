// SPDX-License-Identifier: Apache-2.0
// The figures of the line as CSV.
#pragma once

#include "app/link/link.h"
#include "app/store/files/csv.h"

namespace campanel::panel {

// Returns one line "figure,value" for each figure.
[[nodiscard]] QByteArray figuresCsv(const modbus::LinkFigures& figures,
                                    const store::CsvDialect& dialect = {});
// Returns a header and one line for each minute of the strip, in UTC.
[[nodiscard]] QByteArray stripCsv(const modbus::LinkFigures& figures, const store::CsvDialect& dialect = {});

} // namespace campanel::panel
