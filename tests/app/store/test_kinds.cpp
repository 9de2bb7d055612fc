// SPDX-License-Identifier: Apache-2.0
// Recipe files of every kind of program, and knots as CSV files.
#include "app/program/cam_advance.h"
#include "app/store/recipes/list_file.h"
#include "app/store/recipes/recipe_file.h"
#include "tests/support/random_recipe.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

namespace test_kinds {

using namespace campanel;
using namespace campanel::store;
using namespace Qt::StringLiterals;
using profile::Field;
using profile::ProgramKind;
using Kind = FileError::Kind;

class StoreKindsTest : public QObject {
    Q_OBJECT

private slots:
    void defaultsTrip_data() { addKinds(); }
    void defaultsTrip();
    void randomRecipesTrip_data() { addKinds(); }
    void randomRecipesTrip();
    void everyChoiceTrips_data() { addKinds(); }
    void everyChoiceTrips();
    void aConfirmedAdvanceTrips();
    void theTrimsTrip();
    void theMasterTrips();
    void ratiosOfOlderAndNewerFiles();
    void whatIsAbsentHasTheDefaultsOfItsKind();
    void cutterFilesWithoutAMotorMeanUnknown();
    void fieldsOfOtherKindsAreUnknown();
    void complaints_data();
    void complaints();
    void listsTripAsCsv();
    void wrongKnotFiles_data();
    void wrongKnotFiles();
    void knotFilesThatCannotBeOpened();

private:
    static void addKinds()
    {
        QTest::addColumn<ProgramKind>("kind");
        for (const program::KindInfo& kind : program::kinds())
            QTest::newRow(kind.key.data()) << kind.kind;
    }
    [[nodiscard]] QString put(const QString& name, const QByteArray& bytes) const;

