// SPDX-License-Identifier: Apache-2.0
// Prints the files generated from the register table: --c-header for the controller, --markdown for
// REGISTERS.md.
#include "modbus/map/register_document.h"

#include <cstring>
#include <iostream>

int main(int argc, char** argv)
{
    if (argc == 2 && std::strcmp(argv[1], "--c-header") == 0)
        std::cout << campanel::modbus::registersCHeader();
    else if (argc == 2 && std::strcmp(argv[1], "--markdown") == 0)
        std::cout << campanel::modbus::registersMarkdown();
    else {
        std::cerr << "usage: campanel-generate-registers --c-header | --markdown\n";
        return 2;
    }
    return std::cout.flush() ? 0 : 1;
}
