// SPDX-License-Identifier: Apache-2.0
#include "faulty_controller.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace campanel::soak {
namespace {

constexpr auto answerTime = std::chrono::seconds{60};

// Returns the program behind the line; the environment may name another one.
std::string programName()
{
    const char* other = std::getenv("CAMPANEL_CONTROLLER");
    return other != nullptr ? other : CAMPANEL_CONTROLLER;
}

// Creates a pipe with close-on-exec ends, so that a controller does not keep those of another open.
std::array<int, 2> makePipe()
{
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        throw std::runtime_error("no pipe");
    return ends;
}

} // namespace

FaultyController::FaultyController(const std::filesystem::path& folder, bool paced, std::uint32_t baud)
    : m_folder(folder)
{
    const std::string program = programName();
    std::vector<std::string> words{program,          "--control", "--exit-with-parent",
                                   "--link",         port(),      "--state",
                                   folder / "state", "--baud",    std::to_string(baud)};
    if (!paced)
        words.emplace_back("--no-pacing");
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);

    const auto input = makePipe();
    const auto output = makePipe();
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output[1], STDOUT_FILENO);
    const int failed = posix_spawn(&m_process, program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(input[0]);
    close(output[1]);
    m_input = input[1];
    m_output = output[0];
    fcntl(m_output, F_SETFL, O_NONBLOCK);
    if (failed != 0)
        throw std::runtime_error("cannot start " + program);
    m_reader = std::thread([this] { readLines(); });
}

FaultyController::~FaultyController()
{
    kill(m_process, SIGTERM);
    waitpid(m_process, nullptr, 0);
    m_reader.join(); // its pipe has ended
    close(m_input);
    close(m_output);
}

std::string FaultyController::portNow() const
{
    return std::filesystem::exists(otherPort()) ? otherPort() : port();
}

void FaultyController::takeLine(const std::string& line)
{
    if (line.starts_with("ok ") || line.starts_with("error ")) {
        m_answers.push_back(line);
    } else if (line == "restarted") {
        ++m_events.restarts;
        m_events.lastRestart = Clock::now();
    } else if (line.starts_with("port ")) {
        ++m_events.plugs;
        m_events.lastPlug = Clock::now();
    }
}

FaultyController::Events FaultyController::events()
{
    const std::lock_guard lock(m_mutex);
    std::array<char, 4096> bytes{};
    for (ssize_t size = 0; (size = read(m_output, bytes.data(), bytes.size())) > 0;) {
        m_begun.append(bytes.data(), static_cast<std::size_t>(size));
        for (std::size_t end = 0; (end = m_begun.find('\n')) != std::string::npos;) {
            takeLine(m_begun.substr(0, end));
            m_begun.erase(0, end + 1);
        }
    }
    return m_events;
}

void FaultyController::readLines()
{
    for (;;) {
        pollfd waiting{m_output, POLLIN, 0};
        if (poll(&waiting, 1, -1) < 0 && errno != EINTR)
            return;
        static_cast<void>(events());
        if ((waiting.revents & POLLHUP) != 0)
            return;
    }
}

std::uint64_t FaultyController::setFaults(const std::string& rules)
{
    const std::string line = rules + "\n";
    if (write(m_input, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
        throw std::runtime_error("campanel-controller has ended");
    const auto deadline = Clock::now() + answerTime;
    while (Clock::now() < deadline) {
        static_cast<void>(events());
        const std::lock_guard lock(m_mutex);
        if (m_answers.empty()) {
            pollfd waiting{m_output, POLLIN, 0};
            poll(&waiting, 1, 1);
            continue;
        }
        const std::string answer = m_answers.front();
        m_answers.clear();
        if (!answer.starts_with("ok "))
            throw std::runtime_error(answer + " in: " + rules);
        return std::stoull(answer.substr(3));
    }
    throw std::runtime_error("campanel-controller does not take rules");
}

} // namespace campanel::soak
