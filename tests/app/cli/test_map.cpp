// SPDX-License-Identifier: Apache-2.0
// campanelctl map: the regime map as CSV, JSON and picture, and the jaws in other commands.
#include "campanelctl_call.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace test_map {

using namespace Qt::StringLiterals;
using namespace campanel::test;

class TestMap : public QObject {
    Q_OBJECT

private slots:
    void rowsAgreeWithTheProfile();
    void jsonHasLinesAndPaperLengths();
    void pictureIsAPng();
    void refusalsNameTheWay_data();
    void refusalsNameTheWay();
    void recipeFileKeepsBoth();
};

void TestMap::rowsAgreeWithTheProfile()
{
    const QString jaws = u" --contact-angle-deg 20 --min-seal-time-ms 30"_s;
    const Result map = call(u"map --lengths 5 --from-mm 50 --to-mm 450"_s + jaws);
    QVERIFY2(map.code == Ok, map.complaint.constData());
    const QList<QByteArray> rows = map.lines();
    QCOMPARE(rows.first(), QByteArray("bag_length_mm,rate_bags_per_min,limited_by"));
    QCOMPARE(rows[1], QByteArray("50,0,jaw_window"));
    QCOMPARE(rows.size(), 8); // both sides of the shortest possible bag as well
    int compared = 0;
    for (const QByteArray& row : rows.mid(1)) {
        const QList<QByteArray> cells = row.split(',');
        if (cells[1] == "0" || cells[0].contains('.'))
            continue;
        const Result profile = call(u"profile --format json --rate 20 --bag-length-mm "_s +
                                    QString::fromLatin1(cells[0]) + jaws);
        const QJsonObject fastest = profile.json()[u"fastest"_s].toObject();
        QCOMPARE(fastest[u"rate_bags_per_min"_s].toDouble(), cells[1].toDouble());
        QCOMPARE(fastest[u"limited_by"_s].toString().toLatin1(), cells[2]);
        ++compared;
    }
    QCOMPARE(compared, 4);
}

void TestMap::jsonHasLinesAndPaperLengths()
{
    const Result result = call(u"map --format json --contact-angle-deg 20 --k 4,2.5,1.66666667,1.33333333"_s);
    QVERIFY2(result.code == Ok, result.complaint.constData());
    const QJsonObject map = result.json();
    const auto near = [&](const QString& key, double value) {
        return std::abs(map[key].toDouble() - value) < 0.02;
    };
    QVERIFY(near(u"jaw_length_mm"_s, 104.72));
    QVERIFY(near(u"jaw_length_with_margin_mm"_s, 115.19));
    QVERIFY(near(u"equal_speed_length_mm"_s, 376.99));
    QVERIFY(near(u"dwell_length_mm"_s, 733.04));
    QCOMPARE(map[u"paper_lengths"_s].toArray().size(), 15);
    QCOMPARE(map[u"paper_lengths"_s][14][u"bag_length_mm"_s].toDouble(), 460.0);
    QVERIFY(map[u"points"_s].toArray().size() >= 200);
    QVERIFY(std::abs(map[u"recipe"_s][u"seal_time_ms"_s].toDouble() - 83.7758) < 1e-3);
    QVERIFY(map[u"recipe"_s][u"feasible"_s].toBool());
}

void TestMap::pictureIsAPng()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"map.png"_s);
    const Result result = call({u"map"_s, u"--format"_s, u"png"_s, u"-o"_s, path});
    QVERIFY2(result.code == Ok, result.complaint.constData());
    QCOMPARE(result.complaint, QByteArray());
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    QVERIFY(bytes.startsWith("\x89PNG\r\n\x1a\n"));
    QVERIFY(bytes.contains("IEND"));
    QCOMPARE(call(u"map --format=png"_s).out, bytes); // the same on standard output
}

void TestMap::refusalsNameTheWay_data()
{
    QTest::addColumn<QString>("arguments");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("sentence");
    const auto row = [](const char* tag, const QString& arguments, Code code, const QString& sentence) {
        QTest::newRow(tag) << arguments << static_cast<int>(code) << sentence;
    };
    row("window", u"table --bag-length-mm 100 --contact-angle-deg 20"_s, Refused,
        u"The jaws need a sync window of 22° of the knife; at 0.400 s (144°) the window has only 19.1°. "
        "Nearest possible value: Ratios 4 / 2.5988 / 1.6255 / 1.3333, or Bag length 115.2 mm."_s);
    row("jaws that never fit", u"table --bag-length-mm 150 --knives 4 --contact-angle-deg 150"_s, Refused,
        u"the window has only 28.6°. Nearest possible value: Jaw contact angle 26.6°."_s);
    row("seal time", u"table --rate 300 --contact-angle-deg 20 --min-seal-time-ms 50"_s, Refused,
        u"Seal time would be 16.8 ms at 0.080 s (144°); the film needs 50 ms. Nearest possible value: Rate "
        "100.5 bags/min"_s);
    row("seal time that no rate keeps", u"table --contact-angle-deg 20 --min-seal-time-ms 10000"_s, Refused,
        u"the film needs 10000 ms. Nearest possible value: Min. seal time 83 ms."_s);
    row("no contact angle", u"table --min-seal-time-ms 50"_s, Refused, u"Enter the angle in Settings"_s);
    row("angle out of range", u"map --contact-angle-deg 181"_s, Refused, u"the allowed range is 0.0 to"_s);
    row("ratios", u"map --k 4,2,3,1.2"_s, Refused, u"descend"_s);
    row("press", u"map --kind press"_s, Usage, u"rotary cutter"_s);
    row("lengths", u"map --lengths 1"_s, Usage, u"--lengths takes a whole number from 2 to"_s);
    row("range", u"map --from-mm 300 --to-mm 200"_s, Usage, u"two rising bag lengths"_s);
}

void TestMap::refusalsNameTheWay()
{
    QFETCH(QString, arguments);
    QFETCH(int, code);
    QFETCH(QString, sentence);
    const Result result = call(arguments);
    QVERIFY2(result.code == code, result.complaint.constData());
    QVERIFY2(QString::fromUtf8(result.complaint).contains(sentence), result.complaint.constData());
}

// An older file has neither: no jaws, no seal time.
void TestMap::recipeFileKeepsBoth()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"recipe.json"_s);
    QCOMPARE(call({u"recipe"_s, u"--contact-angle-deg"_s, u"20.5"_s, u"--min-seal-time-ms"_s, u"40"_s,
                   u"-o"_s, path})
                 .code,
             int{Ok});
    const QJsonObject written = call({u"recipe"_s, path}).json();
    QCOMPARE(written[u"machine"_s][u"contact_angle_deg"_s].toDouble(), 20.5);
    QCOMPARE(written[u"program"_s][u"min_seal_time_ms"_s].toDouble(), 40.0);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadWrite));
    QByteArray older = file.readAll();
    for (const char* line :
         {"        \"contact_angle_deg\": 20.5,\n", "        \"min_seal_time_ms\": 40,\n"}) {
        QVERIFY2(older.contains(line), older.constData());
        older.replace(line, "");
    }
    QVERIFY(file.resize(0) && file.seek(0) && file.write(older) == older.size());
    file.close();
    const QJsonObject read = call({u"recipe"_s, path}).json();
    QCOMPARE(read[u"machine"_s][u"contact_angle_deg"_s].toDouble(-1), 0.0);
    QCOMPARE(read[u"program"_s][u"min_seal_time_ms"_s].toDouble(-1), 0.0);
}

CAMPANEL_TEST(TestMap)

} // namespace test_map

#include "test_map.moc"
