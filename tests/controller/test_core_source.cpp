// SPDX-License-Identifier: Apache-2.0
// The restrictions on the core's sources: no floating point (an ARM7 has none), no heap, no globals, no
// foreign headers.
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

namespace test_core_source {

using namespace Qt::StringLiterals;

namespace {

struct Source {
    QString name;
    QString code; // without comments
};

QString withoutComments(QString text)
{
    static const QRegularExpression comment(u"/\\*.*?\\*/|//[^\\n]*"_s,
                                            QRegularExpression::DotMatchesEverythingOption);
    return text.remove(comment);
}

QList<Source> coreSources()
{
    QList<Source> sources;
    QDirIterator files(campanel::test::sourcePath("controller/core"), {u"*.c"_s, u"*.h"_s}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        if (file.open(QIODevice::ReadOnly))
            sources.append({files.fileName(), withoutComments(QString::fromUtf8(file.readAll()))});
    }
    return sources;
}

// Returns the matching lines of the core, each with its file.
QStringList findings(const QString& pattern)
{
    const QRegularExpression expression(pattern);
    QStringList found;
    for (const Source& source : coreSources()) {
        for (const QString& line : source.code.split(u'\n')) {
            if (line.contains(expression))
                found << source.name + u": "_s + line.trimmed();
        }
    }
    return found;
}

} // namespace

class TestCoreSource : public QObject {
    Q_OBJECT

private slots:
    void isFound();
    void usesNoFloatingPoint();
    void usesNoHeapOrInputOutput();
    void hasNoGlobals();
    void includesOnlyItselfAndTheLanguage();
    void setsAnAxisOffInTheGateAlone();
    void shiftsACutAndTriesAnOutputInOnePlaceEach();
};

void TestCoreSource::isFound()
{
    QVERIFY(coreSources().size() > 50);
    QCOMPARE(withoutComments(u"a /* float\n */ b // double"_s), u"a  b "_s);
}

void TestCoreSource::usesNoFloatingPoint()
{
    QCOMPARE(findings(u"\\b(float|double|sqrtf?|math\\.h)\\b|\\b\\d+\\.\\d"_s), QStringList());
}

void TestCoreSource::usesNoHeapOrInputOutput()
{
    QCOMPARE(findings(u"\\b(malloc|calloc|realloc|free|printf|fprintf|fopen|stdio\\.h|stdlib\\.h)\\b"_s),
             QStringList());
}

// A variable at file scope starts in the first column; static ones there must be const.
void TestCoreSource::hasNoGlobals()
{
    QCOMPARE(
        findings(
            u"^(static )?(?!const\\b|static\\b|return\\b|typedef\\b|_Static_assert\\b|struct [a-z_]+;)[a-z_0-9]+\\*? [a-z_0-9]+(\\[.*\\])?( =.*)?;"_s),
        QStringList());
    QCOMPARE(findings(u"^\\s+static (?!const\\b)"_s), QStringList());
}

void TestCoreSource::includesOnlyItselfAndTheLanguage()
{
    QCOMPARE(
        findings(u"#\\s*include (?!\"([a-z]+/)?ctl_[a-z_]+\\.h\"|<(stdint|stddef|stdbool|string)\\.h>)"_s),
        QStringList());
}

// One place asks what a start needs: whatever wants to start calls ctl_start().
void TestCoreSource::setsAnAxisOffInTheGateAlone()
{
    QStringList others;
    for (const QString& line : findings(u"\\bctl_motion_(start|home)\\("_s)) {
        if (!line.startsWith(u"ctl_start.c"_s) && !line.startsWith(u"ctl_motion."_s))
            others << line;
    }
    QCOMPARE(others, QStringList());
    QCOMPARE(findings(u"\\bctl_motion_(start|home)\\("_s).size(), 6); // declared, defined, called
}

// A cut is shifted by ctl_phase_move(), an output is switched on for a test by the gate.
void TestCoreSource::shiftsACutAndTriesAnOutputInOnePlaceEach()
{
    QStringList callers;
    for (const QString& line : findings(u"\\b(ctl_feed_correct|ctl_io_try)\\("_s)) {
        if (!line.contains(u"void "_s))
            callers << line.section(u':', 0, 0);
    }
    callers.sort();
    // The infeed is shifted to its places and by hand; another command switches the output off.
    QCOMPARE(callers, QStringList({u"ctl_command.c"_s, u"ctl_packer.c"_s, u"ctl_packer_hand.c"_s,
                                   u"ctl_phase.c"_s, u"ctl_start.c"_s}));
}

CAMPANEL_TEST(TestCoreSource)

} // namespace test_core_source

#include "test_core_source.moc"
