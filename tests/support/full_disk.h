// SPDX-License-Identifier: Apache-2.0
// A disk that is full, for this process and those that it starts.
#pragma once

#include <csignal>
#include <sys/resource.h>

namespace campanel::test {

// No file can grow beyond `bytes` while it lives: as on a disk that is full. Pipes still take everything.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes = 0)
    {
        getrlimit(RLIMIT_FSIZE, &m_before);
        m_handler = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit none{bytes, m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &none);
    }
    ~FullDisk()
    {
        setrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, m_handler);
    }

private:
    rlimit m_before{};
    void (*m_handler)(int) = nullptr;
};

} // namespace campanel::test
