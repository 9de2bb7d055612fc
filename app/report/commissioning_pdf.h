// SPDX-License-Identifier: Apache-2.0
// The commissioning report as a PDF: A4, texts with their fonts embedded, curves as lines.
#pragma once

#include "app/panel/reports/commissioning.h"

namespace campanel::report {

// GUI thread: the curves are painted by an item of Qt Quick.
[[nodiscard]] QByteArray commissioningPdf(const machine::ReportData& data);

} // namespace campanel::report
