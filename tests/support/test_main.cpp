// SPDX-License-Identifier: Apache-2.0
// The main function of every test program; see test_program.h.
#include "tests/support/test_program.h"

#ifdef QT_GUI_LIB
#include <QGuiApplication>
#else
#include <QCoreApplication>
#endif

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

namespace {

#ifdef QT_GUI_LIB
using ProgramApplication = QGuiApplication;
#else
using ProgramApplication = QCoreApplication;
#endif

constexpr int usageError = 2;

struct Entry {
    campanel::test::Application application;
    campanel::test::Run run;
};

// A function, because registrations in other files come before this file's variables.
std::map<std::string, Entry>& entries()
{
    static std::map<std::string, Entry> all;
    return all;
}

std::string stemOf(const std::string& file)
{
    const std::string name = file.substr(file.find_last_of('/') + 1);
    return name.substr(0, name.find_last_of('.'));
}

} // namespace

campanel::test::Registration::Registration(const char* file, Application application, Run run)
{
    if (!entries().try_emplace(stemOf(file), Entry{application, std::move(run)}).second) {
        std::fprintf(stderr, "%s is in this program twice\n", file);
        std::abort();
    }
}

int main(int argc, char** argv)
{
    const auto found = argc > 1 ? entries().find(argv[1]) : entries().end();
    if (found == entries().end()) {
        std::fprintf(stderr, "usage: %s NAME [options of Qt Test, -help tells them]\n", argv[0]);
        for (const auto& [name, entry] : entries()) {
            if (entry.application == campanel::test::Application::Made)
                std::fprintf(stderr, "  %s\n", name.c_str());
        }
        return usageError;
    }
    argv[1] = argv[0];
    ++argv;
    --argc;
    const Entry& entry = found->second;
    if (entry.application == campanel::test::Application::None)
        return entry.run(argc, argv);
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    const ProgramApplication application(argc, argv);
    return entry.run(argc, argv);
}
