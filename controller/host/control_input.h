// SPDX-License-Identifier: Apache-2.0
// Reads lines from a descriptor without waiting: fault scripts on standard input while the controller runs.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace campanel::controller {

class ControlInput {
public:
    // Does not close the descriptor; -1: there are no lines.
    explicit ControlInput(int descriptor)
        : m_descriptor(descriptor)
    {
    }

    // Returns the descriptor to poll for reading; -1 after the end of input.
    [[nodiscard]] int descriptor() const { return m_descriptor; }
    // Reads once, without waiting when the descriptor is readable; passes each line without its end to
    // `take`.
    void read(const std::function<void(std::string_view)>& take);

private:
    int m_descriptor = -1;
    std::string m_begun; // incomplete line
};

} // namespace campanel::controller
