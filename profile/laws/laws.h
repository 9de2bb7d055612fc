// SPDX-License-Identifier: Apache-2.0
// The table of laws. A new law is one header in laws/ and one row in laws.cpp.
#pragma once

#include "profile/model/law.h"

#include <span>
#include <string_view>

namespace campanel::profile {

[[nodiscard]] std::span<const Law> laws();

// Returns the law with this key or code, or null.
[[nodiscard]] const Law* findLaw(std::string_view key);
[[nodiscard]] const Law* findLaw(LawId id);

// Returns the parameter with this id, or null.
[[nodiscard]] const LawParameterInfo* findLawParameter(std::string_view id);

[[nodiscard]] LawParameters defaultParameters(const Law& law);

} // namespace campanel::profile
