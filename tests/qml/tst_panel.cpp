// SPDX-License-Identifier: Apache-2.0
// The whole panel in a window, touched as a finger would, on the demonstration link: keypad, pins, handles,
// navigation, Stop, language.
#include "app/main/fonts.h"
#include "app/main/qml_modules.h"
#include "app/main/scene_checks.h"
#include "app/main/stage.h"

#include <QSignalSpy>
#include <QTest>

#include <memory>

using campanel::panel::Look;
using campanel::panel::Stage;

class TestPanel : public QObject {
    Q_OBJECT

    std::unique_ptr<Stage> m_stage;

    auto& editor() { return m_stage->panel().editor(); }
    void tap(const char* name) { m_stage->tap(QString::fromLatin1(name)); }
    QString textOf(const char* name)
    {
        const QQuickItem* item = m_stage->find(QString::fromLatin1(name));
        return item ? item->property("text").toString() : QString();
    }
    QPoint centerOf(const QString& name)
    {
        const QQuickItem* item = m_stage->find(name);
        return item ? item->mapToScene(item->boundingRect().center()).toPoint() : QPoint();
    }

private slots:
    void initTestCase() { campanel::panel::applyFonts(); }
    void init()
    {
        m_stage =
            std::make_unique<Stage>(Look{QStringLiteral("en"), QStringLiteral("light"), QSize(1024, 600)});
        QVERIFY(m_stage->isReady());
    }
    void cleanup()
    {
        QCOMPARE(m_stage->complaints(), QStringList());
        m_stage.reset();
    }

    void paleTextIsFound()
    {
        const campanel::panel::TouchLimits anySize;
        QCOMPARE(checkScene(m_stage->root(), anySize, m_stage->grab()), QStringList());
        m_stage->find(QStringLiteral("stateText"))->setProperty("color", QColor(0x98, 0x98, 0x98));
        const QStringList faults = checkScene(m_stage->root(), anySize, m_stage->grab());
        QCOMPARE(faults.size(), 1);
        QCOMPARE(
            faults.constFirst(),
            QStringLiteral("stateText \"Running\" in #989898 on #ffffff has a contrast of 2.88, it needs 3"));
    }

    void keypadTakesANumber()
    {
        tap("nav1");
        tap("field_bagLength");
        m_stage->type(QStringLiteral("262.5"));
        QCOMPARE(textOf("keypadText"), QStringLiteral("262.5"));
        tap("keypadAccept");
        QCOMPARE(editor().bagLength()->value(), 262.5);
        QVERIFY(!m_stage->find(QStringLiteral("keypad")));
    }

    void keypadRefusesWithTheLimit()
    {
        tap("nav1");
        tap("field_bagLength");
        m_stage->type(QStringLiteral("99999"));
        QVERIFY2(textOf("keypadHint").contains(QStringLiteral("2000")), qPrintable(textOf("keypadHint")));
        QVERIFY(!m_stage->find(QStringLiteral("keypadAccept"))->isEnabled());
        tap("keypadCancel");
        QCOMPARE(editor().bagLength()->value(), 250.0);
    }

    void keypadLeavesItsFieldAndStopFree_data()
    {
        QTest::addColumn<QStringList>("way");
        QTest::newRow("bag length") << QStringList{"nav1", "field_bagLength"};
        QTest::newRow("film speed") << QStringList{"nav1", "field_filmSpeed"};
        QTest::newRow("machine parameter at the right")
            << QStringList{"nav2", "section2", "field_maxAcceleration"};
    }
    void keypadLeavesItsFieldAndStopFree()
    {
        QFETCH(QStringList, way);
        for (const QString& name : way)
            m_stage->tap(name);
        const auto rectOf = [this](const QString& name) {
            const QQuickItem* item = m_stage->find(name);
            return item->mapRectToScene(item->boundingRect());
        };
        const QRectF keypad = rectOf(QStringLiteral("keypad"));
        QVERIFY(!keypad.intersects(rectOf(way.constLast())));
        QVERIFY(!keypad.intersects(rectOf(QStringLiteral("stopKey"))));
        QVERIFY(!keypad.intersects(rectOf(QStringLiteral("startKey"))));
    }

