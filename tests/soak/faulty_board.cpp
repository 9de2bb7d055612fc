// SPDX-License-Identifier: Apache-2.0
// campanel-faulty-board: the faults of the line, as campanel-controller makes them, in front of the ARM7
// firmware in QEMU. Takes the options and the control lines that campanel-soak gives to campanel-controller;
// the environment variable CAMPANEL_BOARD names run-in-qemu.
#include "control_input.h"
#include "faulty_line.h"
#include "options.h"
#include "served_port.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <string>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

using namespace campanel::controller;

namespace {

constexpr std::int64_t longestSleepNs = 20'000'000;

volatile std::sig_atomic_t stopRequested = 0;

std::int64_t monotonicNs()
{
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return static_cast<std::int64_t>(time.tv_sec) * nsPerS + time.tv_nsec;
}

// The firmware in QEMU, and its serial port. It keeps its flash over a restart.
class Board {
public:
    explicit Board(std::string state)
        : m_state(std::move(state))
    {
        start();
    }
    Board(const Board&) = delete;
    Board& operator=(const Board&) = delete;
    ~Board() { stop(); }

    void restart()
    {
        stop();
        start();
    }
    [[nodiscard]] int descriptor() const { return m_port; }
    void write(std::span<const std::uint8_t> bytes) const
    {
        if (::write(m_port, bytes.data(), bytes.size()) < 0)
            std::perror("campanel-faulty-board: the firmware's port");
    }
    // Returns what the firmware has sent.
    [[nodiscard]] FrameBytes read() const
    {
        std::array<std::uint8_t, 512> bytes{};
        const ssize_t size = ::read(m_port, bytes.data(), bytes.size());
        return {bytes.begin(), bytes.begin() + std::max<ssize_t>(size, 0)};
    }

private:
    void start()
    {
        const char* program = std::getenv("CAMPANEL_BOARD");
        std::array<int, 2> output{};
        if (program == nullptr || pipe2(output.data(), O_CLOEXEC) != 0)
            std::exit(1);
        std::array<std::string, 4> words{program, "--exit-with-parent", "--state", m_state};
        std::array<char*, 5> arguments{words[0].data(), words[1].data(), words[2].data(), words[3].data(),
                                       nullptr};
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, output[1], STDOUT_FILENO);
        const int failed = posix_spawn(&m_process, program, &actions, nullptr, arguments.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        close(output[1]);
        std::string path;
        for (char letter = 0; ::read(output[0], &letter, 1) == 1 && letter != '\n';)
            path += letter;
        close(output[0]);
        m_port = open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
        if (failed != 0 || m_port < 0) {
            std::fprintf(stderr, "campanel-faulty-board: %s does not run\n", program);
            std::exit(1);
        }
    }
    void stop()
    {
        close(m_port);
        kill(m_process, SIGTERM);
        waitpid(m_process, nullptr, 0);
    }

    std::string m_state;
    pid_t m_process = 0;
    int m_port = -1;
};

class Relay {
public:
    explicit Relay(const Options& options)
        : m_port(options.link)
        , m_line(options.line, options.faults, monotonicNs())
        , m_control(options.control ? STDIN_FILENO : -1)
        , m_board(options.stateDirectory.string())
    {
        if (const auto plugged = m_port.plug(); !plugged) {
            std::fprintf(stderr, "campanel-faulty-board: %s\n", plugged.error().c_str());
            std::exit(1);
        }
        say(m_port.path());
    }

    void run()
    {
        while (stopRequested == 0) {
            moveBytes(monotonicNs());
            wait();
        }
    }

private:
    static void say(const std::string& line)
    {
        std::printf("%s\n", line.c_str());
        std::fflush(stdout);
    }

    void moveBytes(std::int64_t nowNs)
    {
        while (const auto event = m_line.takeEvent(nowNs))
            act(*event);
        while (const auto arrival = m_line.takeArrival(nowNs)) {
            m_frame = arrival->frame;
            m_board.write(arrival->bytes);
        }
        const auto forPanel = m_line.takeForPanel(nowNs);
        if (!forPanel.empty())
            m_port.write(forPanel);
    }

