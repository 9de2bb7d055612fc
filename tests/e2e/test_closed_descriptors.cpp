// SPDX-License-Identifier: Apache-2.0
// Programs that are started without standard input, output and error: no file that they open takes their
// place.
#include "tests/support/controller_process.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace test_closed_descriptors {

using namespace campanel;
using namespace Qt::StringLiterals;

namespace {

// Starts a program by a shell that closes descriptors, such as "<&- >&- 2>&-".
void startWithout(const QString& closed, const QString& program, const QStringList& arguments,
                  QProcess& process)
{
    process.start(u"/bin/sh"_s, QStringList{u"-c"_s, u"exec \"$0\" \"$@\" "_s + closed, program} + arguments);
    if (!process.waitForStarted())
        qFatal("%s", qPrintable(process.errorString()));
}

// Returns what a descriptor of the program is; empty before the shell has become it.
QString targetOf(const QProcess& process, int descriptor, const QString& program)
{
    const QString folder = u"/proc/%1/"_s.arg(process.processId());
    if (QFileInfo(QFile::symLinkTarget(folder + u"exe"_s)).fileName() != QFileInfo(program).fileName())
        return {};
    return QFile::symLinkTarget(folder + u"fd/%1"_s.arg(descriptor));
}

} // namespace

class TestClosedDescriptors : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QFile file(m_folder.filePath(u"campanel.toml"_s));
        QVERIFY(file.open(QIODevice::WriteOnly) &&
                file.write("[gateway]\nhost = \"127.0.0.1\"\nport = 9\n") > 0);
    }

    void eachProgramOpensThem_data()
    {
        QTest::addColumn<QString>("program");
        QTest::addColumn<QStringList>("arguments");
        const QString line = m_controller.port();
        QTest::newRow("panel") << test::programPath("campanel") << QStringList();
        QTest::newRow("command line") << test::programPath("campanelctl")
                                      << QStringList{u"link"_s, u"--port"_s, line, u"--seconds"_s, u"600"_s};
        QTest::newRow("gateway") << test::programPath("campanel-gateway")
                                 << QStringList{u"--config"_s, m_folder.filePath(u"campanel.toml"_s),
                                                u"--state"_s, m_folder.path()};
        QTest::newRow("controller") << test::programPath("campanel-controller") << QStringList();
    }
    void eachProgramOpensThem()
    {
        QFETCH(QString, program);
        QFETCH(QStringList, arguments);
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(u"XDG_DATA_HOME"_s, m_folder.path());
        environment.insert(u"QT_QPA_PLATFORM"_s, u"offscreen"_s);
        process.setProcessEnvironment(environment);
        startWithout(u"<&- >&- 2>&-"_s, program, arguments, process);
        for (const int descriptor : {0, 1, 2})
            QTRY_COMPARE(targetOf(process, descriptor, program), u"/dev/null"_s);
        QTest::qWait(300); // it has opened files of its own
        for (const int descriptor : {0, 1, 2})
            QCOMPARE(targetOf(process, descriptor, program), u"/dev/null"_s);
        process.kill();
        process.waitForFinished();
    }

    // The answer does not go onto the machine's line, and that nobody has it is an error.
    void anAnswerThatNobodyGetsIsAnError_data()
    {
        QTest::addColumn<QString>("closed");
        QTest::newRow("input and output") << u"<&- >&-"_s;
        QTest::newRow("output") << u">&-"_s;
    }
    void anAnswerThatNobodyGetsIsAnError()
    {
        QFETCH(QString, closed);
        const QStringList status{u"status"_s, u"--port"_s, m_controller.port()};
        QProcess process;
        startWithout(closed, test::programPath("campanelctl"), status, process);
        QVERIFY(process.waitForFinished());
        QCOMPARE(process.exitCode(), 4);
        QVERIFY(process.readAllStandardError().contains("Standard output cannot be written"));
        QProcess second;
        second.start(test::programPath("campanelctl"), status + QStringList{u"--format"_s, u"csv"_s});
        QVERIFY(second.waitForFinished());
        const QByteArray answer = second.readAllStandardOutput();
        for (const char* error : {"link.crc_errors,0\n", "link.frame_errors,0\n", "link.exceptions,0\n"})
            QVERIFY2(answer.contains(error), answer);
    }

private:
    QTemporaryDir m_folder;
    test::ControllerProcess m_controller;
};

CAMPANEL_TEST(TestClosedDescriptors)

} // namespace test_closed_descriptors

#include "test_closed_descriptors.moc"
