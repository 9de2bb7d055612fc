// SPDX-License-Identifier: Apache-2.0
// Recipe files: data is read back, errors are named, good files are kept.
#include "app/store/files/files.h"
#include "app/store/recipes/last_recipe.h"
#include "app/store/recipes/recipe_file.h"

#include "profile/laws/laws.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include <unistd.h>

namespace test_store {

using namespace campanel;
using namespace campanel::store;
using namespace Qt::StringLiterals;
using Kind = FileError::Kind;

class StoreTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void trip();
    void documentedExample();
    void absentValuesHaveTheirDefaults();
    void everyLawTrips();
    void complaints_data();
    void complaints();
    void aKeyThatOccursTwice_data();
    void aKeyThatOccursTwice();
    void absentFile();
    void unreadable();
    void unwritable();
    void savingKeepsTheLastGoodCopy();
    void powerCutWhileSaving_data();
    void powerCutWhileSaving();
    void damagedFileDoesNotReplaceTheGoodCopy();
    void nothingSavedYet();
    void bothDamaged();

private:
    [[nodiscard]] QString path(const QString& name) const { return m_directory->filePath(name); }
    static void put(const QString& path, const QByteArray& bytes);

    std::unique_ptr<QTemporaryDir> m_directory;
};

void StoreTest::init()
{
    m_directory = std::make_unique<QTemporaryDir>();
    QVERIFY(m_directory->isValid());
}

void StoreTest::put(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

void StoreTest::trip()
{
    program::Recipe recipe;
    recipe.name = "饼干 250";
    recipe.version = 41;
    recipe.cutter().pinned = {profile::Field::FilmSpeed, profile::Field::BagLength};
    recipe.cutter().filmSpeedMmPerS = 251.3;
    recipe.cutter().k = {4.1, 2.51, 1.6667, 1.3333};
    recipe.machine.gearNumerator = 7;
    recipe.machine.gearDenominator = 3;
    recipe.machine.maxKnifeAccelerationMmPerS2 = 12345.5;
    QVERIFY(writeRecipe(recipe, path(u"deep/er/a.json"_s)).has_value());
    const auto read = readRecipe(path(u"deep/er/a.json"_s));
    QVERIFY2(read.has_value(), read ? "" : qPrintable(FileErrorText::describe(read.error())));
    QCOMPARE(toJson(*read), toJson(recipe));
    QCOMPARE(read->name, recipe.name);
    QVERIFY(read->cutter().pinned == recipe.cutter().pinned);
    QCOMPARE(read->cutter().filmSpeedMmPerS, 251.3);
    QCOMPARE(read->machine.gearDenominator, 3);
    QCOMPARE(read->machine.maxKnifeAccelerationMmPerS2, 12345.5);
}

void StoreTest::documentedExample()
{
    const QByteArray example =
        R"({"format":"campanel-recipe","format_version":1,"name":"Biscuit 250","version":7,
        "program":{"kind":"rotary_cutter","pinned":["bag_length_mm","rate_bags_per_min"],"bag_length_mm":250,
        "rate_bags_per_min":60,"base_speed_mm_per_s":null,"film_speed_mm_per_s":null,"k1":4,"k2":2.5,"k3":1.6667,
        "k4":1.3333,"speed_law":"cubic","speed_law_parameters":{},"sync_ratio":1,"slices_per_ramp":60},
        "machine":{"knife_radius_mm":60,"knives":1,"pulses_per_motor_rev":10000,"gear_numerator":1,
        "gear_denominator":1,"max_motor_rpm":3000,"max_knife_acceleration_mm_per_s2":50000,
        "max_pulse_frequency_hz":200000}})";
    const auto read = fromJson(example, u"example"_s);
    QVERIFY2(read.has_value(), read ? "" : qPrintable(FileErrorText::describe(read.error())));
    QCOMPARE(read->version, 7);
    QCOMPARE(read->cutter().k[2], 1.6667);
}

void StoreTest::absentValuesHaveTheirDefaults()
{
    const auto read = fromJson(R"({"format":"campanel-recipe","format_version":1,"name":"Short","program":
        {"kind":"rotary_cutter","pinned":["bag_length_mm","film_speed_mm_per_s"],"bag_length_mm":260,
        "film_speed_mm_per_s":130,"speed_law":"trapezoid","k4":null}})",
                               u"short"_s);
    QVERIFY2(read.has_value(), read ? "" : qPrintable(FileErrorText::describe(read.error())));
    QCOMPARE(read->cutter().filmSpeedMmPerS, 130.0);
    QCOMPARE(read->cutter().k[3], profile::info(profile::Field::K4).defaultValue);
    QVERIFY(read->cutter().speedLawParameters ==
            profile::defaultParameters(*profile::findLaw(profile::LawId::Trapezoid)));
    QCOMPARE(read->machine.knifeRadiusMm, profile::info(profile::Field::KnifeRadius).defaultValue);
}

