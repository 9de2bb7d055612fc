// SPDX-License-Identifier: Apache-2.0
// campanelctl as a person calls it: the real program, its output, its exit code and its error line.
#include "app/store/recipes/recipe_file.h"
#include "campanelctl_call.h"
#include "modbus/line/rtu_client.h"
#include "modbus/map/register_document.h"
#include "profile/laws/laws.h"
#include "tests/support/controller_process.h"
#include "tests/support/places.h"
#include "tests/support/scripted_slave.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <QJsonArray>
#include <QTemporaryDir>

namespace test_cli {

using namespace campanel;
using namespace Qt::StringLiterals;
using namespace campanel::test;

class CliTest : public QObject {
    Q_OBJECT

private slots:
    void complaints_data();
    void complaints();
    void helpSuffices_data();
    void helpSuffices();
    void pulsesPerCycleAreExact_data();
    void pulsesPerCycleAreExact();
    void tableCsvAddsUp();
    void profileNumbers();
    void ratiosThatSuit();
    void lawsOfACutterAreRanked();
    void curvesAreDrawnPastABrokenLimit();
    void optionsReplaceInputs_data();
    void optionsReplaceInputs();
    void recipeFile();
    void damagedRecipeFile();
    void outputFile();
    void registerMap();
    void lawTable();
    void otherLocale();
    void lifeWithAController();
    void pinsOfTheMachine();
    void aRecipeSaysItsMaster();
    void olderController();
    void otherDevices_data();
    void otherDevices();
    void busyPort();

private:
    QTemporaryDir m_directory;
};

void CliTest::complaints_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("words");
    const auto row = [](const char* tag, const QString& arguments, Code code, const QString& words) {
        QTest::newRow(tag) << arguments.split(u' ', Qt::SkipEmptyParts) << static_cast<int>(code) << words;
    };
    row("no command", {}, Usage, u"--help"_s);
    row("unknown command", u"tabel"_s, Usage, u"\"tabel\""_s);
    row("unknown option", u"table --lenght 4"_s, Usage, u"lenght"_s);
    row("no number", u"table --rate fast"_s, Usage, u"--rate takes a number"_s);
    row("half a knife", u"table --knives 1.5"_s, Usage, u"whole number"_s);
    row("not finite", u"table --rate nan"_s, Usage, u"--rate"_s);
    row("three inputs", u"table --rate 60 --bag-length-mm 250 --film-speed-mm-per-s 250"_s, Usage,
        u"at most two"_s);
    row("three ratios", u"table --k 4,3,2"_s, Usage, u"four numbers"_s);
    row("gear without a number", u"table --gear 3/x"_s, Usage, u"5/2"_s);
    row("unknown law", u"table --law spline"_s, Usage, u"cubic"_s);
    row("law without parameters", u"table --law cubic --law-parameters 1"_s, Usage, u"0 numbers"_s);
    row("unknown format", u"table --format xml"_s, Usage, u"csv"_s);
    row("two recipes", u"table a.json b.json"_s, Usage, u"b.json"_s);
    row("points", u"profile --points 1"_s, Usage, u"2 to"_s);
    row("no port", u"status"_s, Usage, u"--port"_s);
    row("unknown permit", u"start --permit film,rain --port /dev/null"_s, Usage, u"rain"_s);
    row("strange parity", u"status --port /dev/null --parity X"_s, Usage, u"N, E or O"_s);
    row("no such baud rate", u"status --port /dev/null --baud 12345"_s, Usage, u"12345"_s);
    row("unit 0", u"status --port /dev/null --unit 0"_s, Usage, u"1 to 247"_s);
    row("unknown register", u"registers --read status.mood --port /dev/null"_s, Usage, u"status.mood"_s);
    row("name without --read", u"registers status.state"_s, Usage, u"--read"_s);
    row("a block", u"registers --read active --port /dev/null"_s, Usage, u"is a block of"_s);
    row("ratios do not descend", u"table --k 4,5,2,1.5"_s, Refused, u"descend"_s);
    row("bag too long", u"table --bag-length-mm 1500"_s, Refused, u"stroke"_s);
    row("bag out of range", u"table --bag-length-mm 5"_s, Refused, u"the allowed range is 10.0 to"_s);
    row("too fast", u"table --rate 500"_s, Refused, u"; the limit is"_s);
    row("absent recipe", u"table /nowhere/r.json"_s, File, u"/nowhere/r.json does not exist"_s);
    row("unwritable output", u"table -o /nowhere/t.txt"_s, File, u"/nowhere/t.txt"_s);
    row("absent port", u"status --port /dev/ttyNONE7"_s, Link, u"/dev/ttyNONE7 does not exist"_s);
    row("no serial port", u"status --port /dev/null"_s, Link, u"not a serial port"_s);
}

