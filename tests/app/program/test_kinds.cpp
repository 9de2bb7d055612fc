// SPDX-License-Identifier: Apache-2.0
// Every kind of program: recipe to registers and back, and the controller's own check of the result.
#include "app/program/differences.h"
#include "app/program/interval_speeds.h"
#include "app/program/program_image.h"
#include "app/program/register_fields.h"
#include "rig.h"
#include "support/random_recipe.h"

#include "bank/ctl_check.h"
#include "modbus/map/codec.h"
#include "modbus/map/protocol.h"
#include "profile/laws/laws.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace test_kinds {

using namespace campanel;
using namespace campanel::program;
using profile::Field;
using profile::ProgramKind;

namespace {

std::span<const std::uint16_t> headerOf(const ProgramImage& image)
{
    return std::span(image.registers).first(modbus::bankHeaderRegisters);
}

std::vector<std::uint16_t> knotsOf(const ProgramImage& image)
{
    const modbus::ListSpan span = modbus::listSpan(image.registers);
    const auto all = std::span(image.registers).subspan(span.offset, span.count);
    return {all.begin(), all.end()};
}

tl::expected<Recipe, DecodeError> shown(const ProgramImage& image)
{
    return decodeProgram(headerOf(image), knotsOf(image), image.recipe.machine);
}

ctl_verdict checked(const ProgramImage& image)
{
    auto bank = std::make_unique<ctl_bank>();
    std::ranges::copy(image.registers, bank->registers);
    const ctl_config config = test::benchConfig();
    return ctl_bank_check(bank.get(), &config, static_cast<std::uint32_t>(image.registers.size()));
}

bool isInRegisters(Field field)
{
    return field != Field::MinSealTime && field != Field::RampPosition;
}

// The origin of the ratios is the panel's own: the controller knows the ratios alone.
bool isInRegisters(Choice choice)
{
    return choice != Choice::Ratios;
}

// Returns an empty text, or the input that differs.
QString lostInput(const Recipe& kept, const Recipe& given)
{
    if (kept.name != given.name || kept.version != given.version || kept.kind() != given.kind())
        return QStringLiteral("name, version or kind");
    const KindInfo& kind = kindInfo(given.kind());
    for (const Field field : kind.programFields) {
        const bool isRead = !given.isCutter() || program::isRead(given.program, field);
        if (isRead && isInRegisters(field) && value(kept, field) != value(given, field))
            return QStringLiteral("%1: %2 is not %3")
                .arg(profile::info(field).id.data())
                .arg(value(kept, field), 0, 'g', 17)
                .arg(value(given, field), 0, 'g', 17);
    }
    for (const ChoiceInfo& each : kind.choices) {
        if (isInRegisters(each.choice) &&
            choice(kept.program, each.choice) != choice(given.program, each.choice))
            return QString::fromLatin1(each.id.data());
    }
    const auto* parameters = lawParameters(given.program);
    if (parameters && *lawParameters(kept.program) != *parameters)
        return QStringLiteral("parameters of the law");
    const auto* cam = std::get_if<profile::PointCamProgram>(&given.program);
    if (cam && std::get<profile::PointCamProgram>(kept.program).knots != cam->knots)
        return QStringLiteral("knots");
    const auto* segments = std::get_if<profile::SegmentCamProgram>(&given.program);
    if (segments && std::get<profile::SegmentCamProgram>(kept.program).segments != segments->segments)
        return QStringLiteral("segments");
    return {};
}

const Difference* find(const std::vector<Difference>& all, std::string_view name)
{
    const auto found = std::ranges::find(all, name, [](const Difference& each) { return each.info->name; });
    return found == all.end() ? nullptr : &*found;
}

} // namespace

