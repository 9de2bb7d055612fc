// SPDX-License-Identifier: Apache-2.0
// Opens the standard descriptors of a program that was started without them: the next file that it opens,
// such as the machine's line, would become its standard output. Linked into each installed program; runs
// before main().
#include <initializer_list>

#include <fcntl.h>
#include <unistd.h>

namespace {

// Early among the constructors: others may open files.
constexpr int constructorPriority = 101;
constexpr int failureCode = 127;

// A write to them is refused, as without them: an answer that nobody gets is an error.
[[gnu::constructor(constructorPriority)]] void openStandardDescriptors()
{
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(descriptor, F_GETFD) < 0 &&
            ::open("/dev/null", O_RDONLY) != descriptor) // NOLINT: variadic
            ::_exit(failureCode);
    }
}

} // namespace
