// SPDX-License-Identifier: Apache-2.0
#include "served_port.h"

#include <cerrno>
#include <cstring>
#include <utility>

namespace campanel::controller {

ServedPort::ServedPort(std::filesystem::path link)
    : m_link(std::move(link))
{
}

ServedPort::~ServedPort()
{
    removeLink();
}

tl::expected<void, std::string> ServedPort::plug(const std::filesystem::path& link)
{
    if (m_terminal)
        return {};
    auto terminal = PseudoTerminal::open();
    if (!terminal)
        return tl::unexpected(terminal.error());
    m_terminal.emplace(std::move(*terminal));
    if (!link.empty())
        m_link = link;
    if (!m_link.empty() && !makeLink())
        return tl::unexpected("cannot make the link " + m_link.string() + ": " + std::strerror(errno) +
                              "; name a place that is free and writable");
    return {};
}

void ServedPort::unplug()
{
    removeLink();
    m_terminal.reset();
}

// Creates the link; replaces an old link, never a file.
bool ServedPort::makeLink()
{
    std::error_code error;
    if (std::filesystem::is_symlink(m_link, error))
        std::filesystem::remove(m_link, error);
    std::filesystem::create_symlink(m_terminal->path(), m_link, error);
    m_isLinkMade = !error;
    return m_isLinkMade;
}

void ServedPort::removeLink()
{
    std::error_code error;
    if (std::exchange(m_isLinkMade, false))
        std::filesystem::remove(m_link, error);
}

std::string ServedPort::path() const
{
    return m_terminal ? m_terminal->path() : std::string();
}

int ServedPort::descriptor() const
{
    return m_terminal ? m_terminal->descriptor() : -1;
}

int ServedPort::closeWatch() const
{
    return m_terminal ? m_terminal->closeWatch() : -1;
}

std::size_t ServedPort::read(std::span<std::uint8_t> bytes)
{
    return m_terminal ? m_terminal->read(bytes) : 0;
}

void ServedPort::write(std::span<const std::uint8_t> bytes)
{
    if (m_terminal)
        m_terminal->write(bytes);
}

void ServedPort::afterClose()
{
    if (m_terminal)
        m_terminal->afterClose();
}

} // namespace campanel::controller
