// SPDX-License-Identifier: Apache-2.0
// The Run page of a packing machine by touch: the film's picture, its texts, and the page for a controller
// without film and marks.
#include "panel_test.h"

#include "app/plot/film/film_picture.h"
#include "tests/support/test_program.h"

#include <QFontMetricsF>
#include <QSignalSpy>

#include <chrono>

namespace test_run_packing {

using campanel::plot::FilmPicture;
using Situation = campanel::looks::DemoLink::Situation;

class TestPacking : public campanel::test::PanelTest {
    Q_OBJECT

    void enter(Situation situation)
    {
        m_window->link().show(situation);
        m_window->checkClock();
        m_window->settle();
        tap("nav_run");
    }
    FilmPicture& picture()
    {
        auto* item = qobject_cast<FilmPicture*>(m_window->find(QStringLiteral("filmPicture")));
        if (!item)
            qFatal("there is no picture of the film");
        return *item;
    }
    // Returns the picture as it is in the window.
    QImage pictureImage()
    {
        m_window->settle();
        return m_window->grab().copy(picture().mapRectToScene(picture().boundingRect()).toRect());
    }
    campanel::link::StatusBatch status()
    {
        return {{{m_window->link().now(), *m_window->panel().controller().status()}}, 0};
    }
    qsizetype countOf(const char* list) { return picture().property(list).value<QList<QPointF>>().size(); }

private slots:
    void aRunningLineIsShown()
    {
        enter(Situation::Running);
        QCOMPARE(countOf("cuts"), 6);
        QVERIFY(countOf("marks") >= 3);
        QVERIFY(countOf("products") >= 3);
        QCOMPARE(picture().property("sensor").toDouble(), 900.0);
        QCOMPARE(picture().property("window").toDouble(), 6.0);
        QVERIFY(picture().property("nextMark").toDouble() > 800);
        QVERIFY(!picture().property("stale").toBool());
        QCOMPARE(textOf("markState"), QStringLiteral("Tracking marks"));
        QCOMPARE(textOf("markError"), QStringLiteral("mark error +0.04 mm"));
        QCOMPARE(textOf("bagLength"), QStringLiteral("250.0"));
        QVERIFY(textOf("lastDeviation").endsWith(QStringLiteral("0.02")));
        QCOMPARE(textOf("bagsWithin"), QStringLiteral("60 of 60 within"));
        QCOMPARE(textOf("lastSkip"), QStringLiteral("Last: Product missing"));
        QVERIFY(!m_window->find(QStringLiteral("packingGate")));
    }

    void aWaitingKnifeSaysWhy()
    {
        enter(Situation::ProductAcross);
        QCOMPARE(textOf("packingGate"), QStringLiteral("Knife stays open: product in its path"));
        QCOMPARE(textOf("lastSkip"), QStringLiteral("Last: Product in the knife's path"));
        QVERIFY(picture().property("knifeOpen").toBool());
        QCOMPARE(picture().property("cuts").value<QList<QPointF>>().constFirst().y(), 1.0);
    }

    void lostMarksAreAnAlarm()
    {
        enter(Situation::MarksLost);
        QCOMPARE(textOf("markState"), QStringLiteral("No marks found"));
        QCOMPARE(countOf("marks"), 0);
        QVERIFY(textOf("banner").startsWith(QStringLiteral("The controller lost the marks")));
        QVERIFY(!m_window->find(QStringLiteral("markError")));
    }

    void theNumbersBehindItOpen_data()
    {
        QTest::addColumn<QString>("card");
        QTest::newRow("film") << QStringLiteral("filmCard");
        QTest::newRow("left out") << QStringLiteral("skippedCutsCard");
    }
    void theNumbersBehindItOpen()
    {
        QFETCH(QString, card);
        enter(Situation::Running);
        m_window->tap(card);
        QVERIFY(m_window->find(QStringLiteral("sheetPanel")));
        QVERIFY(m_window->find(QStringLiteral("sheetMarkError")));
        tap("sheetClose");
        QVERIFY(!m_window->find(QStringLiteral("sheetPanel")));
    }

    // Digits of 14 mm by the screen's density, and whole numbers larger than decimals.
    void numbersAreReadFromThreeMetres()
    {
        enter(Situation::Running);
        const double pixelsPerMm =
            m_window->theme()->property("size").value<QObject*>()->property("pixelsPerMm").toDouble();
        for (const QString& name : {QStringLiteral("rateNumber"), QStringLiteral("bagLength")}) {
            const QQuickItem* number = m_window->find(name);
            QVERIFY2(number, qPrintable(name));
            const QList<QQuickItem*> labels = number->childItems();
            const QFont whole = labels[0]->property("font").value<QFont>();
            const double digitPx = QFontMetricsF(whole).tightBoundingRect(QStringLiteral("250")).height();
            QVERIFY2(digitPx >= 14 * pixelsPerMm - 1, qPrintable(QString::number(digitPx / pixelsPerMm)));
            QVERIFY(labels[1]->property("font").value<QFont>().pixelSize() < whole.pixelSize() / 2);
        }
    }

