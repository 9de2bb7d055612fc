// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace campanel::shell {

// Limits the memory of a process that runs for months. The allocator by default keeps more and more of the
// freed memory: 20 MB more after eight hours than after the first one. After this call it returns free memory
// at a fixed size.
void keepMemoryFlat();

} // namespace campanel::shell
