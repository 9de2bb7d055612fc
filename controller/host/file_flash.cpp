// SPDX-License-Identifier: Apache-2.0
#include "file_flash.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace campanel::controller {

tl::expected<FileFlash, std::string> FileFlash::open(const std::filesystem::path& directory)
{
    const auto failure = [&directory](const std::string& why) {
        return tl::unexpected("cannot keep the controller's flash in " + directory.string() + ": " + why +
                              "; name another directory with --state");
    };
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error)
        return failure(error.message());
    const auto openFile = [&directory](const char* name) {
        return ::open((directory / name).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    };
    FileFlash flash;
    flash.m_lock = openFile("controller.lock");
    flash.m_slots = {openFile("flash-slot-0"), openFile("flash-slot-1")};
    if (flash.m_lock < 0 || std::ranges::any_of(flash.m_slots, [](int slot) { return slot < 0; }))
        return failure(std::strerror(errno));
    if (flock(flash.m_lock, LOCK_EX | LOCK_NB) != 0)
        return failure("another campanel-controller uses it");
    return flash;
}

FileFlash::FileFlash(FileFlash&& other) noexcept
    : m_slots(std::exchange(other.m_slots, {-1, -1}))
    , m_lock(std::exchange(other.m_lock, -1))
{
}

FileFlash::~FileFlash()
{
    for (const int descriptor : {m_slots[0], m_slots[1], m_lock}) {
        if (descriptor >= 0)
            close(descriptor);
    }
}

bool FileFlash::read(std::uint32_t slot, std::uint32_t offset, std::span<std::uint8_t> bytes)
{
    std::ranges::fill(bytes, std::uint8_t{0xFF});
    while (!bytes.empty()) {
        const ssize_t size = pread(m_slots.at(slot), bytes.data(), bytes.size(), offset);
        if (size < 0 && errno != EINTR)
            return false;
        if (size == 0) // beyond the written bytes: still erased
            return true;
        if (size > 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(size));
            offset += static_cast<std::uint32_t>(size);
        }
    }
    return true;
}

bool FileFlash::erase(std::uint32_t slot)
{
    // The remaining slot must be on the disk before this one is erased.
    return fdatasync(m_slots.at(slot ^ 1u)) == 0 && ftruncate(m_slots.at(slot), 0) == 0;
}

bool FileFlash::write(std::uint32_t slot, std::uint32_t offset, std::span<const std::uint8_t> bytes)
{
    while (!bytes.empty()) {
        const ssize_t size = pwrite(m_slots.at(slot), bytes.data(), bytes.size(), offset);
        if (size < 0 && errno != EINTR)
            return false;
        if (size > 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(size));
            offset += static_cast<std::uint32_t>(size);
        }
    }
    return true;
}

std::filesystem::path defaultStateDirectory()
{
    const char* state = std::getenv("XDG_STATE_HOME");
    if (state != nullptr && *state == '/')
        return std::filesystem::path(state) / "campanel";
    const char* home = std::getenv("HOME");
    return std::filesystem::path(home != nullptr ? home : "/") / ".local" / "state" / "campanel";
}

} // namespace campanel::controller
