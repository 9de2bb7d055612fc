// SPDX-License-Identifier: Apache-2.0
// The tests of a folder are one program. With the name of a test file ("test_editor") and options of Qt Test
// it runs that file's test class; without a name it lists them. Each file has a namespace of its own name, so
// that the files can be compiled together.
#pragma once

#include <QTest>

#include <functional>

namespace campanel::test {

using Run = std::function<int(int argc, char** argv)>;

enum class Application {
    Made, // created before the run: a test
    None, // created by the run itself: another process that a test starts
};

// Registers a run of the program. `file` is a path; its name without folder and suffix is the name of the
// run.
class Registration {
public:
    Registration(const char* file, Application application, Run run);
};

} // namespace campanel::test

// Registers a test class; once at the end of a test file, in its namespace.
#define CAMPANEL_TEST(TestClass)                                                                             \
    static const campanel::test::Registration registration(__FILE__, campanel::test::Application::Made,      \
                                                           [](int argc, char** argv) {                       \
                                                               TestClass test;                               \
                                                               return QTest::qExec(&test, argc, argv);       \
                                                           });

// Registers a function that a test starts as another process, by `name`: int function(int argc, char** argv).
#define CAMPANEL_PROCESS(name, function)                                                                     \
    static const campanel::test::Registration process_##function(name, campanel::test::Application::None,    \
                                                                 function);