void StoreTest::everyLawTrips()
{
    for (const profile::Law& law : profile::laws()) {
        if (!law.isSpeedLaw)
            continue;
        program::Recipe recipe;
        recipe.cutter().speedLaw = law.id;
        for (std::size_t i = 0; i < law.parameters.size(); ++i)
            recipe.cutter().speedLawParameters[i] = (law.parameters[i].min + law.parameters[i].max) / 2;
        const auto read = fromJson(toJson(recipe), {});
        QVERIFY2(read.has_value(), read ? "" : qPrintable(FileErrorText::describe(read.error())));
        QCOMPARE(read->cutter().speedLaw, law.id);
        QVERIFY(read->cutter().speedLawParameters == recipe.cutter().speedLawParameters);
    }
}

void StoreTest::complaints_data()
{
    QTest::addColumn<QString>("section");
    QTest::addColumn<QString>("key");
    QTest::addColumn<QJsonValue>("value"); // undefined: removed
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("word");
    const auto row = [](const char* tag, const QString& section, const QString& key, const QJsonValue& value,
                        Kind kind, const QString& word) {
        QTest::newRow(tag) << section << key << value << static_cast<int>(kind) << word;
    };
    const QJsonValue removed(QJsonValue::Undefined);
    row("another format", {}, u"format"_s, u"recipe"_s, Kind::NotARecipe, u"campanel-recipe"_s);
    row("a later version", {}, u"format_version"_s, 7, Kind::NewerVersion, u"version 7"_s);
    row("no version", {}, u"format_version"_s, removed, Kind::WrongType, u"format_version"_s);
    row("no name", {}, u"name"_s, removed, Kind::MissingKey, u"name"_s);
    row("name is a number", {}, u"name"_s, 5, Kind::WrongType, u"a text"_s);
    row("name too long", {}, u"name"_s, QString(33, u'x'), Kind::TooLong, u"32 bytes"_s);
    row("recipe version 0", {}, u"version"_s, 0, Kind::OutOfRange, u"1 to 65535"_s);
    row("no program", {}, u"program"_s, removed, Kind::MissingKey, u"program"_s);
    row("machine is a list", {}, u"machine"_s, QJsonArray{}, Kind::WrongType, u"machine"_s);
    row("misspelled section", {}, u"machines"_s, QJsonObject{}, Kind::UnknownKey, u"machines"_s);
    row("misspelled key", u"program"_s, u"bag_lenght_mm"_s, 1, Kind::UnknownKey, u"program.bag_lenght_mm"_s);
    row("pinned value missing", u"program"_s, u"rate_bags_per_min"_s, QJsonValue::Null, Kind::MissingKey,
        u"program.rate_bags_per_min"_s);
    row("text for a number", u"program"_s, u"k1"_s, u"4"_s, Kind::WrongType,
        u"program.k1 must be a number"_s);
    row("out of range", u"program"_s, u"bag_length_mm"_s, 5, Kind::OutOfRange, u"10 to 2000 mm"_s);
    row("half a slice", u"program"_s, u"slices_per_ramp"_s, 20.5, Kind::WrongType, u"a whole number"_s);
    row("unknown kind", u"program"_s, u"kind"_s, u"gearbox"_s, Kind::NotAChoice, u"rotary_cutter"_s);
    row("unknown law", u"program"_s, u"speed_law"_s, u"spline"_s, Kind::NotAChoice, u"cubic"_s);
    row("one pin", u"program"_s, u"pinned"_s, QJsonArray{u"bag_length_mm"_s}, Kind::WrongType, u"two"_s);
    row("the same pin twice", u"program"_s, u"pinned"_s, QJsonArray{u"bag_length_mm"_s, u"bag_length_mm"_s},
        Kind::WrongType, u"two"_s);
    row("a pin that is none", u"program"_s, u"pinned"_s, QJsonArray{u"bag_length_mm"_s, u"k1"_s},
        Kind::WrongType, u"two"_s);
    row("law parameter unknown", u"program"_s, u"speed_law_parameters"_s, QJsonObject{{u"q"_s, 1}},
        Kind::UnknownKey, u"program.speed_law_parameters.q"_s);
    row("no knife", u"machine"_s, u"knives"_s, 0, Kind::OutOfRange, u"machine.knives is 0; enter 1 to 12"_s);
}

void StoreTest::complaints()
{
    QFETCH(QString, section);
    QFETCH(QString, key);
    QFETCH(QJsonValue, value);
    QFETCH(int, kind);
    QFETCH(QString, word);
    QJsonObject root = QJsonDocument::fromJson(toJson(program::Recipe{})).object();
    if (section.isEmpty()) {
        root[key] = value;
    } else {
        QJsonObject inner = root[section].toObject();
        inner[key] = value;
        root[section] = inner;
    }
    const QString file = path(u"wrong.json"_s);
    put(file, QJsonDocument(root).toJson());
    const auto read = readRecipe(file);
    QVERIFY(!read.has_value());
    const QString sentence = FileErrorText::describe(read.error());
    QVERIFY2(static_cast<int>(read.error().kind) == kind, qPrintable(sentence));
    QVERIFY2(sentence.contains(word) && sentence.contains(file), qPrintable(sentence));
}

