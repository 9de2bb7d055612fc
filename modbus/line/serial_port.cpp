// SPDX-License-Identifier: Apache-2.0
// Exclusive use: flock() on every port; TIOCEXCL also on real ones. Not on pseudo-terminals: there the flag
// outlives a killed panel as long as the controller keeps its end open, and would exclude the next panel.
#include "modbus/line/serial_port.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <grp.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

namespace campanel::modbus {
namespace {

// Majors of UNIX98 pseudo-terminal slaves (Linux, Documentation/admin-guide/devices.txt).
constexpr unsigned firstPtsMajor = 136;
constexpr unsigned lastPtsMajor = 143;

std::string owningGroup(const struct stat& node)
{
    std::array<char, 4096> buffer{};
    struct group entry {};
    struct group* found = nullptr;
    if (getgrgid_r(node.st_gid, &entry, buffer.data(), buffer.size(), &found) == 0 && found != nullptr)
        return entry.gr_name;
    return std::to_string(node.st_gid);
}

bool isPseudoTerminal(int descriptor)
{
    struct stat node {};
    if (fstat(descriptor, &node) != 0)
        return false;
    const unsigned number = major(node.st_rdev);
    return number >= firstPtsMajor && number <= lastPtsMajor;
}

LinkErrorKind kindOfOpenFailure(int error)
{
    switch (error) {
    case EACCES:
    case EPERM:
        return LinkErrorKind::PortNotPermitted;
    case EBUSY:
        return LinkErrorKind::PortBusy;
    default:
        return LinkErrorKind::PortAbsent;
    }
}

} // namespace

tl::expected<PortClaim, LinkError> PortClaim::take(const std::string& port)
{
    const auto refuse = [&port](LinkErrorKind kind, std::string detail = {}) {
        return tl::unexpected(LinkError{kind, port, {}, std::move(detail), 0});
    };
    struct stat node {};
    if (stat(port.c_str(), &node) != 0)
        return refuse(errno == EACCES ? LinkErrorKind::PortNotPermitted : LinkErrorKind::PortAbsent);
    if (!S_ISCHR(node.st_mode))
        return refuse(LinkErrorKind::PortNotSerial);

    PortClaim claim(open(port.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    const LinkErrorKind failure = kindOfOpenFailure(errno); // before another call sets errno
    if (claim.m_descriptor < 0)
        return refuse(failure, owningGroup(node));
    if (isatty(claim.m_descriptor) == 0)
        return refuse(LinkErrorKind::PortNotSerial);
    // The superuser may open a port in exclusive mode, so the mode is read.
    int excluded = 0;
    const bool taken = !isPseudoTerminal(claim.m_descriptor) &&
                       ioctl(claim.m_descriptor, TIOCGEXCL, &excluded) == 0 && excluded != 0;
    if (taken || flock(claim.m_descriptor, LOCK_EX | LOCK_NB) != 0)
        return refuse(LinkErrorKind::PortBusy);
    return claim;
}

PortClaim::PortClaim(PortClaim&& other) noexcept
    : m_descriptor(std::exchange(other.m_descriptor, -1))
{
}

PortClaim& PortClaim::operator=(PortClaim&& other) noexcept
{
    std::swap(m_descriptor, other.m_descriptor);
    return *this;
}

PortClaim::~PortClaim()
{
    if (m_descriptor >= 0) {
        if (!isPseudoTerminal(m_descriptor))
            ioctl(m_descriptor, TIOCNXCL);
        close(m_descriptor);
    }
}

void PortClaim::excludeOthers() const
{
    if (!isPseudoTerminal(m_descriptor))
        ioctl(m_descriptor, TIOCEXCL);
}

bool hasInput(int descriptor)
{
    struct pollfd watched {
        descriptor, POLLIN, 0
    };
    return poll(&watched, 1, 0) > 0;
}

DrainResult drain(int descriptor, std::chrono::milliseconds quiet, std::chrono::milliseconds longest,
                  const std::function<void(std::span<const std::uint8_t>)>& onDropped)
{
    const auto deadline = std::chrono::steady_clock::now() + longest;
    std::array<std::uint8_t, 512> dropped{};
    while (std::chrono::steady_clock::now() < deadline) {
        struct pollfd watched {
            descriptor, POLLIN, 0
        };
        const int ready = poll(&watched, 1, static_cast<int>(quiet.count()));
        if (ready == 0)
            return DrainResult::Quiet;
        if (ready < 0)
            continue;
        const ssize_t count = read(descriptor, dropped.data(), dropped.size());
        if (count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR))
            return DrainResult::Gone;
        if (count > 0)
            onDropped(std::span(dropped).first(static_cast<std::size_t>(count)));
    }
    return DrainResult::StillBusy;
}

} // namespace campanel::modbus