class KindsTest : public QObject {
    Q_OBJECT

private slots:
    void lawsHaveTheNumbersOfTheMap();
    void everyDefaultCanBeDownloaded_data() { addKinds(); }
    void everyDefaultCanBeDownloaded();
    void randomRecipesTripIdentically_data() { addKinds(); }
    void randomRecipesTripIdentically();
    void whatCanBeEnteredIsHeldExactly_data() { addKinds(); }
    void whatCanBeEnteredIsHeldExactly();
    void everyChoiceIsKept_data() { addKinds(); }
    void everyChoiceIsKept();
    void everyFieldMakesADifference_data() { addKinds(); }
    void everyFieldMakesADifference();
    void aHeldSpeedIsTheOneEntered();
    void anotherKindIsOneDifference();
    void changedChoicesAreDifferences();
    void headersThatCannotBeShown_data();
    void headersThatCannotBeShown();
    void damagedHeadersDoNoHarm();

private:
    static void addKinds()
    {
        QTest::addColumn<ProgramKind>("kind");
        for (const KindInfo& kind : kinds())
            QTest::newRow(kind.key.data()) << kind.kind;
    }
};

void KindsTest::everyDefaultCanBeDownloaded()
{
    QFETCH(ProgramKind, kind);
    QVERIFY(findKind(kindInfo(kind).key) == &kindInfo(kind));
    Recipe recipe = defaultRecipe(kind);
    QCOMPARE(recipe.kind(), kind);
    const auto options = choiceInfo(kind, Choice::Execution).options;
    const bool isMove = !options.empty();
    for (std::size_t i = 0; i < (isMove ? options.size() : 1); ++i) {
        if (isMove)
            setChoice(recipe.program, Choice::Execution, options[i].code);
        const auto image = buildProgram(recipe);
        QVERIFY2(image, image ? "" : describe(image.error()).c_str());
        const ctl_verdict verdict = checked(*image);
        QVERIFY2(verdict.result == CTL_TRANSFER_RESULT_ACCEPTED,
                 qPrintable(QStringLiteral("%1, detail %2").arg(verdict.result).arg(verdict.detail)));
        const auto kept = shown(*image);
        QVERIFY2(kept, kept ? "" : QByteArray::number(kept.error().code));
        QCOMPARE(lostInput(*kept, image->recipe), QString());
        QVERIFY(image->solved.cycleS() > 0);
    }
}

void KindsTest::randomRecipesTripIdentically()
{
    QFETCH(ProgramKind, kind);
    constexpr unsigned seed = 2011;
    qInfo("seed %u", seed);
    test::RandomRecipes random(seed);
    constexpr int recipes = 2500;
    int built = 0;
    for (int i = 0; i < recipes; ++i) {
        Recipe recipe = random.around(kind);
        // Intervals take a hundred times as long to compile.
        constexpr int intervalsEvery = 100;
        if (i % intervalsEvery != 0)
            setChoice(recipe.program, Choice::Execution,
                      static_cast<std::uint16_t>(profile::Execution::CamPoints));
        const auto image = buildProgram(recipe);
        if (!image)
            continue;
        ++built;
        const ctl_verdict verdict = checked(*image);
        QVERIFY2(
            verdict.result == CTL_TRANSFER_RESULT_ACCEPTED,
            qPrintable(
                QStringLiteral("recipe %1: %2, detail %3").arg(i).arg(verdict.result).arg(verdict.detail)));
        const auto kept = shown(*image);
        QVERIFY2(kept, kept ? "" : QByteArray::number(kept.error().code));
        const QString lost = lostInput(*kept, image->recipe);
        QVERIFY2(lost.isEmpty(), qPrintable(QStringLiteral("recipe %1: %2").arg(i).arg(lost)));
        Recipe wanted = *kept;
        wanted.machine.maxPulseFrequencyHz = image->recipe.machine.maxPulseFrequencyHz;
        const auto again = buildProgram(wanted);
        QVERIFY2(again, again ? "" : describe(again.error()).c_str());
        QVERIFY2(again->registers == image->registers, qPrintable(QStringLiteral("recipe %1").arg(i)));
        QVERIFY(differences(image->registers, again->registers).empty());
    }
    qInfo("%d of %d built", built, recipes);
    QVERIFY2(built > recipes / 4, qPrintable(QString::number(built)));
}

