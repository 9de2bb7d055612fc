// SPDX-License-Identifier: Apache-2.0
// The record of the system: one size a day, whatever the clock does, and how long the disk lasts.
#include "app/store/files/files.h"
#include "app/store/files/system_record.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

namespace test_system_record {

using namespace campanel::store;
using namespace Qt::StringLiterals;

class TestSystemRecord : public QObject {
    Q_OBJECT

private slots:
    void itComesBackAsItWas()
    {
        const QTemporaryDir folder;
        QCOMPARE(readSystemRecord(folder.path()), SystemRecord());
        const SystemRecord record{{{u"panel"_s, u"1.2.3"_s}, {u"gateway"_s, u"1.2.2"_s}},
                                  {{20'000, 5}, {20'001, 5'000'000'000}}};
        QVERIFY(writeSystemRecord(folder.path(), record));
        QCOMPARE(readSystemRecord(folder.path()), record);
        for (const char* damaged :
             {"", "{", "[]", "{\"software\": 5, \"data_bytes_by_day\": [1, [2], [3, -1], [\"x\", 1]]}"}) {
            QVERIFY(replaceBytes(folder.filePath(u"system.json"_s), damaged));
            QCOMPARE(readSystemRecord(folder.path()), SystemRecord());
        }
    }

    void oneSampleADay()
    {
        SystemRecord record;
        for (qint64 day = 20'000; day < 20'100; ++day) {
            addSample(record, day, day);
            addSample(record, day, day + 1);
        }
        QCOMPARE(record.samples.size(), sampledDays + 1);
        QCOMPARE(record.samples.first(), (DiskSample{20'069, 20'070}));
        QCOMPARE(record.samples.last(), (DiskSample{20'099, 20'100}));
        addSample(record, 20'090, 7); // the clock was set back
        QCOMPARE(record.samples.last(), (DiskSample{20'090, 7}));
        QCOMPARE(record.samples.size(), 22);
        addSample(record, 30'000, 8); // it was wrong before
        QCOMPARE(record.samples, (QList<DiskSample>{{30'000, 8}}));
    }

    void theDiskLastsAsLongAsItsGrowthSays_data()
    {
        QTest::addColumn<qint64>("days");
        QTest::addColumn<qint64>("bytesPerDay");
        QTest::addColumn<bool>("isKnown");
        QTest::addColumn<double>("years");
        QTest::addColumn<bool>("isShort");
        QTest::newRow("one day") << 1LL << 1'000'000LL << false << 0.0 << false;
        QTest::newRow("enough") << 10LL << 1'000'000LL << true << 36'525 / 365.25 << false;
        QTest::newRow("just enough") << 2LL << 20'000'000LL << true << 5.0 << false;
        QTest::newRow("too little") << 30LL << 20'000'001LL << true << 4.9999997 << true;
        QTest::newRow("no growth") << 30LL << 0LL << false << 0.0 << false;
        QTest::newRow("it shrinks") << 30LL << -5LL << false << 0.0 << false;
    }
    void theDiskLastsAsLongAsItsGrowthSays()
    {
        QFETCH(qint64, days);
        QFETCH(qint64, bytesPerDay);
        QFETCH(bool, isKnown);
        QFETCH(double, years);
        QFETCH(bool, isShort);
        SystemRecord record;
        for (qint64 day = 0; day <= days; ++day)
            addSample(record, 20'000 + day, 50'000'000'000 + day * bytesPerDay);
        const DiskForecast forecast = forecastOf(record, 36'525'000'000);
        QCOMPARE(forecast.days, days);
        QCOMPARE(forecast.years.has_value(), isKnown);
        QVERIFY(!isKnown || qAbs(*forecast.years - years) < 1e-6);
        QCOMPARE(forecast.isShort(), isShort);
        QVERIFY(!forecastOf({}, 1000).years);
    }

    void allFilesBelowAFolderCount()
    {
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath(u"a/b"_s));
        QVERIFY(replaceBytes(folder.filePath(u"a/b/.hidden"_s), QByteArray(1000, 'x')));
        QVERIFY(replaceBytes(folder.filePath(u"c"_s), QByteArray(24, 'x')));
        QVERIFY(QFile::link(u"/usr"_s, folder.filePath(u"link"_s)));
        QCOMPARE(sizeOfFolder(folder.path()), 1024);
        QCOMPARE(sizeOfFolder(folder.filePath(u"none"_s)), 0);
    }
};

CAMPANEL_TEST(TestSystemRecord)

} // namespace test_system_record

#include "test_system_record.moc"
