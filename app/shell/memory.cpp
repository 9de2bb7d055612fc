// SPDX-License-Identifier: Apache-2.0
#include "app/shell/memory.h"

#include <malloc.h>

namespace campanel::shell {

void keepMemoryFlat()
{
    constexpr int trimBytes = 128 * 1024;
    constexpr int mapBytes = 64 * 1024;
    mallopt(M_TRIM_THRESHOLD, trimBytes);
    mallopt(M_MMAP_THRESHOLD, mapBytes);
}

} // namespace campanel::shell