void CliTest::complaints()
{
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    QFETCH(QString, words);
    const Result result = call(arguments);
    QVERIFY2(result.code == code, result.complaint.constData());
    QVERIFY2(result.complaint.contains(words.toUtf8()), result.complaint.constData());
    QVERIFY2(result.complaint.startsWith("campanelctl: "), result.complaint.constData());
    QCOMPARE(result.complaint.count('\n'), 1);
    QVERIFY(result.out.isEmpty());
}

void CliTest::helpSuffices_data()
{
    QTest::addColumn<QString>("command");
    QTest::addColumn<QStringList>("words");
    QTest::newRow("overview") << QString()
                              << QStringList{u"profile"_s, u"table"_s,    u"laws"_s, u"download"_s,
                                             u"status"_s,  u"start"_s,    u"stop"_s, u"home"_s,
                                             u"save"_s,    u"registers"_s};
    QTest::newRow("profile") << u"profile"_s << QStringList{u"--points"_s, u"RECIPE.json"_s, u"--law"_s};
    QTest::newRow("table") << u"table"_s << QStringList{u"--slices"_s, u"10 to 2000, mm"_s, u"--format"_s};
    QTest::newRow("laws") << u"laws"_s << QStringList{u"--json"_s, u"--csv"_s, u"G(1)"_s};
    QTest::newRow("download") << u"download"_s
                              << QStringList{u"--verify"_s, u"--port"_s, u"--when-stopped"_s};
    QTest::newRow("status") << u"status"_s << QStringList{u"--baud"_s, u"--unit"_s};
    QTest::newRow("stop") << u"stop"_s << QStringList{u"--now"_s, u"not an emergency stop"_s};
    QTest::newRow("registers") << u"registers"_s << QStringList{u"--read"_s, u"--markdown"_s};
}

void CliTest::helpSuffices()
{
    QFETCH(QString, command);
    QFETCH(QStringList, words);
    const Result result =
        call(command.isEmpty() ? QStringList{u"--help"_s} : QStringList{command, u"--help"_s});
    QCOMPARE(result.code, int{Ok});
    for (const QString& word : words)
        QVERIFY2(result.out.contains(word.toUtf8()), result.out.constData());
    QVERIFY(result.out.contains("Exit codes: 0 done, 1 refused"));
}

void CliTest::pulsesPerCycleAreExact_data()
{
    QTest::addColumn<int>("slices");
    QTest::addColumn<int>("pulsesPerRev");
    QTest::addColumn<int>("knives");
    for (const int slices : {1, 2, 20, 60, 255})
        QTest::addRow("K 10000, N 1, %d slices", slices) << slices << 10000 << 1;
    for (const int slices : {1, 20, 60})
        QTest::addRow("K 10007, N 3, %d slices", slices) << slices << 10007 << 3;
}

