// SPDX-License-Identifier: Apache-2.0
// campanel-generate-metrics: prints docs/metrics.md.
#include "app/plant/metric_document.h"

#include <iostream>

int main()
{
    std::cout << campanel::plant::metricsMarkdown();
    return std::cout.flush() ? 0 : 1;
}
