// SPDX-License-Identifier: Apache-2.0
// Names in texts of QML, each found where it stands for something: a sheet that is opened by its file, with
// its properties and signals, a page, a setting, a field, a parameter. A misspelt one fails here and not on
// the screen.
#include "source_files.h"
#include "tests/support/test_program.h"

#include <QMap>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include <algorithm>

namespace test_names {

using namespace Qt::StringLiterals;
using campanel::test::filesBelow;
using campanel::test::textOf;

namespace {

// Returns what stands between the commas from `from` to the bracket that closes there.
QStringList partsFrom(const QString& text, qsizetype from)
{
    QStringList parts{QString()};
    int open = 1;
    for (qsizetype i = from; i < text.size(); ++i) {
        const QChar letter = text[i];
        if (letter == u'"') {
            const qsizetype end = text.indexOf(u'"', i + 1);
            parts.last() += text.sliced(i, end - i);
            i = end;
        } else if (u"([{"_s.contains(letter)) {
            ++open;
        } else if (u")]}"_s.contains(letter) && --open == 0) {
            break;
        } else if (letter == u',' && open == 1) {
            parts << QString();
            continue;
        }
        parts.last() += text[i];
    }
    return parts;
}

QStringList textsIn(const QString& code)
{
    static const QRegularExpression quoted(uR"(\x22([^\x22]*)\x22)"_s);
    QStringList texts;
    for (const QRegularExpressionMatch& match : quoted.globalMatch(code))
        texts << match.captured(1);
    return texts;
}

// Returns the arguments of each call, as they are written.
QList<QStringList> callsOf(const QString& function, const QString& text)
{
    QList<QStringList> calls;
    for (qsizetype at = text.indexOf(function + u'('); at >= 0; at = text.indexOf(function + u'(', at + 1))
        calls << partsFrom(text, at + function.size() + 1);
    return calls;
}

// Returns the path of each QML file by its name as `Frame.open` takes it: the module and the file.
QMap<QString, QString> filesByName()
{
    static const QRegularExpression module(uR"(campanel_qml_module\(\w+ (\w+))"_s);
    static const QRegularExpression listed(uR"(\b(\w+)\.qml\b)"_s);
    QMap<QString, QString> files;
    for (const QString& list : filesBelow({u"qml"_s}, {u"CMakeLists.txt"_s})) {
        const QString text = textOf(list);
        const QString folder = list.chopped(u"CMakeLists.txt"_s.size());
        const QString name = module.match(text).captured(1);
        for (const QRegularExpressionMatch& match : listed.globalMatch(text))
            files.insert(name + u'/' + match.captured(1), folder + match.captured(1) + u".qml"_s);
    }
    return files;
}

// The properties and signals of a component, with those of the types that it is made of.
struct Members {
    QSet<QString> all; // a signal as its handler: onClosed
    QSet<QString> required;
};

Members membersOf(const QString& path, const QMap<QString, QString>& files)
{
    static const QRegularExpression root(u"^(\\w+) \\{$"_s, QRegularExpression::MultilineOption);
    static const QRegularExpression property(
        uR"(^    (required )?(?:default )?property (?:alias|[\w<>.]+) (\w+))"_s,
        QRegularExpression::MultilineOption);
    static const QRegularExpression signal(u"^    signal (\\w+)"_s, QRegularExpression::MultilineOption);
    static const QRegularExpression bound(u"^    (\\w+):"_s, QRegularExpression::MultilineOption);
    const QString text = textOf(path);
    Members members;
    for (auto it = files.begin(); it != files.end(); ++it) {
        if (it.key().endsWith(u'/' + root.match(text).captured(1)))
            members = membersOf(it.value(), files);
    }
    for (const QRegularExpressionMatch& match : property.globalMatch(text)) {
        members.all << match.captured(2);
        if (match.hasCaptured(1))
            members.required << match.captured(2);
    }
    for (const QRegularExpressionMatch& match : signal.globalMatch(text))
        members.all << u"on"_s + match.captured(1).at(0).toUpper() + match.captured(1).sliced(1);
    for (const QRegularExpressionMatch& match : bound.globalMatch(text))
        members.required.remove(match.captured(1));
    return members;
}

// Returns what is wrong with the call: an unknown sheet, a property or signal that it does not have, a
// required one that is not given.
QStringList wrongIn(const QStringList& call, const QMap<QString, QString>& files)
{
    static const QRegularExpression key(u"^\\s*(\\w+)\\s*:"_s);
    QStringList wrong;
    const QStringList sheets = textsIn(call.first());
    if (sheets.isEmpty() || call.size() != 2)
        return {u"not a name and its values: "_s + call.join(u',')};
    QSet<QString> given;
    const QString values = call.last().trimmed().sliced(1);
    for (const QString& part : partsFrom(values, 0)) {
        if (!part.trimmed().isEmpty())
            given << key.match(part).captured(1);
    }
    for (const QString& sheet : sheets) {
        if (!files.contains(sheet)) {
            wrong << u"no sheet "_s + sheet;
            continue;
        }
        const Members members = membersOf(files[sheet], files);
        if (!members.all.contains(u"pending"_s))
            wrong << sheet + u" is no Overlay: what is typed in it would be lost"_s;
        for (const QString& name : given - members.all)
            wrong << u"%1 has no \"%2\""_s.arg(sheet, name);
        for (const QString& name : members.required - given)
            wrong << u"%1 needs \"%2\""_s.arg(sheet, name);
    }
    return wrong;
}

// Returns the rows of lists that do not stand on ListRow. The rows of tables, keys beside a keyboard and
// fields are no rows of a list.
QStringList strangeRowsIn(const QString& text, const QMap<QString, QString>& files)
{
    static const QSet<QString> others{u"DifferenceRow"_s, u"FrameRow"_s, u"TableRow"_s, u"KeypadKey"_s,
                                      u"FieldTile"_s};
    static const QRegularExpression delegate(uR"(\bdelegate: (\w+) \{)"_s);
    static const QRegularExpression root(u"^(\\w+) \\{$"_s, QRegularExpression::MultilineOption);
    QStringList strange;
    for (const QRegularExpressionMatch& match : delegate.globalMatch(text)) {
        QString type = match.captured(1);
        while (type != u"ListRow" && !others.contains(type)) {
            const auto file = std::ranges::find_if(
                files, [&type](const QString& path) { return path.endsWith(u"/%1.qml"_s.arg(type)); });
            if (file == files.end())
                break;
            type = root.match(textOf(*file)).captured(1);
        }
        if (type != u"ListRow" && !others.contains(type))
            strange << match.captured(1);
    }
    return strange;
}

// Returns the names of settings, as `SettingTile`, `SettingKeys` and `Settings.setting()` have them.
QStringList settingsIn(const QString& text)
{
    static const QRegularExpression name(
        uR"(\bSetting(?:Tile|Keys) \{[^{}]*?\bname: \x22([^\x22]*)\x22|Settings\.setting\(\x22([^\x22]*)\x22\))"_s);
    QStringList names;
    for (const QRegularExpressionMatch& match : name.globalMatch(text))
        names << match.captured(match.lastCapturedIndex());
    return names;
}

// Returns the names of parameters, as `ParameterTile` and `Controller.parameterField()` have them.
QStringList parametersIn(const QString& text)
{
    static const QRegularExpression name(
        uR"(\bParameterTile \{[^{}]*?\bname: \x22([^\x22]*)\x22|Controller\.parameterField\(\x22([^\x22]*)\x22\))"_s);
    QStringList names;
    for (const QRegularExpressionMatch& match : name.globalMatch(text))
        names << match.captured(match.lastCapturedIndex());
    return names;
}

// Returns the names of recipe fields, as `FieldTile` and `Editor.field()` have them, also in lists.
QStringList fieldsIn(const QString& text)
{
    static const QRegularExpression name(
        uR"(\bfields?: (\x22[^\x22]*\x22|\[\x22[^]]*\])|Editor\.field\((\x22[^\x22]*\x22)\)|(\[\x22[^]]*\]), \w+ => Editor\.field\b)"_s);
    QStringList names;
    for (const QRegularExpressionMatch& match : name.globalMatch(text))
        names += textsIn(match.captured(match.lastCapturedIndex()));
    return names;
}

} // namespace

class TestNames : public QObject {
    Q_OBJECT

private slots:
    void everySheetHasItsFile()
    {
        const QMap<QString, QString> files = filesByName();
        QSet<QString> opened;
        QStringList wrong;
        for (const QString& path : filesBelow({u"qml"_s}, {u"*.qml"_s})) {
            for (const QStringList& call : callsOf(u"Frame.open"_s, textOf(path))) {
                for (const QString& sentence : wrongIn(call, files))
                    wrong << path + u": "_s + sentence;
                for (const QString& sheet : textsIn(call.first()))
                    opened << sheet;
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
        QVERIFY(opened.size() > 30);
    }

    // A sheet does not outlive the next one, so it gives it no functions.
    void onlyPagesAndSectionsAnswerSignals()
    {
        static const QRegularExpression handler(u"\\bon[A-Z]\\w*:|=>"_s);
        const QMap<QString, QString> files = filesByName();
        QStringList wrong;
        int calls = 0;
        for (const QString& path : files) {
            if (!membersOf(path, files).all.contains(u"onClosed"_s) ||
                path.endsWith(u"LogFilterDialogs.qml"_s))
                continue;
            for (const QStringList& call : callsOf(u"Frame.open"_s, textOf(path))) {
                ++calls;
                if (call.last().contains(handler))
                    wrong << path + u": "_s + call.first();
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
        QVERIFY(calls > 10);
    }

    void everyRowStandsOnListRow()
    {
        // Pictures with a text, not rows of words.
        const QSet<QString> drawn{u"qml/run/StrokeCard.qml"_s, u"qml/stops/ReasonList.qml"_s};
        const QMap<QString, QString> files = filesByName();
        QStringList strange;
        for (const QString& path : filesBelow({u"qml"_s}, {u"*.qml"_s})) {
            const QStringList rows = strangeRowsIn(textOf(path), files);
            QCOMPARE(!rows.isEmpty() && drawn.contains(path), drawn.contains(path));
            if (!rows.isEmpty() && !drawn.contains(path))
                strange << path + u": "_s + rows.join(u", "_s);
        }
        QVERIFY2(strange.isEmpty(), qPrintable(strange.join(u'\n')));
        QCOMPARE(strangeRowsIn(u"delegate: AuditRow {\ndelegate: Rectangle {\ndelegate: Button {"_s, files),
                 QStringList({u"Rectangle"_s, u"Button"_s}));
    }

    void everyPageIsOfTheFrame()
    {
        static const QRegularExpression source(uR"(^        (\w+): \x22../\w+/\w+Page\.qml\x22)"_s,
                                               QRegularExpression::MultilineOption);
        QSet<QString> pages;
        for (const QRegularExpressionMatch& match : source.globalMatch(textOf(u"qml/frame/PanelFrame.qml"_s)))
            pages << match.captured(1);
        QCOMPARE(pages.size(), 8);
        int sections = 0;
        for (const QString& path : filesBelow({u"qml"_s}, {u"*.qml"_s})) {
            for (const QStringList& call : callsOf(u"Frame.openPage"_s, textOf(path))) {
                for (const QString& name : textsIn(call.first()))
                    QVERIFY2(pages.contains(name), qPrintable(path + u": "_s + name));
            }
            for (const QStringList& call : callsOf(u"Frame.openSection"_s, textOf(path))) {
                const QString page = textsIn(call.at(0)).value(0);
                const QString section = textsIn(call.at(1)).value(0);
                QVERIFY2(pages.contains(page), qPrintable(path + u": "_s + page));
                QVERIFY2(textOf(u"qml/%1/%2Page.qml"_s.arg(page, page.front().toUpper() + page.sliced(1)))
                             .contains(u"source: \"%1\""_s.arg(section)),
                         qPrintable(path + u": "_s + section));
                ++sections;
            }
        }
        QVERIFY(sections > 0);
    }

    void everySettingHasItsRow()
    {
        const QString table = textOf(u"app/panel/settings/setting_table.h"_s);
        int named = 0;
        for (const QString& path : filesBelow({u"qml"_s}, {u"*.qml"_s})) {
            for (const QString& name : settingsIn(textOf(path))) {
                QVERIFY2(table.contains(u".name = \"%1\""_s.arg(name)), qPrintable(path + u": "_s + name));
                ++named;
            }
        }
        QVERIFY(named > 15);
        QCOMPARE(settingsIn(u"    SettingTile {\n        width: 3\n        name: \"display.teme\"\n    }\n"
                            "value: Settings.setting(\"display.glove\").key"_s),
                 QStringList({u"display.teme"_s, u"display.glove"_s}));
        QVERIFY(!table.contains(u".name = \"display.teme\""_s));
    }

    void everyFieldHasItsRow()
    {
        const QString rows = textOf(u"profile/model/fields.h"_s);
        int named = 0;
        for (const QString& path : filesBelow({u"qml"_s}, {u"*.qml"_s})) {
            for (const QString& name : fieldsIn(textOf(path))) {
                QVERIFY2(rows.contains(u"\"%1\""_s.arg(name)), qPrintable(path + u": "_s + name));
                ++named;
            }
        }
        QVERIFY(named > 15);
        QCOMPARE(
            fieldsIn(
                u"field: \"bag_lenght\"; fields: [\"k1\", \"k5\"]\nEditor.field(\"k6\"), Array.from([\"k7\"], name => Editor.field(name))"_s),
            QStringList({u"bag_lenght"_s, u"k1"_s, u"k5"_s, u"k6"_s, u"k7"_s}));
        QVERIFY(!rows.contains(u"\"bag_lenght\""_s));
    }

    void everyParameterHasItsRow()
    {
        const QString table = textOf(u"app/panel/controller/parameter_table.h"_s);
        const QString map = textOf(u"modbus/map/register_map.cpp"_s);
        int named = 0;
        for (const QString& path : filesBelow({u"qml"_s}, {u"*.qml"_s})) {
            for (const QString& name : parametersIn(textOf(path))) {
                QVERIFY2(table.contains(u"\"%1\""_s.arg(name)) && map.contains(u"\"%1\""_s.arg(name)),
                         qPrintable(path + u": "_s + name));
                ++named;
            }
        }
        QVERIFY(named >= 2);
        QCOMPARE(
            parametersIn(
                u"ParameterTile {\n    name: \"parameter.jog\"\n}\nController.parameterField(\"parameter.gog\")"_s),
            QStringList({u"parameter.jog"_s, u"parameter.gog"_s}));
        QVERIFY(!table.contains(u"\"parameter.gog\""_s));
    }

    void plantedNameIsFound_data()
    {
        QTest::addColumn<QString>("code");
        QTest::addColumn<QStringList>("wrong");

        QTest::newRow("right") << uR"(Frame.open("Download/ProofSheet", {}))"_s << QStringList();
        QTest::newRow("misspelt") << uR"(Frame.open("Download/PoofSheet", {}))"_s
                                  << QStringList{u"no sheet Download/PoofSheet"_s};
        QTest::newRow("of another room")
            << uR"(Frame.open("Editor/ProofSheet", {}))"_s << QStringList{u"no sheet Editor/ProofSheet"_s};
        QTest::newRow("no sheet") << uR"(Frame.open("Parts/Page", {}))"_s
                                  << QStringList{
                                         u"Parts/Page is no Overlay: what is typed in it would be lost"_s};
        QTest::newRow("one of two") << uR"(Frame.open(isOne ? "Editor/KnotSheet" : "Editor/KnutSheet", {}))"_s
                                    << QStringList{u"no sheet Editor/KnutSheet"_s};
        QTest::newRow("no text") << u"Frame.open(name, {})"_s
                                 << QStringList{u"not a name and its values: name, {}"_s};
        QTest::newRow("value and handler")
            << uR"(Frame.open("Controls/ListPicker", { title: qsTr("A, b"), choices: [1, { a: 2 }], current: 1, onChosen: key => f(key, 1) }))"_s
            << QStringList();
        QTest::newRow("misspelt property")
            << uR"(Frame.open("Controls/ListPicker", { title: "", choices: [], current: 1, dept: 3 }))"_s
            << QStringList{u"Controls/ListPicker has no \"dept\""_s};
        QTest::newRow("misspelt signal")
            << uR"(Frame.open("Controls/ListPicker", { title: "", choices: [], current: 1, onPicked: key => f(key) }))"_s
            << QStringList{u"Controls/ListPicker has no \"onPicked\""_s};
        QTest::newRow("missing") << uR"(Frame.open("Controls/ListPicker", { title: "", choices: [] }))"_s
                                 << QStringList{u"Controls/ListPicker needs \"current\""_s};
    }
    void plantedNameIsFound()
    {
        QFETCH(const QString, code);
        QFETCH(const QStringList, wrong);

        const QList<QStringList> calls = callsOf(u"Frame.open"_s, code);
        QCOMPARE(calls.size(), 1);
        QCOMPARE(wrongIn(calls.first(), filesByName()), wrong);
    }
};

CAMPANEL_TEST(TestNames)

} // namespace test_names

#include "test_names.moc"
