// SPDX-License-Identifier: Apache-2.0
// The choice of the kiosk's platform for a machine.
#include "app/shell/kiosk.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <chrono>
#include <thread>

namespace test_screen_choice {

using namespace campanel::shell;
using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace {

// A machine's /sys/class/drm and /dev.
class Controller {
public:
    Controller() { QDir(m_folder.path()).mkpath(u"run"_s); }
    [[nodiscard]] ScreenPlaces places() const
    {
        return {m_folder.filePath(u"drm"_s), m_folder.filePath(u"dri"_s), m_folder.filePath(u"fb0"_s),
                m_folder.filePath(u"run"_s)};
    }
    void connector(const QString& connectorName, const char* status) const
    {
        write(u"drm/%1/status"_s.arg(connectorName), QByteArray(status) + '\n');
    }
    void card(const QString& cardName) const { write(u"dri/"_s + cardName, {}); }
    void framebuffer() const { write(u"fb0"_s, {}); }

private:
    void write(const QString& path, const QByteArray& text) const
    {
        QDir(m_folder.path()).mkpath(QFileInfo(path).path());
        QFile file(m_folder.filePath(path));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("%s cannot be written", qPrintable(file.fileName()));
    }
    QTemporaryDir m_folder;
};

} // namespace

class TestScreenChoice : public QObject {
    Q_OBJECT

private slots:
    void theChoice_data()
    {
        QTest::addColumn<QString>("status"); // the only connector; empty: there is none
        QTest::addColumn<bool>("hasCard");
        QTest::addColumn<bool>("hasFramebuffer");
        QTest::addColumn<int>("wanted");
        QTest::addColumn<QString>("platform");
        const auto row = [](const char* tag, const char* status, bool card, bool buffer, ScreenAccess wanted,
                            const char* platform) {
            QTest::newRow(tag) << QString::fromLatin1(status) << card << buffer << static_cast<int>(wanted)
                               << QString::fromLatin1(platform);
        };
        row("a screen on a card", "connected", true, true, ScreenAccess::Auto, "eglfs");
        row("nothing connected", "disconnected", true, true, ScreenAccess::Auto, "linuxfb");
        row("a connector, but no card", "connected", false, true, ScreenAccess::Auto, "linuxfb");
        row("only a framebuffer", "", false, true, ScreenAccess::Auto, "linuxfb");
        row("nothing", "", false, false, ScreenAccess::Auto, "");
        row("nothing connected and no framebuffer", "disconnected", true, false, ScreenAccess::Auto, "");
        row("linuxfb wanted", "connected", true, true, ScreenAccess::LinuxFb, "linuxfb");
        row("linuxfb wanted in vain", "connected", true, false, ScreenAccess::LinuxFb, "");
        row("eglfs wanted", "connected", true, true, ScreenAccess::EglFs, "eglfs");
        row("eglfs wanted in vain", "disconnected", true, true, ScreenAccess::EglFs, "");
    }
    void theChoice()
    {
        QFETCH(QString, status);
        QFETCH(bool, hasCard);
        QFETCH(bool, hasFramebuffer);
        QFETCH(int, wanted);
        QFETCH(QString, platform);
        const Controller machine;
        if (!status.isEmpty())
            machine.connector(u"card0-HDMI-A-1"_s, status.toLatin1().constData());
        if (hasCard)
            machine.card(u"card0"_s);
        if (hasFramebuffer)
            machine.framebuffer();
        const ScreenChoice choice = chooseScreen(static_cast<ScreenAccess>(wanted), machine.places());
        QCOMPARE(choice.platform, platform);
        QVERIFY(choice.reason.endsWith(u'.'));
    }

    void theSecondCardsScreenIsFound()
    {
        const Controller machine;
        machine.connector(u"card0-VGA-1"_s, "disconnected");
        machine.connector(u"card1-eDP-1"_s, "connected");
        machine.card(u"card0"_s);
        machine.card(u"card1"_s);
        const ScreenChoice choice = chooseScreen(ScreenAccess::Auto, machine.places());
        QCOMPARE(choice.platform, u"eglfs"_s);
        QVERIFY(choice.reason.contains(u"card1-eDP-1"));
    }

    // Eglfs ends the process when it cannot draw; the next start must not try it again.
    void eglfsThatDrewNothingIsNotTriedAgain()
    {
        const Controller machine;
        machine.connector(u"card0-HDMI-A-1"_s, "connected");
        machine.card(u"card0"_s);
        machine.framebuffer();
        noteScreenTried(u"eglfs"_s, machine.places());
        QCOMPARE(chooseScreen(ScreenAccess::Auto, machine.places()).platform, u"linuxfb"_s);
        noteScreenTried(u"linuxfb"_s, machine.places());
        qputenv("QT_QPA_PLATFORM", "linuxfb");
        noteScreenWorks(machine.places()); // no proof for eglfs
        QCOMPARE(chooseScreen(ScreenAccess::Auto, machine.places()).platform, u"linuxfb"_s);
        QCOMPARE(chooseScreen(ScreenAccess::EglFs, machine.places()).platform, u"eglfs"_s);
    }
    void eglfsThatDrewIsTakenAgain()
    {
        const Controller machine;
        machine.connector(u"card0-HDMI-A-1"_s, "connected");
        machine.card(u"card0"_s);
        machine.framebuffer();
        noteScreenTried(u"eglfs"_s, machine.places());
        qputenv("QT_QPA_PLATFORM", "eglfs");
        noteScreenWorks(machine.places());
        QCOMPARE(chooseScreen(ScreenAccess::Auto, machine.places()).platform, u"eglfs"_s);
    }

    void aScreenThatComesLateIsWaitedFor()
    {
        const Controller machine;
        std::thread plug([&machine] {
            std::this_thread::sleep_for(500ms);
            machine.framebuffer();
        });
        const ScreenChoice choice = waitForScreen(ScreenAccess::Auto, machine.places(), 20s);
        plug.join();
        QCOMPARE(choice.platform, u"linuxfb"_s);
    }
    void theWaitEnds()
    {
        const Controller machine;
        const auto began = std::chrono::steady_clock::now();
        QCOMPARE(waitForScreen(ScreenAccess::Auto, machine.places(), 300ms).platform, QString());
        QVERIFY(std::chrono::steady_clock::now() - began >= 300ms);
    }

    void cleanup() { qputenv("QT_QPA_PLATFORM", "offscreen"); }
};

CAMPANEL_TEST(TestScreenChoice)

} // namespace test_screen_choice

#include "test_screen_choice.moc"
