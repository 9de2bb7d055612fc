// SPDX-License-Identifier: Apache-2.0
// Replaces qt_master.cpp where qt6-serialbus-dev is not installed.
#include "master.h"

namespace campanel::bench {

std::unique_ptr<Master> qtMaster(const std::string& /*port*/, std::uint32_t /*baud*/)
{
    return nullptr;
}

} // namespace campanel::bench
