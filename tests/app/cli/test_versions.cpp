// SPDX-License-Identifier: Apache-2.0
// campanelctl versions: what the controller says, what the panel has left, and "unknown" for the rest.
#include "app/store/files/files.h"
#include "app/store/recipes/recipe_json.h"
#include "campanelctl_call.h"
#include "tests/support/controller_process.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <QTemporaryDir>

namespace test_versions {

using namespace campanel;
using namespace Qt::StringLiterals;
using namespace campanel::test;

class CliVersionsTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsNotAskedIsUnknown()
    {
        const Result text = call(u"versions"_s);
        QCOMPARE(text.code, int{Ok});
        const QByteArray version = call(u"--version"_s).out.trimmed().split(' ').last();
        QVERIFY2(text.out.contains("campanelctl     " + version + '\n'), text.out);
        for (const char* key : {"panel", "gateway", "controller", "active_program", "open_recipe", "disk"})
            QVERIFY2(text.out.contains(QByteArray(key).leftJustified(16) + "unknown\n"), text.out);
        const QJsonObject json = call(u"versions --format json"_s).json();
        QVERIFY(json.contains(u"controller"_s) && json[u"controller"_s].isNull());
    }

    void theControllerSaysWhatItRuns()
    {
        const ControllerProcess controller;
        const QStringList port{u"--port"_s, controller.port()};
        const QJsonObject empty = call(QStringList{u"versions"_s, u"--format"_s, u"json"_s} + port).json();
        QVERIFY(!empty[u"controller"_s][u"firmware"_s].toString().isEmpty());
        QVERIFY(!empty[u"controller"_s][u"register_map"_s].toString().isEmpty());
        QCOMPARE(empty[u"controller"_s][u"unique_id"_s].toString().size(), 16);
        QVERIFY(empty[u"active_program"_s].isNull());
        QCOMPARE(call(QStringList{u"download"_s} + port).code, int{Ok});
        const QJsonObject json = call(QStringList{u"versions"_s, u"--format"_s, u"json"_s} + port).json();
        const QJsonObject status = call(QStringList{u"status"_s, u"--format"_s, u"json"_s} + port).json();
        const QJsonValue program = json[u"active_program"_s];
        QCOMPARE(program[u"kind"_s], u"rotary_cutter"_s);
        QCOMPARE(program[u"crc32"_s], status[u"active_crc32"_s]);
        QCOMPARE(program[u"generation"_s], status[u"generation"_s]);
        for (const QString& key : {u"name"_s, u"version"_s})
            QCOMPARE(program[key], status[u"program"_s][key]);
        QVERIFY(json[u"panel"_s].isNull());
    }

    // A line without a controller is an error; the rest is printed all the same.
    void withoutAControllerTheRestIsThere()
    {
        const QTemporaryDir folder;
        QVERIFY(store::replaceBytes(
            folder.filePath(u"system.json"_s),
            R"({"software": {"panel": "7.1", "gateway": "7.2\nforged"}, "data_bytes_by_day": [[20000, 1000000000], [20010, 6000000000000000]]})"));
        program::Recipe recipe;
        recipe.name = "Biscuit 250";
        recipe.version = 8;
        QVERIFY(store::replaceBytes(folder.filePath(u"recipe.json"_s), store::toJson(recipe)));
        const QStringList words{u"versions"_s, u"--data"_s, folder.path(), u"--port"_s, u"/dev/ttyNONE7"_s};
        const Result result = call(words);
        QCOMPARE(result.code, int{Link});
        QVERIFY2(result.out.contains("7.1\n") && result.out.contains("Biscuit 250\n") &&
                     result.out.contains("7.2\\u000aforged\n"),
                 result.out);
        QVERIFY2(result.out.contains("The disk lasts for less than five years."), result.out);
        const QJsonObject disk =
            call(QStringList{u"versions"_s, u"--data"_s, folder.path(), u"--format"_s, u"json"_s})
                .json()[u"disk"_s]
                .toObject();
        QCOMPARE(disk[u"measured_days"_s], 10);
        QCOMPARE(disk[u"growth_mb_per_day"_s].toDouble(), 5.999999e8);
        QVERIFY(disk[u"years"_s].toDouble() < 5);
        QCOMPARE(call(u"versions --data /nowhere"_s).code, int{File});
    }
};

CAMPANEL_TEST(CliVersionsTest)

} // namespace test_versions

#include "test_versions.moc"
