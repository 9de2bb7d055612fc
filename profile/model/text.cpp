// SPDX-License-Identifier: Apache-2.0
// Formats numbers through std::to_chars, which is independent of the locale.
#include "profile/model/text.h"

#include <array>
#include <charconv>

namespace campanel::profile::detail {
namespace {

// A buffer for the longest double in fixed notation: 309 digits, sign, point and decimals.
using Buffer = std::array<char, 352>;

} // namespace

std::string significantText(double value)
{
    constexpr int digits = 7;
    Buffer buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                   std::chars_format::general, digits);
    return {buffer.data(), end.ptr};
}

std::string concat(std::initializer_list<std::string_view> parts)
{
    std::string whole;
    for (const std::string_view part : parts)
        whole.append(part);
    return whole;
}

} // namespace campanel::profile::detail
