// SPDX-License-Identifier: Apache-2.0
// The refusals of the panel's command line: one sentence, exit code 2, and no window. The selection of the
// self-test.
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace test_panel_options {

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
        QTest::addRow("baud out of range")
            << QStringList{QStringLiteral("--port"), QStringLiteral("/dev/ttyUSB0"), QStringLiteral("--baud"),
                           QStringLiteral("96")}
            << QStringLiteral("campanel: --baud 96 is not between 1200 and 921600.\n");
        QTest::addRow("a pattern that names no look")
            << QStringList{QStringLiteral("--self-test"), QStringLiteral("--looks"),
                           QStringLiteral("light-en-*,light-fr-*")}
            << QStringLiteral("campanel: --looks \"light-fr-*\" names none of the looks; one is "
                              "light-en-1024x600.\n");
        QTest::addRow("a pattern that names no page")
            << QStringList{QStringLiteral("--capture"), QStringLiteral("pictures"),
                           QStringLiteral("--scenes"), QStringLiteral("walk")}
            << QStringLiteral("campanel: --scenes \"walk\" names none of the scenes; one is run.\n");
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

    void looksAtOneLookUnlessTold_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("told");
        const QStringList onePage{QStringLiteral("--scenes"), QStringLiteral("run")};
        QTest::newRow("one look") << onePage << QStringLiteral("1 pages and dialogs in 1 looks: 0 faults\n");
        QTest::newRow("two looks") << onePage +
                                          QStringList{QStringLiteral("--looks"),
                                                      QStringLiteral("light-en-800x480,light-zh_CN-800x480")}
                                   << QStringLiteral("1 pages and dialogs in 2 looks: 0 faults\n");
    }
    void looksAtOneLookUnlessTold()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, told);
        QProcess panel;
        panel.start(campanel::test::programPath("campanel"),
                    QStringList{QStringLiteral("--self-test")} + arguments);
        QVERIFY(panel.waitForFinished());
        QCOMPARE(QString::fromUtf8(panel.readAllStandardOutput()), told);
        QCOMPARE(panel.exitCode(), 0);
    }

    void capturesOneLookUnlessTold()
    {
        const QTemporaryDir folder;
        QProcess panel;
        panel.start(campanel::test::programPath("campanel"),
                    {QStringLiteral("--capture"), folder.path(), QStringLiteral("--scenes"),
                     QStringLiteral("run,motion")});
        QVERIFY(panel.waitForFinished());
        QCOMPARE(panel.exitCode(), 0);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files, QDir::Name),
                 (QStringList{QStringLiteral("motion-light-en-1024x600.png"),
                              QStringLiteral("run-light-en-1024x600.png")}));
    }
};

CAMPANEL_TEST(TestOptions)

} // namespace test_panel_options

#include "test_panel_options.moc"
