// SPDX-License-Identifier: Apache-2.0
// The options of campanel-looks: a pattern that matches nothing is refused; without patterns it takes one
// variant.
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace test_looks_options {

class TestLooksOptions : public QObject {
    Q_OBJECT

private slots:
    void refusesWithASentence_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("sentence");
        QTest::addRow("a pattern that matches no variant")
            << QStringList{QStringLiteral("--variants"), QStringLiteral("light-en-*,light-fr-*")}
            << QStringLiteral(
                   "campanel-looks: --variants \"light-fr-*\" matches none of the variants. An example is "
                   "light-en-1024x600.\n");
        QTest::addRow("a pattern that matches no page")
            << QStringList{QStringLiteral("--capture"), QStringLiteral("pictures"),
                           QStringLiteral("--screens"), QStringLiteral("walk")}
            << QStringLiteral(
                   "campanel-looks: --screens \"walk\" matches none of the screens. An example is run.\n");
        QTest::addRow("pictures to compare with, but no folder")
            << QStringList{QStringLiteral("--compare"), QStringLiteral("pictures")}
            << QStringLiteral("campanel-looks: --compare needs --capture FOLDER.\n");
    }
    void refusesWithASentence()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, sentence);
        QProcess looks;
        looks.start(campanel::test::programPath("campanel-looks"), arguments);
        QVERIFY(looks.waitForFinished());
        QCOMPARE(looks.exitCode(), 2);
        const QString said = QString::fromUtf8(looks.readAllStandardError());
        QVERIFY2(said.endsWith(sentence), qPrintable(said));
    }

    void looksAtOneLookUnlessTold_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("told");
        const QStringList onePage{QStringLiteral("--screens"), QStringLiteral("run")};
        QTest::newRow("one variant") << onePage
                                     << QStringLiteral("1 pages and dialogs in 1 variants: 0 faults\n");
        QTest::newRow("two variants")
            << onePage + QStringList{QStringLiteral("--variants"),
                                     QStringLiteral("light-en-800x480,light-zh_CN-800x480")}
            << QStringLiteral("1 pages and dialogs in 2 variants: 0 faults\n");
    }
    void looksAtOneLookUnlessTold()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, told);
        QProcess looks;
        looks.start(campanel::test::programPath("campanel-looks"), arguments);
        QVERIFY(looks.waitForFinished());
        QCOMPARE(QString::fromUtf8(looks.readAllStandardOutput()), told);
        QCOMPARE(looks.exitCode(), 0);
    }

    void capturesOneLookUnlessTold()
    {
        const QTemporaryDir folder;
        QProcess looks;
        looks.start(campanel::test::programPath("campanel-looks"),
                    {QStringLiteral("--capture"), folder.path(), QStringLiteral("--screens"),
                     QStringLiteral("run,motion")});
        QVERIFY(looks.waitForFinished());
        QCOMPARE(looks.exitCode(), 0);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files, QDir::Name),
                 (QStringList{QStringLiteral("motion-light-en-1024x600.png"),
                              QStringLiteral("run-light-en-1024x600.png")}));
    }
};

CAMPANEL_TEST(TestLooksOptions)

} // namespace test_looks_options

#include "test_looks_options.moc"
