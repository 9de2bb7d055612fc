// SPDX-License-Identifier: Apache-2.0
// Recipe to registers and back.
#include "app/program/differences.h"
#include "app/program/program_image.h"
#include "app/program/register_fields.h"

#include "modbus/map/codec.h"
#include "modbus/map/crc32.h"
#include "profile/cutter/limits.h"
#include "profile/laws/laws.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <numeric>
#include <random>

namespace test_program {

using namespace campanel;
using namespace campanel::program;
using profile::Field;

class ProgramTest : public QObject {
    Q_OBJECT

private slots:
    void defaultRecipe();
    void randomRecipesTripIdentically();
    void everyPairOfInputsIsKept();
    void lawAndItsParametersAreKept();
    void longNameIsCutBetweenCharacters();
    void refusals_data();
    void refusals();
    void valueWithoutRoomInItsRegister();
    void rowsBeyondTheBankAreRefused();
    void headersThatCannotBeShown_data();
    void headersThatCannotBeShown();
    void differencesAreByField();
    void controllerLimitsTheMachine();
    void everyRegisterFieldExists();
};

void ProgramTest::defaultRecipe()
{
    const auto image = buildProgram(Recipe{});
    QVERIFY2(image.has_value(), image ? "" : describe(image.error()).c_str());
    const modbus::RegisterReader header(image->registers, 0);
    QCOMPARE(header.u32("bank.cycle_pulses"), 10000u);
    QCOMPARE(header.u32("bank.cycle_ticks"), 8'000'000u);
    QCOMPARE(header.u32("bank.divisor"), 1u);
    QCOMPARE(header.u32("bank.remainder"), 0u);
    QCOMPARE(header.u16("program.pinned"), std::uint16_t{3});
    QCOMPARE(header.physical("program.bag_length"), 250.0);
    QCOMPARE(header.physical("program.film_speed"), 250.0);
    QVERIFY(std::abs(header.physical("program.base_speed") - 445.371) < 0.01);
    QVERIFY(std::abs(header.physical("bank.sync_start") - 144.0) < 0.011);
    QVERIFY(std::abs(header.physical("bank.sync_end") - 216.0) < 0.011);
    QVERIFY(std::abs(header.physical("bank.cut_angle") - 180.0) < 0.011);
    QCOMPARE(image->crc, modbus::crc32OfRegisters(image->registers));
    const std::size_t rows = header.u16("bank.row_count");
    QCOMPARE(rows, image->stepTable().rows.size());
    QCOMPARE(image->registers.size(), modbus::bankHeaderRegisters + modbus::rowRegisters * rows);
    unsigned pulses = 0;
    for (std::size_t i = 0; i < rows; ++i)
        pulses += image->registers[modbus::bankHeaderRegisters + modbus::rowRegisters * i];
    QCOMPARE(pulses, 10000u);
}

void ProgramTest::randomRecipesTripIdentically()
{
    const unsigned seed = 31;
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    const auto between = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    int built = 0;
    constexpr int recipes = 300;
    for (int i = 0; i < recipes; ++i) {
        Recipe recipe;
        recipe.name = "Recipe " + std::to_string(i);
        recipe.version = 1 + i;
        recipe.cutter().bagLengthMm = between(100, 400);
        recipe.cutter().rateBagsPerMin = between(10, 90);
        recipe.cutter().k = {between(3.5, 5), between(2.2, 3), between(1.5, 1.9), between(1.1, 1.4)};
        recipe.cutter().slicesPerRamp = 1 + static_cast<int>(random() % 100);
        recipe.machine.knifeRadiusMm = between(55, 90);
        recipe.machine.pulsesPerMotorRev = 2000 + static_cast<int>(random() % 20000);
        const auto image = buildProgram(recipe);
        if (!image)
            continue;
        ++built;
        const auto shown =
            decodeProgram(std::span(image->registers).first(modbus::bankHeaderRegisters), {}, recipe.machine);
        QVERIFY(shown.has_value());
        const auto again = buildProgram(*shown);
        QVERIFY2(again.has_value(), again ? "" : describe(again.error()).c_str());
        QVERIFY(again->registers == image->registers);
        QVERIFY(differences(image->registers, again->registers).empty());
    }
    QVERIFY2(built > recipes / 2, qPrintable(QString::number(built)));
}

void ProgramTest::everyPairOfInputsIsKept()
{
    const auto reference = profile::solve(Recipe{}.cutter(), Recipe{}.machine);
    QVERIFY(reference.has_value());
    for (std::size_t first = 0; first < profile::cycleFields.size(); ++first) {
        for (std::size_t second = first + 1; second < profile::cycleFields.size(); ++second) {
            Recipe recipe;
            // In descending order: the order of pinning must not matter.
            recipe.cutter().pinned = {profile::cycleFields[second], profile::cycleFields[first]};
            recipe.cutter().baseSpeedMmPerS = reference->cycle.baseSpeedMmPerS;
            const auto image = buildProgram(recipe);
            QVERIFY2(image.has_value(), image ? "" : describe(image.error()).c_str());
            const auto shown = decodeProgram(image->registers, {}, recipe.machine);
            QVERIFY(shown.has_value());
            QVERIFY(profile::isPinned(shown->cutter(), profile::cycleFields[first]));
            QVERIFY(profile::isPinned(shown->cutter(), profile::cycleFields[second]));
            QVERIFY(std::abs(shown->cutter().bagLengthMm - 250.0) < 0.01);
            QVERIFY(buildProgram(*shown)->registers == image->registers);
        }
    }
}

void ProgramTest::lawAndItsParametersAreKept()
{
    for (const profile::Law& law : profile::laws()) {
        if (!law.isSpeedLaw)
            continue;
        Recipe recipe;
        recipe.cutter().speedLaw = law.id;
        recipe.cutter().speedLawParameters = profile::defaultParameters(law);
        const auto image = buildProgram(recipe);
        QVERIFY2(image.has_value(), image ? "" : describe(image.error()).c_str());
        const auto shown = decodeProgram(image->registers, {}, recipe.machine);
        QVERIFY(shown.has_value());
        QCOMPARE(shown->cutter().speedLaw, law.id);
        QVERIFY(shown->cutter().speedLawParameters == image->recipe.cutter().speedLawParameters);
        QVERIFY(buildProgram(*shown)->registers == image->registers);
    }
}

void ProgramTest::longNameIsCutBetweenCharacters()
{
    Recipe recipe;
    recipe.name = "饼干二百五十饼干二百五十";
    const auto image = buildProgram(recipe);
    QVERIFY(image.has_value());
    QCOMPARE(decodeProgram(image->registers, {}, recipe.machine)->name, std::string("饼干二百五十饼干二百"));
}

void ProgramTest::refusals_data()
{
    QTest::addColumn<int>("field");
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("limit");
    const auto row = [](const char* tag, Field field, double value, profile::Limit limit) {
        QTest::newRow(tag) << static_cast<int>(field) << value << static_cast<int>(limit);
    };
    row("bag too long for the stroke", Field::BagLength, 1900, profile::Limit::StrokeCannotClose);
    row("not a number", Field::BagLength, std::numeric_limits<double>::quiet_NaN(),
        profile::Limit::FieldRange);
    row("ratios do not descend", Field::K2, 4.5, profile::Limit::RatioOrder);
    row("motor too slow", Field::MaxMotorRpm, 60, profile::Limit::MotorSpeed);
    row("knife too heavy", Field::MaxKnifeAcceleration, 100, profile::Limit::KnifeAcceleration);
    row("output stage too slow", Field::MaxPulseFrequency, 5000, profile::Limit::PulseFrequency);
}

void ProgramTest::refusals()
{
    QFETCH(int, field);
    QFETCH(double, value);
    QFETCH(int, limit);
    Recipe recipe;
    setValue(recipe, static_cast<Field>(field), value);
    const auto image = buildProgram(recipe);
    QVERIFY(!image.has_value());
    QVERIFY(!image.error().limits.empty());
    QCOMPARE(static_cast<int>(image.error().limits.front().limit), limit);
}

void ProgramTest::valueWithoutRoomInItsRegister()
{
    Recipe recipe;
    recipe.version = maxVersion + 1;
    const auto image = buildProgram(recipe);
    QVERIFY(!image.has_value());
    QVERIFY(image.error().unstorable.has_value());
    QVERIFY(image.error().unstorable->registerName == "program.recipe_version");
    QCOMPARE(image.error().unstorable->value, 65536.0);
    QCOMPARE(image.error().unstorable->maximum, 65535.0);
}

void ProgramTest::rowsBeyondTheBankAreRefused()
{
    auto image = buildProgram(Recipe{});
    profile::StepTable table = image->stepTable();
    table.rows.resize(modbus::rowCapacity, {1, 100});
    QVERIFY(encodeBank(image->recipe, image->solved, table).has_value());
    table.rows.push_back({1, 100});
    const auto bank = encodeBank(image->recipe, image->solved, table);
    QVERIFY(!bank.has_value());
    QCOMPARE(bank.error().registerName, std::string_view("bank.row_count"));
}

void ProgramTest::headersThatCannotBeShown_data()
{
    QTest::addColumn<int>("offset");
    QTest::addColumn<int>("value");
    QTest::addColumn<int>("kind");
    QTest::newRow("layout of the future") << 0 << 2 << static_cast<int>(DecodeErrorKind::Layout);
    QTest::newRow("empty bank") << 0 << 0 << static_cast<int>(DecodeErrorKind::Layout);
    QTest::newRow("unknown kind") << 1 << 9 << static_cast<int>(DecodeErrorKind::Kind);
    QTest::newRow("one pin") << 22 << 1 << static_cast<int>(DecodeErrorKind::Pinned);
    QTest::newRow("three pins") << 22 << 7 << static_cast<int>(DecodeErrorKind::Pinned);
    QTest::newRow("unknown law") << 41 << 999 << static_cast<int>(DecodeErrorKind::Law);
}

void ProgramTest::headersThatCannotBeShown()
{
    QFETCH(int, offset);
    QFETCH(int, value);
    QFETCH(int, kind);
    auto registers = buildProgram(Recipe{})->registers;
    registers[static_cast<std::size_t>(offset)] = static_cast<std::uint16_t>(value);
    const auto shown = decodeProgram(registers, {}, profile::Machine{});
    QVERIFY(!shown.has_value());
    QCOMPARE(static_cast<int>(shown.error().kind), kind);
    QCOMPARE(shown.error().code, value);
}

void ProgramTest::differencesAreByField()
{
    Recipe other;
    other.cutter().bagLengthMm = 260;
    other.name = "Biscuit 260";
    const auto found = differences(buildProgram(Recipe{})->registers, buildProgram(other)->registers);
    const auto named = [&found](std::string_view name) {
        return std::find_if(found.begin(), found.end(),
                            [name](const Difference& d) { return d.info->name == name; });
    };
    // Base and film speed follow from the length.
    QCOMPARE(found.size(), std::size_t{4});
    QVERIFY(named("program.bag_length") != found.end());
    QCOMPARE(named("program.bag_length")->field, Field::BagLength);
    QCOMPARE(named("program.bag_length")->a, 250.0);
    QCOMPARE(named("program.bag_length")->b, 260.0);
    QCOMPARE(named("program.recipe_name")->textB, std::string("Biscuit 260"));
    QVERIFY(!named("program.recipe_name")->field.has_value());
}

void ProgramTest::controllerLimitsTheMachine()
{
    modbus::Identity controller;
    controller.timerClockHz = 4'000'000;
    controller.timerBits = 16;
    controller.rowCapacity = 64;
    controller.maxPulseFrequencyHz = 100'000;
    Recipe recipe;
    recipe.machine = withController(recipe.machine, controller);
    QCOMPARE(recipe.machine.maxPulseFrequencyHz, 100'000.0);
    const auto image = buildProgram(recipe);
    QVERIFY(!image.has_value());
    QCOMPARE(image.error().limits.front().limit, profile::Limit::RowCapacity);
    recipe.cutter().slicesPerRamp = 10;
    QCOMPARE(buildProgram(recipe)->stepTable().cycleTicks, 4'000'000u);
}

void ProgramTest::everyRegisterFieldExists()
{
    for (const KindInfo& kind : kinds()) {
        for (const RegisterField& entry : registerFields(kind)) {
            const modbus::RegisterInfo* info = entry.info;
            const double unit = entry.perUnit;
            const profile::FieldInfo& field = profile::info(entry.field);
            // The register holds every value on the field's grid exactly.
            QVERIFY2(info->scale <= field.resolution() * unit * 1.000001, info->name.data());
            QVERIFY2(modbus::toRaw(*info, field.max * unit).has_value(), info->name.data());
            QVERIFY2(modbus::toRaw(*info, field.min * unit).has_value(), info->name.data());
        }
        // Every input has a register, or is in the recipe's file alone.
        for (const Field field : kind.programFields) {
            const auto registers = registerFields(kind);
            const bool isKept = std::ranges::find(registers, field, &RegisterField::field) != registers.end();
            const bool isInFileAlone = field == Field::MinSealTime || field == Field::RampPosition;
            QVERIFY2(isKept != isInFileAlone, profile::info(field).id.data());
        }
    }
}

CAMPANEL_TEST(ProgramTest)

} // namespace test_program

#include "test_program.moc"
