// SPDX-License-Identifier: Apache-2.0
// The allowed directions between the layers, read from every #include and every QML import.
// A folder without a rule, a file in no folder with a rule, or an include that no rule allows fails the test.
#include "source_files.h"
#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QMap>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include <algorithm>
#include <iterator>

namespace test_layering {

using namespace Qt::StringLiterals;
using campanel::test::filesBelow;
using campanel::test::textOf;

namespace {

// A header of the C++ standard library, by its form: no folder, no suffix, lower case.
constexpr auto standardCpp = R"([a-z][a-z0-9_]*)";
constexpr auto standardC = R"((stdint|stddef|stdbool|string)\.h)";
constexpr auto posix =
    R"((fcntl|unistd|termios|poll|grp|pwd|time|errno|stdlib|stdio|signal|getopt|limits|dirent|sys/[a-z]+|linux/serial|pty|malloc)\.h)";
// The host programs find the core and the simulated machine on their include path.
constexpr auto controllerHost =
    R"((base/ctl_crc|ctl_registers|machine|flash_device|simulated_controller)\.h)";
constexpr auto expected = R"(tl/expected\.hpp)";
constexpr auto qtAny = R"(Q[A-Za-z0-9]+(/.*)?)";

struct Rule {
    QString folder;      // deepest match wins
    QStringList allowed; // regular expressions for the whole include path
};

// The rooms of a folder, lowest first: a room may include itself and the rooms of lower levels.
struct House {
    QString folder;
    QString includedFrom;      // the part of the folder that an include leaves out
    QStringList outside;       // what every room may include besides
    QList<QStringList> levels; // rooms of one level do not see one another
};

const QList<House>& houses()
{
    static const QList<House> all{
        {u"profile"_s,
         {},
         {standardCpp, expected, u"text/marked\\.h"_s},
         {{u"model"_s},
          {u"laws"_s},
          {u"cutter"_s},
          {u"program"_s},
          {u"moves"_s, u"cam"_s, u"intervals"_s},
          {u"press"_s, u"segments"_s}}},
        {u"modbus"_s,
         {},
         {standardCpp, posix, expected, u"(modbus/)?modbus(-[a-z]+)?\\.h"_s, u"text/marked\\.h"_s},
         {{u"map"_s}, {u"line"_s}, {u"download"_s}}},
        {u"controller/core"_s,
         u"controller/core/"_s,
         {standardC, u"ctl_registers\\.h"_s},
         {{u"base"_s},
          {u"engine"_s},
          {u"master"_s},
          {u"bank"_s},
          {u"packer"_s},
          {u"motion"_s},
          {u"signal"_s},
          {u"link"_s},
          {u"."_s}}},
        {u"app/store"_s,
         {},
         {standardCpp, posix, expected, qtAny, u"(sodium|sqlite3|zip)\\.h"_s, u"profile/.*"_s,
          u"app/program/.*"_s},
         {{u"files"_s},
          {u"database"_s},
          {u"users"_s, u"recipes"_s, u"logs"_s},
          {u"backup"_s, u"update"_s},
          {u"."_s}}},
        {u"app/panel"_s,
         {},
         {standardCpp, expected, qtAny, u"profile/.*"_s, u"app/(link|plant|program|store)/.*"_s},
         {{u"kit"_s},
          {u"words"_s},
          {u"recipe"_s},
          {u"records"_s, u"settings"_s},
          {u"controller"_s},
          {u"access"_s, u"download"_s, u"hand"_s, u"orders"_s, u"packing"_s, u"trends"_s, u"stops"_s,
           u"display"_s},
          {u"editor"_s},
          {u"library"_s, u"alarms"_s, u"maintenance"_s},
          {u"explain"_s, u"audit"_s, u"scan"_s},
          {u"reports"_s, u"plant"_s, u"update"_s}}},
    };
    return all;
}

QString folderOf(const House& house, const QString& room)
{
    return room == u"."_s ? house.folder : house.folder + u'/' + room;
}

QList<Rule> roomRules()
{
    QList<Rule> rules;
    for (const House& house : houses()) {
        QStringList lower = house.outside;
        for (const QStringList& level : house.levels) {
            QStringList own;
            for (const QString& room : level) {
                const QString folder = folderOf(house, room);
                const QString included = folder + u'/';
                const QString headers = included.sliced(house.includedFrom.size()) +
                                        (room == u"."_s ? u"[a-z_0-9]+\\.h"_s : u".*"_s);
                rules.append({folder, lower + QStringList{headers}});
                own.append(headers);
            }
            lower += own;
        }
    }
    return rules;
}

const QList<Rule>& includeRules()
{
    static const QList<Rule> rules =
        roomRules() +
        QList<Rule>{
            {u"text"_s, {}},
            {u"examples"_s, {standardCpp, u"(profile|modbus)/.*"_s}},
            {u"controller/sim"_s,
             {standardCpp, standardC,
              u"(base/ctl_(bank|port|words)|engine/ctl_(press|step)|bank/ctl_check|packer/ctl_feed|link/ctl_map|motion/ctl_start|ctl_core)\\.h"_s}},
            {u"controller/board"_s,
             {standardC,
              u"(board|ctl_core|(machine|versatilepb)/[a-z_]+|base/ctl_(crc|port|words)|engine/ctl_step)\\.h"_s}},
            {u"controller/host"_s, {standardCpp, standardC, posix, expected, controllerHost}},
            {u"app/link"_s, {standardCpp, posix, expected, qtAny, u"modbus/.*"_s, u"app/link/.*"_s}},
            {u"app/program"_s,
             {standardCpp, expected, u"profile/.*"_s, u"modbus/.*"_s, u"text/marked\\.h"_s,
              u"app/program/.*"_s}},
            {u"app/plant"_s, {standardCpp, qtAny, u"app/plant/.*"_s}},
            {u"app/plot"_s,
             {standardCpp, qtAny, u"qwt[a-z_]*\\.h"_s, u"qrencode\\.h"_s, u"profile/.*"_s, u"app/plot/.*"_s}},
            {u"app/report"_s, {standardCpp, qtAny, u"app/(panel|plot|report)/.*"_s}},
            {u"app/cli"_s,
             {standardCpp, posix, expected, qtAny, u"(profile|modbus)/.*"_s,
              u"app/(program|store|cli|panel/words)/.*"_s, u"app/plot/picture/regime_picture\\.h"_s,
              u"packing_run\\.h"_s, u"app/shell/configuration\\.h"_s, u"gateway/(fleet|mqtt_line)\\.h"_s}},
            {u"gateway"_s,
             {standardCpp, posix, qtAny, u"app/plant/.*"_s,
              u"app/shell/(configuration|termination_signals)\\.h"_s, u"app/store/files/files\\.h"_s,
              u"app/store/(recipes/(recipe_keys|signed_recipe)|signed_order)\\.h"_s, u"gateway/.*"_s,
              u"mosquitto\\.h"_s, u"sparkplug_payload\\.pb-c\\.h"_s}},
            {u"app/shell"_s, {standardCpp, qtAny, u"app/.*"_s, posix, u"toml\\+\\+/toml\\.h"_s}},
        };
    return rules;
}

// The rooms of qml/, as those of the houses. A room's module has its name with a capital letter.
const QList<QStringList>& qmlLevels()
{
    static const QList<QStringList> levels{{u"parts"_s},
                                           {u"explain"_s, u"access"_s, u"audit"_s, u"download"_s, u"alarms"_s,
                                            u"trends"_s, u"stops"_s, u"run"_s, u"orders"_s, u"packing"_s,
                                            u"maintenance"_s, u"reports"_s, u"scan"_s},
                                           {u"editor"_s},
                                           {u"library"_s, u"settings"_s, u"first"_s},
                                           {u"frame"_s}};
    return levels;
}

QString moduleOf(const QString& room)
{
    return u"CamPanel\\.%1%2"_s.arg(room.at(0).toUpper()).arg(room.sliced(1));
}

const QList<Rule>& importRules()
{
    static const QList<Rule> rules = [] {
        const QStringList base{u"QtQml"_s, u"QtQuick(\\.(Window|Templates|Layouts))?"_s};
        QList<Rule> all{{u"qml/Theme"_s, base},
                        {u"qml/Controls"_s, base + QStringList{u"CamPanel\\.(Theme|Controls)"_s}}};
        QStringList lower = base + QStringList{u"CamPanel\\.(Theme|Controls|Panel|Plot)"_s};
        for (const QStringList& level : qmlLevels()) {
            for (const QString& room : level)
                all.append({u"qml/"_s + room, lower});
            for (const QString& room : level)
                lower.append(moduleOf(room));
        }
        return all;
    }();
    return rules;
}

const Rule* ruleFor(const QList<Rule>& rules, const QString& relativePath)
{
    const Rule* best = nullptr;
    for (const Rule& rule : rules) {
        if (relativePath.startsWith(rule.folder + u'/') &&
            (!best || rule.folder.size() > best->folder.size()))
            best = &rule;
    }
    return best;
}

// Returns every first capture of `pattern` in the file that no rule allows, as "path: what".
QStringList violationsIn(const QString& text, const QString& relativePath, const QList<Rule>& rules,
                         const QRegularExpression& pattern)
{
    const Rule* rule = ruleFor(rules, relativePath);
    if (!rule)
        return {relativePath + u": lies in a folder that no rule names"_s};
    const QFileInfo file(QDir(campanel::test::sourcePath(".")).filePath(relativePath));
    const QRegularExpression allowed(
        QRegularExpression::anchoredPattern(u"(?:"_s + rule->allowed.join(u")|(?:"_s) + u")"_s));
    QStringList found;
    for (const QRegularExpressionMatch& match : pattern.globalMatch(text)) {
        const QString what = match.captured(1);
        const bool ownFolder = !what.contains(u'/') && QFile::exists(file.dir().filePath(what));
        if (!ownFolder && !allowed.match(what).hasMatch())
            found << relativePath + u": "_s + what;
    }
    return found;
}

QStringList violations(const QString& relativePath, const QList<Rule>& rules,
                       const QRegularExpression& pattern)
{
    const QString text = textOf(relativePath);
    if (text.isEmpty())
        return {relativePath + u": cannot be read"_s};
    return violationsIn(text, relativePath, rules, pattern);
}

const QRegularExpression includePattern(uR"(^\s*#\s*include\s*[<\x22]([^>\x22]+)[>\x22])"_s,
                                        QRegularExpression::MultilineOption);
// The beginnings of comments without a subject.
const QRegularExpression
    subjectlessComment(uR"((?://|/\*+|^\s*\*) (Of|Who|What|Whether|To be|That)\b[^\n]*)"_s,
                       QRegularExpression::MultilineOption);
// The functions of the standard library that drop a NaN.
const QRegularExpression
    nanDropper(uR"(\b(std::(?:ranges::)?(?:clamp|f?min|f?max|minmax|(?:min|max|minmax)_element)\b|)"
               uR"(f(?:min|max)[fl]?\s*\(|using namespace std\b))"_s);

// What each file includes, of the files that are asked about.
using Graph = QMap<QString, QStringList>;

QString withoutSuffix(const QString& path)
{
    return path.left(path.lastIndexOf(u'.'));
}

QString itself(const QString& path)
{
    return path;
}

Graph includeGraph(const QStringList& files, QString (*nodeOf)(const QString&) = &itself)
{
    const QSet<QString> known(files.begin(), files.end());
    Graph graph;
    for (const QString& path : files) {
        const QString text = textOf(path);
        const QStringList places{QString(), QFileInfo(path).path() + u'/', u"controller/core/"_s,
                                 u"controller/sim/"_s, u"controller/host/"_s};
        for (const QRegularExpressionMatch& match : includePattern.globalMatch(text)) {
            for (const QString& place : places) {
                if (known.contains(place + match.captured(1)) &&
                    nodeOf(place + match.captured(1)) != nodeOf(path))
                    graph[nodeOf(path)].append(nodeOf(place + match.captured(1)));
            }
        }
    }
    return graph;
}

// Returns the files that lead back to themselves, or to a circle; empty when there is none. A file that
// includes none that is left cannot be in a circle, so it is taken away until nothing changes.
QStringList circleIn(Graph graph)
{
    for (bool changed = true; changed;) {
        changed = false;
        for (auto it = graph.begin(); it != graph.end();) {
            const bool ends =
                std::ranges::none_of(it.value(), [&](const QString& file) { return graph.contains(file); });
            changed = changed || ends;
            it = ends ? graph.erase(it) : std::next(it);
        }
    }
    return graph.keys();
}

const QRegularExpression importPattern(uR"(^\s*import\s+([A-Za-z][A-Za-z.]*))"_s,
                                       QRegularExpression::MultilineOption);

} // namespace

class TestLayering : public QObject {
    Q_OBJECT

private slots:
    void everyIncludeIsAllowed()
    {
        const QStringList files = filesBelow(
            {u"text"_s, u"profile"_s, u"modbus"_s, u"controller"_s, u"app"_s, u"examples"_s, u"gateway"_s},
            {u"*.h"_s, u"*.cpp"_s, u"*.c"_s, u"*.hpp"_s});
        QVERIFY(files.size() > 20);
        QStringList all;
        for (const QString& file : files)
            all += violations(file, includeRules(), includePattern);
        QVERIFY2(all.isEmpty(), qPrintable(u"not allowed:\n  "_s + all.join(u"\n  "_s)));
    }

