// SPDX-License-Identifier: Apache-2.0
// Formats numbers as text, independent of the process's locale. Internal to profile/.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace campanel::profile::detail {

[[nodiscard]] std::string significantText(double value); // up to 7 significant digits
[[nodiscard]] std::string concat(std::initializer_list<std::string_view> parts);

} // namespace campanel::profile::detail
