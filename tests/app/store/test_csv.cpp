// SPDX-License-Identifier: Apache-2.0
// CSV for people and programs: no cell of a text from elsewhere becomes a formula, numbers stay numbers, and
// the reader takes each dialect that is written.
#include "app/store/files/csv.h"
#include "app/store/logs/alarm_log.h"
#include "app/store/logs/audit_log.h"
#include "app/store/logs/stop_export.h"
#include "app/store/recipes/list_file.h"
#include "profile/cam/knots_csv.h"
#include "profile/segments/segments_csv.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_csv {

using namespace campanel;
using namespace campanel::store;
using namespace Qt::StringLiterals;

namespace {

QByteArray cell(const QString& text, const CsvDialect& dialect = {})
{
    CsvWriter csv(u"name", dialect);
    csv.text(text).endLine();
    return csv.bytes().mid(csv.bytes().indexOf('\n') + 1).chopped(1);
}

template <typename Row> QByteArray csvOf(const Table<Row>& table, const Row& row)
{
    CsvTable<Row> csv(table.csvColumns());
    csv.add(row);
    return csv.bytes();
}

} // namespace

class TestCsv : public QObject {
    Q_OBJECT

private slots:
    void noTextIsAFormula_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("written");
        const auto row = [](const QString& text, const QString& written) {
            QTest::addRow("%s", qPrintable(QString(text).replace(u'\n', u' '))) << text << written;
        };
        row(u"Biscuit 250"_s, u"Biscuit 250"_s);
        row(u"=1+1"_s, u"'=1+1"_s);
        row(u"+49 711"_s, u"'+49 711"_s);
        row(u"-5"_s, u"'-5"_s);
        row(u"@SUM(A1)"_s, u"'@SUM(A1)"_s);
        row(u"   =1"_s, u"'=1"_s);
        row(u"\u00A0\u3000=1"_s, u"'=1"_s);
        row(u"\t=1"_s, u"\\u0009=1"_s);
        row(u"\r=1"_s, u"\\u000d=1"_s);
        row(u"\n@1"_s, u"\\u000a@1"_s);
        row(u"\x01=1"_s, u"\\u0001=1"_s);
        row(u"\u200B=1"_s, u"\\u200b=1"_s);
        row(u"\uFEFF=1"_s, u"\\ufeff=1"_s);
        row(u"\uFF1D1+1"_s, u"'\uFF1D1+1"_s);
        row(u"\uFF201"_s, u"'\uFF201"_s);
        row(u"a;=1"_s, u"\"a;'=1\""_s);
        row(u"a, =1"_s, u"\"a,' =1\""_s);
        row(u"a;-5;+6,5"_s, u"\"a;-5;+6,5\""_s);
        row(u"a=1-2"_s, u"a=1-2"_s);
        row(u"say \"so\""_s, u"\"say \"\"so\"\"\""_s);
        row(u"two\nlines\r\nand\u2028more"_s, u"two\\u000alines\\u000d\\u000aand\\u2028more"_s);
        row(u"left\u202Eright\u2066\u200F"_s, u"left\\u202eright\\u2066\\u200f"_s);
        row(u"推料 🧁"_s, u"推料 🧁"_s);
        row(u"\u200D=1"_s, u"\\u200d=1"_s);
        row({}, {});
    }
    void noTextIsAFormula()
    {
        QFETCH(QString, text);
        QFETCH(QString, written);
        QCOMPARE(QString::fromUtf8(cell(text)), written);
        QCOMPARE(QString::fromUtf8(cell(text, {';', ',', false})), written);
    }

    void everyLogIsSafe()
    {
        const QString formula = u"=HYPERLINK(\"http://x\")"_s;
        StateInterval interval;
        interval.program = formula;
        interval.stop = 1;
        const StopLog::Span span{{interval}, {StopRow{1, formula, false, formula, 1}}};
        AlarmRow alarm;
        alarm.detail = alarm.acknowledgedBy = formula;
        AuditRow audit;
        audit.entry.who = audit.entry.object = audit.entry.after = formula;
        audit.entry.before = u"-1.5"_s;
        for (const QByteArray& csv :
             {statesCsv(span), stopsCsv(span), csvOf(alarmTable(), alarm), csvOf(auditTable(), audit)}) {
            QVERIFY2(csv.contains("\"'=HYPERLINK(\"\"http://x\"\")\""), csv);
            QVERIFY2(!csv.contains("\"=") && !csv.contains(",="), csv);
        }
        QVERIFY(csvOf(auditTable(), audit).contains(",-1.5,\"'=")); // a number stays one
    }

    void aPersonsLanguageDecidesTheSigns_data()
    {
        QTest::addColumn<QLocale>("locale");
        QTest::addColumn<QByteArray>("written");
        const QByteArray comma = "\xEF\xBB\xBF"
                                 "a,b,c\n-1.50,3,\"x;y\"\n";
        QTest::newRow("English") << QLocale(u"en"_s) << comma;
        QTest::newRow("Chinese") << QLocale(u"zh_CN"_s) << comma;
        QTest::newRow("German") << QLocale(u"de"_s)
                                << QByteArray("\xEF\xBB\xBF"
                                              "a;b;c\n-1,50;3;\"x;y\"\n");
    }
    void aPersonsLanguageDecidesTheSigns()
    {
        QFETCH(QLocale, locale);
        QFETCH(QByteArray, written);
        CsvWriter csv(u"a,b,c", spreadsheetDialect(locale));
        csv.number(-1.5, 2).whole(3).text(u"x;y"_s).endLine();
        QCOMPARE(csv.bytes(), written);
        QCOMPARE(csv.rows(), 1);
    }

    void everyDialectIsReadBack()
    {
        profile::PointCamProgram cam;
        cam.knots[1].slaveMm = -12.25;
        const profile::SegmentCamProgram segments;
        for (const QLocale& locale : {QLocale(u"en"_s), QLocale(u"de"_s), QLocale(u"fr"_s)}) {
            const CsvDialect dialect = spreadsheetDialect(locale);
            const auto knots = profile::readKnotsCsv(profile::writeKnotsCsv(cam.knots, dialect));
            QVERIFY(knots && *knots == cam.knots);
            const auto read = profile::readSegmentsCsv(profile::writeSegmentsCsv(segments.segments, dialect));
            QVERIFY(read && *read == segments.segments);
        }
    }
};

CAMPANEL_TEST(TestCsv)

} // namespace test_csv

#include "test_csv.moc"
