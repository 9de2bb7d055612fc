// SPDX-License-Identifier: Apache-2.0
// The real campanel-controller as a child process with line faults that change while it runs. A separate
// thread adds time stamps to its answers and events, so that their times are known to the millisecond.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <string>
#include <sys/types.h>
#include <thread>
#include <vector>

namespace campanel::soak {

using Clock = std::chrono::steady_clock;

class FaultyController {
public:
    // Starts it with an empty flash in `folder`, which must not be shared. Throws std::runtime_error when it
    // cannot be started; it serves once it has received rules.
    FaultyController(const std::filesystem::path& folder, bool paced, std::uint32_t baud);
    ~FaultyController();
    FaultyController(const FaultyController&) = delete;
    FaultyController& operator=(const FaultyController&) = delete;

    // Returns a time before its first power-up.
    [[nodiscard]] Clock::time_point started() const { return m_started; }
    // Return the possible paths of the port; a fault may bring it back under the second name.
    [[nodiscard]] std::string port() const { return (m_folder / "port").string(); }
    [[nodiscard]] std::string otherPort() const { return (m_folder / "other-port").string(); }
    // Returns the existing one of both; the first when neither exists.
    [[nodiscard]] std::string portNow() const;

    // Replaces the rules. Returns how many faults the earlier ones have applied; throws when the controller
    // refuses the line.
    std::uint64_t setFaults(const std::string& rules);

    // The events up to now; the pipe is empty afterwards.
    struct Events {
        int restarts = 0;
        int plugs = 0;
        Clock::time_point lastRestart;
        Clock::time_point lastPlug;
    };
    [[nodiscard]] Events events();

private:
    void readLines();
    void takeLine(const std::string& line);

    Clock::time_point m_started = Clock::now();
    std::filesystem::path m_folder;
    pid_t m_process = -1;
    int m_input = -1;
    int m_output = -1;
    std::mutex m_mutex; // guards the members below up to the thread
    std::string m_begun;
    Events m_events;
    std::vector<std::string> m_answers;
    std::thread m_reader;
};

} // namespace campanel::soak
