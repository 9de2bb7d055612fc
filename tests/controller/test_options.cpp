// SPDX-License-Identifier: Apache-2.0
// The command line of campanel-controller: every number of the simulated machine reaches its own member,
// within its range, and is in the help.
#include "ctl_registers.h"
#include "input_pins.h"
#include "line_statements.h"
#include "machine_options.h"
#include "options.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <getopt.h>
#include <set>
#include <string>
#include <vector>

namespace test_options {

using namespace campanel::controller;

namespace {

tl::expected<Options, Ending> parse(std::vector<std::string> words)
{
    words.insert(words.begin(), "campanel-controller");
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    optind = 0; // restarts getopt
    const auto count = static_cast<int>(arguments.size());
    arguments.push_back(nullptr);
    return parseOptions(count, arguments.data());
}

std::vector<double> values(MachineOptions machine)
{
    std::vector<double> values;
    for (const MachineOption& option : machineOptions())
        values.push_back(option.member(machine));
    return values;
}

} // namespace

class TestOptions : public QObject {
    Q_OBJECT

private slots:
    // The oldest map that it can be is the first whose later registers are marked with their version.
    void mapMinorIsOneThatItKnows()
    {
        QCOMPARE(parse({})->mapMinor, std::uint16_t{0});
        QCOMPARE(parse({"--map-minor", "4"})->mapMinor, std::uint16_t{4});
        QVERIFY(parse({"--map-minor", std::to_string(CTL_MAP_MINOR)}).has_value());
        for (const std::string& wrong :
             {std::string("3"), std::to_string(CTL_MAP_MINOR + 1), std::string("x")})
            QVERIFY2(!parse({"--map-minor", wrong}).has_value(), wrong.c_str());
    }

    void eachNumberReachesItsOwnMember_data()
    {
        QTest::addColumn<int>("index");
        int index = 0;
        for (const MachineOption& option : machineOptions())
            QTest::newRow(option.name) << index++;
    }
    void eachNumberReachesItsOwnMember()
    {
        QFETCH(int, index);
        const auto at = static_cast<std::size_t>(index);
        const MachineOption& option = machineOptions()[at];
        const std::string name = "--" + std::string(option.name);
        const std::vector<double> before = values({});
        QVERIFY(before[at] >= option.minimum && before[at] <= option.maximum);
        for (const double value : {option.minimum, option.maximum, (option.minimum + option.maximum) / 4}) {
            const auto options = parse({name, QByteArray::number(value, 'g', 17).toStdString()});
            QVERIFY(options.has_value());
            std::vector<double> expected = before;
            expected[at] = value;
            QVERIFY(values(options->machine) == expected);
        }
        const double beyond = option.maximum + 1;
        for (const std::string& wrong : {std::to_string(beyond), std::to_string(option.minimum - 1),
                                         std::string("nan"), std::string("1x"), std::string()}) {
            const auto refused = parse({name, wrong});
            QVERIFY2(!refused.has_value(), wrong.c_str());
            QCOMPARE(refused.error().exitCode, 2);
            QVERIFY2(refused.error().text.find(name + " cannot be '" + wrong + "'") != std::string::npos,
                     refused.error().text.c_str());
        }
    }

    void numbersAreWhatTheirNamesSay()
    {
        const auto options = parse({"--film-slip",
                                    "0.1",
                                    "--film-stretch",
                                    "0.01",
                                    "--film-stretch-step",
                                    "-0.003",
                                    "--film-stretch-step-after",
                                    "40",
                                    "--film-misplaced",
                                    "-12",
                                    "--mark-noise",
                                    "0.2",
                                    "--marks-missing",
                                    "0.02",
                                    "--marks-false",
                                    "0.03",
                                    "--mark-distance",
                                    "903",
                                    "--print-error",
                                    "0.004",
                                    "--product-length",
                                    "120"});
        QVERIFY(options.has_value());
        const FilmOptions& film = options->machine.film;
        QCOMPARE(film.slipMm, 0.1);
        QCOMPARE(film.stretch, 0.01);
        QCOMPARE(film.stretchStep, -0.003);
        QCOMPARE(film.stretchStepM, 40.0);
        QCOMPARE(film.misplacedMm, -12.0);
        QCOMPARE(film.markNoiseMm, 0.2);
        QCOMPARE(film.marksMissing, 0.02);
        QCOMPARE(film.marksFalse, 0.03);
        QCOMPARE(film.markDistanceMm, 903.0);
        QCOMPARE(film.printError, 0.004);
        const auto more = parse({"--product-length", "120", "--product-length-scatter", "3",
                                 "--product-scatter", "4", "--product-lay-slip", "0.4", "--product-eye-noise",
                                 "0.3", "--product-missing", "0.05", "--product-misplaced", "0.06"});
        QVERIFY(more.has_value());
        const ProductOptions& products = more->machine.products;
        QCOMPARE(products.lengthMm, 120.0);
        QCOMPARE(products.lengthScatterMm, 3.0);
        QCOMPARE(products.scatterMm, 4.0);
        QCOMPARE(products.laySlipMm, 0.4);
        QCOMPARE(products.eyeNoiseMm, 0.3);
        QCOMPARE(products.missing, 0.05);
        QCOMPARE(products.misplaced, 0.06);
    }

