// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace campanel::panel {

// For a process that runs for months. By itself the allocator keeps more and more of what has been freed:
// eight hours of running took 20 MB more than the first one. From now on it gives free memory back at a fixed
// size.
void keepMemoryFlat();

} // namespace campanel::panel
