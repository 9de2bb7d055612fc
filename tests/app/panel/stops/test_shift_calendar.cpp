// SPDX-License-Identifier: Apache-2.0
// Shifts over midnight and over both changes of daylight saving in Berlin, and the forms of their settings.
#include "app/panel/stops/shift_calendar.h"
#include "tests/support/test_program.h"

#include <QDateTime>
#include <QRandomGenerator>
#include <QTest>

namespace test_shift_calendar {

using namespace campanel;
using panel::Shift;
using panel::ShiftCalendar;
using panel::shiftStartsIn;
using panel::stopReasonsIn;
using panel::workingDaysIn;

namespace {

constexpr qint64 hourMs = 3'600'000;

const QTimeZone& berlin()
{
    static const QTimeZone zone("Europe/Berlin");
    return zone;
}

qint64 localMs(int year, int month, int day, int hour, int minute = 0)
{
    return QDateTime(QDate(year, month, day), QTime(hour, minute), berlin()).toMSecsSinceEpoch();
}

ShiftCalendar calendar(const char* starts, const char* days = "1234567")
{
    return {shiftStartsIn(QString::fromLatin1(starts)), workingDaysIn(QString::fromLatin1(days)), berlin()};
}

} // namespace

class TestShiftCalendar : public QObject {
    Q_OBJECT

private slots:
    void shiftsFollowOneAnother()
    {
        const ShiftCalendar three = calendar("06:00 14:00 22:00");
        const Shift early = three.at(localMs(2026, 1, 15, 6));
        QCOMPARE(early.beginMs, localMs(2026, 1, 15, 6));
        QCOMPARE(early.endMs, localMs(2026, 1, 15, 14));
        QCOMPARE(three.at(localMs(2026, 1, 15, 13, 59)), early);
        const Shift night = three.before(early);
        QCOMPARE(night.beginMs, localMs(2026, 1, 14, 22)); // over midnight
        QCOMPARE(night.endMs, early.beginMs);
        QCOMPARE(three.after(early).beginMs, early.endMs);
        QCOMPARE(three.at(localMs(2026, 1, 15, 0)), night);
    }

    void daylightSavingMakesANightShorterAndLonger()
    {
        const ShiftCalendar three = calendar("06:00 14:00 22:00");
        const Shift spring = three.at(localMs(2026, 3, 29, 1)); // 02:00 becomes 03:00
        QCOMPARE(spring.durationMs(), 7 * hourMs);
        const Shift autumn = three.at(localMs(2026, 10, 25, 1)); // 03:00 becomes 02:00
        QCOMPARE(autumn.durationMs(), 9 * hourMs);
        QCOMPARE(three.after(spring).durationMs(), 8 * hourMs);
        QCOMPARE(three.before(autumn).durationMs(), 8 * hourMs);
    }

    // Also when a shift begins at a time that does not exist, or exists twice.
    void everyMomentLiesInOneShift()
    {
        const quint32 seed = QRandomGenerator::global()->generate();
        QRandomGenerator random(seed);
        for (const char* starts :
             {"00:00", "06:00 14:00 22:00", "02:30 03:00 10:30", "02:00 02:15 02:30 02:45"}) {
            const ShiftCalendar each = calendar(starts);
            for (const qint64 begin : {localMs(2026, 3, 26, 0), localMs(2026, 10, 22, 0)}) {
                Shift shift = each.at(begin);
                for (int i = 0; i < 40; ++i) {
                    QVERIFY2(shift.endMs > shift.beginMs, starts);
                    const qint64 moment = shift.beginMs + random.bounded(shift.durationMs());
                    QVERIFY2(each.at(moment) == shift, qPrintable(QString::number(seed)));
                    const Shift next = each.after(shift);
                    QCOMPARE(next.beginMs, shift.endMs);
                    QCOMPARE(each.before(next), shift);
                    shift = next;
                }
            }
        }
    }

    void aShiftBelongsToTheDayOnWhichItBegins()
    {
        const ShiftCalendar weekdays = calendar("06:00 22:00", "12345");
        QVERIFY(weekdays.at(localMs(2026, 1, 16, 23)).isWorking);  // Friday
        QVERIFY(weekdays.at(localMs(2026, 1, 17, 3)).isWorking);   // its night
        QVERIFY(!weekdays.at(localMs(2026, 1, 17, 12)).isWorking); // Saturday
        QVERIFY(!weekdays.at(localMs(2026, 1, 19, 3)).isWorking);  // Sunday's night
        QVERIFY(weekdays.at(localMs(2026, 1, 19, 6)).isWorking);
    }

    void formsOfTheSettings()
    {
        QCOMPARE(shiftStartsIn(QStringLiteral("06:00 14:15")), (QList<QTime>{QTime(6, 0), QTime(14, 15)}));
        for (const char* wrong : {"", "6:00", "06:00 06:00", "14:00 06:00", "06:10", "24:00", "06:00  14:00",
                                  "x", "00:00 01:00 02:00 03:00 04:00 05:00 06:00"})
            QVERIFY2(shiftStartsIn(QString::fromLatin1(wrong)).isEmpty(), wrong);
        QCOMPARE(workingDaysIn(QStringLiteral("157")), (QList<int>{1, 5, 7}));
        for (const char* wrong : {"", "0", "8", "11", "21", "1 2"})
            QVERIFY2(workingDaysIn(QString::fromLatin1(wrong)).isEmpty(), wrong);
    }

    void reasonsHaveTwoLevelsOfEight()
    {
        const auto standard = stopReasonsIn({});
        QVERIFY(standard.size() > 8);
        QCOMPARE(stopReasonsIn(panel::stopReasonsText(standard)), standard);
        const auto own = stopReasonsIn(QStringLiteral("Foil\nFoil/Torn\nplanned:Break"));
        QCOMPARE(own.size(), 3);
        QCOMPARE(own[1].key(), QStringLiteral("Foil/Torn"));
        QVERIFY(own[2].isPlanned && !own[1].isPlanned);
        QString nine;
        for (int i = 0; i < 9; ++i)
            nine += (i > 0 ? QStringLiteral("\n") : QString()) + QString::number(i);
        QString nineOfOne = QStringLiteral("a");
        for (int i = 0; i < 9; ++i)
            nineOfOne += QStringLiteral("\na/%1").arg(i);
        const QString longWord(panel::maxReasonLength + 1, u'x');
        for (const QString& wrong : {QStringLiteral("a\na"), QStringLiteral("a/b"),
                                     QStringLiteral("a\na/b/c"), QStringLiteral("a\n"), QStringLiteral(" a"),
                                     QStringLiteral("planned:"), nine, nineOfOne, longWord})
            QVERIFY2(stopReasonsIn(wrong).isEmpty(), qPrintable(wrong));
        nine.chop(2);
        QCOMPARE(stopReasonsIn(nine).size(), 8);
    }
};

CAMPANEL_TEST(TestShiftCalendar)

} // namespace test_shift_calendar

#include "test_shift_calendar.moc"
