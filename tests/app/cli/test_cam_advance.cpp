// SPDX-License-Identifier: Apache-2.0
// campanelctl and the ends of a cam: closed by the table, confirmed as progressive, or closed by an option.
#include "campanelctl_call.h"
#include "tests/support/controller_process.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <QFile>
#include <QTemporaryDir>

namespace test_cam_advance {

using namespace Qt::StringLiterals;
using namespace campanel::test;

class CliCamAdvanceTest : public QObject {
    Q_OBJECT

    // Returns options for a cam that ends here; its span is 50 mm.
    QString knotsTo(const QByteArray& endMm)
    {
        return u"--kind point_cam --knots-csv "_s +
               put(u"knots.csv"_s, "master_deg,slave_mm\n0,0\n90,20\n180,50\n270,20\n360," + endMm + '\n');
    }
    QString segmentsTo(const QByteArray& endMm)
    {
        const QByteArray values =
            "start_speed_mm_per_deg,start_acceleration_mm_per_deg2,end_speed_mm_per_deg,"
            "end_acceleration_mm_per_deg2,law_parameter1,law_parameter2\n";
        return u"--kind segment_cam --segments-csv "_s +
               put(u"segments.csv"_s, "from_deg,to_deg,motion,end_mm," + values + "0,180,quintic,50,,,,,,\n" +
                                          "180,360,quintic," + endMm + ",,,,,,\n");
    }
    QString put(const QString& name, const QByteArray& bytes) const
    {
        QFile file(m_directory.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("%s", qPrintable(file.errorString()));
        return file.fileName();
    }

    QTemporaryDir m_directory;

private slots:
    void figuresAgree_data()
    {
        QTest::addColumn<QByteArray>("endMm");
        QTest::addColumn<double>("advanceMm");
        QTest::newRow("0.8 %") << QByteArray("0.4") << 0.0;
        QTest::newRow("1 %") << QByteArray("0.5") << 0.0;
        QTest::newRow("1.2 %") << QByteArray("0.6") << 0.6;
        QTest::newRow("back") << QByteArray("-25") << -25.0;
    }
    void figuresAgree()
    {
        QFETCH(QByteArray, endMm);
        QFETCH(double, advanceMm);
        for (const QString& words : {knotsTo(endMm), segmentsTo(endMm)}) {
            const QString json = u" --format json "_s + words;
            const QJsonObject profile = call(u"profile --points 2"_s + json).json();
            QCOMPARE(profile[u"cycle"_s][u"distance_mm"_s].toDouble(), advanceMm);
            QCOMPARE(profile[u"advance_mm_per_cycle"_s].toDouble(-1), advanceMm);
            QCOMPARE(profile[u"advance_confirmed"_s], advanceMm == 0 ? QJsonValue() : QJsonValue(false));
            const QJsonObject table = call(u"table"_s + json).json();
            QCOMPARE(table[u"advance_mm_per_cycle"_s].toDouble(-1), advanceMm);
            QCOMPARE(table[u"pulses_per_cycle"_s][u"whole"_s].toDouble(-1), advanceMm * 10);
            const bool isKnots = words.contains(u"knots"_s);
            const QJsonObject ends = call((isKnots ? u"knots"_s : u"segments"_s) + json).json();
            QCOMPARE(ends[u"advance_mm"_s].toDouble(-1), advanceMm);
            QCOMPARE(ends[u"closing_error_mm"_s].toDouble(-1), endMm.toDouble() - advanceMm);
            QVERIFY(ends[isKnots ? u"smooth"_s : u"continuous"_s].toBool());
        }
    }

    void aRecipeKeepsTheConfirmation()
    {
        const Result made = call(u"recipe --progressive "_s + knotsTo("0.6"));
        QVERIFY2(made.code == Ok, made.complaint.constData());
        QCOMPARE(made.json()[u"program"_s][u"confirmed_advance_mm"_s].toDouble(), 0.6);
        const QString file = put(u"cam.json"_s, made.out);
        QCOMPARE(call(u"profile --points 2 --format json "_s + file).json()[u"advance_confirmed"_s],
                 QJsonValue(true));
        // Another advance is not confirmed.
        const QString scaled = u"profile --points 2 --format json --slave-scale 2 "_s + file;
        QCOMPARE(call(scaled).json()[u"advance_confirmed"_s], QJsonValue(false));
        const Result closed = call(u"recipe --close "_s + segmentsTo("25"));
        QVERIFY2(closed.code == Ok, closed.complaint.constData());
        QVERIFY(!closed.json()[u"program"_s].toObject().contains(u"confirmed_advance_mm"_s));
        const QString again = put(u"closed.json"_s, closed.out);
        QCOMPARE(call(u"table --format json "_s + again).json()[u"advance_mm_per_cycle"_s].toDouble(-1), 0.0);
    }

    void anUnconfirmedCamIsNotDownloaded()
    {
        ControllerProcess controller;
        const QString download = u"download --format json --port %1 "_s.arg(controller.port());
        const QString status = u"status --format json --port "_s + controller.port();
        const Result refused = call(download + knotsTo("0.6"));
        QCOMPARE(refused.code, int{Refused});
        QCOMPARE(
            refused.complaint,
            QByteArray("campanelctl: The axis advances by +0.6 mm in every cycle, and no travel limit stops "
                       "it. Add --progressive to confirm this, or --close to close the cam.\n"));
        QVERIFY(call(status).json()[u"program"_s].isNull());
        const Result sent = call(download + u"--progressive "_s + knotsTo("-0.6"));
        QVERIFY2(sent.code == Ok, sent.complaint.constData());
        QCOMPARE(sent.json()[u"advance_mm_per_cycle"_s].toDouble(), -0.6);
        QCOMPARE(call(status).json()[u"program"_s][u"advance_mm_per_cycle"_s].toDouble(), -0.6);
        const Result closed = call(download + u"--close "_s + segmentsTo("25"));
        QVERIFY2(closed.code == Ok, closed.complaint.constData());
        QCOMPARE(call(status).json()[u"program"_s][u"advance_mm_per_cycle"_s].toDouble(-1), 0.0);
        const Result nearly = call(download + segmentsTo("0.4"));
        QVERIFY2(nearly.code == Ok, nearly.complaint.constData());
    }

    void complaints()
    {
        for (const QString& option : {u"--progressive"_s, u"--close"_s}) {
            const Result cutter = call(u"recipe "_s + option);
            QCOMPARE(cutter.code, int{Usage});
            QCOMPARE(cutter.complaint, "campanelctl: " + option.toUtf8() + " applies to a cam only.\n");
        }
        QCOMPARE(call(u"recipe --close --progressive "_s + knotsTo("0.6")).code, int{Usage});
    }
};

CAMPANEL_TEST(CliCamAdvanceTest)

} // namespace test_cam_advance

#include "test_cam_advance.moc"
