// SPDX-License-Identifier: Apache-2.0
// The table of fields, and the explanations: their evaluated numbers give the result.
#include "recipes.h"

#include "profile/cam/point_cam.h"
#include "profile/cutter/explain.h"
#include "profile/cutter/limits.h"
#include "profile/moves/position_move.h"
#include "profile/moves/speed_move.h"
#include "profile/press/press.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <type_traits>

namespace test_fields_and_text {

using namespace campanel::profile;
using namespace campanel::profile::test;

namespace {

using Owners = std::tuple<Machine, RotaryCutterProgram, PositionMoveProgram, SpeedMoveProgram,
                          PointCamProgram, PressProgram>;

template <typename Tuple, typename Visit> void forEach(Tuple& owners, Visit visit)
{
    std::apply([&](auto&... owner) { (visit(owner), ...); }, owners);
}

// Returns the rounding of a derived value.
double roundingOf(const FieldInfo& field)
{
    return std::min(1e-10 * field.max, 1e-4 * field.resolution());
}

// Evaluates + - * / ( ) |x|, numbers and pi; two factors side by side multiply.
class Calculator {
public:
    explicit Calculator(std::string text)
        : m_text(std::move(text))
    {
    }

    double sum()
    {
        double total = product();
        for (;;) {
            if (take('+'))
                total += product();
            else if (take('-'))
                total -= product();
            else
                return total;
        }
    }

private:
    double product()
    {
        double total = factor();
        for (;;) {
            if (take('*'))
                total *= factor();
            else if (take('/'))
                total /= factor();
            else if (peek() == 'p')
                total *= factor();
            else
                return total;
        }
    }

    double factor()
    {
        if (take('(')) {
            const double inner = sum();
            take(')');
            return inner;
        }
        if (take('|')) {
            const double inner = sum();
            take('|');
            return std::abs(inner);
        }
        if (take('p')) {
            take('i');
            return std::acos(-1.0);
        }
        std::size_t used = 0;
        const double number = std::stod(m_text.substr(m_at), &used);
        m_at += used;
        return number;
    }

    char peek()
    {
        while (m_at < m_text.size() && m_text[m_at] == ' ')
            ++m_at;
        return m_at < m_text.size() ? m_text[m_at] : '\0';
    }

    bool take(char c)
    {
        if (peek() != c)
            return false;
        ++m_at;
        return true;
    }