    QTemporaryDir m_directory;
};

QString StoreKindsTest::put(const QString& name, const QByteArray& bytes) const
{
    QFile file(m_directory.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("%s", qPrintable(file.errorString()));
    return file.fileName();
}

void StoreKindsTest::defaultsTrip()
{
    QFETCH(ProgramKind, kind);
    const program::Recipe recipe = program::defaultRecipe(kind);
    const QString path = m_directory.filePath(u"default.json"_s);
    QVERIFY(writeRecipe(recipe, path));
    const auto read = readRecipe(path);
    QVERIFY2(read, read ? "" : qPrintable(FileErrorText::describe(read.error())));
    QCOMPARE(read->kind(), kind);
    QCOMPARE(toJson(*read), toJson(recipe));
    const QJsonObject program = QJsonDocument::fromJson(toJson(recipe)).object()[u"program"_s].toObject();
    QCOMPARE(program[u"kind"_s].toString().toStdString(), std::string(program::kindInfo(kind).key));
    for (const Field field : program::kindInfo(kind).programFields)
        QVERIFY2(program.contains(QString::fromLatin1(profile::info(field).id.data())),
                 profile::info(field).id.data());
}

// Written recipes are read back to the last digit.
void StoreKindsTest::randomRecipesTrip()
{
    QFETCH(ProgramKind, kind);
    constexpr unsigned seed = 12;
    qInfo("seed %u", seed);
    test::RandomRecipes random(seed);
    for (int i = 0; i < 1000; ++i) {
        const program::Recipe recipe = i % 2 == 0 ? random.around(kind) : random.anywhere(kind);
        const auto read = fromJson(toJson(recipe), u"random"_s);
        QVERIFY2(read, read ? "" : qPrintable(FileErrorText::describe(read.error())));
        QCOMPARE(toJson(*read), toJson(recipe));
        for (const Field field : program::kindInfo(kind).programFields) {
            if (!recipe.isCutter() || program::isRead(recipe.program, field))
                QCOMPARE(program::value(*read, field), program::value(recipe, field));
        }
        for (const Field field : program::kindInfo(kind).machineFields)
            QCOMPARE(program::value(*read, field), program::value(recipe, field));
        if (const auto* cam = std::get_if<profile::PointCamProgram>(&recipe.program))
            QVERIFY(std::get<profile::PointCamProgram>(read->program).knots == cam->knots);
        if (const auto* cam = std::get_if<profile::SegmentCamProgram>(&recipe.program))
            QVERIFY(std::get<profile::SegmentCamProgram>(read->program).segments == cam->segments);
        if (const auto* parameters = program::lawParameters(recipe.program)) {
            const auto law =
                static_cast<profile::LawId>(program::choice(recipe.program, program::Choice::Law));
            for (std::size_t at = 0; at < profile::findLaw(law)->parameters.size(); ++at)
                QCOMPARE((*program::lawParameters(read->program))[at], (*parameters)[at]);
        }
    }
}

// Only a file that needs it says that it needs a newer reader; a file of today has nothing confirmed.
void StoreKindsTest::aConfirmedAdvanceTrips()
{
    for (const ProgramKind kind : {ProgramKind::PointCam, ProgramKind::SegmentCam}) {
        program::Recipe recipe = program::defaultRecipe(kind);
        const auto version = [&recipe] {
            return QJsonDocument::fromJson(toJson(recipe)).object()[u"format_version"_s].toInt();
        };
        QCOMPARE(version(), 2);
        QVERIFY(!toJson(recipe).contains("confirmed_advance_mm"));
        program::setConfirmedAdvance(recipe.program, -376.991);
        QCOMPARE(version(), 3);
        const auto read = fromJson(toJson(recipe), {});
        QVERIFY(read.has_value());
        QCOMPARE(program::confirmedAdvanceMm(read->program), -376.991);
        QByteArray wrong = toJson(recipe);
        QCOMPARE(fromJson(wrong.replace("-376.991", "\"all\""), {}).error().key,
                 u"program.confirmed_advance_mm"_s);
    }
    const QByteArray older = R"({"format": "campanel-recipe", "format_version": 1, "name": "Feed", "program":
        {"kind": "point_cam", "knots": [[0, 0], [90, 20], [180, 50], [270, 80], [360, 100]]}})";
    const auto read = fromJson(older, {});
    QVERIFY(read.has_value());
    QCOMPARE(program::advanceMm(read->program), 100.0);
    QVERIFY(!program::isAdvanceConfirmed(read->program));
    QByteArray cutter = toJson(program::defaultRecipe(ProgramKind::RotaryCutter));
    cutter.replace("\"program\": {", "\"program\": {\"confirmed_advance_mm\": 5,");
    QCOMPARE(fromJson(cutter, {}).error().kind, Kind::UnknownKey);
}

// A recipe without trims can be read by an older reader; one beyond the limits of the register is refused.
void StoreKindsTest::theTrimsTrip()
{
    program::Recipe recipe = program::defaultRecipe(ProgramKind::RotaryCutter);
    QVERIFY(!toJson(recipe).contains("trims"));
    recipe.trims = {-2.5, 0.0, 1.0};
    QByteArray json = toJson(recipe);
    QCOMPARE(QJsonDocument::fromJson(json).object()[u"format_version"_s].toInt(), 5);
    QVERIFY(!json.contains("product_mm"));
    const auto read = fromJson(json, {});
    QVERIFY(read.has_value());
    QCOMPARE(read->trims, recipe.trims);
    const FileError tooFar = fromJson(json.replace("-2.5", "-10.5"), {}).error();
    QCOMPARE(tooFar.kind, Kind::OutOfRange);
    QCOMPARE(tooFar.key, u"trims.cut_mm"_s);
    const FileError unknown = fromJson(json.replace("cut_mm", "knife_mm"), {}).error();
    QCOMPARE(unknown.kind, Kind::UnknownKey);
}