    // Plants an include between any two rooms: upwards or sideways it is a violation, downwards it is none.
    void plantedIncludeIsFound()
    {
        int planted = 0;
        for (const House& house : houses()) {
            for (qsizetype from = 0; from < house.levels.size(); ++from) {
                for (qsizetype to = 0; to < house.levels.size(); ++to) {
                    for (const QString& room : house.levels[from]) {
                        for (const QString& other : house.levels[to]) {
                            if (room == other)
                                continue;
                            const QString header = folderOf(house, other) + u"/planted.h"_s;
                            const QString text =
                                u"#include \"%1\"\n"_s.arg(header.sliced(house.includedFrom.size()));
                            const QString path = folderOf(house, room) + u"/planted.cpp"_s;
                            const bool isFound =
                                !violationsIn(text, path, includeRules(), includePattern).isEmpty();
                            QVERIFY2(isFound == (to >= from), qPrintable(path + u" -> "_s + other));
                            ++planted;
                        }
                    }
                }
            }
        }
        QVERIFY(planted > 300);
    }

    // Plants an include between any two folders with a rule, in both directions: one is a violation at least.
    void noTwoFoldersIncludeEachOther()
    {
        QStringList folders;
        for (const Rule& rule : includeRules())
            folders << rule.folder;
        QVERIFY(folders.size() > 40);
        const auto isFound = [](const QString& from, const QString& to) {
            const qsizetype left = to.startsWith(u"controller/core/"_s) ? u"controller/core/"_s.size() : 0;
            const QString text = u"#include \"%1/planted.h\"\n"_s.arg(to.sliced(left));
            return !violationsIn(text, from + u"/planted.cpp"_s, includeRules(), includePattern).isEmpty();
        };
        for (const QString& a : folders) {
            for (const QString& b : folders) {
                const bool isWithin = a.startsWith(b) || b.startsWith(a); // the files of a house's own folder
                if (a < b && !isWithin)
                    QVERIFY2(isFound(a, b) || isFound(b, a), qPrintable(a + u" <-> "_s + b));
            }
        }
    }

