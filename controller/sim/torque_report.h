// SPDX-License-Identifier: Apache-2.0
// A drive reports its torque late, now and then, and not exactly.
#pragma once

#include <cstdint>
#include <random>

namespace campanel::controller {

struct ReportOptions {
    double everyMs = 0.0;      // the torque of one report ago; 0: at once
    double stepPercent = 0.1;  // resolution, of the rated torque
    double noisePercent = 0.0; // standard deviation
};

class TorqueReport {
public:
    TorqueReport(const ReportOptions& options, std::uint64_t seed);

    // Moves on by a step with this torque, in percent of the rated one.
    void advance(double stepS, double percent);
    // Returns the torque of the last report.
    [[nodiscard]] double percent() const { return m_percent; }

private:
    ReportOptions m_options;
    std::mt19937_64 m_random;
    double m_sinceS = 0.0;
    double m_taken = 0.0; // to be reported next
    double m_percent = 0.0;
};

} // namespace campanel::controller
