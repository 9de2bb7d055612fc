// SPDX-License-Identifier: Apache-2.0
#include "report.h"

#include <algorithm>
#include <cstdio>

namespace campanel::soak {
namespace {

unsigned long long wide(std::uint64_t value)
{
    return value;
}

void printRow(const char* name, const Tally& panel, const std::array<Tally, 2>& plain)
{
    std::printf("%-28s %8llu %7llu %9llu %6llu %6llu %6llu %6llu %8.0f", name, wide(panel.exchanges),
                wide(panel.faults), wide(panel.believed), wide(panel.wrong), wide(panel.repeated),
                wide(panel.mixed), wide(panel.hangs), panel.longestCallMs);
    for (const Tally& tally : plain)
        std::printf("  %6llu of %7llu", wide(tally.wrong), wide(tally.believed));
    std::printf("\n");
}

void printCounts(const char* what, const std::map<std::string, std::uint64_t>& counts)
{
    std::printf("\n%s\n", what);
    for (const auto& [name, count] : counts)
        std::printf("  %8llu %s\n", wide(count), name.c_str());
}

void printTimes(const char* what, std::vector<double> times)
{
    if (times.empty())
        return;
    std::ranges::sort(times);
    std::printf("%s: %zu times, median %.0f ms, longest %.0f ms\n", what, times.size(),
                times[times.size() / 2], times.back());
}

} // namespace

bool report(const Results& results)
{
    std::printf("%-28s %8s %7s %9s %6s %6s %6s %6s %8s  %17s  %17s\n", "", "", "", "", "wrong", "comm.",
                "mixed", "", "longest", "libmodbus NONE", "PROTOCOL");
    std::printf("%-28s %8s %7s %9s %6s %6s %6s %6s %8s  %17s  %17s\n", "fault", "exchang.", "faults",
                "believed", "values", "repea.", "tables", "hangs", "call ms", "wrong of believed",
                "wrong of believed");
    ClassResult all;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const ClassResult& result = results[i];
        if (result.panel.exchanges == 0 && result.panel.findings.empty())
            continue; // not chosen
        printRow(std::string(faultClasses[i].name).c_str(), result.panel, result.plain);
        all.panel.add(result.panel);
        for (std::size_t mode = 0; mode < all.plain.size(); ++mode)
            all.plain[mode].add(result.plain[mode]);
    }
    printRow("all", all.panel, all.plain);
    printCounts("errors told by the panel's client", all.panel.errors);
    printCounts("commands and downloads", all.panel.work);
    std::printf("\n");
    printTimes("port's return to the first good status", all.panel.replugMs);
    printTimes("controller's return to the first good status", all.panel.restartMs);
    for (std::size_t i = 0; i < results.size(); ++i) {
        for (const std::string& finding : results[i].panel.findings)
            std::printf("VIOLATION in '%s': %s\n", std::string(faultClasses[i].name).c_str(),
                        finding.c_str());
    }
    const Tally& panel = all.panel;
    std::printf(
        "soak: %llu exchanges, %llu faults: %llu wrong values, %llu repeated commands, %llu mixed tables, "
        "%llu hangs\n",
        wide(panel.exchanges), wide(panel.faults), wide(panel.wrong), wide(panel.repeated), wide(panel.mixed),
        wide(panel.hangs));
    return panel.wrong + panel.repeated + panel.mixed + panel.hangs == 0;
}

} // namespace campanel::soak