    // The same for the imports of the rooms of qml/.
    void plantedImportIsFound()
    {
        const auto isFound = [](const QString& from, const QString& to) {
            const QString text = u"import "_s + moduleOf(to).remove(u'\\') + u'\n';
            const QString path = u"qml/%1/Planted.qml"_s.arg(from);
            return !violationsIn(text, path, importRules(), importPattern).isEmpty();
        };
        for (qsizetype from = 0; from < qmlLevels().size(); ++from) {
            for (qsizetype to = 0; to < qmlLevels().size(); ++to) {
                for (const QString& a : qmlLevels()[from]) {
                    for (const QString& b : qmlLevels()[to])
                        QVERIFY2(isFound(a, b) == (to >= from), qPrintable(a + u" -> "_s + b));
                }
            }
        }
    }

    void noFolderHasTooManyFiles()
    {
        constexpr int maxFiles = 40;
        QMap<QString, int> counts;
        const QStringList files = filesBelow({u"profile"_s, u"modbus"_s, u"controller"_s, u"app"_s, u"qml"_s,
                                              u"gateway"_s, u"tests"_s, u"packaging"_s, u"examples"_s},
                                             {u"*"_s});
        for (const QString& file : files)
            ++counts[QFileInfo(file).path()];
        QVERIFY(counts.size() > 60);
        for (auto it = counts.begin(); it != counts.end(); ++it)
            QVERIFY2(it.value() <= maxFiles, qPrintable(u"%1: %2 files"_s.arg(it.key()).arg(it.value())));
    }

