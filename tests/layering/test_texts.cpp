// SPDX-License-Identifier: Apache-2.0
// Texts with places for values. A value that was filled in first is searched for places by the second .arg():
// the recipe "Mix 50%3" became "Mix 507". So one .arg() fills a text with all its values; before another one
// there may only be numbers, known as such by their form.
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>

namespace test_texts {

using namespace Qt::StringLiterals;

namespace {

// Returns the place behind the bracket that closes what is open at `from`; -1: none.
qsizetype closingOf(const QString& text, qsizetype from)
{
    int open = 1;
    for (qsizetype i = from; i < text.size(); ++i) {
        const QChar letter = text[i];
        const bool isCharacter =
            letter == u'\'' && !(text[i - 1].isLetterOrNumber() && text[i - 1] != u'u'); // else 1'000
        if (letter == u'"' || isCharacter) {
            for (++i; i < text.size() && text[i] != letter; ++i)
                i += text[i] == u'\\' ? 1 : 0;
        } else if (u"([{"_s.contains(letter)) {
            ++open;
        } else if (u")]}"_s.contains(letter) && --open == 0) {
            return i + 1;
        }
    }
    return -1;
}

// Returns true for what is a number whatever the names mean: a count, a calculation, a base or digits, or one
// of the names that are always given to numbers.
bool isNumber(const QString& argument)
{
    static const QRegularExpression text(uR"(\x22|_s\b|QChar|QString)"_s);
    static const QRegularExpression number(
        uR"(, \d+, '[efg]', \w+$|, \d+, (10|16)(, .*)?$|\.(size|count)\(\)$|^std::(lround|abs|max|min)\(| ([-+*/&]|>>) \w+$|^\d+$)"
        uR"(|\b(number|sequence|generation|version|baud|stopBits|mapMajor|minimum|maximum|min|max|offset|done|lowest|minutes|bags|seed|margin|outOfTolerance|startUpScrap|within|unit|exception|refusedLine|differingRegisters|i|lengthMm)$)"
        uR"(|^(bagsSinceStep\(\)|minPinDigits\(level\))$)"_s);
    static const QRegularExpression zeros(uR"(, \d+, (10|16), QLatin1Char\('0'\)$)"_s);
    return zeros.match(argument).hasMatch() ||
           (!text.match(argument).hasMatch() && number.match(argument).hasMatch());
}

// Returns the values that another .arg() would search for places, as "path: value".
QStringList searchedValues(const QString& text, const QString& path, bool areNumbersAllowed)
{
    static const QRegularExpression link(uR"(\s*\.arg\()"_s);
    QStringList found;
    for (qsizetype at = text.indexOf(u".arg("_s); at >= 0; at = text.indexOf(u".arg("_s, at)) {
        QStringList values;
        for (auto match = link.match(text, at, QRegularExpression::NormalMatch,
                                     QRegularExpression::AnchorAtOffsetMatchOption);
             match.hasMatch(); match = link.match(text, at, QRegularExpression::NormalMatch,
                                                  QRegularExpression::AnchorAtOffsetMatchOption)) {
            at = closingOf(text, match.capturedEnd());
            if (at < 0)
                return {path + u": a bracket is not closed"_s};
            values << text.sliced(match.capturedEnd(), at - 1 - match.capturedEnd()).simplified();
        }
        values.removeLast();
        for (const QString& value : values) {
            if (!areNumbersAllowed || !isNumber(value))
                found << path + u": "_s + value;
        }
    }
    return found;
}

QStringList searchedValuesBelow(const QStringList& folders, const QStringList& patterns,
                                bool areNumbersAllowed, int& files)
{
    QStringList found;
    const QDir root(campanel::test::sourcePath("."));
    for (const QString& folder : folders) {
        QDirIterator it(root.filePath(folder), patterns, QDir::Files, QDirIterator::Subdirectories);
        while (it.hasNext()) {
            QFile file(it.next());
            if (!file.open(QIODevice::ReadOnly))
                return {file.fileName() + u": cannot be read"_s};
            ++files;
            found += searchedValues(QString::fromUtf8(file.readAll()), root.relativeFilePath(file.fileName()),
                                    areNumbersAllowed);
        }
    }
    return found;
}

// Returns the enumerations whose rows have the texts: those of the protocol that the panel shows, and those
// of recipes.
QStringList enumerationsWithTexts()
{
    static const QRegularExpression shown(uR"(constexpr std::string_view nameOf\((\w+)\))"_s);
    QFile file(QDir(campanel::test::sourcePath(".")).filePath(u"modbus/map/protocol.h"_s));
    QStringList names{u"FaultBit"_s, u"WarningBit"_s, u"Field"_s, u"LawId"_s, u"ProgramKind"_s, u"Choice"_s};
    if (file.open(QIODevice::ReadOnly)) {
        for (const QRegularExpressionMatch& match : shown.globalMatch(QString::fromUtf8(file.readAll())))
            names << match.captured(1);
    }
    return names;
}

// Returns each text of a switch over one of these enumerations, as "path: case".
QStringList textsBesideRows(const QString& text, const QString& path)
{
    QStringList names = enumerationsWithTexts();
    std::ranges::replace(names, u"State"_s, u"modbus::State"_s); // other classes have a State too
    const QRegularExpression pattern(
        uR"(case (?:\w+::)*(?:%1)::\w+:(?:\s*case (?:\w+::)+\w+:)*\s*return (?:\w+::)*tr(?:anslate)?\()"_s
            .arg(names.join(u'|')));
    QStringList found;
    for (const QRegularExpressionMatch& match : pattern.globalMatch(text))
        found << path + u": "_s + match.captured().simplified();
    return found;
}

} // namespace

class TestTexts : public QObject {
    Q_OBJECT

private slots:
    void noValueIsSearchedForPlaces()
    {
        int files = 0;
        const QStringList found =
            searchedValuesBelow({u"app"_s, u"gateway"_s}, {u"*.cpp"_s, u"*.h"_s}, true, files);
        QVERIFY(files > 400);
        QVERIFY2(found.isEmpty(),
                 qPrintable(u"fill the text with one .arg(a, b), numbers by QString::number():\n  "_s +
                            found.join(u"\n  "_s)));
    }