// A file that names no master can be read by an older reader too.
void StoreKindsTest::theMasterTrips()
{
    program::Recipe recipe = program::defaultRecipe(ProgramKind::RotaryCutter);
    const auto version = [&recipe] {
        return QJsonDocument::fromJson(toJson(recipe)).object()[u"format_version"_s].toInt();
    };
    QCOMPARE(version(), 2);
    QVERIFY(!toJson(recipe).contains("\"master\""));
    for (const auto master : {program::RecipeMaster::Clock, program::RecipeMaster::Encoder}) {
        recipe.master = master;
        QCOMPARE(version(), 4);
        const auto read = fromJson(toJson(recipe), {});
        QVERIFY(read.has_value());
        QCOMPARE(read->master, master);
    }
    QByteArray json = toJson(recipe);
    QCOMPARE(fromJson(json.replace("\"encoder\"", "\"any\""), {})->master, program::RecipeMaster::Any);
    const FileError wrong = fromJson(json.replace("\"any\"", "\"film\""), {}).error();
    QCOMPARE(wrong.kind, Kind::NotAChoice);
    QCOMPARE(wrong.key, u"master"_s);
    QCOMPARE(wrong.expected, u"any, clock, encoder"_s);
    const QByteArray older = R"({"format": "campanel-recipe", "format_version": 1, "name": "Feed", "program":
        {"kind": "point_cam", "knots": [[0, 0], [90, 20], [180, 50], [270, 20], [360, 0]]}})";
    QCOMPARE(fromJson(older, {})->master, program::RecipeMaster::Any);
}

// Older files have no origin of the ratios: they were set by hand. A file with an origin and without ratios
// gets those that suit its machine.
void StoreKindsTest::ratiosOfOlderAndNewerFiles()
{
    program::Recipe recipe = program::gentleRecipe(program::defaultRecipe(ProgramKind::RotaryCutter));
    QJsonObject root = QJsonDocument::fromJson(toJson(recipe)).object();
    QJsonObject program = root[u"program"_s].toObject();
    QCOMPARE(program[u"ratios"_s].toString(), u"gentle"_s);
    const auto read = [&] {
        root[u"program"_s] = program;
        return fromJson(QJsonDocument(root).toJson(), u"ratios"_s);
    };
    for (const auto& key : {u"k1"_s, u"k2"_s, u"k3"_s, u"k4"_s})
        program.remove(key);
    QVERIFY(read());
    QCOMPARE(read()->cutter().k, recipe.cutter().k);
    // Saved ratios are those that run, whatever would suit now.
    program[u"k1"_s] = 7;
    program[u"k4"_s] = 1.4;
    QCOMPARE(read()->cutter().k[0], 7.0);
    QCOMPARE(read()->cutter().ratioMode, profile::RatioMode::Gentle);
    program.remove(u"ratios"_s);
    program.remove(u"ramp_position_percent"_s);
    QCOMPARE(read()->cutter().k[0], 7.0);
    QCOMPARE(read()->cutter().ratioMode, profile::RatioMode::ByHand);
    program[u"ratios"_s] = u"fastest"_s;
    QCOMPARE(read().error().kind, Kind::NotAChoice);
    program[u"ratios"_s] = u"between"_s;
    program[u"ramp_position_percent"_s] = 70;
    QCOMPARE(read()->cutter().rampPositionPercent, 70.0);
    program[u"ramp_position_percent"_s] = 101;
    QCOMPARE(read().error().kind, Kind::OutOfRange);
}

void StoreKindsTest::everyChoiceTrips()
{
    QFETCH(ProgramKind, kind);
    int tried = 0;
    for (const program::ChoiceInfo& info : program::kindInfo(kind).choices) {
        const program::Choice each = info.choice;
        std::vector<std::uint16_t> codes;
        for (const program::ChoiceOption& option : info.options)
            codes.push_back(option.code);
        for (const profile::Law& law : profile::laws()) {
            if (each == program::Choice::Law && program::isLawOf(kind, law))
                codes.push_back(static_cast<std::uint16_t>(law.id));
        }
        for (const std::uint16_t code : codes) {
            program::Recipe recipe = program::defaultRecipe(kind);
            program::setChoice(recipe.program, each, code);
            if (each == program::Choice::Law)
                *program::lawParameters(recipe.program) =
                    profile::defaultParameters(*profile::findLaw(static_cast<profile::LawId>(code)));
            const auto read = fromJson(toJson(recipe), {});
            QVERIFY2(read, read ? "" : qPrintable(FileErrorText::describe(read.error())));
            QCOMPARE(program::choice(read->program, each), code);
            ++tried;
        }
    }
    QCOMPARE(tried > 0, kind != ProgramKind::Press);
}

