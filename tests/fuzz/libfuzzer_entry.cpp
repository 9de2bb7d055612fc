// SPDX-License-Identifier: Apache-2.0
// The entry of libFuzzer, which has the main function. It begins with the files that `replay_... --seeds`
// wrote.
#include "tests/fuzz/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    campanel::fuzz::runTarget({data, size});
    return 0;
}
