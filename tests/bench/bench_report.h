// SPDX-License-Identifier: Apache-2.0
// One line per figure: what was measured, against which limit or peer, and their ratio.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace campanel::bench {

// A ratio is always measured / limit; `atMost` says whether 1 is its upper or its lower end.
struct Figure {
    std::string what;
    double measured = 0;
    double limit = 0;
    std::string unit;
    std::string limitText; // what the limit is: "a frame", "wire's limit", "an empty window"
    bool atMost = true;
    bool isPeer = false; // `limit` is what another one does under the same conditions, nothing to be kept

    [[nodiscard]] double ratio() const { return measured / limit; }
    [[nodiscard]] bool holds() const { return atMost ? ratio() <= 1.0 : ratio() >= 1.0; }
};

using Figures = std::vector<Figure>;

// So long status exchanges are counted.
inline constexpr std::chrono::seconds statusTime{5};

// The parts; each returns its figures, or throws std::runtime_error when something could not be measured at
// all.
[[nodiscard]] Figures measureMotion();
[[nodiscard]] Figures measurePrograms();
[[nodiscard]] Figures measurePacking();
[[nodiscard]] Figures measurePlots();
[[nodiscard]] Figures measureLink();
[[nodiscard]] Figures measurePeers();
[[nodiscard]] Figures measureStart();
[[nodiscard]] Figures measureMemory(); // takes some minutes
[[nodiscard]] Figures measureRecords();

// Memory of a process; throws std::runtime_error when there is no such process.
[[nodiscard]] double residentMb(std::int64_t processId);

// The value below which `fraction` of the samples lie.
[[nodiscard]] double quantile(std::vector<double> samples, double fraction);

// Markdown table with the processor's name above it.
[[nodiscard]] std::string format(const Figures& figures);

} // namespace campanel::bench
