// SPDX-License-Identifier: Apache-2.0
// campanelctl with every kind of program: law comparison, intervals, knots, profiles and tables, and its
// errors for contradictory inputs.
#include "app/store/recipes/recipe_file.h"
#include "campanelctl_call.h"
#include "profile/laws/laws.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <QJsonArray>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>

namespace test_kinds {

using namespace campanel;
using namespace Qt::StringLiterals;
using namespace campanel::test;

namespace {

bool isNear(double value, double expected, double within)
{
    return std::abs(value - expected) <= within;
}

} // namespace

class CliKindsTest : public QObject {
    Q_OBJECT

private slots:
    void profileOfEachKind_data();
    void profileOfEachKind();
    void optionsReplaceInputs_data();
    void optionsReplaceInputs();
    void tableOfEachKind_data();
    void tableOfEachKind();
    void intervalsOfThePaper();
    void refusedErrorNamesOneThatIsKept();
    void intervalsOfAMove();
    void lawsCompared();
    void profileAgreesWithTheTable_data();
    void profileAgreesWithTheTable();
    void numbersThatAreNone();
    void motorAndShaftOfAKnife();
    void knotsAsCsv();
    void knotsThatCannotBe();
    void knotsRepaired();
    void backwardCamHasASmallError();
    void recipeFileOfEachKind();
    void complaints_data();
    void complaints();

private:
    QString put(const QString& name, const QByteArray& bytes) const
    {
        QFile file(m_directory.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("%s", qPrintable(file.errorString()));
        return file.fileName();
    }

    QTemporaryDir m_directory;
};

void CliKindsTest::profileOfEachKind_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("kind");
    QTest::addColumn<double>("timeS");
    QTest::addColumn<double>("motorRpm");
    QTest::addColumn<double>("acceleration");
    // 15/8 S/T and 10/sqrt(3) S/T^2 of the quintic, 100 mm a revolution.
    QTest::newRow("quintic") << u"--kind position_move"_s << u"position_move"_s << 1.0 << 6750.0 << 34641.016;
    // pi/2 dV/T of the half modified sine.
    QTest::newRow("half modified sine")
        << u"--kind speed_move"_s << u"speed_move"_s << 1.0 << 5400.0 << 14137.167;
    QTest::newRow("point cam, half the speed")
        << u"--kind point_cam --master-rate-rev-per-min 30"_s << u"point_cam"_s << 2.0 << 49.0 << 420.0;
    QTest::newRow("press") << u"--kind press"_s << u"press"_s << 8.877 << 480.0 << 2000.0;
}

void CliKindsTest::profileOfEachKind()
{
    QFETCH(QString, words);
    QFETCH(QString, kind);
    QFETCH(double, timeS);
    QFETCH(double, motorRpm);
    QFETCH(double, acceleration);
    const Result result = call(u"profile --format json --points 50 "_s + words);
    QVERIFY2(result.code == Ok, result.complaint.constData());
    const QJsonObject object = result.json();
    QCOMPARE(object[u"kind"_s].toString(), kind);
    QVERIFY(object[u"feasible"_s].toBool());
    QVERIFY2(isNear(object[u"cycle"_s][u"time_s"_s].toDouble(), timeS, 1e-3), result.out.constData());
    QVERIFY2(isNear(object[u"peaks"_s][u"motor_rpm"_s].toDouble(), motorRpm, 1e-2), result.out.constData());
    QVERIFY2(isNear(object[u"peaks"_s][u"acceleration_mm_per_s2"_s].toDouble(), acceleration, 1e-2),
             result.out.constData());
    const QJsonValue torque = object[u"peaks"_s][u"torque_nm"_s]; // a press has no inertia in its recipe
    QVERIFY(kind == u"press"_s ? torque.isNull() : torque.toDouble() > 0.02);
    const QJsonArray times = object[u"curves"_s][u"time_s"_s].toArray();
    QVERIFY(times.size() >= 50);
    QCOMPARE(times.last().toDouble(), object[u"cycle"_s][u"time_s"_s].toDouble());
    const Result csv = call(u"profile --format csv --points 50 "_s + words);
    QCOMPARE(csv.lines().size(), times.size() + 1);
    QVERIFY(csv.out.startsWith("time_s,position_mm,"));
    QVERIFY(call(u"profile "_s + words).out.contains("kind "));
}

void CliKindsTest::optionsReplaceInputs_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("key");
    QTest::addColumn<double>("value");
    QTest::newRow("distance") << u"--kind position_move --distance-mm -500"_s << u"distance_mm"_s << -500.0;
    QTest::newRow("time") << u"--kind position_move --time-s 2.5"_s << u"time_s"_s << 2.5;
    QTest::newRow("over a distance") << u"--kind speed_move --duration over_distance --distance-mm 9000"_s
                                     << u"distance_mm"_s << 9000.0;
    QTest::newRow("end speed") << u"--kind speed_move --end-speed-mm-per-s -800"_s << u"end_speed_mm_per_s"_s
                               << -800.0;
    QTest::newRow("K") << u"--kind point_cam --pulses-per-rev 2500"_s << u"pulses_per_mm"_s << 25.0;
    QTest::newRow("feed") << u"--kind press --feed-mm-per-motor-rev 8"_s << u"pulses_per_mm"_s << 125.0;
    // 1/2 Ca of the modified sine: T = sqrt(5.527957 S / 50000).
    QTest::newRow("fastest") << u"--kind position_move --duration fastest --law modified_sine "
                                "--distance-mm 1000 --max-torque-nm 100"_s
                             << u"time_s"_s << 0.3325;
}