    void act(const LineEvent& event)
    {
        switch (event.kind) {
        case LineEvent::Kind::Unplug:
            m_port.unplug();
            say("unplugged");
            return;
        case LineEvent::Kind::Plug:
            static_cast<void>(m_port.plug(event.port));
            say("port " + m_port.path());
            return;
        case LineEvent::Kind::Restart:
            m_answer.clear();
            m_board.restart();
            dropFromPanel(); // nobody heard it
            say("restarted");
            return;
        }
    }

    // Reads and drops what the panel has sent up to now.
    void dropFromPanel()
    {
        std::array<std::uint8_t, 512> bytes{};
        while (m_port.read(bytes) > 0) {
        }
    }

    // Hands on whole answers, as the simulated controller gives them.
    void takeAnswer()
    {
        const FrameBytes bytes = m_board.read();
        m_answer.insert(m_answer.end(), bytes.begin(), bytes.end());
        for (std::size_t size = answerBytes(); size != 0 && m_answer.size() >= size; size = answerBytes()) {
            m_line.fromController({m_answer.data(), size}, m_frame, monotonicNs());
            m_answer.erase(m_answer.begin(), m_answer.begin() + static_cast<std::ptrdiff_t>(size));
        }
    }

    [[nodiscard]] std::size_t answerBytes() const
    {
        if (m_answer.size() < 3)
            return 0;
        if ((m_answer[1] & 0x80u) != 0)
            return 5;
        const bool isRead = m_answer[1] == 3 || m_answer[1] == 23;
        return isRead ? 5u + m_answer[2] : 8u;
    }

    void takeControlLine(std::string_view text)
    {
        const auto script = parseFaultScript(text, m_line.script());
        if (!script) {
            say("error " + script.error());
            return;
        }
        const std::uint64_t applied = m_line.applied();
        m_line.setScript(*script, monotonicNs());
        say("ok " + std::to_string(applied));
    }

    void wait()
    {
        const std::int64_t nowNs = monotonicNs();
        const std::int64_t untilNs =
            std::min(nowNs + longestSleepNs, m_line.nextEventNs().value_or(INT64_MAX));
        const timespec timeout{0, static_cast<long>(std::max<std::int64_t>(0, untilNs - nowNs))};
        std::array<pollfd, 4> descriptors{{{m_port.descriptor(), POLLIN, 0},
                                           {m_port.closeWatch(), POLLIN, 0},
                                           {m_control.descriptor(), POLLIN, 0},
                                           {m_board.descriptor(), POLLIN, 0}}};
        if (ppoll(descriptors.data(), descriptors.size(), &timeout, nullptr) <= 0)
            return;
        if ((descriptors[3].revents & POLLIN) != 0)
            takeAnswer();
        if ((descriptors[1].revents & POLLIN) != 0)
            m_port.afterClose();
        if ((descriptors[0].revents & POLLIN) != 0) {
            std::array<std::uint8_t, 512> bytes{};
            const std::size_t size = m_port.read(bytes);
            if (size > 0)
                m_line.fromPanel({bytes.data(), size}, monotonicNs());
        }
        if (descriptors[2].revents != 0)
            m_control.read([this](std::string_view line) { takeControlLine(line); });
    }

    ServedPort m_port;
    FaultyLine m_line;
    ControlInput m_control;
    Board m_board;
    std::uint64_t m_frame = 0; // frame of the last bytes
    FrameBytes m_answer;       // incomplete
};

} // namespace

int main(int argc, char** argv)
{
    const auto options = parseOptions(argc, argv);
    if (!options) {
        std::fputs(options.error().text.c_str(), stderr);
        return options.error().exitCode;
    }
    struct sigaction action {};
    action.sa_handler = [](int) { stopRequested = 1; };
    for (const int number : {SIGTERM, SIGINT, SIGHUP})
        sigaction(number, &action, nullptr);
    const pid_t parent = getppid();
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (options->exitWithParent && getppid() != parent)
        return 0;
    Relay(*options).run();
    return 0;
}