    void noHeaderIncludesItself()
    {
        const QStringList headers = filesBelow(
            {u"profile"_s, u"modbus"_s, u"controller"_s, u"app"_s, u"gateway"_s}, {u"*.h"_s, u"*.hpp"_s});
        QVERIFY(headers.size() > 300);
        QCOMPARE(circleIn(includeGraph(headers)), QStringList());
    }

    // A source of the core counts with its header: none of them needs what needs it.
    void noPartOfTheCoreNeedsItself()
    {
        const QStringList files = filesBelow({u"controller/core"_s}, {u"*.h"_s, u"*.c"_s});
        const Graph graph = includeGraph(files, &withoutSuffix);
        QVERIFY(graph.value(u"controller/core/ctl_core"_s).contains(u"controller/core/link/ctl_parts"_s));
        QCOMPARE(circleIn(graph), QStringList());
    }

    void plantedCircleIsFound()
    {
        Graph graph = includeGraph(filesBelow({u"controller"_s}, {u"*.h"_s}));
        QCOMPARE(circleIn(graph), QStringList());
        const QString core = u"controller/core/ctl_core.h"_s;
        const QString ramp = u"controller/core/engine/ctl_ramp.h"_s;
        graph[ramp].append(core);
        const QStringList circle = circleIn(graph);
        QVERIFY(circle.contains(core) && circle.contains(ramp));
    }