void StoreKindsTest::whatIsAbsentHasTheDefaultsOfItsKind()
{
    for (const program::KindInfo& kind : program::kinds()) {
        if (kind.kind == ProgramKind::RotaryCutter)
            continue; // the given pair is required
        const QString law =
            QString::fromLatin1(kind.kind == ProgramKind::PositionMove ? "quintic" : "half_modified_sine");
        QJsonObject program{{u"kind"_s, QString::fromLatin1(kind.key.data())}};
        program::Recipe expected = program::defaultRecipe(kind.kind);
        if (program::lawParameters(expected.program))
            program[u"law"_s] = law;
        const QJsonObject root{{u"format"_s, u"campanel-recipe"_s},
                               {u"format_version"_s, 1},
                               {u"name"_s, QString::fromStdString(expected.name)},
                               {u"program"_s, program}};
        const auto read = fromJson(QJsonDocument(root).toJson(), {});
        QVERIFY2(read, read ? "" : qPrintable(FileErrorText::describe(read.error())));
        QCOMPARE(toJson(*read), toJson(expected));
    }
}

// The files of cutters before they had a motor and a shaft.
void StoreKindsTest::cutterFilesWithoutAMotorMeanUnknown()
{
    QJsonObject root = QJsonDocument::fromJson(toJson(program::Recipe())).object();
    QJsonObject machine = root[u"machine"_s].toObject();
    for (const Field field : {Field::MaxTorque, Field::RatedTorque, Field::Inertia, Field::Friction,
                              Field::NaturalFrequency, Field::DampingRatio}) {
        const QString key = QString::fromLatin1(profile::info(field).id.data());
        QVERIFY(machine.contains(key));
        machine.remove(key);
    }
    root[u"machine"_s] = machine;
    const auto read = fromJson(QJsonDocument(root).toJson(), {});
    QVERIFY2(read, read ? "" : qPrintable(FileErrorText::describe(read.error())));
    QCOMPARE(read->machine.inertiaKgCm2, 0.0);
    QCOMPARE(read->machine.maxTorqueNm, 0.0);
    QCOMPARE(read->machine.ratedTorqueNm, 0.0);
    QCOMPARE(read->machine.frictionNm, 0.0);
    QCOMPARE(read->machine.naturalFrequencyHz, 0.0);
    QCOMPARE(toJson(*read), toJson(program::Recipe()));
}

void StoreKindsTest::fieldsOfOtherKindsAreUnknown()
{
    int refused = 0;
    for (const program::KindInfo& kind : program::kinds()) {
        for (const char* section : {"program", "machine"}) {
            const bool isProgram = QByteArray(section) == "program";
            const auto own = isProgram ? kind.programFields : kind.machineFields;
            for (const profile::FieldInfo& field : profile::fields) {
                if (std::ranges::find(own, field.field) != own.end())
                    continue;
                QJsonObject root =
                    QJsonDocument::fromJson(toJson(program::defaultRecipe(kind.kind))).object();
                QJsonObject inner = root[QLatin1String(section)].toObject();
                inner[QString::fromLatin1(field.id.data())] = field.defaultValue;
                root[QLatin1String(section)] = inner;
                const auto read = fromJson(QJsonDocument(root).toJson(), {});
                QVERIFY2(!read, field.id.data());
                QCOMPARE(read.error().kind, Kind::UnknownKey);
                QCOMPARE(read.error().key,
                         QLatin1String(section) + u'.' + QString::fromLatin1(field.id.data()));
                ++refused;
            }
        }
    }
    QVERIFY(refused > 100);
}

