// SPDX-License-Identifier: Apache-2.0
// Prints the commissioning report as a PDF: A4, texts with embedded fonts, curves as vector lines.
#pragma once

#include "app/panel/reports/commissioning.h"
#include "app/report/report_colors.h"

namespace campanel::report {

// Returns the PDF. Call it in the GUI thread: a Qt Quick item paints the curves.
[[nodiscard]] QByteArray commissioningPdf(const panel::ReportData& data, const ReportColors& colors);

} // namespace campanel::report
