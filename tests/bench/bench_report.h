// SPDX-License-Identifier: Apache-2.0
// The figures of the benchmark, one line each: the measured value, its limit or peer, and their ratio.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace campanel::bench {

// A figure. The ratio is always measured / limit; `atMost` says if 1 is its upper or its lower limit.
struct Figure {
    std::string what;
    double measured = 0;
    double limit = 0;
    std::string unit;
    std::string limitText; // meaning of the limit: "a frame", "wire's limit", "an empty window"
    bool atMost = true;
    bool isPeer = false; // `limit` is another implementation's result under the same conditions, not a
                         // requirement

    [[nodiscard]] double ratio() const { return measured / limit; }
    [[nodiscard]] bool holds() const { return atMost ? ratio() <= 1.0 : ratio() >= 1.0; }
};

using Figures = std::vector<Figure>;

// The time during which status exchanges are counted.
inline constexpr std::chrono::seconds statusTime{5};

// The parts. Each returns its figures, or throws std::runtime_error when a measurement was impossible.
[[nodiscard]] Figures measureMotion();
[[nodiscard]] Figures measurePrograms();
[[nodiscard]] Figures measurePacking();
[[nodiscard]] Figures measurePlots();
[[nodiscard]] Figures measureLink();
[[nodiscard]] Figures measurePeers();
[[nodiscard]] Figures measureStart();
[[nodiscard]] Figures measureIdle(); // takes two minutes
[[nodiscard]] Figures measureMemory(); // takes some minutes
[[nodiscard]] Figures measureRecords();

// Returns the memory of a process; throws std::runtime_error when the process does not exist.
[[nodiscard]] double residentMb(std::int64_t processId);

// Returns the value below which `fraction` of the samples lie.
[[nodiscard]] double quantile(std::vector<double> samples, double fraction);

// Returns a Markdown table with the processor's name and the commit of the sources above it.
[[nodiscard]] std::string format(const Figures& figures);
// Replaces the table in a Markdown file, between the comments "campanel-bench: begin" and "end". Throws
// std::runtime_error when the file has none or cannot be written.
void replaceTable(const std::string& path, const std::string& table);
// Returns the figures that miss their limit, but for those whose name begins with one of `named`: known
// misses, with their reason in docs/figures.md.
[[nodiscard]] Figures missed(const Figures& figures, const std::vector<std::string>& named);

} // namespace campanel::bench