void CliKindsTest::optionsReplaceInputs()
{
    QFETCH(QString, words);
    QFETCH(QString, key);
    QFETCH(double, value);
    const Result result = call(u"profile --format json --points 2 "_s + words);
    QVERIFY2(result.code == Ok, result.complaint.constData());
    const double found = result.json()[u"cycle"_s][key].toDouble();
    QVERIFY2(isNear(found, value, 1e-3), qPrintable(QString::number(found, 'g', 12)));
}

void CliKindsTest::tableOfEachKind_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<QByteArray>("header");
    QTest::addColumn<int>("rows");
    QTest::addColumn<int>("column");
    QTest::addColumn<double>("last");
    QTest::newRow("move as points") << u"--kind position_move"_s
                                    << QByteArray("row,time_s,position_mm,position_pulses,slope_pulses")
                                    << 101 << 3 << 60000.0;
    QTest::newRow("cam") << u"--kind point_cam --cam-points 200"_s
                         << QByteArray("row,time_s,position_mm,position_pulses,slope_pulses") << 201 << 3
                         << 0.0;
    QTest::newRow("press") << u"--kind press"_s << QByteArray("row,speed_hz,end_pulses,force_n,time_ms") << 5
                           << 1 << 8000.0;
}

void CliKindsTest::tableOfEachKind()
{
    QFETCH(QString, words);
    QFETCH(QByteArray, header);
    QFETCH(int, rows);
    QFETCH(int, column);
    QFETCH(double, last);
    const Result csv = call(u"table --format csv "_s + words);
    QVERIFY2(csv.code == Ok, csv.complaint.constData());
    QCOMPARE(csv.lines().first(), header);
    QCOMPARE(csv.lines().size(), rows + 1);
    QCOMPARE(csv.lines().last().split(',')[column].toDouble(), last);
    const QJsonObject json = call(u"table --format json "_s + words).json();
    QCOMPARE(json[u"rows"_s].toArray().size(), rows);
    QCOMPARE(json[u"rows_used"_s].toInt(), rows);
    QVERIFY(json[u"cycle_time_s"_s].toDouble() > 0);
    QVERIFY(json[u"errors"_s].isObject());
    QVERIFY(call(u"table "_s + words).out.contains("crc32"));
}

// CamMov(10, 50, 800, 40000) of the paper on intervals.
void CliKindsTest::intervalsOfThePaper()
{
    const Result result = call(u"intervals --cam-mov 10,50,800,40000 --format json"_s);
    QVERIFY2(result.code == Ok, result.complaint.constData());
    const QJsonObject object = result.json();
    QVERIFY(isNear(object[u"published"_s][u"total_ms"_s].toDouble(), 21.44208, 1e-6));
    QVERIFY(isNear(object[u"corrected"_s][u"total_ms"_s].toDouble(), 21.2890625, 1e-3));
    QCOMPARE(object[u"theory_total_ms"_s].toDouble(), 21.2890625);
    QCOMPARE(object[u"published"_s][u"pulse_times_ms"_s].toArray().size(), 10);
    const Result text = call(u"intervals --cam-mov 10,50,800,40000"_s);
    QVERIFY2(text.out.contains("published 21.44208 ms"), text.out.constData());
}