    void enteringADerivedValuePinsIt()
    {
        tap("nav1");
        QVERIFY(editor().filmSpeed()->derived());
        tap("field_filmSpeed");
        m_stage->type(QStringLiteral("300"));
        tap("keypadAccept");
        QVERIFY(editor().filmSpeed()->pinned());
        QCOMPARE(editor().filmSpeed()->value(), 300.0);
        tap("undo");
        QVERIFY(editor().filmSpeed()->derived());
        tap("redo");
        QVERIFY(editor().filmSpeed()->pinned());
    }

    void holdingADerivedValueExplainsIt()
    {
        tap("nav1");
        m_stage->hold(QStringLiteral("field_baseSpeed"));
        QVERIFY(m_stage->find(QStringLiteral("sheetPanel")));
        tap("sheetClose");
        QVERIFY(!m_stage->find(QStringLiteral("sheetPanel")));
    }

    void aHandleMovesItsRatio()
    {
        tap("nav1");
        const double before = editor().k2()->value();
        const double first = editor().k1()->value();
        const QPoint handle = centerOf(QStringLiteral("handle1"));
        QTest::mousePress(&m_stage->window(), Qt::LeftButton, {}, handle);
        QTest::mouseMove(&m_stage->window(), handle - QPoint(15, 0));
        QTest::mouseMove(&m_stage->window(), handle - QPoint(30, 0));
        QTest::mouseRelease(&m_stage->window(), Qt::LeftButton, {}, handle - QPoint(30, 0));
        QVERIFY2(editor().k2()->value() > before, "an earlier end of the ramp is a larger k");
        QCOMPARE(editor().k1()->value(), first);
        m_stage->settle();
        QVERIFY((centerOf(QStringLiteral("handle1")) - handle).manhattanLength() > 20);
        tap("undo");
        QCOMPARE(editor().k2()->value(), before);
    }

    void stopIsReachedOverDialogsAndKeypad_data()
    {
        QTest::addColumn<QStringList>("way");
        QTest::newRow("run") << QStringList{"nav0"};
        QTest::newRow("settings") << QStringList{"nav2"};
        QTest::newRow("keypad") << QStringList{"nav1", "field_rate"};
        QTest::newRow("dialog") << QStringList{"nav1", "lawButton"};
        QTest::newRow("dialog from a dialog") << QStringList{"nav1", "more", "tableButton"};
    }
    void stopIsReachedOverDialogsAndKeypad()
    {
        QFETCH(QStringList, way);
        for (const QString& name : way)
            m_stage->tap(name);
        const int before = m_stage->link().stopRequests();
        tap("stopKey");
        QCOMPARE(m_stage->link().stopRequests(), before + 1);
    }

    void languageChangesAtOnce()
    {
        QCOMPARE(textOf("stopKey"), QStringLiteral("Stop"));
        m_stage->panel().settings().setLanguage(QStringLiteral("zh_CN"));
        m_stage->settle();
        QCOMPARE(textOf("stopKey"), QString::fromUtf8("停止"));
        QCOMPARE(textOf("stateText"), QString::fromUtf8("运行"));
        m_stage->panel().settings().setLanguage(QStringLiteral("en"));
        m_stage->settle();
        QCOMPARE(textOf("stateText"), QStringLiteral("Running"));
    }

    void onlyTheRunPageIsMadeAtStart()
    {
        QVERIFY(!m_stage->root().findChild<QObject*>(QStringLiteral("motionPlot")));
        tap("nav1");
        QVERIFY(m_stage->find(QStringLiteral("motionPlot")));
    }

    void absentPortIsSaidAfterAMoment()
    {
        m_stage->link().show(campanel::panel::DemoLink::Situation::Absent);
        m_stage->settle();
        QVERIFY2(!m_stage->find(QStringLiteral("banner")), "a link that is just coming up is no trouble");
        QTRY_VERIFY(m_stage->find(QStringLiteral("banner")));
        QVERIFY2(textOf("banner").contains(QStringLiteral("/dev/ttyUSB0")), qPrintable(textOf("banner")));
        m_stage->link().show(campanel::panel::DemoLink::Situation::Running);
        QTRY_VERIFY(!m_stage->find(QStringLiteral("banner")));
    }

    void startRefusedSaysWhy()
    {
        tap("startKey");
        const QQuickItem* banner = m_stage->find(QStringLiteral("banner"));
        QVERIFY(banner);
        QVERIFY(!banner->property("text").toString().isEmpty());
    }
};

int main(int argc, char* argv[])
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QGuiApplication application(argc, argv);
    TestPanel test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_panel.moc"