void CliTest::pulsesPerCycleAreExact()
{
    QFETCH(int, slices);
    QFETCH(int, pulsesPerRev);
    QFETCH(int, knives);
    // A third of the stroke has space for a third of the bag.
    const Result result =
        call({u"table"_s, u"--bag-length-mm"_s, QString::number(knives == 1 ? 250 : 83), u"--rate"_s, u"60"_s,
              u"--knife-radius-mm"_s, u"60"_s, u"--gear"_s, u"1/1"_s, u"--k"_s, u"4,2.5,1.6667,1.3333"_s,
              u"--pulses-per-rev"_s, QString::number(pulsesPerRev), u"--knives"_s, QString::number(knives),
              u"--slices"_s, QString::number(slices), u"--format"_s, u"json"_s});
    QVERIFY2(result.code == Ok, result.complaint.constData());
    const QJsonObject table = result.json();
    const QJsonObject pulses = table[u"pulses_per_cycle"_s].toObject();
    QCOMPARE(pulses[u"whole"_s].toInt(), pulsesPerRev / knives);
    QCOMPARE(pulses[u"remainder"_s].toInt(), pulsesPerRev % knives);
    QCOMPARE(table[u"cycle_ticks"_s].toInt(), 8'000'000);
    int pulseSum = 0;
    int tickSum = 0;
    for (const QJsonValue& row : table[u"rows"_s].toArray()) {
        pulseSum += row[u"pulses"_s].toInt();
        tickSum += row[u"ticks"_s].toInt();
    }
    QCOMPARE(pulseSum, pulsesPerRev / knives);
    QCOMPARE(tickSum, 8'000'000);
}

void CliTest::tableCsvAddsUp()
{
    const Result result = call({u"table"_s, u"--format"_s, u"csv"_s});
    QCOMPARE(result.code, int{Ok});
    const QList<QByteArray> lines = result.out.trimmed().split('\n');
    QCOMPARE(lines.first(), QByteArray("row,time_s,frequency_hz,pulses,ticks"));
    int pulses = 0;
    for (const QByteArray& line : lines.mid(1)) {
        QCOMPARE(line.split(',').size(), 5);
        pulses += line.split(',')[3].toInt();
    }
    QCOMPARE(pulses, 10000);
}

void CliTest::profileNumbers()
{
    const Result result = call({u"profile"_s, u"--k"_s, u"4,2.5,1.6666666667,1.3333333333"_s, u"--format"_s,
                                u"json"_s, u"--points"_s, u"100"_s});
    QVERIFY2(result.code == Ok, result.complaint.constData());
    const QJsonObject cycle = result.json()[u"cycle"_s].toObject();
    QVERIFY(std::abs(cycle[u"base_speed_mm_per_s"_s].toDouble() - 445.3710) < 1e-3);
    QVERIFY(std::abs(cycle[u"weight_s"_s].toDouble() - 0.35) < 1e-6);
    QVERIFY(result.json()[u"feasible"_s].toBool());
    const QJsonArray times = result.json()[u"curves"_s][u"time_s"_s].toArray();
    QVERIFY(times.size() >= 100);
    QCOMPARE(times.last().toDouble(), 1.0);
}

