// SPDX-License-Identifier: Apache-2.0
// packaging/test in a folder with planted tests: ctest itself runs them, nothing is built.
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

namespace test_skipped {

using namespace Qt::StringLiterals;
using campanel::test::sourcePath;

class TestSkipped : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    QString path(const QString& name) { return m_folder.filePath(name); }
    void write(const QString& name, const QByteArray& text)
    {
        QVERIFY(QDir().mkpath(QFileInfo(path(name)).path()));
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
        QVERIFY(file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
    }
    // Runs the script with these options, and keeps what it prints.
    int run(const QStringList& options, QByteArray* printed)
    {
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(u"PATH"_s, path(u"bin"_s) + u':' + environment.value(u"PATH"_s));
        process.setProcessEnvironment(environment);
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(path(u"packaging/test"_s), options);
        if (!process.waitForFinished(60'000))
            return -1;
        *printed = process.readAll();
        return process.exitCode();
    }

private slots:
    void initTestCase()
    {
        QVERIFY(QDir().mkpath(path(u"packaging"_s)));
        for (const char* name : {"packaging/test", "packaging/lib", "CMakePresets.json"})
            QVERIFY(QFile::copy(sourcePath(name), path(QLatin1String(name))));
        write(u"packaging/dependencies"_s, "");
        write(u"packaging/qwt"_s, "#!/bin/sh\n");
        write(u"bin/cmake"_s, "#!/bin/sh\n");
        write(u"build/ci/CTestTestfile.cmake"_s,
              "add_test(planted/good true)\n"
              "add_test(planted/lacking sh -c \"echo no emulator; exit 77\")\n"
              "set_tests_properties(planted/lacking PROPERTIES SKIP_RETURN_CODE 77)\n"
              "add_test(planted/disabled true)\n"
              "set_tests_properties(planted/disabled PROPERTIES DISABLED ON)\n");
    }

    void aSkippedTestIsAFailureAndNamed_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArrayList>("named");
        QTest::addColumn<int>("exitCode");
        QTest::newRow("nothing is skipped") << QStringList{u"-R"_s, u"good"_s} << QByteArrayList() << 0;
        QTest::newRow("skipped") << QStringList{u"-R"_s, u"good|lacking"_s}
                                 << QByteArrayList{"planted/lacking (Skipped)"} << 1;
        QTest::newRow("disabled") << QStringList{u"-R"_s, u"good|disabled"_s}
                                  << QByteArrayList{"planted/disabled (Disabled)"} << 1;
        QTest::newRow("every tier") << QStringList{u"--all"_s}
                                    << QByteArrayList{"planted/lacking (Skipped)",
                                                      "planted/disabled (Disabled)"}
                                    << 1;
        QTest::newRow("accepted by a person") << QStringList{u"--allow-skipped"_s, u"-R"_s, u"good|lacking"_s}
                                              << QByteArrayList{"planted/lacking (Skipped)"} << 0;
    }
    void aSkippedTestIsAFailureAndNamed()
    {
        QFETCH(QStringList, options);
        QFETCH(QByteArrayList, named);
        QFETCH(int, exitCode);
        QByteArray printed;
        const int code = run(options, &printed);
        QVERIFY2(code == exitCode, printed);
        const qsizetype summary = printed.lastIndexOf("100% tests passed, 0 tests failed out of ");
        QVERIFY2(summary >= 0, printed);
        for (const QByteArray& name : named)
            QVERIFY2(printed.lastIndexOf('\n' + name + '\n', summary) >= 0, printed);
        QCOMPARE(printed.contains("campanel: tests that did not run:"), !named.isEmpty());
        QCOMPARE(printed.contains("--allow-skipped accepts it"), exitCode != 0);
        QVERIFY2(!printed.mid(summary).contains("campanel:"), printed);
    }
};

CAMPANEL_TEST(TestSkipped)

} // namespace test_skipped

#include "test_skipped.moc"
