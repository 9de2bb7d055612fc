// SPDX-License-Identifier: Apache-2.0
// docs/metrics.md, written from the metric table.
#pragma once

#include <string>

namespace campanel::plant {

[[nodiscard]] std::string metricsMarkdown();

} // namespace campanel::plant
