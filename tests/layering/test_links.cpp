// SPDX-License-Identifier: Apache-2.0
// Every relative link in a Markdown file leads to a file, and its anchor to a heading there.
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QRegularExpression>
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
};

CAMPANEL_TEST(TestLinks)

} // namespace test_links

#include "test_links.moc"
