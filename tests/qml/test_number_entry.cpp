// SPDX-License-Identifier: Apache-2.0
// The number of the keypad: the effect of keys, the language, and completeness.
#include "qml/Controls/number_entry.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_number_entry {

using campanel::controls::NumberEntry;

class TestNumberEntry : public QObject {
    Q_OBJECT

private slots:
    void keysMakeANumber_data()
    {
        QTest::addColumn<QString>("keys");
        QTest::addColumn<int>("decimals");
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("value");
        QTest::newRow("digits") << "250" << 1 << "250" << 250.0;
        QTest::newRow("decimals") << "62.5" << 1 << "62.5" << 62.5;
        QTest::newRow("no more decimals than allowed") << "62.57" << 1 << "62.5" << 62.5;
        QTest::newRow("point first") << ".5" << 2 << "0.5" << 0.5;
        QTest::newRow("second point is ignored") << "1.2.3" << 3 << "1.23" << 1.23;
        QTest::newRow("comma is a point too") << "95,5" << 1 << "95.5" << 95.5;
        QTest::newRow("comma of a Chinese keyboard") << QString::fromUtf8("95，5") << 1 << "95.5" << 95.5;
        QTest::newRow("point and comma are one sign") << "1,000.5" << 4 << "1.0005" << 1.0005;
        QTest::newRow("leading zero is replaced") << "07" << 0 << "7" << 7.0;
        QTest::newRow("zero before a point stays") << "0.7" << 1 << "0.7" << 0.7;
        QTest::newRow("sign toggles") << "5-" << 0 << QString(QChar(0x2212)) + "5" << -5.0;
        QTest::newRow("sign twice") << "5--" << 0 << "5" << 5.0;
        QTest::newRow("letters are ignored") << "1a2" << 0 << "12" << 12.0;
        QTest::newRow("at most nine digits") << "12345678901" << 0 << "123456789" << 123456789.0;
    }
    void keysMakeANumber()
    {
        QFETCH(QString, keys);
        QFETCH(int, decimals);
        QFETCH(QString, text);
        QFETCH(double, value);
        NumberEntry entry;
        entry.setDecimals(decimals);
        for (const QChar key : keys)
            entry.type(QString(key));
        QCOMPARE(entry.text(), text);
        QVERIFY(entry.isComplete());
        QCOMPARE(entry.value(), value);
    }

    void moreDigitsBringItBetweenTheLimits_data()
    {
        QTest::addColumn<QString>("keys");
        QTest::addColumn<int>("decimals");
        QTest::addColumn<double>("minimum");
        QTest::addColumn<double>("maximum");
        QTest::addColumn<bool>("can");
        QTest::newRow("180 begins with 1") << "1" << 1 << 10.0 << 2000.0 << true;
        QTest::newRow("too large") << "99999" << 1 << 10.0 << 2000.0 << false;
        QTest::newRow("between two lengths") << "3" << 0 << 10.0 << 29.0 << false;
        QTest::newRow("only decimals are left") << "5.2" << 1 << 10.0 << 2000.0 << false;
        QTest::newRow("decimals help") << "0." << 2 << 0.05 << 5.0 << true;
        QTest::newRow("decimals do not reach") << "9" << 2 << 0.05 << 5.0 << false;
        QTest::newRow("the minus comes later") << "5" << 0 << -90.0 << -10.0 << true;
        QTest::newRow("no more decimals") << "0.0" << 1 << 0.1 << 1.0 << false;
        QTest::newRow("whole") << "4" << 0 << 5.0 << 9.0 << false;
    }
    void moreDigitsBringItBetweenTheLimits()
    {
        QFETCH(QString, keys);
        QFETCH(int, decimals);
        QFETCH(double, minimum);
        QFETCH(double, maximum);
        QFETCH(bool, can);
        NumberEntry entry;
        entry.setDecimals(decimals);
        for (const QChar key : keys)
            entry.type(QString(key));
        QCOMPARE(entry.canBecome(minimum, maximum), can);
    }

    // A whole number never grows by its decimals.
    void aWholeNumberTakesNoDecimals_data()
    {
        QTest::addColumn<QString>("keys");
        for (const char* keys : {"4.2", "95,5", "1,000", "4."})
            QTest::addRow("%s", keys) << QString::fromLatin1(keys);
    }
    void aWholeNumberTakesNoDecimals()
    {
        QFETCH(QString, keys);
        NumberEntry entry;
        for (const QChar key : keys)
            entry.type(QString(key));
        QVERIFY(!entry.isComplete());
        QVERIFY(entry.hasUnwantedFraction());
        QVERIFY(std::isnan(entry.value()));
        entry.backspace();
        QVERIFY(entry.isComplete());
    }

    void aCommaIsADecimalPointInEveryLanguage()
    {
        for (const char* language : {"en", "de", "zh_CN", "fr"}) {
            for (const char* keys : {"95.5", "95,5"}) {
                NumberEntry entry;
                entry.setDecimals(1);
                entry.setLocale(QString::fromLatin1(language));
                for (const QChar key : QString::fromLatin1(keys))
                    entry.type(QString(key));
                QCOMPARE(entry.value(), 95.5);
            }
        }
    }

    void showsThePointOfTheLanguage()
    {
        NumberEntry entry;
        entry.setDecimals(2);
        entry.setLocale(QStringLiteral("de"));
        for (const char* key : {"1", ",", "5"})
            entry.type(QString::fromLatin1(key));
        QCOMPARE(entry.text(), QStringLiteral("1,5"));
        QCOMPARE(entry.value(), 1.5);
    }

    void isUnknownUntilComplete()
    {
        NumberEntry entry;
        QVERIFY(entry.isEmpty());
        QVERIFY(!entry.isComplete());
        QVERIFY(std::isnan(entry.value()));
        entry.type(QStringLiteral("-"));
        QVERIFY(!entry.isComplete());
    }

    void backspaceAndClear()
    {
        NumberEntry entry;
        entry.setDecimals(1);
        entry.setValue(62.5);
        QCOMPARE(entry.text(), QStringLiteral("62.5"));
        entry.backspace();
        QCOMPARE(entry.value(), 62.0);
        entry.clear();
        QVERIFY(entry.isEmpty());
        entry.backspace();
        QVERIFY(entry.isEmpty());
    }
};

CAMPANEL_TEST(TestNumberEntry)

} // namespace test_number_entry

#include "test_number_entry.moc"
