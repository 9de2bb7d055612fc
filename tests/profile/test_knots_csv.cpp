// SPDX-License-Identifier: Apache-2.0
// Knots as CSV: valid files, exact refusals, and writing as the inverse of reading.
#include "profile/cam/knots_csv.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <random>

namespace test_knots_csv {

using namespace campanel::profile;

class TestKnotsCsv : public QObject {
    Q_OBJECT

private slots:
    void reads_data();
    void reads();
    void refuses_data();
    void refuses();
    void refusesWhatIsNotUtf8();
    void namesTheLineOfAKnot();
    void writes();
    void readsWhatItWrote();
    void readsTheLongestNumbers();
};

// In fixed notation a number has hundreds of characters.
void TestKnotsCsv::readsTheLongestNumbers()
{
    const std::vector<Knot> knots{
        {0.0, -1.7976931348623157e308}, {90.0, 1.2345678901234567e-50}, {180.0, -5e-324}};
    const auto read = readKnotsCsv(writeKnotsCsv(knots));
    QVERIFY(read);
    QCOMPARE(*read, knots);
}

void TestKnotsCsv::namesTheLineOfAKnot()
{
    const std::string text = "\n master_deg , slave_mm \n\n 0 , +0\n\t90.5,-20.25 \n   \n360, +1000\n\n";
    QCOMPARE(csvLineOfRow(text, 0), 4);
    QCOMPARE(csvLineOfRow(text, 1), 5);
    QCOMPARE(csvLineOfRow(text, 2), 7);
    QCOMPARE(csvLineOfRow(text, 99), 7);
    QCOMPARE(csvLineOfRow("sep=;\nmaster_deg;slave_mm;\n;;\n0;0;\r;\r90;1;\n;", 1), 6);
}

void TestKnotsCsv::reads_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("plain") << QByteArray("master_deg,slave_mm\n0,0\n90.5,-20.25\n360,1000\n");
    QTest::newRow("without the last line end")
        << QByteArray("master_deg,slave_mm\n0,0\n90.5,-20.25\n360,1e3");
    QTest::newRow("CRLF and byte order mark")
        << QByteArray("\xEF\xBB\xBFmaster_deg,slave_mm\r\n0,0\r\n90.5,-20.25\r\n360,1000\r\n");
    QTest::newRow("semicolon and comma")
        << QByteArray("master_deg;slave_mm\n0;0\n90,5;-20,25\n360,0;1000,000\n");
    QTest::newRow("semicolon and point") << QByteArray("master_deg;slave_mm\n0;0\n90.5;-20.25\n360.0;1000\n");
    QTest::newRow("blanks, plus, empty lines")
        << QByteArray("\n master_deg , slave_mm \n\n 0 , +0\n\t90.5,-20.25 \n   \n360, +1000\n\n");
    QTest::newRow("quoted") << QByteArray(
        "\"master_deg\",\"slave_mm\"\r\n\"0\",\"0\"\r\n \"90.5\" , \"-20.25\"\r\n360,\" 1000 \"\r\n");
    QTest::newRow("quoted decimal comma")
        << QByteArray("master_deg,slave_mm\n0,0\n\"90,5\",\"-20,25\"\n360,\"1000,0\"\n");
    QTest::newRow("empty columns and rows at the end")
        << QByteArray("master_deg,slave_mm,,\n0,0,,\n90.5,-20.25,,\n,,,\n360,1000,\n,,,\n , \n\"\",\n");
    QTest::newRow("the same with semicolons")
        << QByteArray("\xEF\xBB\xBFmaster_deg;slave_mm;\r\n0;0;\r\n90,5;-20,25;\r\n360;1000;\r\n;;\r\n");
    QTest::newRow("tabulators") << QByteArray(
        "master_deg\tslave_mm\t\n0\t0\n90,5\t-20,25\t\n360\t1000\n\t\n");
    QTest::newRow("the separator named")
        << QByteArray("sep=;\r\nmaster_deg;slave_mm\r\n0;0\r\n90,5;-20,25\r\n360;1000\r\n");
    QTest::newRow("CR alone") << QByteArray("master_deg;slave_mm\r0;0\r90.5;-20.25\r360;1000\r");
    QTest::newRow("exponents") << QByteArray(
        "master_deg;slave_mm\n0,00E+00;0\n9,05E+01;-2,025E+01\n360;1E+03\n");
}

void TestKnotsCsv::reads()
{
    QFETCH(QByteArray, text);
    const auto knots = readKnotsCsv(text.toStdString());
    QVERIFY2(knots.has_value(), knots ? "" : knots.error().found.c_str());
    QCOMPARE(knots->size(), std::size_t{3});
    QVERIFY(knots->at(0) == (Knot{0, 0}));
    QVERIFY(knots->at(1) == (Knot{90.5, -20.25}));
    QVERIFY(knots->at(2) == (Knot{360, 1000}));
}

