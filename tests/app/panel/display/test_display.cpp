// SPDX-License-Identifier: Apache-2.0
// Brightness by the kernel's files, automatic switch-off, the waking touch, and the time for cleaning.
#include "tests/app/panel/panel_rig.h"

#include "app/panel/display/display.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QEvent>
#include <QFile>
#include <QTest>

namespace test_display {

using namespace campanel;
using namespace std::chrono_literals;
using namespace Qt::StringLiterals;
using panel::Backlight;
using panel::Display;

namespace {

QByteArray read(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

struct DisplayRig : test::PanelRig {
    QString device = folder.filePath(u"backlight/panel"_s);
    Display display{machine, settings, nullptr};

    DisplayRig()
    {
        QDir().mkpath(device);
        write(u"max_brightness"_s, "250");
        write(u"brightness"_s, "250");
        display.setBacklight(Backlight::find(folder.filePath(u"backlight"_s)));
    }

    void write(const QString& name, const QByteArray& text)
    {
        QFile file(device + u'/' + name);
        if (!file.open(QIODevice::WriteOnly) || file.write(text) < 0)
            qFatal("no backlight");
    }
    [[nodiscard]] QByteArray level() const { return read(device + u"/brightness"_s); }
    void pass(std::chrono::minutes time)
    {
        now += time;
        display.tick();
    }
};

// Counts the touches that reach the panel.
struct Touched : QObject {
    int presses = 0;
    int releases = 0;

    bool event(QEvent* event) override
    {
        presses += event->type() == QEvent::MouseButtonPress ? 1 : 0;
        releases += event->type() == QEvent::MouseButtonRelease ? 1 : 0;
        return QObject::event(event);
    }
    void tap()
    {
        for (const auto type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
            QEvent event(type);
            QCoreApplication::sendEvent(this, &event);
        }
    }
};

} // namespace

class TestDisplay : public QObject {
    Q_OBJECT

private slots:
    void brightnessIsSetAndKept()
    {
        DisplayRig rig;
        QVERIFY(rig.display.adjustable());
        rig.settings.set("display.brightness", panel::settingText(50));
        QCOMPARE(rig.level(), QByteArray("125"));
        rig.settings.set("display.brightness", panel::settingText(51)); // none of the choices
        QCOMPARE(rig.settings.values().whole("display.brightness"), 50);
        panel::Settings stored(rig.folder.filePath(u"settings.ini"_s), nullptr);
        const Display again(rig.machine, stored, nullptr);
        QCOMPARE(stored.values().whole("display.brightness"), 50);
    }

    void withoutABacklightItSaysSo()
    {
        DisplayRig rig;
        QVERIFY(!Backlight::find(rig.folder.filePath(u"nothing"_s)));
        rig.write(u"max_brightness"_s, "many");
        QVERIFY(!Backlight::find(rig.folder.filePath(u"backlight"_s)));
        QVERIFY(QDir(rig.device).removeRecursively());
        rig.settings.set("display.brightness", panel::settingText(75)); // removed while the panel runs
        QVERIFY(!rig.display.adjustable());
    }

    void itGoesDarkAtStandstillOnly()
    {
        DisplayRig rig;
        rig.connectRunning();
        rig.settings.set("display.dark_after_minutes", panel::settingText(5));
        rig.pass(60min);
        QVERIFY(!rig.display.dark());
        rig.link.status.state = modbus::State::Ready;
        rig.link.sendStatus(rig.now);
        rig.pass(4min);
        QVERIFY(!rig.display.dark());
        rig.pass(1min);
        QVERIFY(rig.display.dark());
        QCOMPARE(rig.level(), QByteArray("0"));
        rig.link.status.state = modbus::State::Fault;
        rig.link.status.faultBits = 1;
        rig.link.sendStatus(rig.now);
        QVERIFY(!rig.display.dark()); // must be visible
        QCOMPARE(rig.level(), QByteArray("250"));
    }

    void theTouchThatWakesItDoesNothingElse()
    {
        DisplayRig rig;
        Touched page;
        rig.settings.set("display.dark_after_minutes", panel::settingText(5));
        rig.pass(5min);
        QVERIFY(rig.display.dark());
        page.tap();
        QVERIFY(!rig.display.dark());
        QCOMPARE(page.presses, 0);
        QCOMPARE(page.releases, 0);
        rig.now += 299ms; // a double tap
        page.tap();
        QCOMPARE(page.presses, 0);
        QCOMPARE(page.releases, 0);
        rig.now += 1ms;
        page.tap();
        QCOMPARE(page.presses, 1);
        QCOMPARE(page.releases, 1);
        rig.pass(4min);
        page.tap();
        rig.pass(4min);
        QVERIFY(!rig.display.dark());
    }

    void neverIsNever()
    {
        DisplayRig rig;
        rig.pass(600min);
        QVERIFY(!rig.display.dark());
    }

    void wipingEndsByItself()
    {
        DisplayRig rig;
        rig.display.wipe();
        QCOMPARE(rig.display.wipeSeconds(), Display::wipeTimeS);
        for (int second = 0; second < Display::wipeTimeS; ++second)
            rig.display.tick();
        QCOMPARE(rig.display.wipeSeconds(), 0);
    }
};

CAMPANEL_TEST(TestDisplay)

} // namespace test_display

#include "test_display.moc"
