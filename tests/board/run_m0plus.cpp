// SPDX-License-Identifier: Apache-2.0
// Runs a bench for a Cortex-M0+ and prints what it prints: board_cycles BENCH.bin [NUMBER]
#include "cortex_m0plus.h"

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

int main(int argc, char** argv)
{
    if (argc < 2)
        return EXIT_FAILURE;
    std::ifstream file(argv[1], std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    try {
        campanel::board::CortexM0plus processor(
            {bytes.begin(), bytes.end()},
            argc > 2 ? static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10)) : 0);
        return processor.run();
    } catch (const std::exception& problem) {
        std::cerr << argv[1] << ": " << problem.what() << '\n';
        return EXIT_FAILURE;
    }
}