void StoreTest::aKeyThatOccursTwice_data()
{
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<QString>("key");
    QTest::newRow("outside") << QByteArray("\"name\":") << QByteArray("\"name\": \"a\", \"name\":")
                             << u"name"_s;
    QTest::newRow("inside") << QByteArray("\"k1\":") << QByteArray("\"k1\": 4, \"k1\":") << u"program.k1"_s;
    QTest::newRow("written in another way")
        << QByteArray("\"k1\":") << QByteArray("\"\\u006b1\": 4, \"k1\":") << u"program.k1"_s;
    QTest::newRow("in a text, which is none")
        << QByteArray("\"name\": \"") << QByteArray("\"name\": \"{\\\"a\\\":1,\\\"a\\\":2} ") << QString();
}

void StoreTest::aKeyThatOccursTwice()
{
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    QFETCH(QString, key);
    QByteArray json = toJson(program::Recipe{});
    QVERIFY(json.contains(from));
    const auto read = fromJson(json.replace(from, to), u"twice.json"_s);
    QCOMPARE(read.has_value(), key.isEmpty());
    if (read)
        return;
    QCOMPARE(read.error().kind, Kind::RepeatedKey);
    QCOMPARE(read.error().key, key);
}

void StoreTest::absentFile()
{
    QCOMPARE(readRecipe(path(u"absent.json"_s)).error().kind, Kind::NotFound);
}

void StoreTest::unreadable()
{
    QCOMPARE(readRecipe(m_directory->path()).error().kind, Kind::NotReadable);
}

void StoreTest::unwritable()
{
    // A file where the folder should be.
    put(path(u"file"_s), "x");
    const auto written = writeRecipe({}, path(u"file/recipe.json"_s));
    QVERIFY(!written.has_value());
    QCOMPARE(written.error().kind, Kind::NotWritable);
    QVERIFY(FileErrorText::describe(written.error()).contains(u"unchanged"_s));
}

void StoreTest::savingKeepsTheLastGoodCopy()
{
    const LastRecipe last(path(u"last.json"_s));
    program::Recipe recipe;
    recipe.version = 1;
    QVERIFY(last.save(recipe).has_value());
    QVERIFY(!QFile::exists(backupPath(last.path())));
    recipe.version = 2;
    QVERIFY(last.save(recipe).has_value());
    QCOMPARE(last.load().recipe.version, 2);
    QVERIFY(last.load().notice.isEmpty());
    QCOMPARE(readRecipe(backupPath(last.path()))->version, 1);
}

void StoreTest::powerCutWhileSaving_data()
{
    QTest::addColumn<int>("bytes");
    const auto size = static_cast<int>(toJson(program::Recipe{}).size());
    for (int bytes = 0; bytes < size - 2; bytes += 97)
        QTest::addRow("%d bytes written", bytes) << bytes;
}

void StoreTest::powerCutWhileSaving()
{
    // The new file is written beside the old one; a power cut leaves a temporary file that is never read.
    QFETCH(int, bytes);
    const LastRecipe last(path(u"last.json"_s));
    program::Recipe recipe;
    recipe.version = 5;
    QVERIFY(last.save(recipe).has_value());
    put(path(u"last.json.AbCdEf"_s), toJson(recipe).left(bytes));
    QCOMPARE(last.load().recipe.version, 5);
    QVERIFY(last.load().notice.isEmpty());
    // A disk that lost the end of the file itself.
    recipe.version = 6;
    QVERIFY(last.save(recipe).has_value());
    put(last.path(), toJson(recipe).left(bytes));
    const LastRecipe::Loaded loaded = last.load();
    QCOMPARE(loaded.recipe.version, 5);
    QVERIFY2(loaded.notice.contains(u"last good copy"_s), qPrintable(loaded.notice));
}

void StoreTest::damagedFileDoesNotReplaceTheGoodCopy()
{
    const LastRecipe last(path(u"last.json"_s));
    program::Recipe recipe;
    recipe.version = 1;
    QVERIFY(last.save(recipe).has_value());
    recipe.version = 2;
    QVERIFY(last.save(recipe).has_value());
    put(last.path(), "{");
    recipe.version = 3;
    QVERIFY(last.save(recipe).has_value());
    QCOMPARE(readRecipe(backupPath(last.path()))->version, 1);
    QCOMPARE(last.load().recipe.version, 3);
}

void StoreTest::nothingSavedYet()
{
    const LastRecipe::Loaded loaded = LastRecipe(path(u"last.json"_s)).load();
    QVERIFY(loaded.notice.isEmpty());
    QCOMPARE(loaded.recipe.name, std::string("Biscuit 250"));
}

void StoreTest::bothDamaged()
{
    const LastRecipe last(path(u"last.json"_s));
    put(last.path(), "[1,");
    put(backupPath(last.path()), "");
    QTest::ignoreMessage(QtWarningMsg, QRegularExpression(u"damaged at byte .* default recipe"_s));
    const LastRecipe::Loaded loaded = last.load();
    QVERIFY2(loaded.notice.contains(u"default recipe"_s), qPrintable(loaded.notice));
    QCOMPARE(loaded.recipe.cutter().bagLengthMm, 250.0);
}

CAMPANEL_TEST(StoreTest)

} // namespace test_store

#include "test_store.moc"