    // The knife's curve is one tap away.
    void theKnifesCurveOpens()
    {
        enter(Situation::Running);
        QVERIFY(!m_window->find(QStringLiteral("speedNumbers")));
        m_window->tap(QStringLiteral("knifeCard"));
        QVERIFY(m_window->find(QStringLiteral("speedNumbers")));
        tap("sheetClose");
    }

    // A fault stands where the numbers were, with what to do; no banner tells it again.
    void aFaultStandsOnThePage()
    {
        enter(Situation::Jammed);
        QCOMPARE(textOf("faultTitle"), QStringLiteral("Jam at the jaws"));
        QVERIFY2(textOf("faultAction").startsWith(QStringLiteral("Take out")),
                 qPrintable(textOf("faultAction")));
        QCOMPARE(picture().property("faultColor").value<QColor>().alpha(), 255);
        QVERIFY(!m_window->find(QStringLiteral("banner")));
        QVERIFY(!m_window->find(QStringLiteral("rateNumber")));
        m_window->tap(QStringLiteral("faultCard"));
        QVERIFY(m_window->find(QStringLiteral("alarmReset")));
        tap("sheetClose");
        tap("nav_motion");
        QVERIFY2(m_window->find(QStringLiteral("banner")), "other pages have it as a banner");
        enter(Situation::Running);
        QVERIFY(!m_window->find(QStringLiteral("faultCard")));
        QVERIFY(m_window->find(QStringLiteral("rateNumber")));
    }

    void anOldControllerHasThePageAsBefore()
    {
        m_window->link().setOld(true);
        m_window->link().show(Situation::Stopped);
        enter(Situation::Running);
        QVERIFY(!m_window->find(QStringLiteral("filmPicture")));
        QVERIFY(m_window->find(QStringLiteral("knifeDial")));
        QCOMPARE(m_window->panel().controller().bags().series.size(), 60);
        m_window->link().setOld(false);
        m_window->link().show(Situation::Stopped);
        enter(Situation::Running);
        QVERIFY(m_window->find(QStringLiteral("filmPicture")));
        QCOMPARE(m_window->panel().controller().bags().series.size(), 60);
    }

    // Statuses paint the film at its present place, without a report of the film itself.
    void thePictureMovesWithEachStatusWhileItIsSeen()
    {
        m_window->theme()->setProperty("animated", true);
        enter(Situation::Running);
        const auto realTime = std::chrono::steady_clock::now().time_since_epoch();
        double nowS = std::chrono::duration<double>(realTime).count();
        picture().setClock([&] { return nowS; });
        emit m_window->link().statusReceived(status());
        const QImage before = pictureImage();
        nowS += 0.05;
        m_window->settle();
        QCOMPARE(pictureImage(), before);
        emit m_window->link().statusReceived(status());
        QCOMPARE(pictureImage(), before); // ten pictures a second are enough
        nowS += 0.06;
        emit m_window->link().statusReceived(status());
        const QImage after = pictureImage();
        QVERIFY(after != before);
        // A film that stops is painted at its last place too.
        nowS += 0.05;
        picture().setProperty("speed", 0.0);
        m_window->settle();
        nowS += 0.2;
        emit m_window->link().statusReceived(status());
        const QImage stopped = pictureImage();
        picture().update(picture().boundingRect().toAlignedRect());
        QCOMPARE(pictureImage(), stopped);
        // On another page it is not painted, although it moves.
        FilmPicture& hidden = picture();
        hidden.setProperty("speed", 250.0);
        m_window->settle();
        tap("nav_motion");
        // The other page may still need frames.
        // Back and forth: a film moves only for a while after its status.
        QSignalSpy frames(&m_window->panel().window(), &QQuickWindow::frameSwapped);
        bool isPainted = true;
        for (int attempt = 0; attempt < 20 && isPainted; ++attempt) {
            nowS += attempt % 2 == 0 ? 0.1 : -0.1;
            frames.clear();
            hidden.advance();
            QTest::qWait(100);
            isPainted = !frames.isEmpty();
        }
        QVERIFY(!isPainted);
        enter(Situation::Lost);
        QVERIFY(picture().property("stale").toBool());
        const QImage stale = pictureImage();
        nowS += 0.05;
        picture().advance();
        QCOMPARE(pictureImage(), stale);
    }

    void theToleranceIsChosen()
    {
        tap("nav_settings");
        tap("section2");
        tap("bagTolerance");
        m_window->type(QStringLiteral("9"));
        QVERIFY2(textOf("keypadHint").contains(QStringLiteral("is 5 mm")), qPrintable(textOf("keypadHint")));
        tap("keypadCancel");
        QVERIFY(!m_window->find(QStringLiteral("keypad")));
        tap("bagTolerance");
        m_window->type(QStringLiteral("0.05"));
        tap("keypadAccept");
        QCOMPARE(m_window->panel().settings().bagToleranceMm(), 0.05);
        enter(Situation::Running);
        QCOMPARE(textOf("toleranceText"), QStringLiteral("±0.05 mm"));
        QVERIFY(m_window->panel().controller().bags().within < 60);
    }
};

CAMPANEL_TEST(TestPacking)

} // namespace test_run_packing

#include "test_run_packing.moc"