    // QML has no .arg() of several values: Theme.fill() is it.
    void noValueOfTheScreenIsSearchedForPlaces()
    {
        int files = 0;
        const QStringList found = searchedValuesBelow({u"qml"_s}, {u"*.qml"_s}, false, files);
        QVERIFY(files > 100);
        QVERIFY2(found.isEmpty(), qPrintable(u"use Theme.fill(text, [a, b]):\n  "_s + found.join(u"\n  "_s)));
    }

    // The text of a value stands in its row, in modbus/map, profile or app/program.
    void noSwitchSaysTheTextOfARow()
    {
        QVERIFY(enumerationsWithTexts().size() > 12);
        QStringList found;
        int files = 0;
        const QDir root(campanel::test::sourcePath("."));
        QDirIterator it(root.filePath(u"app"_s), {u"*.cpp"_s, u"*.h"_s}, QDir::Files,
                        QDirIterator::Subdirectories);
        while (it.hasNext()) {
            QFile file(it.next());
            QVERIFY(file.open(QIODevice::ReadOnly));
            found +=
                textsBesideRows(QString::fromUtf8(file.readAll()), root.relativeFilePath(file.fileName()));
            ++files;
        }
        QVERIFY(files > 400);
        QVERIFY2(found.isEmpty(), qPrintable(u"put the text into the row:\n  "_s + found.join(u"\n  "_s)));
    }

    void plantedTextBesideARowIsFound_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("isFound");
        QTest::addRow("a refusal") << u"case Refusal::InFault:\n        return tr(\"In fault.\");"_s << true;
        QTest::addRow("a state") << u"case modbus::State::Idle: return tr(\"Idle\");"_s << true;
        QTest::addRow("two stages of a press")
            << u"case PressStage::Press:\n case PressStage::Hold:\n return Words::tr(\"Down\");"_s << true;
        QTest::addRow("a field")
            << u"case profile::Field::Rate:\n return QCoreApplication::translate(\"\", \"Rate\");"_s << true;
        QTest::addRow("a state of another class")
            << u"case State::Sealing: return tr(\"Sealing\");"_s << false;
        QTest::addRow("a key") << u"case Command::Start: return u\"command.start\"_s;"_s << false;
    }

    void plantedTextBesideARowIsFound()
    {
        QFETCH(QString, text);
        QFETCH(bool, isFound);
        QCOMPARE(!textsBesideRows(text, u"planted"_s).isEmpty(), isFound);
    }

    void plantedChainIsFound_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("isFound");
        QTest::addRow("a name") << u"tr(\"%1, version %2\").arg(name).arg(version)"_s << true;
        QTest::addRow("a name on two lines")
            << u"tr(\"%1, %2\")\n    .arg(nameOf(kept.recipe))\n    .arg(3)"_s << true;
        QTest::addRow("a name behind a number") << u"u\"%1 %2 %3\"_s.arg(i).arg(name).arg(x)"_s << true;
        QTest::addRow("a text that looks like a number")
            << u"t.arg(QString::number(i) + version).arg(x)"_s << true;
        QTest::addRow("a bracket in a text") << u"t.arg(\")\" + name).arg(x)"_s << true;
        QTest::addRow("several at once") << u"tr(\"%1, %2\").arg(name, QString::number(version))"_s << false;
        QTest::addRow("a number") << u"tr(\"%1 of %2\").arg(rows.size()).arg(name)"_s << false;
        QTest::addRow("digits") << u"t.arg(std::abs(minutes) / 60, 2, 10, QLatin1Char('0')).arg(x)"_s
                                << false;
    }

    void plantedChainIsFound()
    {
        QFETCH(QString, text);
        QFETCH(bool, isFound);
        QCOMPARE(!searchedValues(text, u"planted"_s, true).isEmpty(), isFound);
    }
};

CAMPANEL_TEST(TestTexts)

} // namespace test_texts

#include "test_texts.moc"