// The check values of L = 150 mm at 200 bags/min, the figures that the papers name, and who decides the
// ratios.
void CliTest::ratiosThatSuit()
{
    const auto profileOf = [](const QString& options) {
        return call(u"profile --format json --bag-length-mm 150 --rate 200 "_s + options).json();
    };
    const auto near = [](const QJsonValue& value, double expected, double relative) {
        return std::abs(value.toDouble() - expected) <= relative * expected;
    };
    const QJsonObject gentle = profileOf(u"--ratios gentle"_s);
    QCOMPARE(gentle[u"ratios"_s][u"mode"_s].toString(), u"gentle"_s);
    QVERIFY(gentle[u"ratios"_s][u"k1"_s].toDouble() > 900);
    QVERIFY(near(gentle[u"peaks"_s][u"acceleration_mm_per_s2"_s], 23645, 1e-4));
    QVERIFY(near(gentle[u"fastest"_s][u"rate_bags_per_min"_s], 290.8, 1e-3));
    const QJsonObject cool = profileOf(u"--ratios cool"_s);
    QVERIFY(near(cool[u"peaks"_s][u"rms_acceleration_mm_per_s2"_s], 14186.94, 1e-4));
    const QJsonObject between = profileOf(u"--ratios between --ramp-position-percent 50"_s);
    QCOMPARE(between[u"ratios"_s][u"k1"_s], cool[u"ratios"_s][u"k1"_s]);
    const QJsonObject hand = profileOf({});
    QCOMPARE(hand[u"ratios"_s][u"mode"_s].toString(), u"hand"_s);
    QCOMPARE(hand[u"ratios"_s][u"k1"_s].toDouble(), 4.0);
    const QJsonObject cycle = hand[u"cycle"_s].toObject();
    const double base = cycle[u"base_speed_mm_per_s"_s].toDouble();
    QVERIFY(near(cycle[u"speed_ratio"_s], 500 / base, 1e-9)); // k0
    QVERIFY(near(cycle[u"base_circle_rad_per_s"_s], base / 60, 1e-9));
    const QJsonObject move = call(u"profile --kind position_move --format json"_s).json();
    QVERIFY(near(move[u"coefficients"_s][u"C3"_s], 6e-5, 1e-9));
    QVERIFY(near(move[u"coefficients"_s][u"C5"_s], 3.6e-11, 1e-9));

    QCOMPARE(call(u"profile --ratios fastest"_s).code, int{Usage});
    QCOMPARE(call(u"profile --kind press --ratios gentle"_s).code, int{Usage});
    // A new recipe begins gentle; the ratios of a file stay.
    const auto modeOf = [](const Result& result) {
        return result.json()[u"program"_s][u"ratios"_s].toString();
    };
    QCOMPARE(modeOf(call(u"recipe"_s)), u"gentle"_s);
    QCOMPARE(modeOf(call(u"recipe --k 5,2.5,1.6,1.2"_s)), u"hand"_s);
    const QString path = m_directory.filePath(u"hand.json"_s);
    QVERIFY(store::writeRecipe(program::Recipe{}, path).has_value());
    QCOMPARE(modeOf(call(QStringList{u"recipe"_s, path})), u"hand"_s);
    const Result followed = call({u"recipe"_s, path, u"--ratios"_s, u"slow"_s, u"--rate"_s, u"180"_s});
    QCOMPARE(modeOf(followed), u"slow"_s);
    QVERIFY(followed.json()[u"program"_s][u"k1"_s].toDouble() < 4);
}

void CliTest::lawsOfACutterAreRanked()
{
    const Result result = call(u"compare --bag-length-mm 150 --rate 200 --format json"_s);
    QVERIFY2(result.code == Ok, result.complaint.constData());
    const QJsonArray rows = result.json()[u"laws"_s].toArray();
    QCOMPARE(rows.size(), static_cast<qsizetype>(profile::laws().size()));
    double before = 0;
    for (const QJsonValue& row : rows) {
        QVERIFY(row[u"acceleration_mm_per_s2"_s].toDouble() >= before);
        before = row[u"acceleration_mm_per_s2"_s].toDouble();
        QVERIFY(row[u"rms_acceleration_mm_per_s2"_s].toDouble() < before);
    }
    const Result text = call(u"compare --bag-length-mm 150 --rate 200"_s);
    QCOMPARE(text.lines().size(), rows.size() + 1);
    QVERIFY(text.lines().first().startsWith("law"));
}

void CliTest::curvesAreDrawnPastABrokenLimit()
{
    const Result result = call({u"profile"_s, u"--rate"_s, u"400"_s, u"--format"_s, u"csv"_s});
    QCOMPARE(result.code, int{Refused});
    QVERIFY(result.out.startsWith("time_s,position_mm,velocity_mm_per_s"));
    QVERIFY(result.out.count('\n') > 1000);
    QVERIFY2(result.complaint.contains("Nearest possible value"), result.complaint.constData());
    QCOMPARE(result.complaint.count('\n'), 1);
}

void CliTest::optionsReplaceInputs_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("key");
    QTest::addColumn<double>("value");
    const auto row = [](const char* tag, const QString& arguments, const char* key, double value) {
        QTest::newRow(tag) << arguments.split(u' ') << QString::fromLatin1(key) << value;
    };
    row("length", u"--bag-length-mm 260"_s, "film_speed_mm_per_s", 260);
    row("rate", u"--rate 90"_s, "film_speed_mm_per_s", 375);
    row("film speed keeps the length", u"--film-speed-mm-per-s 500"_s, "rate_bags_per_min", 120);
    row("base speed keeps the length", u"--base-speed-mm-per-s 445"_s, "bag_length_mm", 250);
    row("two inputs", u"--film-speed-mm-per-s 300 --rate 60"_s, "bag_length_mm", 300);
    row("sync ratio", u"--sync-ratio 1.1"_s, "film_speed_mm_per_s", 275);
}

