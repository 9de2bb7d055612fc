// SPDX-License-Identifier: Apache-2.0
#include "file_flash.h"

#include "base/ctl_crc.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace campanel::controller {
namespace {

// A record has two places, written in turn, so that one that was cut short leaves the other.
struct Place {
    std::uint32_t sequence = 0; // 0: never written
    std::uint32_t size = 0;
    std::array<std::uint8_t, FlashDevice::maxRecordBytes> bytes{};
    std::uint32_t crc = 0; // of what is above

    [[nodiscard]] std::uint32_t sum() const
    {
        return ctl_crc32_bytes(CTL_CRC32_START, reinterpret_cast<const std::uint8_t*>(this),
                               offsetof(Place, crc));
    }
};

off_t offsetOf(std::uint32_t sequence)
{
    return static_cast<off_t>((sequence % 2) * sizeof(Place));
}

// Returns the newest valid place; sequence 0 when there is none.
Place newestOf(int record)
{
    Place newest;
    for (const std::uint32_t place : {0u, 1u}) {
        Place read;
        if (pread(record, &read, sizeof read, offsetOf(place)) == sizeof read && read.crc == read.sum() &&
            read.size <= read.bytes.size() && read.sequence > newest.sequence)
            newest = read;
    }
    return newest;
}

} // namespace

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
    flash.m_records = {openFile("kept-record-0"), openFile("kept-record-1"), openFile("kept-record-2")};
    const auto failed = [](int descriptor) { return descriptor < 0; };
    if (flash.m_lock < 0 || std::ranges::any_of(flash.m_slots, failed) ||
        std::ranges::any_of(flash.m_records, failed))
        return failure(std::strerror(errno));
    if (flock(flash.m_lock, LOCK_EX | LOCK_NB) != 0)
        return failure("another campanel-controller uses it");
    std::ranges::transform(flash.m_records, flash.m_sequences.begin(),
                           [](int record) { return newestOf(record).sequence; });
    return flash;
}

FileFlash::FileFlash(FileFlash&& other) noexcept
    : m_slots(std::exchange(other.m_slots, {-1, -1}))
    , m_records(std::exchange(other.m_records, {-1, -1, -1}))
    , m_sequences(other.m_sequences)
    , m_lock(std::exchange(other.m_lock, -1))
{
}

FileFlash::~FileFlash()
{
    const auto closeAll = [](const auto& descriptors) {
        for (const int descriptor : descriptors) {
            if (descriptor >= 0)
                close(descriptor);
        }
    };
    closeAll(m_slots);
    closeAll(m_records);
    closeAll(std::array{m_lock});
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

bool FileFlash::keep(std::uint32_t record, std::span<const std::uint8_t> bytes)
{
    Place place{.sequence = m_sequences.at(record) + 1, .size = static_cast<std::uint32_t>(bytes.size())};
    if (bytes.size() > place.bytes.size())
        return false;
    std::ranges::copy(bytes, place.bytes.begin());
    place.crc = place.sum();
    if (pwrite(m_records.at(record), &place, sizeof place, offsetOf(place.sequence)) != sizeof place)
        return false;
    m_sequences.at(record) = place.sequence;
    return true;
}

std::size_t FileFlash::kept(std::uint32_t record, std::span<std::uint8_t> bytes)
{
    const Place newest = newestOf(m_records.at(record));
    std::copy_n(newest.bytes.begin(), std::min<std::size_t>(newest.size, bytes.size()), bytes.begin());
    return newest.size;
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