    void everyImportIsAllowed()
    {
        const QStringList files = filesBelow({u"qml"_s}, {u"*.qml"_s});
        QVERIFY(files.size() > 10);
        QStringList all;
        for (const QString& file : files)
            all += violations(file, importRules(), importPattern);
        QVERIFY2(all.isEmpty(), qPrintable(u"not allowed:\n  "_s + all.join(u"\n  "_s)));
    }

    // In profile/ profile/model/bounds.h takes their place.
    void noNanIsDropped()
    {
        QStringList files = filesBelow({u"profile"_s}, {u"*.h"_s, u"*.cpp"_s});
        QVERIFY(files.removeOne(u"profile/model/bounds.h"_s) && files.size() > 100);
        QStringList found;
        for (const QString& name : files) {
            for (const QRegularExpressionMatch& match : nanDropper.globalMatch(textOf(name)))
                found << name + u": "_s + match.captured(1);
        }
        QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
    }

    void plantedNanDropperIsFound()
    {
        for (const QString& planted :
             {u"x = std::max(a, b);"_s, u"std::min<double>(a, b)"_s, u"std::clamp(x, 0.0, 1.0)"_s,
              u"std::ranges::max(all)"_s, u"std::ranges::minmax(all)"_s, u"*std::max_element(a, b)"_s,
              u"std::fmax(a, b)"_s, u"x = fmin(a, b);"_s, u"fmaxf (a, b)"_s, u"using std::min;"_s,
              u"using namespace std;"_s})
            QVERIFY2(nanDropper.match(planted).hasMatch(), qPrintable(planted));
        for (const QString& allowed : {u"std::numeric_limits<double>::max()"_s, u"info(field).max"_s,
                                       u"maxOf(a, b)"_s, u"std::string"_s})
            QVERIFY2(!nanDropper.match(allowed).hasMatch(), qPrintable(allowed));
    }

    void everySourceFileNamesItsLicence()
    {
        const QStringList files = filesBelow({u"profile"_s, u"modbus"_s, u"controller"_s, u"app"_s, u"qml"_s,
                                              u"tests"_s, u"cmake"_s, u"packaging"_s, u"examples"_s},
                                             {u"*.h"_s, u"*.cpp"_s, u"*.c"_s, u"*.qml"_s, u"CMakeLists.txt"_s,
                                              u"*.cmake"_s, u"*.py"_s, u"*.sh"_s});
        for (const QString& name : files) {
            QVERIFY2(textOf(name).left(200).contains(u"SPDX-License-Identifier: Apache-2.0"_s),
                     qPrintable(name));
        }
    }

    void everyHeaderCommentHasASubject()
    {
        const QStringList files = filesBelow(
            {u"profile"_s, u"modbus"_s, u"controller"_s, u"app"_s, u"qml"_s, u"tests"_s}, {u"*.h"_s});
        QVERIFY(files.size() > 20);
        QStringList found;
        for (const QString& name : files) {
            const QString text = textOf(name);
            for (const QRegularExpressionMatch& match : subjectlessComment.globalMatch(text))
                found << name + u": "_s + match.captured(0);
        }
        QVERIFY2(found.isEmpty(), qPrintable(u"comments without a subject:\n  "_s + found.join(u"\n  "_s)));
    }
};

CAMPANEL_TEST(TestLayering)

} // namespace test_layering

#include "test_layering.moc"
