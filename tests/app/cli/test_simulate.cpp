// SPDX-License-Identifier: Apache-2.0
// campanelctl simulate as a person calls it: rows, summary, table, errors and exit codes.
#include "campanelctl_call.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <QJsonArray>
#include <QTemporaryDir>

namespace test_simulate {

using namespace Qt::StringLiterals;
using namespace campanel::test;

class CliSimulateTest : public QObject {
    Q_OBJECT

private slots:
    void complaints_data()
    {
        QTest::addColumn<QString>("words");
        QTest::addColumn<int>("code");
        QTest::addColumn<QByteArray>("complaint");
        const auto row = [](const char* tag, const QString& words, Code code, const char* complaint) {
            QTest::newRow(tag) << u"simulate "_s + words << static_cast<int>(code) << QByteArray(complaint);
        };
        row("no bags", u"--bags 0"_s, Usage, "--bags takes a number from 1 to");
        row("half a bag", u"--bags 1.5"_s, Usage, "whole number");
        row("seed", u"--seed x"_s, Usage, "--seed takes");
        row("slip", u"--slip -1"_s, Usage, "--slip takes a number from 0 to 10");
        row("share", u"--marks-missing 2"_s, Usage, "--marks-missing");
        row("not a number", u"--stretch nan"_s, Usage, "--stretch");
        row("no parameter", u"--set status.state=1"_s, Usage, "\"status.state\" is not a parameter");
        row("no value", u"--set parameter.anti_cut"_s, Usage, "--set takes a parameter and its value");
        row("out of range", u"--set parameter.cut_clearance=99"_s, Usage,
            "the allowed range is 0.5 to 60 mm");
        row("another kind", u"--kind press"_s, Usage, "rotary cutter");
        row("lengths alone", u"--lengths 100"_s, Usage, "--lengths requires --table");
        row("bad lengths", u"--table --lengths 100,x"_s, Usage, "--lengths takes numbers");
        row("table without tracking", u"--table --no-tracking"_s, Usage, "cannot be combined with --table");
        row("table of what cannot be", u"--table --bags 20 --lengths 2000"_s, Refused,
            "2000 mm at 60 bags/min");
        row("too fast", u"--bag-length-mm 150 --rate 300"_s, Refused,
            "Nearest possible value: Rate 227.0 bags/min");
        row("no marks", u"--marks-missing 1"_s, Refused, "Check film and mark sensor");
        row("product too long", u"--product-length 260"_s, Refused, "longer bag");
        row("sensor too far", u"--bag-length-mm 100 --set parameter.mark_distance=5000"_s, Refused,
            "refuses to start");
        row("no products", u"--products-missing 1 --save-film"_s, Refused, "film or knife stood");
        row("absent recipe", u"/nowhere/r.json"_s, File, "/nowhere/r.json");
        row("unwritable", u"--bags 10 -o /nowhere/bags.csv"_s, File, "/nowhere/bags.csv");
    }
    void complaints()
    {
        QFETCH(QString, words);
        QFETCH(int, code);
        QFETCH(QByteArray, complaint);
        const Result result = call(words);
        QCOMPARE(result.code, code);
        QVERIFY2(result.complaint.contains(complaint), result.complaint.constData());
        QVERIFY(result.complaint.startsWith("campanelctl: "));
        QCOMPARE(result.complaint.count('\n'), 1);
    }

    // Only the bags on standard output, the summary on standard error.
    void bagsAsCsv()
    {
        const Result result = call(u"simulate --bags 50 --format csv"_s);
        QCOMPARE(result.code, int{Ok});
        const QList<QByteArray> lines = result.lines();
        QCOMPARE(lines.size(), 51);
        QVERIFY(lines[0].startsWith("bag,time_s,length_mm,lengths,deviation_mm,"));
        const qsizetype columns = lines[0].split(',').size();
        for (qsizetype i = 1; i < lines.size(); ++i) {
            const QList<QByteArray> cells = lines[i].split(',');
            QCOMPARE(cells.size(), columns);
            QCOMPARE(cells[0].toInt(), int(i));
            QVERIFY(std::abs(cells[2].toDouble() - 250 * cells[3].toInt() - cells[4].toDouble()) < 1e-6);
        }
        QVERIFY(result.complaint.contains("deviation_mm.mean"));
    }

    void sameSeedSameBytes()
    {
        const QString words = u"simulate --bags 200 --products-misplaced 0.1 --format csv --seed "_s;
        const QByteArray first = call(words + u'7').out;
        QVERIFY(!first.isEmpty());
        QCOMPARE(call(words + u'7').out, first);
        QVERIFY(call(words + u'8').out != first);
    }

