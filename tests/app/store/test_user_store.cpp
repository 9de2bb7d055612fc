// SPDX-License-Identifier: Apache-2.0
// Users in the database: the rules for adding and removing, wrong PINs that are counted across a restart,
// hashes.
#include "app/store/users/pin_hash.h"
#include "app/store/users/user_store.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace test_user_store {

using namespace campanel::store;
using namespace Qt::StringLiterals;

namespace {

constexpr qint64 nowMs = 1'790'000'000'000;

std::unique_ptr<Database> opened(const QTemporaryDir& folder)
{
    auto database = Database::open(folder.path());
    return database ? std::move(*database) : nullptr;
}

qint64 added(Database& database, const QString& name, UserLevel level)
{
    const auto user = addUser(database, name, level, u"hash of "_s + name);
    return user ? user->id : 0;
}

} // namespace

class TestUserStore : public QObject {
    Q_OBJECT

private slots:
    void pinsAreKeptAsHashesOnly()
    {
        const auto hash = hashPin(u"2580"_s);
        QVERIFY(hash);
        QVERIFY2(hash->startsWith(u"$argon2id$"), qPrintable(*hash));
        QVERIFY(!hash->contains(u"2580"));
        QVERIFY(isPin(*hash, u"2580"_s));
        QVERIFY(!isPin(*hash, u"2581"_s));
        QVERIFY(!isPin(*hash, u"25800"_s));
        QVERIFY(!isPin(u"nonsense"_s, u"2580"_s));
        QVERIFY(*hash != *hashPin(u"2580"_s)); // each with its own salt
    }

    void firstUserIsOfTheHighestLevel()
    {
        const QTemporaryDir folder;
        const auto database = opened(folder);
        const auto refused = addUser(*database, u"Anna"_s, UserLevel::Technician, u"hash"_s);
        QVERIFY(!refused && refused.error().kind == StoreError::Kind::Refused);
        QVERIFY(users(*database)->isEmpty());
        QVERIFY(added(*database, u"Anna"_s, UserLevel::Service));
    }

    void namesAreUniqueWhateverTheirCase()
    {
        const QTemporaryDir folder;
        const auto database = opened(folder);
        const qint64 anna = added(*database, u"Anna"_s, UserLevel::Service);
        QVERIFY(added(*database, u"Li Wei"_s, UserLevel::Service));
        QCOMPARE(added(*database, u"anna"_s, UserLevel::Operator), qint64{0});
        QVERIFY(removeUser(*database, anna));
        QVERIFY(added(*database, u"anna"_s, UserLevel::Operator)); // the name is free again
    }

    void lastServiceUserStays()
    {
        const QTemporaryDir folder;
        const auto database = opened(folder);
        const qint64 anna = added(*database, u"Anna"_s, UserLevel::Service);
        const qint64 bo = added(*database, u"Bo"_s, UserLevel::Technician);
        QVERIFY(!removeUser(*database, anna));
        QVERIFY(!setUserLevel(*database, anna, UserLevel::Operator));
        QCOMPARE(users(*database)->size(), 2);
        QCOMPARE(users(*database)->first().level, UserLevel::Service);
        QVERIFY(setUserLevel(*database, bo, UserLevel::Service));
        QVERIFY(removeUser(*database, anna));
        QCOMPARE(users(*database)->size(), 1);
        QVERIFY(!removeUser(*database, anna)); // removed already
    }

    void waitGrowsAndSurvivesAReopening()
    {
        const QTemporaryDir folder;
        qint64 now = nowMs;
        qint64 anna = 0;
        const QList<qint64> seconds{1, 2, 4, 8, 16, 32, 64, 128, 256, 300, 300};
        for (const qint64 wait : seconds) {
            const auto database = opened(folder); // opened again for each attempt
            if (anna == 0)
                anna = added(*database, u"Anna"_s, UserLevel::Service);
            const auto attempt = beginLogin(*database, anna, now);
            QVERIFY(attempt && !attempt->pinHash.isEmpty());
            QCOMPARE(attempt->waitMs, wait * 1000);
            // Too early: no hash is returned and nothing is counted.
            const auto early = beginLogin(*database, anna, now + wait * 1000 - 1);
            QVERIFY(early && early->pinHash.isEmpty());
            QCOMPARE(early->waitMs, 1);
            now += wait * 1000;
        }
        const auto database = opened(folder);
        QVERIFY(endLogin(*database, anna));
        QCOMPARE(beginLogin(*database, anna, now)->waitMs, 1000);
    }

    void waitOfAClockThatWasWrongIsOver_data()
    {
        QTest::addColumn<qint64>("aheadMs");
        constexpr qint64 hourMs = 3'600'000;
        QTest::newRow("ahead by ten years") << 87'600 * hourMs;
        QTest::newRow("ahead by two hours") << 2 * hourMs;
        QTest::newRow("ahead by ten seconds") << qint64{10'000};
        QTest::newRow("behind by two hours") << -2 * hourMs;
        QTest::newRow("at the beginning of time") << -nowMs;
    }

    void waitOfAClockThatWasWrongIsOver()
    {
        QFETCH(qint64, aheadMs);
        const QTemporaryDir folder;
        qint64 anna = 0;
        {
            const auto database = opened(folder);
            anna = added(*database, u"Anna"_s, UserLevel::Service);
            QVERIFY(beginLogin(*database, anna, nowMs + aheadMs));
        }
        const auto database = opened(folder); // after a restart
        QCOMPARE(waitMs(users(*database)->first(), nowMs), qint64{0});
        const auto attempt = beginLogin(*database, anna, nowMs);
        QVERIFY(attempt && !attempt->pinHash.isEmpty());
        // The wrong PIN was counted, and the next one begins a wait by the present clock.
        QCOMPARE(attempt->waitMs, 2000);
        QCOMPARE(beginLogin(*database, anna, nowMs + 500)->waitMs, 1500);
    }

    void aNewPinEndsTheWait()
    {
        const QTemporaryDir folder;
        const auto database = opened(folder);
        const qint64 anna = added(*database, u"Anna"_s, UserLevel::Service);
        QVERIFY(beginLogin(*database, anna, nowMs));
        QVERIFY(setUserPin(*database, anna, u"other"_s));
        QCOMPARE(beginLogin(*database, anna, nowMs)->pinHash, u"other"_s);
    }

    void removedUserCannotLogIn()
    {
        const QTemporaryDir folder;
        const auto database = opened(folder);
        QVERIFY(added(*database, u"Anna"_s, UserLevel::Service));
        const qint64 bo = added(*database, u"Bo"_s, UserLevel::Service);
        QVERIFY(removeUser(*database, bo));
        QVERIFY(!beginLogin(*database, bo, nowMs));
        auto kept = database->execute(u"SELECT pin FROM user WHERE id = ?"_s, {bo});
        QVERIFY(kept && kept->next());
        QVERIFY(kept->value(0).toString().isEmpty());
    }
};

CAMPANEL_TEST(TestUserStore)

} // namespace test_user_store

#include "test_user_store.moc"
