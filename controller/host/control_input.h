// SPDX-License-Identifier: Apache-2.0
// Lines from a descriptor that must not be waited for: fault scripts on standard input while the controller
// runs.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace campanel::controller {

class ControlInput {
public:
    // The descriptor is not closed; -1: there are no lines.
    explicit ControlInput(int descriptor)
        : m_descriptor(descriptor)
    {
    }

    // To be watched for reading; -1 after the end of input.
    [[nodiscard]] int descriptor() const { return m_descriptor; }
    // Reads once, without waiting when the descriptor is readable; hands over each line without its end.
    void read(const std::function<void(std::string_view)>& take);

private:
    int m_descriptor = -1;
    std::string m_begun; // line of which the end has not come
};

} // namespace campanel::controller
