// SPDX-License-Identifier: Apache-2.0
// What the panel's command line refuses: one sentence, exit code 2, and no window.
#include <QProcess>
#include <QTest>

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
    }
    void refusesWithASentence()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, sentence);
        QProcess panel;
        panel.start(QStringLiteral(CAMPANEL_EXECUTABLE), arguments);
        QVERIFY2(panel.waitForFinished(), "it runs instead of refusing");
        QCOMPARE(panel.exitStatus(), QProcess::NormalExit);
        QCOMPARE(panel.exitCode(), 2);
        const QString said = QString::fromUtf8(panel.readAllStandardError());
        QVERIFY2(said.endsWith(sentence), qPrintable(said));
    }
};

QTEST_GUILESS_MAIN(TestOptions)
#include "test_panel_options.moc"