void CliTest::optionsReplaceInputs()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, key);
    QFETCH(double, value);
    const Result result = call(QStringList{u"profile"_s, u"--format"_s, u"json"_s} + arguments);
    QVERIFY2(result.code == Ok, result.complaint.constData());
    const double found = result.json()[u"cycle"_s][key].toDouble();
    QVERIFY2(std::abs(found - value) < 1e-6, qPrintable(QString::number(found)));
}

void CliTest::recipeFile()
{
    program::Recipe recipe;
    recipe.name = "饼干";
    recipe.cutter().bagLengthMm = 300;
    const QString path = m_directory.filePath(u"配方.json"_s);
    QVERIFY(store::writeRecipe(recipe, path).has_value());
    const Result result = call({u"profile"_s, path, u"--rate"_s, u"30"_s, u"--format"_s, u"json"_s});
    QVERIFY2(result.code == Ok, result.complaint.constData());
    QCOMPARE(result.json()[u"name"_s].toString(), u"饼干"_s);
    QCOMPARE(result.json()[u"cycle"_s][u"bag_length_mm"_s].toDouble(), 300.0);
    QCOMPARE(result.json()[u"cycle"_s][u"rate_bags_per_min"_s].toDouble(), 30.0);
}

void CliTest::damagedRecipeFile()
{
    const QString path = m_directory.filePath(u"damaged.json"_s);
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(store::toJson({}).left(200));
    file.close();
    const Result result = call({u"table"_s, path});
    QCOMPARE(result.code, int{File});
    QVERIFY2(result.complaint.contains("damaged at byte"), result.complaint.constData());
}

void CliTest::outputFile()
{
    const QString path = m_directory.filePath(u"table.csv"_s);
    const Result direct = call({u"table"_s, u"--format"_s, u"csv"_s});
    const Result filed = call({u"table"_s, u"--format"_s, u"csv"_s, u"-o"_s, path});
    QCOMPARE(filed.code, int{Ok});
    QVERIFY(filed.out.isEmpty());
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), direct.out);
}

void CliTest::registerMap()
{
    const Result json = call({u"registers"_s, u"--json"_s});
    QCOMPARE(json.code, int{Ok});
    QCOMPARE(json.json()[u"device_type"_s].toInt(), 0xCA3D);
    QCOMPARE(static_cast<std::size_t>(json.json()[u"registers"_s].toArray().size()),
             modbus::registers().size());
    QCOMPARE(call({u"registers"_s, u"--markdown"_s}).out,
             QByteArray::fromStdString(modbus::registersMarkdown()));
    QVERIFY(call({u"registers"_s}).out.contains("0x0102  status.state"));
}

void CliTest::lawTable()
{
    const Result csv = call({u"laws"_s, u"--csv"_s});
    QVERIFY2(csv.code == Ok, csv.complaint.constData());
    const QList<QByteArray> lines = csv.out.trimmed().split('\n');
    QCOMPARE(lines.first(), QByteArray("key,name,uses,parameters,cv,ca,cj,g_integral,strength,weakness"));
    QCOMPARE(static_cast<std::size_t>(lines.size()), profile::laws().size() + 1);
    const auto has = [&csv](const char* cells) { return csv.out.contains(cells); };
    QVERIFY(has("\ncubic,Cubic,\"speed; displacement\",,1.500000,6.000000,12.000000,0.500000,"));
    QVERIFY(has(",1.875000,5.773503,60.000000,0.500000,")); // quintic
    QVERIFY(has(",2.187500,7.513188,52.500000,0.500000,")); // 4-5-6-7
    QVERIFY(has(",1.570796,4.934802,15.503138,0.500000,")); // harmonic
    QVERIFY(has(",2.000000,6.283185,39.478418,0.500000,")); // cycloidal
    QVERIFY(has(",1.759603,5.527957,69.466357,0.500000,")); // modified sine
    QVERIFY(has(",2.000000,4.888124,61.425975,0.500000,")); // modified trapezoid
    QVERIFY(has(",2.000000,4.000000,inf,0.500000,"));       // parabolic
    QVERIFY(has("ramp_fraction = 0.25,1.333333,5.333333,inf,"));
    QVERIFY(has("\nhalf_modified_sine,Half modified sine,speed,,1.570796,9.869604,62.012553,0.568310,"));

    const Result json = call({u"laws"_s, u"--json"_s});
    QCOMPARE(call({u"laws"_s, u"--format"_s, u"json"_s}).out, json.out);
    const QJsonArray laws = json.json()[u"laws"_s].toArray();
    QCOMPARE(static_cast<std::size_t>(laws.size()), profile::laws().size());
    QCOMPARE(laws[7].toObject()[u"key"_s].toString(), u"parabolic"_s);
    QVERIFY(laws[7].toObject()[u"cj"_s].isNull());
    QCOMPARE(laws[9].toObject()[u"parameters"_s].toArray().size(), 2);
    for (const QJsonValue& law : laws) {
        QVERIFY(!law[u"strength"_s].toString().isEmpty());
        QVERIFY(!law[u"weakness"_s].toString().isEmpty());
    }
    const Result text = call({u"laws"_s});
    QVERIFY(text.out.contains("1.759603    5.527957   69.466357    0.500000"));
    QVERIFY(text.out.contains("22.29 %"));
}

