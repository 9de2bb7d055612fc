// SPDX-License-Identifier: Apache-2.0
#include "pseudo_terminal.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/inotify.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>
#include <utility>

namespace campanel::controller {
namespace {

tl::unexpected<std::string> failure(const char* what)
{
    const char* reason = std::strerror(errno); // before another call sets errno
    return tl::unexpected(std::string(what) + ": " + reason);
}

bool makeRaw(int descriptor)
{
    termios settings{};
    if (tcgetattr(descriptor, &settings) != 0)
        return false;
    cfmakeraw(&settings);
    return tcsetattr(descriptor, TCSANOW, &settings) == 0;
}

} // namespace

tl::expected<PseudoTerminal, std::string> PseudoTerminal::open()
{
    PseudoTerminal terminal;
    terminal.m_master = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
    if (terminal.m_master < 0 || grantpt(terminal.m_master) != 0 || unlockpt(terminal.m_master) != 0)
        return failure("cannot open a pseudo-terminal");
    std::array<char, 128> name{};
    if (ptsname_r(terminal.m_master, name.data(), name.size()) != 0)
        return failure("cannot name the pseudo-terminal");
    terminal.m_path = name.data();
    terminal.m_slave = ::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (terminal.m_slave < 0 || !makeRaw(terminal.m_slave))
        return failure("cannot set up the pseudo-terminal");
    terminal.m_watch = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    if (terminal.m_watch < 0 || inotify_add_watch(terminal.m_watch, name.data(), IN_CLOSE) < 0)
        return failure("cannot watch the pseudo-terminal");
    return terminal;
}

PseudoTerminal::PseudoTerminal(PseudoTerminal&& other) noexcept
    : m_master(std::exchange(other.m_master, -1))
    , m_slave(std::exchange(other.m_slave, -1))
    , m_watch(std::exchange(other.m_watch, -1))
    , m_path(std::move(other.m_path))
{
}

PseudoTerminal::~PseudoTerminal()
{
    for (const int descriptor : {m_watch, m_slave, m_master}) {
        if (descriptor >= 0)
            close(descriptor);
    }
}

std::size_t PseudoTerminal::read(std::span<std::uint8_t> bytes)
{
    const ssize_t size = ::read(m_master, bytes.data(), bytes.size());
    return size > 0 ? static_cast<std::size_t>(size) : 0;
}

void PseudoTerminal::write(std::span<const std::uint8_t> bytes)
{
    while (!bytes.empty()) {
        const ssize_t size = ::write(m_master, bytes.data(), bytes.size());
        if (size <= 0 && errno != EINTR)
            return;
        bytes = bytes.subspan(size > 0 ? static_cast<std::size_t>(size) : 0);
    }
}

void PseudoTerminal::afterClose()
{
    std::array<std::uint8_t, 4096> events{};
    while (::read(m_watch, events.data(), events.size()) > 0) {
    }
    ioctl(m_slave, TIOCNXCL);
    makeRaw(m_slave);
}

} // namespace campanel::controller