void StoreKindsTest::complaints_data()
{
    QTest::addColumn<ProgramKind>("kind");
    QTest::addColumn<QString>("key");
    QTest::addColumn<QJsonValue>("value"); // undefined: removed
    QTest::addColumn<Kind>("error");
    QTest::addColumn<QString>("word");
    const auto row = [](const char* tag, ProgramKind kind, const QString& key, const QJsonValue& value,
                        Kind error,
                        const QString& word) { QTest::newRow(tag) << kind << key << value << error << word; };
    const auto position = ProgramKind::PositionMove;
    const auto speed = ProgramKind::SpeedMove;
    const auto cam = ProgramKind::PointCam;
    row("a speed law for a position", position, u"law"_s, u"half_modified_sine"_s, Kind::NotAChoice,
        u"modified_sine"_s);
    row("an unknown law", speed, u"law"_s, u"spline"_s, Kind::NotAChoice, u"half_modified_sine"_s);
    row("no law", speed, u"law"_s, QJsonValue(QJsonValue::Undefined), Kind::MissingKey, u"program.law"_s);
    row("a law parameter of another law", position, u"law_parameters"_s, QJsonObject{{u"q"_s, 1}},
        Kind::UnknownKey, u"program.law_parameters.q"_s);
    row("a position over a distance", position, u"duration"_s, u"over_distance"_s, Kind::NotAChoice,
        u"given_time, fastest"_s);
    row("unknown execution", speed, u"execution"_s, u"steps"_s, Kind::NotAChoice, u"cam_points, intervals"_s);
    row("execution is a number", speed, u"execution"_s, 1, Kind::WrongType, u"a text"_s);
    row("unknown ends", cam, u"ends"_s, u"open"_s, Kind::NotAChoice, u"natural, clamped, periodic"_s);
    row("unknown ramp", cam, u"master_ramp_shape"_s, u"linear"_s, Kind::NotAChoice, u"trapezoid, s_curve"_s);
    row("a choice of another kind", cam, u"duration"_s, u"fastest"_s, Kind::UnknownKey,
        u"program.duration"_s);
    row("a press has no law", ProgramKind::Press, u"law"_s, u"cubic"_s, Kind::UnknownKey, u"program.law"_s);
    row("the cutter's law", position, u"speed_law"_s, u"cubic"_s, Kind::UnknownKey, u"program.speed_law"_s);
    row("knots of a move", position, u"knots"_s, QJsonArray{}, Kind::UnknownKey, u"program.knots"_s);
    row("half a point", position, u"cam_points"_s, 100.5, Kind::WrongType, u"a whole number"_s);
    row("knots are a number", cam, u"knots"_s, 5, Kind::WrongType, u"pairs of master angle"_s);
    row("knots are triples", cam, u"knots"_s, QJsonArray{QJsonArray{0, 1, 2}}, Kind::WrongType,
        u"pairs of master angle"_s);
    row("knots are numbers", cam, u"knots"_s, QJsonArray{0, 90, 180, 270, 360}, Kind::WrongType,
        u"pairs of master angle"_s);
    row("a knot in words", cam, u"knots"_s, QJsonArray{QJsonArray{0, u"top"_s}}, Kind::WrongType,
        u"pairs of master angle"_s);
    row("too slow", ProgramKind::Press, u"probe_speed_mm_per_s"_s, 1, Kind::OutOfRange, u"2 to 5 mm/s"_s);
}