    std::string m_text;
    std::size_t m_at = 0;
};

} // namespace

class TestFieldsAndText : public QObject {
    Q_OBJECT

private slots:
    void fieldsAreSound();
    void everyFieldHasAnOwner();
    void defaultsAreFeasible();
    void valuesGoInAndComeOut();
    void explanationsAddUp_data();
    void explanationsAddUp();
};

void TestFieldsAndText::fieldsAreSound()
{
    std::set<std::string_view> ids;
    for (const FieldInfo& field : fields) {
        QVERIFY(ids.insert(field.id).second);
        QVERIFY(field.min <= field.defaultValue && field.defaultValue <= field.max);
        QVERIFY(fieldById(field.id) == field.field);
        QCOMPARE(snapToGrid(field.field, field.defaultValue), field.defaultValue);
        QVERIFY(inRange(field.field, field.min) && inRange(field.field, field.max));
        QVERIFY(!inRange(field.field, field.min - field.resolution()));
        QVERIFY(!inRange(field.field, field.max + field.resolution()));
        QVERIFY(inRange(field.field, field.min - roundingOf(field)));
        QVERIFY(inRange(field.field, field.max + roundingOf(field)));
        QVERIFY(!inRange(field.field, std::nan("")));
    }
    QVERIFY(!fieldById("no_such_field"));
    QCOMPARE(info(Field::BagLength).resolution(), 0.1);
}

void TestFieldsAndText::everyFieldHasAnOwner()
{
    const Owners owners;
    for (const FieldInfo& field : fields) {
        int count = 0;
        forEach(owners, [&](const auto& owner) { count += std::isnan(value(owner, field.field)) ? 0 : 1; });
        const bool ofMachine = !std::isnan(value(std::get<Machine>(owners), field.field));
        // No machine field is a program field; programs of several kinds may share an input.
        QVERIFY2(count == 1 || (count > 1 && !ofMachine), field.id.data());
    }
}

void TestFieldsAndText::defaultsAreFeasible()
{
    const Owners owners;
    for (const FieldInfo& field : fields) {
        forEach(owners, [&](const auto& owner) {
            const double present = value(owner, field.field);
            // A repeating cam has space for a finer table than a move.
            const bool isFinerCam =
                std::is_same_v<decltype(owner), const PointCamProgram&> && field.field == Field::CamPoints;
            if (!std::isnan(present))
                QCOMPARE(present, isFinerCam ? 1000 : field.defaultValue);
        });
    }
    const Machine machine;
    QVERIFY(isFeasible(RotaryCutterProgram{}, machine));
    const auto cam = solve(PointCamProgram{}, machine);
    QVERIFY(cam && cam->broken.empty());
    const auto stroke = solve(PressProgram{}, machine);
    QVERIFY(stroke && stroke->broken.empty());
    // The papers' moves, 6000 mm in 1 s and up to 9000 mm/s, need a faster motor and output stage.
    Machine faster;
    faster.maxMotorRpm = 7000;
    faster.maxPulseFrequencyHz = 1'200'000;
    QVERIFY(!isFeasible(PositionMoveProgram{}, machine) && isFeasible(PositionMoveProgram{}, faster));
    QVERIFY(!isFeasible(SpeedMoveProgram{}, machine) && isFeasible(SpeedMoveProgram{}, faster));
}

void TestFieldsAndText::valuesGoInAndComeOut()
{
    for (const FieldInfo& field : fields) {
        const double x = snapToGrid(field.field, field.min + 0.37 * (field.max - field.min));
        Owners owners;
        forEach(owners, [&](auto& owner) {
            const bool isOwner = !std::isnan(value(owner, field.field));
            setValue(owner, field.field, x);
            if (isOwner)
                QCOMPARE(value(owner, field.field), x);
            else
                QVERIFY(std::isnan(value(owner, field.field)));
        });
    }
}

void TestFieldsAndText::explanationsAddUp_data()
{
    QTest::addColumn<int>("pair");
    for (int i = 0; i < static_cast<int>(allPairs.size()); ++i) {
        const auto& pair = allPairs[static_cast<std::size_t>(i)];
        QTest::newRow(
            (std::string(info(pair[0]).symbol) + " and " + std::string(info(pair[1]).symbol)).c_str())
            << i;
    }
}

void TestFieldsAndText::explanationsAddUp()
{
    QFETCH(int, pair);
    Recipe r = checkRecipe();
    r.program.syncRatio = 1.02;
    r.program.speedLaw = LawId::HalfModifiedSine;
    r.machine.gearNumerator = 22;
    r.machine.gearDenominator = 7;
    const CycleNumbers c = solve(r.program, r.machine)->cycle;
    r.program.pinned = allPairs[static_cast<std::size_t>(pair)];
    setValue(r.program, Field::BaseSpeed, c.baseSpeedMmPerS);
    setValue(r.program, Field::FilmSpeed, c.filmSpeedMmPerS);
    const auto cutter = solve(r.program, r.machine);
    QVERIFY(cutter.has_value());
    const Peaks peak = peaks(*cutter);
    const std::array<std::pair<CutterQuantity, double>, 8> expected{
        {{CutterQuantity::BagLength, c.bagLengthMm},
         {CutterQuantity::Rate, c.rateBagsPerMin},
         {CutterQuantity::BaseSpeed, c.baseSpeedMmPerS},
         {CutterQuantity::FilmSpeed, c.filmSpeedMmPerS},
         {CutterQuantity::Weight, c.weightS},
         {CutterQuantity::PeakMotorRpm, peak.motorRpm},
         {CutterQuantity::PeakAcceleration, peak.accelerationMmPerS2},
         {CutterQuantity::PeakFrequency, peak.pulseFrequencyHz}}};
    for (const auto& [quantity, result] : expected) {
        const Explanation e = explain(*cutter, quantity);
        QVERIFY(!e.formula.empty() && !e.unit.empty());
        QVERIFY(std::abs(e.result - result) <= 1e-6 * result);
        const double calculated = Calculator(e.numbers).sum();
        QVERIFY2(std::abs(calculated - result) <= 1e-5 * result, (e.formula + " = " + e.numbers).c_str());
    }
}

CAMPANEL_TEST(TestFieldsAndText)

} // namespace test_fields_and_text

#include "test_fields_and_text.moc"
