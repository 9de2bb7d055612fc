// SPDX-License-Identifier: Apache-2.0
// The refusals of the panel's command line: one sentence, exit code 2, and no window. The selection of the
// self-test.
#include "app/shell/folder_wait.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QWindow>

#include <memory>

namespace test_panel_options {

namespace {

QProcessEnvironment environmentOf(const QTemporaryDir& home)
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
    for (const char* place : {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME"})
        environment.insert(QString::fromLatin1(place), home.path());
    return environment;
}

// Returns the command line of the first child process, which any thread may have started.
QByteArray commandOfChild(qint64 process)
{
    const QDir tasks(QStringLiteral("/proc/%1/task").arg(process));
    for (const QString& task : tasks.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile children(tasks.filePath(task + QStringLiteral("/children")));
        if (!children.open(QIODevice::ReadOnly))
            continue;
        const QList<QByteArray> ids = children.readAll().simplified().split(' ');
        QFile command(QStringLiteral("/proc/%1/cmdline").arg(QString::fromLatin1(ids.first())));
        if (!ids.first().isEmpty() && command.open(QIODevice::ReadOnly))
            return command.readAll().replace('\0', ' ').trimmed();
    }
    return {};
}

} // namespace

class TestOptions : public QObject {
    Q_OBJECT

private slots:
    void refusesWithASentence_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("sentence");
        const auto withoutPort = [](const char* option, const char* value) {
            const QString name = QString::fromLatin1(option);
            const QString text = QString::fromLatin1(value);
            QTest::addRow("%s without a port", option)
                << QStringList{name, text}
                << QStringLiteral(
                       "campanel: %1 %2 needs a port: add --port /dev/ttyUSB0, or leave %1 out and set it in "
                       "Settings > Connection.\n")
                       .arg(name, text);
        };
        withoutPort("--baud", "9600");
        withoutPort("--parity", "E");
        withoutPort("--stop-bits", "2");
        withoutPort("--unit", "5");
        const auto wrong = [](const char* option, const char* allowed) {
            for (const char* value : {"0", "-1", "96", "4294967296", "nan", "inf", "1x", ""})
                QTest::addRow("%s %s", option, value)
                    << QStringList{QStringLiteral("--port"), QStringLiteral("/dev/ttyUSB0"),
                                   QStringLiteral("%1=%2").arg(option, value)}
                    << QStringLiteral("campanel: %1 %2 is not %3.\n").arg(option, value, allowed);
        };
        wrong("--baud", "one of 9600, 19200, 38400, 57600, 115200");
        wrong("--stop-bits", "between 1 and 2");
        wrong("--parity", "one of N, E, O");
        for (const char* value : {"0", "-1", "248", "4294967297", "nan", ""})
            QTest::addRow("--unit %s", value)
                << QStringList{QStringLiteral("--port"), QStringLiteral("/dev/ttyUSB0"),
                               QStringLiteral("--unit=%1").arg(value)}
                << QStringLiteral("campanel: --unit %1 is not between 1 and 247.\n").arg(value);
        for (const char* value : {"0x0", "-1x-1", "99999x99999", "nan", "1024", ""})
            QTest::addRow("--size %s", value)
                << QStringList{QStringLiteral("--size=%1").arg(value)}
                << QStringLiteral("campanel: --size %1 is not of the form 1024x600.\n").arg(value);
    }
    void refusesWithASentence()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, sentence);
        QProcess panel;
        panel.start(campanel::test::programPath("campanel"), arguments);
        QVERIFY2(panel.waitForFinished(), "it runs instead of refusing");
        QCOMPARE(panel.exitStatus(), QProcess::NormalExit);
        QCOMPARE(panel.exitCode(), 2);
        const QString said = QString::fromUtf8(panel.readAllStandardError());
        QVERIFY2(said.endsWith(sentence), qPrintable(said));
    }

    void aSecondPanelWaitsForTheFirst()
    {
        const QTemporaryDir home;
        const QString folder = home.filePath(QStringLiteral("campanel/campanel"));
        auto first = std::make_unique<campanel::store::FolderLock>(folder);
        QVERIFY(!first->isHeldByAnother());
        QProcess panel;
        panel.setProcessEnvironment(environmentOf(home));
        panel.start(campanel::test::programPath("campanel"), {QStringLiteral("--announce-first-frame")});
        QByteArray said;
        QTRY_VERIFY_WITH_TIMEOUT((said += panel.readAllStandardError()).contains("another CamPanel uses"),
                                 20'000);
        QCOMPARE(panel.state(), QProcess::Running);
        first.reset();
        said.clear();
        QTRY_VERIFY_WITH_TIMEOUT((said += panel.readAllStandardOutput()).contains("first frame"), 20'000);
        panel.terminate();
        QVERIFY(panel.waitForFinished());
        QCOMPARE(panel.exitCode(), 0);
    }

    void theSimulatedControllerGetsItsOptions_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArray>("expected");
        QTest::newRow("none") << QStringList() << QByteArray();
        QTest::newRow("late sensor") << QStringList{QStringLiteral("--simulator-arguments"),
                                                    QStringLiteral("--sensor-delay-ms 1")}
                                     << QByteArray("--sensor-delay-ms 1");
        QTest::newRow("the last one counts")
            << QStringList{QStringLiteral("--simulator-arguments=--sensor-delay-ms 1"),
                           QStringLiteral("--simulator-arguments=")}
            << QByteArray();
    }
    void theSimulatedControllerGetsItsOptions()
    {
        QFETCH(QStringList, options);
        QFETCH(QByteArray, expected);
        const QTemporaryDir home;
        QProcess panel;
        panel.setProcessEnvironment(environmentOf(home));
        panel.start(campanel::test::programPath("campanel"), options);
        QVERIFY(panel.waitForStarted());
        QByteArray command;
        QTRY_VERIFY_WITH_TIMEOUT(
            (command = commandOfChild(panel.processId())).contains("campanel-controller"), 20'000);
        panel.terminate();
        QVERIFY(panel.waitForFinished());
        QVERIFY2(command.contains("--unit 1"), command.constData());
        QCOMPARE(command.contains("--sensor-delay-ms"), !expected.isEmpty());
        QVERIFY2(command.contains(expected), command.constData());
    }

    void theWaitIsSeenAndIsClosed()
    {
        const QTemporaryDir home;
        const campanel::store::FolderLock first(home.path());
        QString text;
        QTimer::singleShot(200, this, [&text] {
            auto* window = QGuiApplication::topLevelWindows().value(0);
            auto* label = window ? window->findChild<QObject*>(QStringLiteral("bannerText")) : nullptr;
            text = label ? label->property("text").toString() : QStringLiteral("no text");
            if (window)
                window->close();
        });
        QVERIFY(!campanel::shell::waitForFolder(home.path(), QStringLiteral("en")));
        QVERIFY2(text.contains(QStringLiteral("Another CamPanel uses the data in ") + home.path()),
                 qPrintable(text));
    }

    void selfTestOpensEveryPage()
    {
        QProcess panel;
        panel.start(campanel::test::programPath("campanel"), {QStringLiteral("--self-test")});
        QVERIFY(panel.waitForFinished(60'000));
        const QString said = QString::fromUtf8(panel.readAllStandardOutput());
        static const QRegularExpression form(
            QStringLiteral("^(\\d+) QML files, 8 pages in en, de, zh_CN: 0 faults\n$"));
        const auto match = form.match(said);
        QVERIFY2(match.hasMatch(), qPrintable(said + QString::fromUtf8(panel.readAllStandardError())));
        QVERIFY(match.captured(1).toInt() > 150);
        QCOMPARE(panel.exitCode(), 0);
    }
};

CAMPANEL_TEST(TestOptions)

} // namespace test_panel_options

#include "test_panel_options.moc"