// Quantising does not change values on the grids of the fields, and never changes a value twice.
void KindsTest::whatCanBeEnteredIsHeldExactly()
{
    QFETCH(ProgramKind, kind);
    constexpr unsigned seed = 77;
    qInfo("seed %u", seed);
    test::RandomRecipes random(seed);
    for (int i = 0; i < 2500; ++i) {
        const Recipe given = random.anywhere(kind);
        const Recipe once = quantised(given);
        for (const Field field : kindInfo(kind).programFields) {
            if (given.isCutter() && !program::isRead(given.program, field))
                continue;
            const double off = std::abs(value(once, field) - value(given, field));
            QVERIFY2(off <= 1e-9 * std::max(1.0, std::abs(value(given, field))),
                     profile::info(field).id.data());
        }
        QCOMPARE(lostInput(quantised(once), once), QString());
    }
}

void KindsTest::everyChoiceIsKept()
{
    QFETCH(ProgramKind, kind);
    for (const ChoiceInfo& info : kindInfo(kind).choices) {
        const Choice each = info.choice;
        if (!isInRegisters(each))
            continue;
        std::vector<std::uint16_t> codes;
        for (const ChoiceOption& option : info.options)
            codes.push_back(option.code);
        if (each == Choice::Law) {
            for (const profile::Law& law : profile::laws()) {
                if (isLawOf(kind, law))
                    codes.push_back(static_cast<std::uint16_t>(law.id));
            }
        }
        QVERIFY(codes.size() > 1);
        for (const std::uint16_t code : codes) {
            Recipe recipe = defaultRecipe(kind);
            if (auto* move = std::get_if<profile::SpeedMoveProgram>(&recipe.program)) {
                move->endSpeedMmPerS = 3000;
                move->timeS = 2;
                move->distanceMm = 5000;
            }
            if (auto* move = std::get_if<profile::PositionMoveProgram>(&recipe.program))
                move->timeS = 2;
            if (auto* cam = std::get_if<profile::PointCamProgram>(&recipe.program))
                cam->masterRateRevPerMin = 30; // slow enough for the jumps at the wrap
            setChoice(recipe.program, each, code);
            if (auto* parameters = lawParameters(recipe.program))
                *parameters = profile::defaultParameters(
                    *profile::findLaw(static_cast<profile::LawId>(choice(recipe.program, Choice::Law))));
            const auto image = buildProgram(recipe);
            QVERIFY2(image, image ? "" : describe(image.error()).c_str());
            const auto kept = shown(*image);
            QVERIFY(kept);
            QCOMPARE(choice(kept->program, each), code);
            QCOMPARE(lostInput(*kept, image->recipe), QString());
        }
    }
}

// A stored field is compared by its field, in its unit.
void KindsTest::everyFieldMakesADifference()
{
    QFETCH(ProgramKind, kind);
    const Recipe recipe = defaultRecipe(kind);
    const auto before = buildProgram(recipe);
    QVERIFY(before);
    std::set<Field> kept;
    for (const RegisterField& entry : registerFields(kindInfo(kind))) {
        const modbus::RegisterInfo* info = entry.info;
        auto registers = before->registers;
        modbus::RegisterWriter writer(registers, 0);
        const double raised = modbus::RegisterReader(registers, 0).physical(*info) + info->scale;
        QVERIFY2(writer.physical(*info, raised), info->name.data());
        const auto found = differences(before->registers, registers);
        QVERIFY2(found.size() == 1, info->name.data());
        QCOMPARE(found.front().info, info);
        QVERIFY(found.front().field == entry.field);
        QVERIFY(std::abs(found.front().b - found.front().a - info->scale) < 1e-6 * info->scale);
        kept.insert(entry.field);
    }
    for (const Field field : kindInfo(kind).programFields) {
        QVERIFY2(kept.contains(field) == isInRegisters(field), profile::info(field).id.data());
        QCOMPARE(isInController(recipe, field), isInRegisters(field));
    }
}

