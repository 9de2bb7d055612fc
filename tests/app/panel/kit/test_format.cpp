// SPDX-License-Identifier: Apache-2.0
// Numbers and times as text, in both languages.
#include "app/panel/kit/format.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <ctime>
#include <limits>

namespace test_format {

using campanel::panel::Format;
using namespace Qt::StringLiterals;

class FormatTest : public QObject {
    Q_OBJECT

public:
    static void initMain()
    {
        qputenv("TZ", "Asia/Shanghai");
    } // otherwise UTC would be the local time of many a build machine

private slots:
    void numbers_data();
    void numbers();
    void groupsOnlyWhereNobodyEdits();
    void withoutSuperfluousZeros();
    void momentsAreOfTheLocalTime();
    void theRepeatedHourNamesItsZone();
    void decimalsTellNumbersApart();
};

void FormatTest::numbers_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("decimals");
    QTest::addColumn<QString>("text");
    QTest::newRow("plain") << 249.996 << 2 << u"250.00"_s;
    QTest::newRow("no groups") << 34641.0 << 0 << u"34641"_s;
    QTest::newRow("a minus sign, not a hyphen") << -0.31 << 2 << u"\u22120.31"_s;
    QTest::newRow("no negative zero") << -0.004 << 2 << u"0.00"_s;
    QTest::newRow("just below zero") << -0.006 << 2 << u"\u22120.01"_s;
    QTest::newRow("very large") << -1e306 << 3 << u"\u22121E+306"_s;
    QTest::newRow("unknown") << std::numeric_limits<double>::quiet_NaN() << 2 << u"--"_s;
    QTest::newRow("not finite") << -std::numeric_limits<double>::infinity() << 2 << u"--"_s;
}

void FormatTest::numbers()
{
    QFETCH(const double, value);
    QFETCH(const int, decimals);
    QFETCH(const QString, text);
    for (const auto language : {QLocale::English, QLocale::Chinese})
        QCOMPARE(Format(QLocale(language)).number(value, decimals), text);
}

void FormatTest::groupsOnlyWhereNobodyEdits()
{
    const Format format{QLocale(QLocale::English)};
    QCOMPARE(format.grouped(-50000, 0), u"\u221250,000"_s);
    QCOMPARE(format.grouped(9999, 0), u"9999"_s);
}

void FormatTest::withoutSuperfluousZeros()
{
    const Format format{QLocale(QLocale::English)};
    QCOMPARE(format.compact(2.5, 2, 4), u"2.50"_s);
    QCOMPARE(format.compact(5.0 / 3, 2, 4), u"1.6667"_s);
    QCOMPARE(format.compact(-3.0, 0, 3), u"\u22123"_s);
}

void FormatTest::theRepeatedHourNamesItsZone()
{
    qputenv("TZ", "Europe/Berlin");
    tzset();
    const QDateTime before(QDate(2027, 10, 31), QTime(0, 50), Qt::UTC);
    QCOMPARE(Format::minute(before), u"2027-10-31 02:50 CEST"_s);
    QCOMPARE(Format::minute(before.addSecs(600)), u"2027-10-31 02:00 CET"_s);
    QCOMPARE(Format::local(before.addSecs(-3600), u"HH:mm"_s), u"01:50"_s);
    QCOMPARE(Format::local(before.addSecs(4200), u"HH:mm"_s), u"03:00"_s);
}

void FormatTest::decimalsTellNumbersApart()
{
    QCOMPARE(Format::decimalsToTell(90, 89.99996, 3), 5);
    QCOMPARE(Format::decimalsToTell(0.0004, 0.1, 3), 4);
    QCOMPARE(Format::decimalsToTell(2, 1, 0), 0);
    QCOMPARE(Format::decimalsToTell(2, 2, 1), 1);
    QCOMPARE(Format::decimalsToTell(1, 1 + 1e-12, 3), 3); // nothing tells them apart
    QCOMPARE(Format::decimalsToTell(qQNaN(), 1, 3), 3);
}

void FormatTest::momentsAreOfTheLocalTime()
{
    const QDateTime local(QDate(2026, 8, 1), QTime(9, 5, 7));
    QCOMPARE(Format::minute(local), u"2026-08-01 09:05"_s);
    QCOMPARE(Format::second(local.toUTC()), u"2026-08-01 09:05:07"_s);
}

CAMPANEL_TEST(FormatTest)

} // namespace test_format

#include "test_format.moc"
