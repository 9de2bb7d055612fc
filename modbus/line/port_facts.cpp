// SPDX-License-Identifier: Apache-2.0
#include "modbus/line/port_facts.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <pwd.h>
#include <unistd.h>

namespace campanel::modbus {
namespace {

namespace fs = std::filesystem;

// Resolves symbolic links, as in /dev/serial/by-id.
fs::path nodeOf(const std::string& port)
{
    std::error_code failure;
    const fs::path node = fs::canonical(port, failure);
    return failure ? fs::path(port) : node;
}

bool hasOpen(const fs::path& process, const fs::path& node)
{
    std::error_code failure;
    for (fs::directory_iterator entry(process / "fd", failure), end; !failure && entry != end;
         entry.increment(failure)) {
        std::error_code unreadable;
        if (fs::read_symlink(entry->path(), unreadable) == node)
            return true;
    }
    return false;
}

std::string firstLine(const fs::path& file)
{
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    return line;
}

std::string userName()
{
    const passwd* user = getpwuid(getuid());
    return user != nullptr ? user->pw_name : "USER";
}

} // namespace

std::vector<PortHolder> holdersOf(const std::string& port, const std::string& processes)
{
    const fs::path node = nodeOf(port);
    std::vector<PortHolder> holders;
    std::error_code failure;
    for (fs::directory_iterator entry(processes, failure), end; !failure && entry != end;
         entry.increment(failure)) {
        const std::string name = entry->path().filename();
        if (!std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; }) || name.size() > 9)
            continue;
        const int processId = std::stoi(name);
        if (processId != getpid() && hasOpen(entry->path(), node))
            holders.push_back({processId, firstLine(entry->path() / "comm")});
    }
    std::ranges::sort(holders, {}, &PortHolder::processId);
    return holders;
}

std::optional<int> ftdiLatencyMs(const std::string& port, const std::string& devices)
{
    const std::string text = firstLine(fs::path(devices) / nodeOf(port).filename() / "latency_timer");
    const bool isNumber = !text.empty() && text.size() < 6 &&
                          std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
    return isNumber ? std::optional(std::stoi(text)) : std::nullopt;
}

std::string joinGroupCommand(const std::string& group)
{
    return "sudo usermod -aG " + group + " " + userName();
}

std::string lowerLatencyCommand(const std::string& port)
{
    return "echo 1 | sudo tee /sys/bus/usb-serial/devices/" + nodeOf(port).filename().string() +
           "/latency_timer";
}

} // namespace campanel::modbus