void CliKindsTest::refusedErrorNamesOneThatIsKept()
{
    const Result none = call(u"intervals --speed-error-mm-per-s 0"_s);
    QCOMPARE(none.code, int(Refused));
    static const QRegularExpression kept(u"not possible, but ([0-9.]+) mm/s is"_s);
    const QString allowed = kept.match(QString::fromUtf8(none.complaint)).captured(1);
    QVERIFY2(!allowed.isEmpty(), none.complaint.constData());
    const Result taken = call(u"intervals --speed-error-mm-per-s "_s + allowed);
    QVERIFY2(taken.code == Ok, taken.complaint.constData());
}

// Whole pulses, and the rows' own times add up to the table's.
void CliKindsTest::intervalsOfAMove()
{
    const Result result = call(u"intervals --kind position_move --distance-mm 600 --format json "
                               "--speed-error-mm-per-s 20"_s);
    QVERIFY2(result.code == Ok, result.complaint.constData());
    const QJsonObject object = result.json();
    double pulses = 0;
    double time = 0;
    double before = 0;
    for (const QJsonValue& each : object[u"rows"_s].toArray()) {
        const QJsonArray row = each.toArray();
        const double first = row[1].toDouble();
        const double last = row[2].toDouble();
        const double ramp = first == last ? 0 : std::abs(last - first) / row[3].toDouble();
        pulses += row[0].toDouble();
        time += ramp + (row[0].toDouble() - ramp * (first + last) / 2) / last;
        QVERIFY(before == 0 || isNear(first, before, 1e-9));
        before = last;
    }
    QCOMPARE(pulses, 6000.0);
    QCOMPARE(object[u"pulses"_s].toInt(), 6000);
    QVERIFY2(isNear(time, object[u"time_s"_s].toDouble(), 1e-4), qPrintable(QString::number(time, 'g', 12)));
    QVERIFY(object[u"errors"_s][u"speed_mm_per_s"_s].toDouble() <= 20);
    const Result slower = call(u"intervals --kind position_move --distance-mm 600 --published --format json "
                               "--speed-error-mm-per-s 20"_s);
    QVERIFY(isNear(slower.json()[u"time_s"_s].toDouble(), 1.00663296 * object[u"time_s"_s].toDouble(), 5e-3));
    const Result csv = call(u"intervals --kind speed_move --format csv --speed-error-mm-per-s 100"_s);
    QCOMPARE(csv.lines().first(), QByteArray("pulses,first_hz,last_hz,acceleration_hz_per_s"));
    // 9000 mm/s at 10 pulses per mm, at the real clock.
    QVERIFY2(isNear(csv.lines().last().split(',')[2].toDouble(), 90'000, 0.01), csv.out.constData());
    const Result table = call(u"table --kind position_move --execution intervals --format csv"_s);
    double sum = 0;
    for (const QByteArray& line : table.lines().mid(1))
        sum += line.split(',')[1].toDouble();
    QCOMPARE(sum, 60'000.0);
}

void CliKindsTest::profileAgreesWithTheTable_data()
{
    QTest::addColumn<QString>("inputs");
    QTest::addColumn<bool>("isFeasible");
    QTest::newRow("ramps longer than a row holds") << u"--max-acceleration-mm-per-s2 70"_s << false;
    QTest::newRow("ramps that a row just holds") << u"--max-acceleration-mm-per-s2 80"_s << true;
    QTest::newRow("a speed between two places of the grid")
        << u"--max-motor-rpm 480 --return-speed-mm-per-s 80.04"_s << true;
    QTest::newRow("one pulse for two stages")
        << u"--pulses-per-rev 1 --approach-position-mm 61 --probe-end-mm 64"_s << false;
}

void CliKindsTest::profileAgreesWithTheTable()
{
    QFETCH(QString, inputs);
    QFETCH(bool, isFeasible);
    for (const QString& command : {u"profile"_s, u"table"_s}) {
        const Result result = call(command + u" --kind press --format json "_s + inputs);
        QVERIFY2(result.code == (isFeasible ? Ok : Refused), result.complaint.constData());
    }
}

// Unknown or unlimited: a word in text, null in JSON.
void CliKindsTest::numbersThatAreNone()
{
    for (const QString& words :
         {u"profile"_s, u"profile --kind press"_s, u"profile --base-speed-mm-per-s 0 --rate 60"_s,
          u"profile --kind position_move --law harmonic"_s, u"compare"_s,
          u"compare --kind position_move"_s}) {
        const Result text = call(words);
        QVERIFY2(text.code == Ok, text.complaint.constData());
        static const QRegularExpression none(u"\\b(nan|inf)\\b"_s);
        QVERIFY2(!none.match(QString::fromUtf8(text.out)).hasMatch(), text.out.constData());
    }
    static const QRegularExpression noTorque(u"\\npeaks.torque_nm +--\\n"_s);
    QVERIFY(noTorque.match(QString::fromUtf8(call(u"profile"_s).out)).hasMatch());
    static const QRegularExpression steps(u"\\nharmonic .* steps +0.0"_s);
    QVERIFY(steps.match(QString::fromUtf8(call(u"compare --kind position_move"_s).out)).hasMatch());
    const QJsonObject object = call(u"profile --format json"_s).json();
    QVERIFY(object[u"peaks"_s][u"torque_nm"_s].isNull() && object[u"peaks"_s][u"rms_torque_nm"_s].isNull());
    QVERIFY(object[u"vibration"_s][u"seal_error_mm"_s].isNull());
    QVERIFY(!object[u"curves"_s].toObject().contains(u"torque_nm"_s));
}

// The check numbers of torque and vibration, and the refusals of their limits.
void CliKindsTest::motorAndShaftOfAKnife()
{
    const QString words = u"profile --bag-length-mm 150 --rate 200 --inertia-kg-cm2 10 --friction-nm 0.1 "
                          "--natural-frequency-hz 25"_s;
    const QJsonObject object = call(words + u" --format json"_s).json();
    const QJsonObject peaks = object[u"peaks"_s].toObject();
    // The peak is that of the curve between its samples; friction helps where the knife slows down, which
    // has the largest acceleration.
    const double peak = peaks[u"torque_nm"_s].toDouble();
    double sampled = 0;
    for (const QJsonValue& each : object[u"curves"_s][u"torque_nm"_s].toArray())
        sampled = std::max(sampled, std::abs(each.toDouble()));
    QVERIFY2(peak >= sampled && peak < sampled + 2e-5, QByteArray::number(peak - sampled));
    QVERIFY(peak < 1e-3 * peaks[u"acceleration_mm_per_s2"_s].toDouble() / 60 + 0.1);
    QVERIFY(std::abs(object[u"vibration"_s][u"seal_error_mm"_s].toDouble() - 1.72) < 0.005);
    QCOMPARE(object[u"curves"_s][u"torque_nm"_s].toArray().size(),
             object[u"curves"_s][u"time_s"_s].toArray().size());
    QVERIFY(call(words + u" --format csv"_s)
                .out.startsWith("time_s,position_mm,velocity_mm_per_s,"
                                "acceleration_mm_per_s2,jerk_mm_per_s3,"
                                "frequency_hz,torque_nm\n"));
    for (const auto& [limit, sentence] :
         {std::pair{u" --max-torque-nm 0.2"_s, "Motor torque would reach"},
          std::pair{u" --rated-torque-nm 0.2"_s, "RMS torque would be"},
          std::pair{u" --natural-frequency-hz 3"_s, "The cycle repeats at 3.3 Hz"}}) {
        const Result refused = call(words + limit);
        QCOMPARE(refused.code, Refused);
        QVERIFY2(refused.complaint.contains(sentence), refused.complaint.constData());
    }
    const Result compared = call(u"compare --kind position_move --natural-frequency-hz 2 --format json"_s);
    const QJsonArray laws = compared.json()[u"laws"_s].toArray();
    for (const QJsonValue& law : laws) {
        const double strokes = law[u"residual_mm"_s].toDouble() / 6000; // f T = 2
        if (law[u"law"_s].toString() == u"quintic")
            QVERIFY(std::abs(strokes - 0.02887) < 1e-5);
        if (law[u"law"_s].toString() == u"cycloidal")
            QVERIFY(strokes < 1e-5);
    }
    for (const QString& cam : {u"point_cam"_s, u"segment_cam"_s}) {
        const QString profile = u"profile --format json --kind "_s + cam;
        QVERIFY(call(profile).json()[u"vibration"_s][u"cycle_error_mm"_s].isNull());
        const double soft = call(profile + u" --natural-frequency-hz 4"_s)
                                .json()[u"vibration"_s][u"cycle_error_mm"_s]
                                .toDouble();
        const double stiff = call(profile + u" --natural-frequency-hz 40"_s)
                                 .json()[u"vibration"_s][u"cycle_error_mm"_s]
                                 .toDouble();
        // Far above the cycle the load lags by a / w^2 alone: a hundredth, but for the free vibration.
        QVERIFY2(stiff > 0 && soft > 20 * stiff, qPrintable(QString::number(soft / stiff)));
    }
}

void CliKindsTest::lawsCompared()
{
    const Result text = call(u"compare --kind speed_move"_s);
    QVERIFY2(text.code == Ok, text.complaint.constData());
    const auto speedLaws = std::ranges::count_if(profile::laws(), &profile::Law::isSpeedLaw);
    QCOMPARE(text.lines().size(), speedLaws + 1);
    QVERIFY(text.out.contains("\nhalf_modified_sine       1.000    5400.0"));
    const Result json = call(u"compare --kind position_move --max-motor-rpm 6000 --format json"_s);
    int feasible = 0;
    double harmonic = 0;
    for (const QJsonValue& each : json.json()[u"laws"_s].toArray()) {
        feasible += each[u"feasible"_s].toBool() ? 1 : 0;
        if (each[u"law"_s].toString() == u"harmonic"_s)
            harmonic = each[u"motor_rpm"_s].toDouble();
        QVERIFY(each[u"law"_s].toString() != u"half_modified_sine"_s);
    }
    QVERIFY(isNear(harmonic, 3600 * std::acos(-1.0) / 2, 1e-6));
    QVERIFY(feasible >= 1 && feasible < 11);
}

void CliKindsTest::knotsAsCsv()
{
    const QByteArray text = "master_deg,slave_mm\n0,0\n60,10\n120.5,40.25\n200,30\n360,0\n";
    const QString file = put(u"knots.csv"_s, text);
    const Result result = call(u"knots --kind point_cam --format csv --knots-csv "_s + file);
    QVERIFY2(result.code == Ok, result.complaint.constData());
    QCOMPARE(result.out, text);
    const Result profile = call(u"profile --kind point_cam --format json --knots-csv "_s + file);
    QCOMPARE(profile.code, int{Ok});
    double highest = 0;
    for (const QJsonValue& each : profile.json()[u"curves"_s][u"position_mm"_s].toArray())
        highest = std::max(highest, each.toDouble());
    QVERIFY(highest > 40 && highest < 45);
}

void CliKindsTest::knotsThatCannotBe()
{
    const auto complaintOf = [this](const QByteArray& bytes) {
        const QString path = put(u"wrong.csv"_s, bytes);
        return call({u"table"_s, u"--kind"_s, u"point_cam"_s, u"--knots-csv"_s, path}).complaint;
    };
    const QString text = u"\ufeffmaster_deg,slave_mm\n0,0\n"_s;
    const QByteArray utf16(reinterpret_cast<const char*>(text.utf16()), text.size() * 2);
    QCOMPARE(complaintOf(utf16), "campanelctl: The file " + m_directory.filePath(u"wrong.csv"_s).toUtf8() +
                                     " is not UTF-8 text. Save the file as CSV in UTF-8.\n");
    const QByteArray knots("master_deg,slave_mm\n0,0\n90,20\n180,50\n270,20\n360,1e306\n");
    QCOMPARE(complaintOf(knots),
             QByteArray(
                 "campanelctl: Knot 5 at 1E+306 mm is out of range; the nearest position is 1000000 mm.\n"));
}

void CliKindsTest::knotsRepaired()
{
    const QString file = put(u"open.csv"_s, "master_deg,slave_mm\n0,0\n90,20\n180,50\n270,20\n360,0.2\n");
    const QString words = u"knots --kind point_cam --ends natural --format %1 --knots-csv "_s + file;
    const QJsonObject open = call(words.arg(u"json"_s)).json();
    QVERIFY(!open[u"smooth"_s].toBool());
    QCOMPARE(open[u"closing_error_mm"_s].toDouble(), 0.2);
    const QJsonObject closed = call(words.arg(u"json"_s) + u" --repair"_s).json();
    QVERIFY(closed[u"smooth"_s].toBool());
    QVERIFY(call(words.arg(u"csv"_s) + u" --repair"_s).out.endsWith("\n360,0\n"));
}

void CliKindsTest::backwardCamHasASmallError()
{
    for (const QString& rate : {u"60"_s, u"-60"_s}) {
        const QJsonObject table =
            call(u"table --kind point_cam --format json --phase-deg 30 --master-rate-rev-per-min "_s + rate)
                .json();
        const double error = table[u"errors"_s][u"position_pulses"_s].toDouble(-1);
        QVERIFY2(error >= 0 && error < 0.1, qPrintable(QString::number(error)));
    }
}

void CliKindsTest::recipeFileOfEachKind()
{
    for (const program::KindInfo& kind : program::kinds()) {
        program::Recipe recipe = program::defaultRecipe(kind.kind);
        recipe.name = "From a file";
        const QString path = m_directory.filePath(u"kind.json"_s);
        QVERIFY(store::writeRecipe(recipe, path));
        const Result result = call(u"profile --format json --points 2 "_s + path);
        QVERIFY2(result.code == Ok, result.complaint.constData());
        QCOMPARE(result.json()[u"name"_s].toString(), u"From a file"_s);
        QCOMPARE(result.json()[u"kind"_s].toString().toStdString(), std::string(kind.key));
        const Result other = call(u"profile --kind press "_s + path);
        QCOMPARE(other.code, int{kind.key == "press" ? Ok : Usage});
    }
}

void CliKindsTest::complaints_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("complaint");
    const auto row = [](const char* tag, const QString& words, Code code, const QString& complaint) {
        QTest::newRow(tag) << words << static_cast<int>(code) << complaint;
    };
    row("unknown kind", u"table --kind gearbox"_s, Usage, u"rotary_cutter, position_move"_s);
    row("a field of another kind", u"table --kind point_cam --distance-mm 5"_s, Usage,
        u"--distance-mm does not apply to a program of kind point_cam"_s);
    row("a knife for a press", u"profile --kind press --knives 2"_s, Usage, u"--knives does not apply"_s);
    row("a press without options", u"profile --press-speed-mm-per-s 10"_s, Usage, u"rotary_cutter"_s);
    row("a choice of another kind", u"table --kind press --duration fastest"_s, Usage, u"--duration"_s);
    row("no such choice", u"table --kind position_move --duration over_distance"_s, Usage,
        u"given_time, fastest"_s);
    row("gear of a move", u"table --kind position_move --gear 3/2"_s, Usage, u"rotary cutter"_s);
    row("ratios of a cam", u"table --kind point_cam --k 4,3,2,1.5"_s, Usage, u"rotary cutter"_s);
    row("law of a press", u"table --kind press --law cubic"_s, Usage, u"has no law"_s);
    row("law of the wrong sort", u"table --kind position_move --law half_modified_sine"_s, Usage,
        u"Unknown displacement law"_s);
    row("knots of a move", u"table --kind speed_move --knots-csv x"_s, Usage, u"point cam"_s);
    row("absent knots", u"knots --kind point_cam --knots-csv /nowhere/k.csv"_s, File, u"/nowhere/k.csv"_s);
    row("no knots", u"knots"_s, Usage, u"--kind point_cam"_s);
    row("laws of a cam", u"compare --kind point_cam"_s, Usage, u"--kind position_move"_s);
    row("three numbers", u"intervals --cam-mov 10,50,800"_s, Usage, u"four numbers"_s);
    row("no pulses", u"intervals --cam-mov 0,50,800,40000"_s, Usage, u"above zero"_s);
    row("half a pulse", u"intervals --cam-mov 0.5,50,800,40000"_s, Usage, u"whole"_s);
    row("not to be made of intervals", u"intervals --kind point_cam"_s, Refused, u"campanelctl: "_s);
    row("too fast", u"table --kind position_move --time-s 0.5"_s, Refused, u"limit"_s);
    row("no distance", u"table --kind position_move --distance-mm 0"_s, Refused, u"istance"_s);
    row("stages out of order", u"table --kind press --press-position-mm 80"_s, Refused, u"80"_s);
    row("ramp too long for a row", u"table --kind press --max-acceleration-mm-per-s2 70"_s, Refused,
        u"Return speed needs a ramp of 1143 ms"_s);
    row("forces out of order", u"table --kind press --probe-force-n 9000"_s, Refused, u"9000"_s);
    row("half a point", u"table --kind position_move --cam-points 100.5"_s, Usage, u"whole number"_s);
}

void CliKindsTest::complaints()
{
    QFETCH(QString, words);
    QFETCH(int, code);
    QFETCH(QString, complaint);
    const Result result = call(words);
    QVERIFY2(result.code == code, result.complaint.constData());
    QVERIFY2(result.complaint.contains(complaint.toUtf8()), result.complaint.constData());
    QCOMPARE(result.complaint.count('\n'), 1);
    QVERIFY(result.out.isEmpty());
}

CAMPANEL_TEST(CliKindsTest)

} // namespace test_kinds

#include "test_kinds.moc"
