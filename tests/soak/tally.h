// SPDX-License-Identifier: Apache-2.0
// What the soak counts, and the watch over calls that do not return.
#pragma once

#include "tests/soak/faulty_controller.h"

#include <atomic>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace campanel::soak {

struct Tally {
    std::uint64_t exchanges = 0; // questions of the master, not its client's own repetitions
    std::uint64_t faults = 0;    // applied by the line
    std::uint64_t believed = 0;
    std::uint64_t wrong = 0;    // believed, and not so
    std::uint64_t repeated = 0; // commands carried out more often than they were given
    std::uint64_t mixed = 0;    // tables that are none of those sent
    std::uint64_t hangs = 0;    // calls beyond their bound, and controllers that were not found again in time
    std::map<std::string, std::uint64_t> errors; // by kind
    std::map<std::string, std::uint64_t> work;   // commands and downloads by outcome
    std::vector<double> replugMs;                // the port's return to the first good status
    std::vector<double> restartMs;               // the controller's return to that
    double longestCallMs = 0;
    std::vector<std::string> findings; // the first few violations in words

    void find(std::uint64_t& counter, const std::string& sentence)
    {
        constexpr std::size_t most = 5;
        ++counter;
        if (findings.size() < most)
            findings.push_back(sentence);
    }
    void add(const Tally& other);
};

// One for each thread that asks: what it is doing, and since when.
class Watch {
public:
    void begin(const char* what)
    {
        m_what = what;
        m_since = Clock::now().time_since_epoch().count();
    }
    void end() { m_since = 0; }
    [[nodiscard]] const char* what() const { return m_what; }
    // Zero while nothing is under way.
    [[nodiscard]] double seconds() const
    {
        const auto since = m_since.load();
        return since == 0
                   ? 0.0
                   : std::chrono::duration<double>(Clock::now().time_since_epoch() - Clock::duration(since))
                         .count();
    }

private:
    std::atomic<Clock::rep> m_since{0};
    std::atomic<const char*> m_what{""};
};

} // namespace campanel::soak