    void positionsAreKeptFromTheIndexMark()
    {
        QVERIFY(!parse({})->keepsPositions);
        const auto options = parse({"--positions-kept"});
        QVERIFY(options && options->keepsPositions);
        QCOMPARE(options->machine.startAngleDegrees, 0.0);
    }

    void theLineHasAnEncoder()
    {
        QCOMPARE(parse({})->machine.shaft.counts, 10'000u);
        QCOMPARE(parse({})->machine.shaft.speedMmPerS, 0.0);
        QCOMPARE(parse({"--master-counts", "2500"})->machine.shaft.counts, 2'500u);
        QCOMPARE(parse({"--master-counts", "0"})->machine.shaft.counts, 0u);
        for (const char* wrong : {"3", "-1", "1000001", "x", ""})
            QVERIFY2(!parse({"--master-counts", wrong}).has_value(), wrong);
    }

    void theLineIsMoved()
    {
        ShaftOptions options;
        LineShaft none(options);
        QVERIFY(!applyLineStatement("start 100", none));
        options.counts = 10'000;
        LineShaft shaft(options);
        const auto present = [&shaft] { return shaft.options(); };
        QVERIFY(applyLineStatement("start", shaft));
        QCOMPARE(present().speedMmPerS, 250.0);
        QVERIFY(applyLineStatement("start -20.5", shaft));
        QCOMPARE(present().speedMmPerS, -20.5);
        QVERIFY(applyLineStatement("slip 0.1", shaft));
        QCOMPARE(present().slip, 0.1);
        QVERIFY(applyLineStatement("lose 7", shaft));
        QCOMPARE(present().lost, 7u);
        QVERIFY(applyLineStatement("swap on", shaft));
        QVERIFY(present().isReversed);
        QVERIFY(applyLineStatement("noise on", shaft));
        QVERIFY(present().noise > 0.0);
        const auto counts = shaft.counts();
        QVERIFY(applyLineStatement("jump", shaft));
        QCOMPARE(shaft.counts(), counts + 5'000);
        for (const char* wrong : {"", "start x", "start 1e9", "start nan", "stop 1", "slip", "slip 1.5",
                                  "lose -1", "swap", "swap 2", "swap  on", "jump on", "halt"})
            QVERIFY2(!applyLineStatement(wrong, shaft), wrong);
        QVERIFY(applyLineStatement("swap off", shaft) && applyLineStatement("noise off", shaft));
        QVERIFY(applyLineStatement("stop", shaft));
        QVERIFY(!present().isReversed);
        QCOMPARE(present().noise, 0.0);
        QCOMPARE(present().speedMmPerS, 0.0);
    }

    void pinsAreNamed()
    {
        const auto options = parse({"--pins", "limit-reverse,drive-alarm"});
        QVERIFY(options.has_value());
        QCOMPARE(options->machine.inputs,
                 1u << CTL_INPUT_BIT_LIMIT_REVERSE | 1u << CTL_INPUT_BIT_DRIVE_ALARM);
        for (const char* wrong : {"", "limit", "drive-alarm,", ",drive-alarm", "index-mark"})
            QVERIFY2(!parse({"--pins", wrong}).has_value(), wrong);
        QVERIFY(pinNames().starts_with("drive-alarm, emergency-stop, limit-forward, limit-reverse"));
        const auto statement = parsePinStatement("emergency-stop off");
        QVERIFY(statement);
        QCOMPARE(statement->bit, CTL_INPUT_BIT_EMERGENCY_STOP);
        QVERIFY(!statement->isOn);
        QVERIFY(parsePinStatement("limit-forward on")->isOn);
        for (const char* wrong :
             {"", "drive-alarm", "drive-alarm ", "drive-alarm  on", "drive-alarm on ", "x on"})
            QVERIFY2(!parsePinStatement(wrong), wrong);
    }

    void noTwoOptionsShareAMember()
    {
        MachineOptions machine;
        std::set<const double*> members;
        for (const MachineOption& option : machineOptions())
            members.insert(&option.member(machine));
        QCOMPARE(members.size(), machineOptions().size());
    }

    void helpNamesEachWithRangeAndDefault()
    {
        const auto help = parse({"--help"});
        QVERIFY(!help.has_value());
        QCOMPARE(help.error().exitCode, 0);
        const std::string& text = help.error().text;
        for (const MachineOption& option : machineOptions())
            QVERIFY2(text.find("\n  --" + std::string(option.name) + " ") != std::string::npos, option.name);
        QVERIFY(
            text.find("--film-slip MM       standard deviation of the film's slip per bag, 0..10 (0.03)\n") !=
            std::string::npos);
        QVERIFY(text.find("  --seed N ") < text.find("  --film-slip MM "));
        QVERIFY(text.find("  --drive-rated-torque NM ") < text.find("  --faults FILE "));
    }
};

CAMPANEL_TEST(TestOptions)

} // namespace test_options

#include "test_options.moc"
