// SPDX-License-Identifier: Apache-2.0
// The counters of the soak test, and the watch over calls that do not return.
#pragma once

#include "tests/soak/faulty_controller.h"

#include <atomic>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace campanel::soak {

struct Tally {
    std::uint64_t exchanges = 0; // questions of the master, without its client's repetitions
    std::uint64_t faults = 0;    // applied by the line
    std::uint64_t believed = 0;
    std::uint64_t wrong = 0;    // accepted, but wrong
    std::uint64_t repeated = 0; // commands executed more often than they were sent
    std::uint64_t mixed = 0;    // tables other than those sent
    std::uint64_t hangs = 0;    // calls beyond their limit, and controllers that were not found again in time
    std::map<std::string, std::uint64_t> errors; // by kind
    std::map<std::string, std::uint64_t> work;   // commands and downloads by outcome
    std::vector<double> replugMs;                // from the port's return to the first good status
    std::vector<double> restartMs;               // from the controller's return to the first good status
    double longestCallMs = 0;
    std::vector<std::string> findings; // the first few violations as text

    void find(std::uint64_t& counter, const std::string& sentence)
    {
        constexpr std::size_t most = 5;
        ++counter;
        if (findings.size() < most)
            findings.push_back(sentence);
    }
    void add(const Tally& other);
};

// The present action of one asking thread, and its start.
class Watch {
public:
    void begin(const char* what)
    {
        m_what = what;
        m_since = Clock::now().time_since_epoch().count();
    }
    void end() { m_since = 0; }
    [[nodiscard]] const char* what() const { return m_what; }
    // Returns zero while no action is in progress.
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