void StoreKindsTest::complaints()
{
    QFETCH(ProgramKind, kind);
    QFETCH(QString, key);
    QFETCH(QJsonValue, value);
    QFETCH(Kind, error);
    QFETCH(QString, word);
    QJsonObject root = QJsonDocument::fromJson(toJson(program::defaultRecipe(kind))).object();
    QJsonObject inner = root[u"program"_s].toObject();
    inner[key] = value;
    root[u"program"_s] = inner;
    const QString path = put(u"wrong.json"_s, QJsonDocument(root).toJson());
    const auto read = readRecipe(path);
    QVERIFY(!read);
    const QString sentence = FileErrorText::describe(read.error());
    QVERIFY2(read.error().kind == error, qPrintable(sentence));
    QVERIFY2(sentence.contains(word) && sentence.contains(path), qPrintable(sentence));
}

void StoreKindsTest::listsTripAsCsv()
{
    constexpr unsigned seed = 4;
    qInfo("seed %u", seed);
    test::RandomRecipes random(seed);
    const QString path = m_directory.filePath(u"list.csv"_s);
    for (int i = 0; i < 20; ++i) {
        const ProgramKind kind = i % 2 == 0 ? ProgramKind::PointCam : ProgramKind::SegmentCam;
        const auto cam = random.around(kind).program;
        QVERIFY(writeListCsv(cam, path));
        profile::Program read = program::defaultRecipe(kind).program;
        const auto isRead = readListCsv(path, read);
        QVERIFY2(isRead, isRead ? "" : qPrintable(isRead.error()));
        QVERIFY(program::kindInfo(kind).list->isEqual(read, cam));
    }
    profile::Program european = profile::PointCamProgram{};
    QVERIFY(readListCsv(put(u"de.csv"_s, "master_deg;slave_mm\r\n0;0\r\n90,5;12,25\r\n"), european));
    const auto& knots = std::get<profile::PointCamProgram>(european).knots;
    QCOMPARE(knots.size(), std::size_t{2});
    QVERIFY((knots.back() == profile::Knot{90.5, 12.25}));
}

void StoreKindsTest::wrongKnotFiles_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("words");
    QTest::newRow("empty") << QByteArray() << u"line 1: expected the header master_deg,slave_mm"_s;
    QTest::newRow("no header") << QByteArray("0,0\n90,1\n") << u"line 1: expected the header"_s;
    QTest::newRow("header only") << QByteArray("master_deg,slave_mm\n") << u"at least one line of values"_s;
    QTest::newRow("three values") << QByteArray("master_deg,slave_mm\n0,0\n90,1,2\n")
                                  << u"line 3: expected 2 values, as in the header, found \"90,1,2\""_s;
    QTest::newRow("a word") << QByteArray("master_deg,slave_mm\n0,0\n\nninety,1\n")
                            << u"line 4: expected a number, found \"ninety\""_s;
    QTest::newRow("both decimal signs") << QByteArray("master_deg;slave_mm\n0,5;0\n1.5;1\n")
                                        << u"line 3: expected a number with a decimal comma"_s;
}

void StoreKindsTest::wrongKnotFiles()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, words);
    const QString path = put(u"wrong.csv"_s, text);
    profile::Program cam = profile::PointCamProgram{};
    const auto read = readListCsv(path, cam);
    QVERIFY(!read);
    QVERIFY2(read.error().startsWith(path) && read.error().contains(words), qPrintable(read.error()));
}

void StoreKindsTest::knotFilesThatCannotBeOpened()
{
    const QString path = m_directory.filePath(u"absent.csv"_s);
    profile::Program cam = profile::PointCamProgram{};
    const auto absent = readListCsv(path, cam);
    QVERIFY(!absent);
    QVERIFY2(absent.error().contains(path) && !absent.error().contains(u"recipe"_s),
             qPrintable(absent.error()));
    QVERIFY(QFile::exists(put(u"file"_s, "x")));
    const QString below = m_directory.filePath(u"file/knots.csv"_s);
    const auto written = writeListCsv(cam, below);
    QVERIFY(!written);
    QVERIFY2(written.error().contains(below) && !written.error().contains(u"recipe"_s),
             qPrintable(written.error()));
}

CAMPANEL_TEST(StoreKindsTest)

} // namespace test_kinds

#include "test_kinds.moc"
