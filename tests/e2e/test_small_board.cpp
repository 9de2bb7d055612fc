// SPDX-License-Identifier: Apache-2.0
// The panel on a board that cannot hold or execute a program: the ARM7 firmware in QEMU, once with less
// memory, once without intervals. tests/board runs it.
#include "app/shell/fonts.h"
#include "panel_window.h"
#include "tests/support/controller_process.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_small_board {

using namespace campanel;
using panel::Controller;
using panel::ProgramDownload;
using test::ControllerProcess;
using test::PanelWindow;

namespace {

constexpr int timeoutMs = 20'000;

QStringList smallFirmware()
{
    return {QStringLiteral("--firmware"), qEnvironmentVariable("CAMPANEL_SMALL_FIRMWARE")};
}

// Downloads by touch, and waits for the refusal.
void downloadInVain(PanelWindow& panel)
{
    const ProgramDownload& download = *panel.editor().programDownload();
    QTRY_VERIFY_WITH_TIMEOUT(download.canDownload(), timeoutMs);
    panel.tap("nav_motion");
    panel.tap("nextStep");
    panel.tap("downloadStart");
    QVERIFY2(panel.complaints().isEmpty(), qPrintable(panel.complaints().join(u'\n')));
    QTRY_COMPARE_WITH_TIMEOUT(download.state(), ProgramDownload::State::Failed, timeoutMs);
    panel.touchDriver().settle();
}

void chooseIntervals(panel::Editor& editor)
{
    for (int row = 0; row < editor.choices()->count(); ++row) {
        const panel::ChoiceRow& choice = editor.choices()->row(row);
        if (choice.choice == program::Choice::Execution)
            editor.setChoice(row, static_cast<int>(choice.codes.indexOf(
                                      static_cast<std::uint16_t>(profile::Execution::Intervals))));
    }
}

} // namespace

class TestSmallBoard : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { shell::applyFonts(); }

    void aTableThatIsTooLong_data()
    {
        QTest::addColumn<QString>("sentence");
        QTest::newRow("en")
            << "registers, the controller has 256; its program is unchanged. Use fewer slices per ramp.";
        QTest::newRow("zh_CN") << "控制器只有 256 个，其程序没有改变。请减少斜坡分段数。";
        QTest::newRow("de")
            << "die Steuerung hat 256; ihr Programm ist unverändert. Weniger Teilschritte je Rampe wählen.";
    }
    void aTableThatIsTooLong()
    {
        QFETCH(const QString, sentence);
        const ControllerProcess controller(smallFirmware());
        PanelWindow panel(controller.port(), QString::fromLatin1(QTest::currentDataTag()));
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        downloadInVain(panel);
        QVERIFY2(texts(panel).contains(sentence), qPrintable(panel.texts()));
        QCOMPARE(panel.controller().generation(), 0.0);
        QCOMPARE(panel.complaints(), QStringList());
    }

    void intervalsThatTheBoardLacks_data()
    {
        QTest::addColumn<QString>("sentence");
        QTest::newRow("en")
            << "This controller cannot execute intervals; its program is unchanged. Choose cam points.";
        QTest::newRow("zh_CN") << "该控制器不能执行区间表，其程序没有改变。请选择凸轮点。";
        QTest::newRow("de") << "Diese Steuerung kann keine Intervalle ausführen; ihr Programm ist "
                               "unverändert. Wählen Sie Kurvenpunkte.";
    }
    // The recipe has them from another machine: without the controller they can be chosen.
    void intervalsThatTheBoardLacks()
    {
        QFETCH(const QString, sentence);
        ControllerProcess controller;
        controller.kill();
        PanelWindow panel(controller.port(), QString::fromLatin1(QTest::currentDataTag()));
        QTRY_COMPARE_WITH_TIMEOUT(panel.panel().recipes().total(), 1, timeoutMs);
        panel.editor().newProgram(static_cast<int>(modbus::ProgramKind::SpeedMove));
        chooseIntervals(panel.editor());
        controller.start();
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        downloadInVain(panel);
        QVERIFY2(texts(panel).contains(sentence), qPrintable(panel.texts()));
        QCOMPARE(panel.controller().generation(), 0.0);
        QCOMPARE(panel.complaints(), QStringList());
    }

private:
    // Returns the texts on the screen without the marks that keep words together.
    static QString texts(PanelWindow& panel)
    {
        return panel.texts().remove(QChar(0x2060)).replace(QChar(0xA0), u' ');
    }
};

CAMPANEL_TEST(TestSmallBoard)

} // namespace test_small_board

#include "test_small_board.moc"
