// SPDX-License-Identifier: Apache-2.0
// One row per thing: fields, bits and inputs are listed where their rows stand, and nowhere beside them. A
// list elsewhere is forgotten by the one who adds a row; it is a column of the row.
#include "source_files.h"
#include "tests/support/test_program.h"

#include <QRegularExpression>
#include <QTest>

namespace test_rows {

using namespace Qt::StringLiterals;

namespace {

// The files with the rows, and the two lists that are none of rows: the four values of which two give a
// cycle, in the order of their bits, and the order in which a speed move looks for a value that it can meet.
bool mayList(const QString& path)
{
    static const QRegularExpression rows(
        u"^(profile/model/|profile/program/programs\\.h$|profile/cutter/rotary_cutter\\.h$|modbus/map/|"
        "profile/moves/speed_move\\.cpp$)"_s);
    return rows.match(path).hasMatch();
}

// Returns each list of three or more values of an enumeration with rows, as "path: list".
QStringList listsIn(const QString& text, const QString& path)
{
    static const QRegularExpression list(
        uR"((?:\w+::)*\b(Field|\w+Bit)::\w+(?:\s*,\s*(?:\w+::)*\1::\w+){2,})"_s);
    static const QRegularExpression cases(
        uR"((?:case (?:\w+::)*(Field|\w+Bit)::\w+:\s*return (?:u?"[^"]*"(?:_s)?|\w+\("[^"]*"\));\s*){3,})"_s);
    static const QRegularExpression masks(uR"((?:\b(CTL_\w+_BIT)_\w+\s*\)*\s*,[^;{}]{0,12}){2,}\1_\w+)"_s);
    QStringList found;
    for (const QRegularExpression& pattern : {list, cases, masks}) {
        for (const QRegularExpressionMatch& match : pattern.globalMatch(text))
            found << path + u": "_s + match.captured().simplified();
    }
    return found;
}

} // namespace

class TestRows : public QObject {
    Q_OBJECT

private slots:
    void noListStandsBesideTheRows()
    {
        const QStringList paths =
            campanel::test::filesBelow({u"app"_s, u"profile"_s, u"modbus"_s, u"controller"_s, u"gateway"_s},
                                       {u"*.cpp"_s, u"*.h"_s, u"*.c"_s});
        QVERIFY(paths.size() > 700);
        QStringList found;
        for (const QString& path : paths) {
            if (!mayList(path))
                found += listsIn(campanel::test::textOf(path), path);
        }
        QVERIFY2(found.isEmpty(), qPrintable(u"make it a column of the row:\n  "_s + found.join(u"\n  "_s)));
    }

    void plantedListIsFound_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("isFound");
        QTest::addRow("fields") << u"constexpr std::array shaft{Field::KnifeRadius, Field::Knives,\n"
                                   "    Field::GearNumerator};"_s
                                << true;
        QTest::addRow("fields by their namespace")
            << u"for (const auto field : {profile::Field::K1, profile::Field::K2, profile::Field::K3})"_s
            << true;
        QTest::addRow("bits") << u"{WarningBit::MarksLost, WarningBit::Skips, WarningBit::NotHomed}"_s
                              << true;
        QTest::addRow("inputs")
            << u"add(modbus::InputBit::Door,modbus::InputBit::Reset, modbus::InputBit::Jog)"_s << true;
        QTest::addRow("bits of the core")
            << u"{CTL_INPUT_BIT_DOOR, CTL_INPUT_BIT_START, CTL_INPUT_BIT_RESET}"_s << true;
        QTest::addRow("texts of a switch")
            << u"case Field::K1:\n  return u\"k1\"_s;\ncase Field::K2:\n  return "
               "u\"k2\"_s;\ncase Field::K3:\n  return u\"k3\"_s;\n"_s
            << true;
        QTest::addRow("two fields") << u"checkEach(Field::K1, Field::K2);"_s << false;
        QTest::addRow("rows") << u"{Field::K1, \"k1\", 1}, {Field::K2, \"k2\", 2}, {Field::K3, \"k3\", 3}"_s
                              << false;
    }

    void plantedListIsFound()
    {
        QFETCH(QString, text);
        QFETCH(bool, isFound);
        QCOMPARE(!listsIn(text, u"planted"_s).isEmpty(), isFound);
    }
};

CAMPANEL_TEST(TestRows)

} // namespace test_rows

#include "test_rows.moc"