    void summary()
    {
        const Result result =
            call(u"simulate --bags 2000 --products-misplaced 0.05 --format json --with-bags"_s);
        QCOMPARE(result.code, int{Ok});
        const QJsonObject object = result.json();
        QCOMPARE(object[u"bags"_s].toInt(), 2000);
        QCOMPARE(object[u"end"_s].toString(), u"all bags cut"_s);
        QVERIFY(object[u"deviation_mm"_s][u"largest"_s].toDouble() < 0.2);
        QCOMPARE(object[u"tolerance"_s][u"share_within"_s].toDouble(), 1.0);
        const QJsonObject cuts = object[u"cuts"_s].toObject();
        QVERIFY(cuts[u"skipped"_s].toInt() > 0);
        QCOMPARE(cuts[u"skipped_product_across"_s].toInt(), cuts[u"skipped"_s].toInt());
        QCOMPARE(cuts[u"skipped_unexplained"_s].toInt(-1), 0);
        QCOMPARE(cuts[u"through_product"_s].toInt(-1), 0);
        QCOMPARE(cuts[u"phase_lost"_s].toInt(-1), 0);
        int skipped = 0;
        for (const QJsonValue& bag : object[u"bag_list"_s].toArray())
            skipped += bag[u"lengths"_s].toInt() - 1;
        QCOMPARE(skipped, cuts[u"skipped"_s].toInt());
    }

    // The summary is still printed and contains the end of the run.
    void alarmEndsTheRun()
    {
        const Result result = call(u"simulate --marks-missing 1 --format json"_s);
        QCOMPARE(result.code, int{Refused});
        QVERIFY(result.json()[u"end"_s].toString().contains(u"consecutive marks were missing"_s));
        QCOMPARE(result.json()[u"alarms"_s][u"MarksLost"_s].toInt(), 1);
        QVERIFY(result.json()[u"bags"_s].toInt() < 20);
        const Result goesOn = call(u"simulate --marks-missing 1 --format json --bags 100 --go-on"_s);
        QCOMPARE(goesOn.code, int{Ok});
        QCOMPARE(goesOn.json()[u"bags"_s].toInt(), 100);
        QVERIFY(goesOn.json()[u"alarms"_s][u"MarksLost"_s].toInt() > 5);
    }

    void parametersTakeEffect()
    {
        const Result far = call(u"simulate --bags 100 --no-tracking --format json"_s);
        QVERIFY(far.json()[u"deviation_mm"_s][u"mean"_s].toDouble() < -0.2);
        const Result trimmed = call(u"simulate --bags 100 --format json --set parameter.mark_tracking=0 "
                                    "--set parameter.length_trim=1"_s);
        const double by = trimmed.json()[u"deviation_mm"_s][u"mean"_s].toDouble() -
                          far.json()[u"deviation_mm"_s][u"mean"_s].toDouble();
        QVERIFY2(std::abs(by - 1) < 0.02, qPrintable(QString::number(by)));
        QVERIFY(call(u"simulate --bags 300 --products-missing 0.1 --save-film --format json"_s)
                    .json()[u"film_saved_m"_s]
                    .toDouble() > 2);
    }

    void table()
    {
        const Result result = call(u"simulate --table --bags 100 --lengths 100,249,260 --format csv"_s);
        QCOMPARE(result.code, int{Ok});
        const QList<QByteArray> lines = result.lines();
        QCOMPARE(lines.size(), 1 + 3 * 2 + 1); // 100 mm is faster with the gentlest ratios
        QVERIFY(lines[0].startsWith("set_length_mm,paper_deviation_mm,rate_bags_per_min,mean_mm,"));
        QVERIFY(lines[1].startsWith("100,0.1,60,"));
        QVERIFY(lines[2].startsWith("100,0.1,205,")); // 205.5 is the largest
        QVERIFY(lines[3].startsWith("100,0.1,263,,,"));
        QVERIFY(lines[5].startsWith("249,-0.2,300,"));
        QVERIFY(lines[6].startsWith("260,,60,"));
        for (qsizetype i = 1; i < lines.size(); ++i) {
            const QList<QByteArray> cells = lines[i].split(',');
            QVERIFY(std::abs(cells[5].toDouble()) <= 0.2);                          // largest
            QVERIFY(std::abs(cells[8].toDouble()) > 0.2 || i == 3);                 // mean without tracking
            QVERIFY(!cells[11].isEmpty() && std::abs(cells[11].toDouble()) <= 0.2); // gentle
        }
        const Result text = call(u"simulate --table --bags 50 --lengths 300"_s);
        QCOMPARE(text.lines().size(), 2 + 2);
    }

