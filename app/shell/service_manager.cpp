// SPDX-License-Identifier: Apache-2.0
#include "app/shell/service_manager.h"

#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace campanel::shell {
namespace {

std::string takeVariable(const char* name)
{
    const char* value = std::getenv(name);
    std::string taken = value ? value : "";
    ::unsetenv(name);
    return taken;
}

std::optional<long long> numberFrom(const std::string& text)
{
    long long number = 0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number);
    if (parsed.ec != std::errc() || parsed.ptr != text.data() + text.size())
        return std::nullopt;
    return number;
}

} // namespace

ServiceManager::ServiceManager()
    : m_address(takeVariable("NOTIFY_SOCKET"))
{
    const auto period = numberFrom(takeVariable("WATCHDOG_USEC"));
    const std::string whom = takeVariable("WATCHDOG_PID");
    const bool isForUs = whom.empty() || numberFrom(whom) == ::getpid();
    if (period && *period > 0 && isForUs)
        m_watchdogPeriod = std::chrono::microseconds(*period);
}

void ServiceManager::notify(std::string_view state) const
{
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (m_address.empty() || m_address.size() >= sizeof(address.sun_path))
        return;
    std::memcpy(address.sun_path, m_address.data(), m_address.size());
    if (address.sun_path[0] == '@')
        address.sun_path[0] = '\0';
    const int socket = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (socket < 0)
        return;
    const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + m_address.size());
    // Does not wait: a service manager that does not read must not block the panel.
    (void)::sendto(socket, state.data(), state.size(), MSG_NOSIGNAL | MSG_DONTWAIT,
                   reinterpret_cast<const sockaddr*>(&address), length);
    ::close(socket);
}

} // namespace campanel::shell
