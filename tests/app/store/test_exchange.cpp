// SPDX-License-Identifier: Apache-2.0
// Import and export of knots at the exchange places: offers, refusals, unique names, disks that fail.
#include "app/store/files/ask_places.h"
#include "app/store/recipes/list_file.h"
#include "app/store/recipes/recipe_file.h"
#include "tests/support/full_disk.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace test_exchange {

using namespace campanel;
using namespace campanel::store;
using test::FullDisk;
using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace {

void put(const QString& path, const QByteArray& bytes, const QDateTime& changed = {})
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.flush())
        qFatal("%s", qPrintable(file.errorString()));
    if (changed.isValid())
        file.setFileTime(changed, QFileDevice::FileModificationTime);
}

QByteArray csv(const QList<QByteArray>& lines)
{
    return "master_deg,slave_mm\n" + lines.join('\n') + '\n';
}

const profile::Program defaultCam = profile::PointCamProgram{};

} // namespace

class TestExchange : public QObject {
    Q_OBJECT

private slots:
    void onlyMountsOfMediaAreRemovable_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<bool>("isRemovable");
        QTest::newRow("a user's stick") << "/media/panel/KINGSTON" << true;
        QTest::newRow("a stick") << "/media/usb0" << true;
        QTest::newRow("a session's stick") << "/run/media/panel/KINGSTON" << true;
        QTest::newRow("by hand") << "/mnt/stick" << true;
        QTest::newRow("the system") << "/" << false;
        QTest::newRow("the user's data") << "/home" << false;
        QTest::newRow("a runtime folder") << "/run/user/1000" << false;
        QTest::newRow("named alike") << "/mediathek/usb" << false;
        QTest::newRow("a way out") << "/media/../etc" << false;
    }
    void onlyMountsOfMediaAreRemovable()
    {
        QFETCH(QString, path);
        QFETCH(bool, isRemovable);
        QCOMPARE(isRemovableMount(path), isRemovable);
    }

    void thePanelsOwnFolderIsAlwaysAPlace()
    {
        const QTemporaryDir folder;
        const QString own = folder.filePath(u"data/knots"_s);
        const QList<Place> places = exchangePlaces(own);
        QVERIFY(!places.isEmpty());
        QCOMPARE(places.last().path, own);
        QVERIFY(!places.last().isReadOnly);
        QVERIFY(QFileInfo(own).isDir());
        for (const Place& place : places.first(places.size() - 1))
            QVERIFY2(isRemovableMount(place.path), qPrintable(place.path));
    }

    void namesAreFreeAndPortable_data()
    {
        QTest::addColumn<QString>("recipe");
        QTest::addColumn<QStringList>("present");
        QTest::addColumn<QString>("file");
        QTest::newRow("plain") << "Pusher" << QStringList() << "Pusher.csv";
        QTest::newRow("taken") << "Pusher" << QStringList{"Pusher.csv"} << "Pusher-2.csv";
        QTest::newRow("twice taken") << "Pusher" << QStringList{"Pusher.csv", "Pusher-2.csv"}
                                     << "Pusher-3.csv";
        QTest::newRow("a path") << "../etc/passwd" << QStringList() << "_etc_passwd.csv";
        QTest::newRow("not for a stick") << "a<b>:\"c\"|d?*\\ " << QStringList() << "a_b___c__d___.csv";
        QTest::newRow("hidden, empty at its end") << " .. x. " << QStringList() << "x.csv";
        QTest::newRow("nothing left") << "..." << QStringList() << "recipe.csv";
        for (const char* device :
             {"AUX", "Con", "nul", "PRN", "COM1", "lpt9", "aux.old", "NUL .x", "COM\xC2\xB2"})
            QTest::addRow("a device: %s", device)
                << QString::fromUtf8(device) << QStringList() << u"_%1.csv"_s.arg(QString::fromUtf8(device));
        QTest::newRow("no device") << "Auxiliary COM10" << QStringList() << "Auxiliary COM10.csv";
        QTest::newRow("a device, spaces behind") << "AUX  . ." << QStringList() << "_AUX.csv";
        QTest::newRow("other capitals") << "PUSHER" << QStringList{"Pusher.csv"} << "PUSHER-2.csv";
        QTest::newRow("other capitals, not ASCII")
            << u"tüte"_s << QStringList{u"TÜTE.CSV"_s} << u"tüte-2.csv"_s;
        QTest::newRow("hidden signs") << u"a\u202Eb\u200Bc\x7F"_s << QStringList() << "a_b_c_.csv";
        QTest::newRow("long") << QString(300, u'面') << QStringList() << QString(64, u'面') + u".csv"_s;
        QTest::newRow("long, of two units") << QString(u"🧁"_s).repeated(200) << QStringList()
                                            << QString(u"🧁"_s).repeated(32) + u".csv"_s;
        QTest::newRow("Chinese") << u"推料凸轮"_s << QStringList() << u"推料凸轮.csv"_s;
    }
    void namesAreFreeAndPortable()
    {
        QFETCH(QString, recipe);
        QFETCH(QStringList, present);
        QFETCH(QString, file);
        const QTemporaryDir folder;
        for (const QString& name : present)
            put(folder.filePath(name), "x");
        const Place place{folder.path(), u"STICK"_s, false};
        QCOMPARE(QFileInfo(exportPath(recipe, place)).fileName(), file);
        QCOMPARE(QFileInfo(exportPath(recipe, place)).absolutePath(), folder.path());
    }

    void whatIsExportedIsOfferedAndNeverReplaced()
    {
        const QTemporaryDir folder;
        const Place place{folder.path(), u"STICK"_s, false};
        profile::PointCamProgram cam;
        const auto first = exportList(cam, u"Pusher"_s, place);
        QVERIFY2(first, first ? "" : qPrintable(first.error()));
        cam.knots[1].slaveMm = 1.25;
        const auto second = exportList(cam, u"Pusher"_s, place);
        QVERIFY2(second, second ? "" : qPrintable(second.error()));
        QVERIFY(*first != *second);
        const QList<ListOffer> offers = offeredLists({place}, defaultCam);
        QCOMPARE(offers.size(), 2);
        for (const ListOffer& offer : offers) {
            QVERIFY2(offer.isUsable(), qPrintable(offer.problem));
            QCOMPARE(offer.placeName, u"STICK"_s);
            QVERIFY(offer.changed.isValid());
            QCOMPARE(std::get<profile::PointCamProgram>(offer.program).knots == cam.knots,
                     offer.path == *second);
        }
    }

    // The link is on the stick of somebody else; what it names is not there yet.
    void noLinkIsFollowed_data()
    {
        QTest::addColumn<bool>("isThere");
        QTest::newRow("to a file that is not there") << false;
        QTest::newRow("to a file") << true;
    }
    void noLinkIsFollowed()
    {
        QFETCH(bool, isThere);
        const QTemporaryDir stick;
        const QTemporaryDir home;
        const QString target = home.filePath(u"autostart.csv"_s);
        if (isThere)
            put(target, "old");
        QVERIFY(QFile::link(target, stick.filePath(u"Pusher.csv"_s)));
        const Place place{stick.path(), u"STICK"_s, false};
        const auto written = exportList(defaultCam, u"Pusher"_s, place);
        QVERIFY2(written, written ? "" : qPrintable(written.error()));
        QCOMPARE(*written, stick.filePath(u"Pusher-2.csv"_s));
        QVERIFY(!QFileInfo(*written).isSymLink());
        QCOMPARE(QFile::exists(target), isThere);
        QCOMPARE(QFileInfo(target).size(), isThere ? 3 : 0);
        QCOMPARE(QDir(stick.path())
                     .entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot)
                     .size(),
                 2);                                           // nothing temporary
        QCOMPARE(offeredLists({place}, defaultCam).size(), 1); // nor is it read
    }

    void whatIsMissingInAListIsSaid()
    {
        const QTemporaryDir folder;
        for (const char* name : {"a.csv", "b.CSV", "c.csv", "d.txt"})
            put(folder.filePath(QString::fromLatin1(name)), "x");
        Place place{folder.path(), u"STICK"_s, false};
        QVERIFY(filesIn(place, u"*.csv"_s, 3).notice.isEmpty());
        const FolderFiles two = filesIn(place, u"*.csv"_s, 2);
        QCOMPARE(two.files.size(), 2);
        QVERIFY2(two.notice.startsWith(u"1 older files of "_s + folder.path()), qPrintable(two.notice));
        place.isSilent = true;
        const auto offers = offeredLists({place}, defaultCam);
        QCOMPARE(offers.size(), 1);
        QVERIFY(offers[0].isNotice && !offers[0].isUsable());
        QVERIFY2(offers[0].problem.contains(u"does not answer"_s), qPrintable(offers[0].problem));
    }

    void everyRecipeOfALongListIsOffered()
    {
        const QTemporaryDir folder;
        for (int i = 0; i < 2003; ++i)
            put(folder.filePath(u"%1.json"_s.arg(i)), "{}");
        const auto offers = offeredRecipes({{folder.path(), u"STICK"_s}}, {});
        QCOMPARE(offers.size(), 2001);
        const FileError& last = offers.last().recipe.error();
        QCOMPARE(static_cast<int>(last.kind), static_cast<int>(FileError::Kind::NotShown));
        QVERIFY2(FileErrorText::describe(last).startsWith(u"3 older files of "_s), qPrintable(last.found));
    }

    // A share that never answers: its thread waits in the kernel and cannot be ended.
    void aSilentPlaceHidesNoOther()
    {
        const auto gate = std::make_shared<std::promise<void>>();
        const std::shared_future<void> opened = gate->get_future().share();
        const auto calls = std::make_shared<std::atomic<int>>(0);
        const std::function<QString(const Place&)> ask = [opened, calls](const Place& place) {
            ++*calls;
            if (place.name == u"share"_s)
                opened.wait();
            return place.name;
        };
        const QList<Place> places{{u"/mnt/share"_s, u"share"_s}, {u"/media/stick"_s, u"stick"_s}};
        for (const int asked : {2, 3}) { // the share is not asked again
            const auto answers = askPlaces<QString>(places, ask, 500ms);
            QVERIFY(!answers[0]);
            QCOMPARE(answers[1], u"stick"_s);
            QCOMPARE(calls->load(), asked);
        }
        gate->set_value();
        QTRY_VERIFY(askPlaces<QString>(places, ask, 500ms)[0]);
    }

    void theNewestFileComesFirst()
    {
        const QTemporaryDir stick;
        const QTemporaryDir own;
        const QDateTime day(QDate(2026, 1, 15), QTime(12, 0));
        put(stick.filePath(u"old.csv"_s), "x", day);
        put(own.filePath(u"new.CSV"_s), "x", day.addSecs(120));
        put(stick.filePath(u"newer.csv"_s), "x", day.addSecs(180));
        put(stick.filePath(u"other.txt"_s), "x");
        QVERIFY(QDir(stick.path()).mkdir(u"folder.csv"_s));
        const auto offers =
            offeredLists({{stick.path(), u"STICK"_s, false}, {own.path(), u"own"_s, false}}, defaultCam);
        QStringList names;
        for (const ListOffer& offer : offers)
            names << QFileInfo(offer.path).fileName();
        QCOMPARE(names, (QStringList{"newer.csv", "new.CSV", "old.csv"}));
    }

    void aRefusalNamesItsLine_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("line");
        QTest::newRow("not ascending") << csv({"0,0", "90,1", "", "80,2", "270,1", "360,0"}) << 5;
        QTest::newRow("too close") << csv({"0,0", "90,1", "90.01,2", "270,1", "360,0"}) << 4;
        QTest::newRow("beyond the cycle") << csv({"0,0", "90,1", "180,2", "270,1", "400,0"}) << 6;
        QTest::newRow("no end") << csv({"0,0", "90,1", "180,2", "270,1", "350,0"}) << 6;
        QTest::newRow("too few") << csv({"0,0", "360,0"}) << 2;
    }
    void aRefusalNamesItsLine()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, line);
        const QTemporaryDir folder;
        put(folder.filePath(u"wrong.csv"_s), text);
        const auto offers = offeredLists({{folder.path(), u"STICK"_s, false}}, defaultCam);
        QCOMPARE(offers.size(), 1);
        QVERIFY(!offers[0].isUsable());
        QVERIFY(offers[0].problem.isEmpty() && offers[0].refusal);
        QCOMPARE(offers[0].refusedLine, line);
    }

    void aFileThatIsNoCsvSaysWhy()
    {
        const QTemporaryDir folder;
        put(folder.filePath(u"photo.csv"_s), QByteArray("\xFF\xD8\xFF\0\x10", 5));
        const auto offers = offeredLists({{folder.path(), u"STICK"_s, false}}, defaultCam);
        QCOMPARE(offers.size(), 1);
        QVERIFY2(offers[0].problem.contains(u"photo.csv is not UTF-8 text"_s), qPrintable(offers[0].problem));
    }

    void aFullDiskLeavesTheFileThatWasThere()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"kept.csv"_s);
        profile::PointCamProgram cam;
        QVERIFY(writeListCsv(cam, path));
        cam.knots[1].slaveMm = 7;
        {
            const FullDisk full;
            QVERIFY(!writeListCsv(cam, path));
        }
        profile::Program kept = cam;
        QVERIFY(readListCsv(path, kept));
        QVERIFY(std::get<profile::PointCamProgram>(kept).knots == profile::defaultKnots());
    }

    void aDiskThatFailsIsASentence_data()
    {
        QTest::addColumn<bool>("isFull");
        QTest::newRow("full") << true;
        QTest::newRow("pulled out") << false;
    }
    void aDiskThatFailsIsASentence()
    {
        QFETCH(bool, isFull);
        const QTemporaryDir folder;
        const Place place{isFull ? folder.path() : folder.filePath(u"gone"_s), u"STICK"_s, false};
        const auto written = [&]() -> tl::expected<QString, QString> {
            if (!isFull)
                return exportList(defaultCam, u"Pusher"_s, place);
            const FullDisk full;
            return exportList(defaultCam, u"Pusher"_s, place);
        }();
        QVERIFY(!written);
        QVERIFY2(written.error().contains(place.path) && written.error().contains(u"cannot be written"_s) &&
                     written.error().contains(u"choose another location"_s),
                 qPrintable(written.error()));
        QVERIFY(QDir(folder.path()).isEmpty()); // no partial file
        QCOMPARE(offeredLists({place}, defaultCam).size(), 0);
    }
};

CAMPANEL_TEST(TestExchange)

} // namespace test_exchange

#include "test_exchange.moc"
