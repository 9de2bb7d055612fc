// SPDX-License-Identifier: Apache-2.0
// Properties and invokables exist for QML: each is used there, and no class has too many.
#include "source_files.h"
#include "tests/support/test_program.h"

#include <QRegularExpression>
#include <QSet>
#include <QTest>

namespace test_properties {

using namespace Qt::StringLiterals;
using campanel::test::filesBelow;
using campanel::test::textOf;

namespace {

QSet<QString> wordsIn(const QString& text)
{
    static const QRegularExpression word(u"\\w+"_s);
    QSet<QString> words;
    for (const QRegularExpressionMatch& match : word.globalMatch(text))
        words.insert(match.captured());
    return words;
}

// Returns the properties and invokables of a header whose names are not among the words.
QStringList unusedIn(const QString& header, const QSet<QString>& words)
{
    static const QRegularExpression offered(
        uR"(Q_PROPERTY\([^)]*?(\w+)\s+(?:READ|MEMBER)\b|Q_INVOKABLE\b[^;(]*?(\w+)\()"_s);
    QStringList unused;
    for (const QRegularExpressionMatch& match : offered.globalMatch(header)) {
        const QString name = match.captured(match.lastCapturedIndex());
        if (!words.contains(name))
            unused << name;
    }
    return unused;
}

} // namespace

class TestProperties : public QObject {
    Q_OBJECT

private slots:
    void qmlUsesEveryProperty()
    {
        QSet<QString> words;
        for (const QString& file : filesBelow({u"qml"_s}, {u"*.qml"_s, u"*.js"_s}))
            words.unite(wordsIn(textOf(file)));
        QStringList unused;
        for (const QString& file : filesBelow({u"app"_s}, {u"*.h"_s})) {
            for (const QString& name : unusedIn(textOf(file), words))
                unused << file + u": "_s + name;
        }
        QVERIFY2(unused.isEmpty(), qPrintable(unused.join(u'\n')));
    }

    void plantedPropertyIsFound()
    {
        const QString header = u"Q_PROPERTY(QList<QPointF> forces READ forces)\n"
                               "Q_PROPERTY(int rate MEMBER m_rate NOTIFY changed FINAL)\n"
                               "[[nodiscard]] Q_INVOKABLE double yOf(double value);"_s;
        QCOMPARE(unusedIn(header, {}), QStringList({u"forces"_s, u"rate"_s, u"yOf"_s}));
        QCOMPARE(unusedIn(header, wordsIn(u"x: Controller.rate; y: plot.yOf(3)"_s)),
                 QStringList{u"forces"_s});
    }

    void noClassHasTooManyProperties()
    {
        constexpr int maxProperties = 30;
        static const QRegularExpression start(u"^(class|struct) (\\w+)"_s,
                                              QRegularExpression::MultilineOption);
        int classes = 0;
        for (const QString& name : filesBelow({u"app"_s}, {u"*.h"_s})) {
            const QString text = textOf(name);
            QRegularExpressionMatchIterator it = start.globalMatch(text);
            while (it.hasNext()) {
                const QRegularExpressionMatch match = it.next();
                const qsizetype end = it.hasNext() ? it.peekNext().capturedStart() : text.size();
                const QString body = text.sliced(match.capturedStart(), end - match.capturedStart());
                const qsizetype count = body.count(u"Q_PROPERTY("_s);
                QVERIFY2(count <= maxProperties,
                         qPrintable(u"%1: %2 properties"_s.arg(match.captured(2)).arg(count)));
                classes += count > 0 ? 1 : 0;
            }
        }
        QVERIFY(classes > 40);
    }
};

CAMPANEL_TEST(TestProperties)

} // namespace test_properties

#include "test_properties.moc"
