// SPDX-License-Identifier: Apache-2.0
// Every relative link in a Markdown file leads to a file, and its anchor to a heading there. Every name of
// code in docs/architecture.md exists.
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

namespace test_links {

using namespace Qt::StringLiterals;

namespace {

QString textWithoutCode(const QString& path)
{
    static const QRegularExpression code(u"^```.*?^```|`[^`\\n]*`"_s,
                                         QRegularExpression::MultilineOption |
                                             QRegularExpression::DotMatchesEverythingOption);
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()).remove(code) : QString();
}

// As GitHub names them: lower case, words joined by hyphens, everything else dropped.
bool hasHeading(const QString& path, const QString& anchor)
{
    static const QRegularExpression heading(u"^#+ +(.+)$"_s, QRegularExpression::MultilineOption);
    static const QRegularExpression dropped(u"[^\\w\\- ]"_s, QRegularExpression::UseUnicodePropertiesOption);
    const QString text = textWithoutCode(path);
    for (const QRegularExpressionMatch& match : heading.globalMatch(text)) {
        if (match.captured(1).toLower().remove(dropped).replace(u' ', u'-') == anchor)
            return true;
    }
    return false;
}

// The links of one document that lead nowhere.
QStringList deadLinks(const QDir& root, const QString& path)
{
    static const QRegularExpression link(u"\\]\\(([^)\\s]+)\\)"_s);
    static const QRegularExpression scheme(u"^[a-z]+:"_s);
    const QString text = textWithoutCode(path);
    QStringList dead;
    for (const QRegularExpressionMatch& match : link.globalMatch(text)) {
        const QString target = match.captured(1);
        if (scheme.match(target).hasMatch())
            continue;
        const QString name = target.section(u'#', 0, 0);
        const QString anchor = target.section(u'#', 1);
        const QString file = name.isEmpty() ? path : QFileInfo(path).dir().filePath(name);
        if (!QFileInfo::exists(file) || (!anchor.isEmpty() && !hasHeading(file, anchor)))
            dead << root.relativeFilePath(path) + u": "_s + target;
    }
    return dead;
}

// Returns the words of all sources, without their comments, and the names of their files.
QSet<QString> wordsOfSources(const QDir& root)
{
    static const QRegularExpression comment(u"//[^\\n]*"_s);
    static const QRegularExpression word(u"\\w+"_s);
    QSet<QString> words;
    for (const char* folder : {"profile", "modbus", "controller", "app", "qml", "tests"}) {
        QDirIterator it(root.filePath(QString::fromLatin1(folder)),
                        {u"*.h"_s, u"*.c"_s, u"*.cpp"_s, u"*.qml"_s}, QDir::Files,
                        QDirIterator::Subdirectories);
        while (it.hasNext()) {
            QFile file(it.next());
            if (!file.open(QIODevice::ReadOnly))
                continue;
            words << QFileInfo(file).completeBaseName() << QFileInfo(file).suffix();
            const QString text = QString::fromUtf8(file.readAll()).remove(comment);
            for (const QRegularExpressionMatch& match : word.globalMatch(text))
                words << match.captured();
        }
    }
    return words;
}

} // namespace

class TestLinks : public QObject {
    Q_OBJECT

private slots:
    void everyLinkLeadsSomewhere()
    {
        const QDir root(campanel::test::sourcePath("."));
        QStringList documents = root.entryList({u"*.md"_s}, QDir::Files);
        for (const QString& folder : root.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
            if (folder == u"build"_s)
                continue;
            QDirIterator it(root.filePath(folder), {u"*.md"_s}, QDir::Files, QDirIterator::Subdirectories);
            while (it.hasNext())
                documents << root.relativeFilePath(it.next());
        }
        QVERIFY(documents.size() > 20);
        QStringList dead;
        for (const QString& document : documents)
            dead += deadLinks(root, root.filePath(document));
        QVERIFY2(dead.isEmpty(), qPrintable(u"lead nowhere:\n  "_s + dead.join(u"\n  "_s)));
    }

    // The life of one change names the functions that it goes through.
    void everyNameOfTheArchitectureExists()
    {
        static const QRegularExpression code(u"`([^`\\n]+)`"_s);
        static const QRegularExpression word(u"\\w+"_s);
        const QDir root(campanel::test::sourcePath("."));
        QFile file(root.filePath(u"docs/architecture.md"_s));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(file.readAll()).section(u"## The life of one change"_s, 1);
        QStringList named;
        for (const QRegularExpressionMatch& match : code.globalMatch(text)) {
            if (match.captured(1).contains(u'/')) // a path
                continue;
            for (const QRegularExpressionMatch& part : word.globalMatch(match.captured(1)))
                named << part.captured();
        }
        QVERIFY(named.size() > 30);
        const QSet<QString> known = wordsOfSources(root);
        named.removeIf([&known](const QString& name) { return known.contains(name); });
        QCOMPARE(named, QStringList());
    }
};

CAMPANEL_TEST(TestLinks)

} // namespace test_links

#include "test_links.moc"
