// SPDX-License-Identifier: Apache-2.0
#include "control_input.h"

#include <array>
#include <cerrno>
#include <unistd.h>

namespace campanel::controller {

void ControlInput::read(const std::function<void(std::string_view)>& take)
{
    std::array<char, 4096> bytes{};
    const ssize_t size = ::read(m_descriptor, bytes.data(), bytes.size());
    if (size == 0 || (size < 0 && errno != EINTR && errno != EAGAIN)) {
        m_descriptor = -1;
        return;
    }
    m_begun.append(bytes.data(), size > 0 ? static_cast<std::size_t>(size) : 0);
    for (std::size_t end = m_begun.find('\n'); end != std::string::npos; end = m_begun.find('\n')) {
        take(std::string_view(m_begun).substr(0, end));
        m_begun.erase(0, end + 1);
    }
}

} // namespace campanel::controller