// The last speed of intervals is held until a stop; more pulses make it more exact.
void KindsTest::aHeldSpeedIsTheOneEntered()
{
    constexpr std::array<std::pair<double, double>, 4> speedsAndShares{
        {{500, 0.005}, {-1000, 0.005}, {5000, 0.0015}, {9000, 0.0015}}};
    for (const auto& [speed, share] : speedsAndShares) {
        Recipe recipe = defaultRecipe(ProgramKind::SpeedMove);
        setValue(recipe, Field::EndSpeed, speed);
        setChoice(recipe.program, Choice::Execution,
                  static_cast<std::uint16_t>(profile::Execution::Intervals));
        const auto image = buildProgram(recipe);
        QVERIFY2(image, image ? "" : describe(image.error()).c_str());
        const auto& table = std::get<profile::IntervalTable>(image->table);
        const double held =
            speedsOf(table.rows.back(), table.fractionBits).lastHz / image->solved.pulsesPerMm;
        QVERIFY2(std::abs(held - std::abs(speed)) <= share * std::abs(speed),
                 qPrintable(QStringLiteral("%1 instead of %2").arg(held).arg(speed)));
    }
}

void KindsTest::anotherKindIsOneDifference()
{
    for (const KindInfo& a : kinds()) {
        for (const KindInfo& b : kinds()) {
            if (a.kind == b.kind)
                continue;
            const auto found = differences(buildProgram(defaultRecipe(a.kind))->registers,
                                           buildProgram(defaultRecipe(b.kind))->registers);
            QCOMPARE(found.size(), std::size_t{2});
            QVERIFY(find(found, "program.recipe_name"));
            const Difference* kind = find(found, "bank.kind");
            QVERIFY(kind);
            QCOMPARE(kind->a, static_cast<double>(a.kind));
            QCOMPARE(kind->b, static_cast<double>(b.kind));
        }
    }
}

void KindsTest::changedChoicesAreDifferences()
{
    Recipe move = defaultRecipe(ProgramKind::PositionMove);
    const auto before = buildProgram(move);
    setChoice(move.program, Choice::Execution, static_cast<std::uint16_t>(profile::Execution::Intervals));
    auto found = differences(before->registers, buildProgram(move)->registers);
    QCOMPARE(found.size(), std::size_t{1});
    QVERIFY(find(found, "bank.layout"));
    setChoice(move.program, Choice::Law, static_cast<std::uint16_t>(profile::LawId::Cycloidal));
    found = differences(before->registers, buildProgram(move)->registers);
    QVERIFY(find(found, "position_move.law"));

    Recipe cam = defaultRecipe(ProgramKind::PointCam);
    const auto round = buildProgram(cam);
    setChoice(cam.program, Choice::MasterRampShape, static_cast<std::uint16_t>(profile::RampShape::SCurve));
    std::get<profile::PointCamProgram>(cam.program)
        .knots.insert(std::get<profile::PointCamProgram>(cam.program).knots.begin() + 1, {45, 6});
    found = differences(round->registers, buildProgram(cam)->registers);
    QVERIFY(find(found, "cam.ramp_shape"));
}

