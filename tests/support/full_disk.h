// SPDX-License-Identifier: Apache-2.0
// A full disk, for this process and its children.
#pragma once

#include <csignal>
#include <sys/resource.h>

namespace campanel::test {

// Limits every file to `bytes` during its lifetime, like a full disk. Pipes are not limited.
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