void TestKnotsCsv::refuses_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("line");
    QTest::addColumn<CsvExpectation>("expected");
    QTest::addColumn<QByteArray>("found");
    const auto row = [](const char* name, const char* text, int line, CsvExpectation expected,
                        const char* found) {
        QTest::newRow(name) << QByteArray(text) << line << expected << QByteArray(found);
    };
    row("empty", "", 1, CsvExpectation::Header, "");
    row("no header", "0,0\n90,20\n", 1, CsvExpectation::Header, "0,0");
    row("columns swapped", "slave_mm,master_deg\n0,0\n", 1, CsvExpectation::Header, "slave_mm,master_deg");
    row("header only", "master_deg,slave_mm\n", 1, CsvExpectation::Rows, "");
    row("one value", "master_deg,slave_mm\n0,0\n90\n", 3, CsvExpectation::Values, "90");
    row("three values", "master_deg,slave_mm\n0,0,0\n", 2, CsvExpectation::Values, "0,0,0");
    row("other separator", "master_deg;slave_mm\n0,0\n", 2, CsvExpectation::Values, "0,0");
    row("word", "master_deg,slave_mm\n0,0\n\nninety,20\n", 4, CsvExpectation::Number, "ninety");
    row("no number", "master_deg,slave_mm\n0,\n", 2, CsvExpectation::Number, "");
    row("not finite", "master_deg,slave_mm\n0,nan\n", 2, CsvExpectation::Number, "nan");
    row("infinite", "master_deg,slave_mm\ninf,0\n", 2, CsvExpectation::Number, "inf");
    row("too large", "master_deg,slave_mm\n0,1e999\n", 2, CsvExpectation::Number, "1e999");
    row("unit", "master_deg,slave_mm\n0,5 mm\n", 2, CsvExpectation::Number, "5 mm");
    row("two signs", "master_deg,slave_mm\n+-1,5\n", 2, CsvExpectation::Number, "+-1");
    row("thousands", "master_deg;slave_mm\n0;1.000,5\n", 2, CsvExpectation::Number, "1.000,5");
    row("comma, then point", "master_deg;slave_mm\n0;0,5\n90;1.5\n", 3, CsvExpectation::DecimalComma, "1.5");
    row("point, then comma", "master_deg;slave_mm\n0;0.5\n90,5;1\n", 3, CsvExpectation::DecimalPoint, "90,5");
    row("three values of spreadsheets", "master_deg,slave_mm,\n0,0,x\n", 2, CsvExpectation::Values, "0,0,x");
    row("a third name", "master_deg,slave_mm,note\n0,0,\n", 1, CsvExpectation::Header,
        "master_deg,slave_mm,note");
    row("an open quote", "master_deg,slave_mm\n\"0,0\n", 2, CsvExpectation::Values, "\"0,0");
    row("a quote in a number", "master_deg,slave_mm\n0,1\"2\n", 2, CsvExpectation::Number, "1\"2");
    row("control characters", "master_deg,slave_mm\n0,\x1b[31m\x7f\n", 2, CsvExpectation::Number, "?[31m?");
    row("long line", "a line of a document that is no list of knots at all\n", 1, CsvExpectation::Header,
        "a line of a document that is no list of ");
    row("cut before a whole character", "123456789012345678901234567890123456789\u00e4\n", 1,
        CsvExpectation::Header, "123456789012345678901234567890123456789");
}

void TestKnotsCsv::refuses()
{
    QFETCH(QByteArray, text);
    QFETCH(int, line);
    QFETCH(CsvExpectation, expected);
    QFETCH(QByteArray, found);
    const auto knots = readKnotsCsv(text.toStdString());
    QVERIFY(!knots.has_value());
    QCOMPARE(knots.error().line, line);
    QCOMPARE(static_cast<int>(knots.error().expected), static_cast<int>(expected));
    QCOMPARE(QByteArray::fromStdString(knots.error().found), found);
}

void TestKnotsCsv::refusesWhatIsNotUtf8()
{
    const std::u16string text = u"master_deg,slave_mm\r\n0,0\r\n";
    std::string little;
    std::string big;
    for (const char16_t c : text) {
        little += {static_cast<char>(c), '\0'};
        big += {'\0', static_cast<char>(c)};
    }
    for (const std::string& bytes :
         {"\xFF\xFE" + little, "\xFE\xFF" + big, little, std::string("\xFF\xFE"), std::string(9, '\0')}) {
        const auto knots = readKnotsCsv(bytes);
        QVERIFY(!knots.has_value());
        QVERIFY(knots.error() == (CsvError{1, CsvExpectation::Utf8, {}}));
    }
}

void TestKnotsCsv::writes()
{
    const std::vector<Knot> knots{{0, 0}, {90.5, -20.25}, {0.1 + 0.2, 1e-7}, {360, 1234567}};
    QCOMPARE(
        QByteArray::fromStdString(writeKnotsCsv(knots)),
        QByteArray("master_deg,slave_mm\n0,0\n90.5,-20.25\n0.30000000000000004,0.0000001\n360,1234567\n"));
}

void TestKnotsCsv::readsWhatItWrote()
{
    constexpr unsigned seed = 1618;
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(-1e6, 1e6);
    std::vector<Knot> knots;
    for (int i = 0; i < 2000; ++i)
        knots.push_back({value(random), value(random) / 1e9});
    const auto again = readKnotsCsv(writeKnotsCsv(knots));
    QVERIFY(again.has_value());
    QVERIFY(*again == knots);
}

CAMPANEL_TEST(TestKnotsCsv)

} // namespace test_knots_csv

#include "test_knots_csv.moc"