    // The controller's own records of the marks are all that is known of the sensor.
    // One part that comes to the same place each time, at two speeds; and usual products.
    void measuresTheEyesDeadTimes_data()
    {
        QTest::addColumn<double>("delayMs");
        QTest::addColumn<double>("scatterMm");
        QTest::addColumn<bool>("isOffered");
        QTest::newRow("1 ms") << 1.0 << 0.0 << true;
        QTest::newRow("2.5 ms") << 2.5 << 0.0 << true;
        QTest::newRow("1 ms, 2 mm of scatter") << 1.0 << 2.0 << false;
    }
    void measuresTheEyesDeadTimes()
    {
        QFETCH(double, delayMs);
        QFETCH(double, scatterMm);
        QFETCH(bool, isOffered);
        const auto result = call(
            u"simulate --rate 240 --bags 400 --change-rate-every 50 --format json --sensor-off-later-ms 0.7 "
            "--sensor-compensation-ms learned --sensor-delay-ms %1 "
            "--product-scatter %2"_s.arg(delayMs)
                .arg(scatterMm));
        QCOMPARE(result.code, int{Ok});
        const QJsonObject eye = result.json()[u"eye"_s].toObject();
        for (const auto& [edge, trueMs] :
             {std::pair(u"begin"_s, delayMs), std::pair(u"end"_s, delayMs + 0.7)}) {
            const QJsonObject found = eye[edge].toObject();
            const double margin = found[u"standard_deviation_ms"_s].toDouble();
            QCOMPARE(found[u"offered"_s].toBool(), isOffered);
            QVERIFY2(margin > 0 && (margin <= 0.2) == isOffered, qPrintable(QString::number(margin)));
            const double error = found[u"dead_time_ms"_s].toDouble() - trueMs;
            QVERIFY2(std::abs(error) <= 3 * margin, qPrintable(QString::number(error)));
        }
    }

    // An encoder leads at half of the rate, which is full speed of one program and half of the other's.
    void changesTheRateBehindAnEncoder()
    {
        const Result result =
            call(u"simulate --bag-length-mm 460 --rate 240 --bags 300 --change-rate-every 50 "
                 "--master encoder --master-ripple 0.01 --format json"_s);
        QCOMPARE(result.code, int{Ok});
        const QJsonObject summary = result.json();
        QCOMPARE(summary[u"starts"_s].toInt(), 1);
        QCOMPARE(summary[u"tolerance"_s][u"bags_outside"_s].toInt(), 0);
        QCOMPARE(summary[u"cuts"_s][u"phase_lost"_s].toInt(), 0);
        QVERIFY(summary[u"bags_start_up_scrap"_s].toInt() <= 4);
        QVERIFY(summary[u"deviation_mm"_s][u"standard_deviation"_s].toDouble() < 0.06);
        // Four seconds for eight bags, whichever program cuts them.
        QVERIFY(std::abs(summary[u"simulated_s"_s].toDouble() - 150.0) < 10.0);
    }

    void learnsTheDeadTime()
    {
        const QString words = u"simulate --bag-length-mm 300 --rate 300 --bags 600 --change-rate-every 50 "
                              "--slip-per-acceleration 0.05 --format json --sensor-delay-ms %1 "
                              "--sensor-compensation-ms learned"_s;
        for (const double delayMs : {0.0, 0.5, 2.0}) {
            const Result result = call(words.arg(delayMs));
            QCOMPARE(result.code, int{Ok});
            const QJsonObject learned = result.json()[u"learned"_s].toObject();
            const double error = learned[u"mark_dead_time_ms"_s].toDouble() - delayMs;
            const double margin = learned[u"standard_deviation_ms"_s].toDouble();
            QVERIFY2(margin > 0.0 && margin < 0.1, qPrintable(QString::number(margin)));
            QVERIFY2(std::abs(error) < 3 * margin, qPrintable(QString::number(error)));
        }
        QCOMPARE(call(u"simulate --bags 5 --sensor-compensation-ms learnt"_s).code, int{Usage});
        // The fit knows neither of edges that scatter nor of film that stretches four times as much.
        const Result rough =
            call(u"simulate --bag-length-mm 300 --rate 300 --bags 5000 --change-rate-every 50 "
                 "--slip-per-acceleration 0.05 --format json --sensor-delay-ms 2 "
                 "--sensor-compensation-ms learned --sensor-scatter-ms 0.1 --stretch 0.02"_s);
        const double found = rough.json()[u"learned"_s][u"mark_dead_time_ms"_s].toDouble();
        QVERIFY2(std::abs(found - 2.0) < 0.05, qPrintable(QString::number(found)));
    }

    void outputFile()
    {
        const QTemporaryDir directory;
        const QString path = directory.filePath(u"bags.csv"_s);
        const Result result = call(u"simulate --bags 10 --format csv -o "_s + path);
        QCOMPARE(result.code, int{Ok});
        QVERIFY(result.out.isEmpty());
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll().count('\n'), 11);
    }
};

CAMPANEL_TEST(CliSimulateTest)

} // namespace test_simulate

#include "test_simulate.moc"