void CliTest::otherLocale()
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(u"LC_ALL"_s, u"C"_s);
    process.setProcessEnvironment(environment);
    process.start(campanel::test::programPath("campanelctl"), {u"profile"_s});
    QVERIFY(process.waitForFinished());
    QCOMPARE(process.exitCode(), int{Ok});
    QVERIFY(process.readAllStandardOutput().contains("cycle.base_speed_mm_per_s         445.37"));
    QCOMPARE(process.readAllStandardError(), QByteArray());
}

void CliTest::lifeWithAController()
{
    const ControllerProcess controller;
    const QStringList port{u"--port"_s, controller.port()};
    const QStringList json{u"--format"_s, u"json"_s};
    const auto status = [&] { return call(QStringList{u"status"_s} + port + json).json(); };

    const QJsonObject fresh = status();
    QCOMPARE(fresh[u"state"_s].toString(), u"Idle"_s);
    QVERIFY(fresh[u"active_crc32"_s].isNull());
    QVERIFY(fresh[u"program"_s].isNull());
    QVERIFY(fresh[u"bag_length_mm"_s].isNull());
    const Result tooEarly = call(QStringList{u"start"_s} + port);
    QCOMPARE(tooEarly.code, int{Refused});
    QVERIFY2(tooEarly.complaint.contains("Download a recipe first"), tooEarly.complaint.constData());

    const Result loaded =
        call(QStringList{u"download"_s, u"--rate"_s, u"120"_s, u"--verify"_s} + port + json);
    QVERIFY2(loaded.code == Ok, loaded.complaint.constData());
    QCOMPARE(loaded.json()[u"generation"_s].toInt(), 1);
    QCOMPARE(call(QStringList{u"start"_s} + port).code, int{Ok});
    QTRY_COMPARE_WITH_TIMEOUT(status()[u"state"_s].toString(), u"Running"_s, 20'000);

    // A change during the run.
    const Result changed =
        call(QStringList{u"download"_s, u"--rate"_s, u"120"_s, u"--bag-length-mm"_s, u"260"_s} + port + json);
    QVERIFY2(changed.code == Ok, changed.complaint.constData());
    QCOMPARE(changed.json()[u"generation"_s].toInt(), 2);
    QCOMPARE(status()[u"program"_s][u"bag_length_mm"_s].toDouble(), 260.0);
    QCOMPARE(status()[u"active_crc32"_s], changed.json()[u"crc32"_s]);
    const Result moving = call(QStringList{u"download"_s, u"--when-stopped"_s} + port);
    QCOMPARE(moving.code, int{Refused});
    QVERIFY2(moving.complaint.contains("standstill"), moving.complaint.constData());

    QCOMPARE(call(QStringList{u"stop"_s} + port).code, int{Ok});
    QTRY_COMPARE_WITH_TIMEOUT(status()[u"state"_s].toString(), u"Ready"_s, 20'000);
    QCOMPARE(call(QStringList{u"save"_s} + port).code, int{Ok});
    QCOMPARE(status()[u"saved_crc32"_s], changed.json()[u"crc32"_s]);
    const Result read =
        call(QStringList{u"registers"_s, u"--read"_s, u"program.bag_length"_s, u"program.recipe_name"_s} +
             port + json);
    QCOMPARE(read.json()[u"program.bag_length"_s].toDouble(), 260.0);
    QCOMPARE(read.json()[u"program.recipe_name"_s].toString(), u"Biscuit 250"_s);
    const Result wrongUnit = call(QStringList{u"status"_s, u"--unit"_s, u"9"_s} + port);
    QCOMPARE(wrongUnit.code, int{Link});
    QVERIFY2(wrongUnit.complaint.contains("unit number"), wrongUnit.complaint.constData());
}

void CliTest::otherDevices_data()
{
    QTest::addColumn<int>("address");
    QTest::addColumn<int>("value");
    QTest::addColumn<QString>("words");
    QTest::newRow("another device") << 0 << 0x1234 << u"not a CamPanel controller"_s;
    QTest::newRow("a later map") << 1 << 2 << u"Update the older device"_s;
}

void CliTest::pinsOfTheMachine()
{
    const ControllerProcess controller({u"--pins"_s, u"emergency-stop,limit-reverse"_s});
    const QStringList port{u"--port"_s, controller.port()};
    const QStringList json{u"--format"_s, u"json"_s};
    const QJsonObject io = call(QStringList{u"status"_s} + port + json).json()[u"io"_s].toObject();
    QVERIFY(io[u"inputs"_s].toArray().contains(u"EmergencyStop"_s));
    QVERIFY(io[u"inputs"_s].toArray().contains(u"LimitReverse"_s));
    QVERIFY(!io[u"inputs"_s].toArray().contains(u"DriveAlarm"_s));
    QVERIFY(io[u"outputs"_s].toArray().contains(u"DriveEnable"_s));
    QVERIFY(io[u"outputs"_s].toArray().contains(u"TowerYellow"_s)); // red blinks
    QVERIFY(!io[u"outputs"_s].toArray().contains(u"Switch1"_s));
    QCOMPARE(io[u"torque_percent"_s].toDouble(-1), 0.0);
    QVERIFY(io[u"infeed_position_mm"_s].isNull()); // no packing machine yet
    const QJsonObject bare = call(QStringList{u"status"_s} + port + json).json();
    const QJsonObject line = bare[u"master"_s].toObject(); // it stands, and no run follows it
    QCOMPARE(line[u"counts"_s].toInt(-1), 0);
    QCOMPARE(line[u"speed_mm_per_s"_s].toDouble(-1), 0.0);
    const ControllerProcess without({u"--master-counts"_s, u"0"_s});
    const QStringList other{u"--port"_s, without.port()};
    QVERIFY(call(QStringList{u"status"_s} + other + json).json()[u"master"_s].isNull());
    QVERIFY(io[u"positions_kept"_s].isArray() && io[u"positions_kept"_s].toArray().isEmpty());
    const ControllerProcess kept({u"--positions-kept"_s});
    const QStringList status{u"status"_s, u"--port"_s, kept.port()};
    QCOMPARE(call(status + json).json()[u"io"_s][u"positions_kept"_s].toArray(),
             (QJsonArray{u"axis"_s, u"film"_s, u"infeed"_s}));
    QCOMPARE(call(QStringList{u"set"_s, u"parameter.switch1_on_angle"_s, u"90.5"_s} + port).code, int{Ok});
    QCOMPARE(call(QStringList{u"set"_s, u"parameter.switch1_on_angle"_s, u"360"_s} + port).code, int{Usage});
    const auto late = call(QStringList{u"set"_s, u"parameter.mark_dead_time"_s, u"50"_s} + port);
    QCOMPARE(late.code, int{Usage});
    QVERIFY2(
        late.complaint.contains("parameter.mark_dead_time cannot be 50; the allowed range is 0 to 20 ms."),
        late.complaint.constData());
    QCOMPARE(call(QStringList{u"set"_s, u"parameter.drive_enable"_s, u"0"_s} + port).code, int{Ok});
    const auto outputs = call(QStringList{u"status"_s} + port + json).json()[u"io"_s][u"outputs"_s].toArray();
    QVERIFY(!outputs.contains(u"DriveEnable"_s));
}

void CliTest::aRecipeSaysItsMaster()
{
    QTemporaryDir folder;
    const QString file = folder.filePath(u"recipe.json"_s);
    const Result made = call({u"recipe"_s, u"--for-master"_s, u"encoder"_s, u"--output"_s, file});
    QCOMPARE(made.code, int{Ok});
    QCOMPARE(call({u"recipe"_s, file}).json()[u"master"_s].toString(), u"encoder"_s);
    QCOMPARE(call(u"recipe --for-master film"_s).code, int{Usage});
    QCOMPARE(call(u"recipe --kind press --for-master clock"_s).code, int{Usage});

    const ControllerProcess controller;
    const QStringList port{u"--port"_s, controller.port()};
    const Result clock = call(QStringList{u"download"_s, file} + port);
    QCOMPARE(clock.code, int{Refused});
    QVERIFY2(clock.complaint.contains("the machine follows its clock"), clock.complaint.constData());
    QCOMPARE(call(QStringList{u"set"_s, u"master.source"_s, u"1"_s} + port).code, int{Ok});
    QCOMPARE(call(QStringList{u"download"_s, file} + port).code, int{Ok});
    const Result encoder = call(QStringList{u"download"_s, file, u"--for-master"_s, u"clock"_s} + port);
    QCOMPARE(encoder.code, int{Refused});
    QVERIFY2(encoder.complaint.contains("an encoder leads the machine"), encoder.complaint.constData());

    const ControllerProcess none({u"--master-counts"_s, u"0"_s});
    const Result missing = call({u"download"_s, file, u"--port"_s, none.port()});
    QCOMPARE(missing.code, int{Refused});
    QVERIFY2(missing.complaint.contains("no input for one"), missing.complaint.constData());
}

// A controller of register map 1.2 has no pins; all else is as ever.
void CliTest::olderController()
{
    QTemporaryDir folder;
    QFile faults(folder.filePath(u"faults"_s));
    QVERIFY(faults.open(QIODevice::WriteOnly));
    faults.write("map-version major=1 minor=2\n");
    faults.close();
    const ControllerProcess controller({u"--faults"_s, faults.fileName()});
    const Result result = call({u"status"_s, u"--port"_s, controller.port(), u"--format"_s, u"json"_s});
    QVERIFY2(result.code == Ok, result.complaint.constData());
    QCOMPARE(result.json()[u"identity"_s][u"register_map"_s].toString(), u"1.2"_s);
    QCOMPARE(result.json()[u"state"_s].toString(), u"Idle"_s);
    QVERIFY(result.json()[u"io"_s].isNull());
}

void CliTest::otherDevices()
{
    QFETCH(int, address);
    QFETCH(int, value);
    QFETCH(QString, words);
    campanel::test::ScriptedSlave device;
    device.setRegister(static_cast<std::uint16_t>(address), static_cast<std::uint16_t>(value));
    for (const QString& command : {u"status"_s, u"start"_s, u"download"_s}) {
        const Result result = call({command, u"--port"_s, QString::fromStdString(device.port())});
        QCOMPARE(result.code, int{Link});
        QVERIFY2(result.complaint.contains(words.toUtf8()), result.complaint.constData());
    }
    QCOMPARE(device.writes(), 0);
}

void CliTest::busyPort()
{
    campanel::test::ScriptedSlave device;
    modbus::LinkSettings settings;
    settings.port = device.port();
    modbus::RtuClient owner(settings);
    QVERIFY(owner.open().has_value());
    const Result result = call({u"status"_s, u"--port"_s, QString::fromStdString(device.port())});
    QCOMPARE(result.code, int{Link});
    QVERIFY2(result.complaint.contains("Another program is using port"), result.complaint.constData());
}

CAMPANEL_TEST(CliTest)

} // namespace test_cli

#include "test_cli.moc"