void KindsTest::headersThatCannotBeShown_data()
{
    QTest::addColumn<ProgramKind>("kind");
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("value");
    QTest::addColumn<int>("error");
    const auto row = [](const char* tag, ProgramKind kind, const char* name, int value,
                        DecodeErrorKind error) {
        QTest::newRow(tag) << kind << QString::fromLatin1(name) << value << static_cast<int>(error);
    };
    row("kind 0", ProgramKind::PointCam, "bank.kind", 0, DecodeErrorKind::Kind);
    row("kind 7", ProgramKind::Press, "bank.kind", 7, DecodeErrorKind::Kind);
    row("layout of the future", ProgramKind::PositionMove, "bank.layout", 9, DecodeErrorKind::Layout);
    row("no layout", ProgramKind::SpeedMove, "bank.layout", 0, DecodeErrorKind::Layout);
    row("a cam of intervals", ProgramKind::PointCam, "bank.layout",
        static_cast<int>(modbus::TableLayout::Intervals), DecodeErrorKind::Layout);
    row("a press of cam points", ProgramKind::Press, "bank.layout",
        static_cast<int>(modbus::TableLayout::CamPoints), DecodeErrorKind::Layout);
    row("unknown law", ProgramKind::PositionMove, "position_move.law", 99, DecodeErrorKind::Law);
    row("a speed law for a position", ProgramKind::PositionMove, "position_move.law",
        static_cast<int>(profile::LawId::HalfModifiedSine), DecodeErrorKind::Law);
    row("unknown law of a speed move", ProgramKind::SpeedMove, "speed_move.law", 0, DecodeErrorKind::Law);
    row("unknown duration", ProgramKind::SpeedMove, "speed_move.duration", 3, DecodeErrorKind::Choice);
    row("position over a distance", ProgramKind::PositionMove, "position_move.duration", 2,
        DecodeErrorKind::Choice);
    row("unknown ends", ProgramKind::PointCam, "cam.ends", 3, DecodeErrorKind::Choice);
    row("unknown ramp", ProgramKind::PointCam, "cam.ramp_shape", 2, DecodeErrorKind::Choice);
}

void KindsTest::headersThatCannotBeShown()
{
    QFETCH(ProgramKind, kind);
    QFETCH(QString, name);
    QFETCH(int, value);
    QFETCH(int, error);
    auto image = buildProgram(defaultRecipe(kind));
    QVERIFY(image);
    const modbus::RegisterInfo& info = modbus::registerNamed(name.toStdString());
    image->registers[info.address] = static_cast<std::uint16_t>(value);
    const auto result = shown(*image);
    QVERIFY(!result);
    QCOMPARE(static_cast<int>(result.error().kind), error);
    QCOMPARE(result.error().code, value);
}

// A header with any contents is displayed or refused, without further effects.
void KindsTest::damagedHeadersDoNoHarm()
{
    constexpr unsigned seed = 5;
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    std::vector<ProgramImage> images;
    for (const KindInfo& each : kinds())
        images.push_back(*buildProgram(defaultRecipe(each.kind)));
    int refused = 0;
    for (int i = 0; i < 5000; ++i) {
        ProgramImage image = images[random() % images.size()];
        for (int change = 0; change < 8; ++change)
            image.registers[1 + random() % (modbus::bankHeaderRegisters - 1)] =
                static_cast<std::uint16_t>(random());
        const auto kept = shown(image);
        if (!kept) {
            ++refused;
            continue;
        }
        // Either a motion or a refusal.
        static_cast<void>(solveProgram(*kept));
    }
    QVERIFY(refused > 0 && refused < 5000);
}

// Returns "modified_sine" for ModifiedSine.
QString keyOf(std::string_view name)
{
    QString key;
    for (const QChar c : QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()))) {
        const bool begins = c.isUpper() || (c.isDigit() && !key.isEmpty() && !key.back().isDigit());
        key += begins && !key.isEmpty() ? u'_' + QString(c.toLower()) : QString(c.toLower());
    }
    return key;
}

void KindsTest::lawsHaveTheNumbersOfTheMap()
{
    const auto map = std::ranges::find(modbus::enumerations(), "Law", &modbus::EnumInfo::name);
    QVERIFY(map != modbus::enumerations().end());
    QCOMPARE(map->values.size(), profile::laws().size());
    for (const modbus::EnumValue& value : map->values) {
        const auto* law = profile::findLaw(static_cast<profile::LawId>(value.value));
        QVERIFY2(law != nullptr, value.name.data());
        QCOMPARE(QString::fromUtf8(law->key.data(), static_cast<qsizetype>(law->key.size())),
                 keyOf(value.name));
    }
}

CAMPANEL_TEST(KindsTest)

} // namespace test_kinds

#include "test_kinds.moc"
