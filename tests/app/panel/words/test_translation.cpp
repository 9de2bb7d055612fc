// SPDX-License-Identifier: Apache-2.0
// The texts of each language: complete, with the same placeholders, and switched at run time.
#include "app/panel/kit/language_notifier.h"
#include "profile/laws/laws.h"
#include "tests/app/panel/panel_rig.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTranslator>
#include <QXmlStreamReader>

namespace test_translation {

using namespace campanel;
using test::PanelRig;

namespace {

QStringList placesIn(const QString& text)
{
    static const QRegularExpression place(QStringLiteral("%[0-9]"));
    QStringList places;
    for (const QRegularExpressionMatch& match : place.globalMatch(text))
        places << match.captured();
    places.removeDuplicates(); // a text has each place once in every plural form
    places.sort();
    return places;
}

// Returns "context: text" of a file, sorted; a text with a comment for the translator is followed by it.
QStringList sourcesIn(const QString& path)
{
    QFile file(path);
    QStringList sources;
    if (!file.open(QIODevice::ReadOnly))
        return sources;
    QXmlStreamReader xml(&file);
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == QLatin1String("name"))
            context = xml.readElementText();
        else if (xml.name() == QLatin1String("source"))
            sources += context + ": " + xml.readElementText();
        else if (xml.name() == QLatin1String("comment"))
            sources.last() += " (" + xml.readElementText() + ")";
    }
    sources.sort();
    return sources;
}

const QStringList folders{QStringLiteral("app/i18n"), QStringLiteral("qml/i18n")};

// Copies the files of every language into the folder and returns their paths there.
QStringList copiesIn(const QString& folder)
{
    QStringList paths;
    for (const QString& part : folders) {
        const QDir texts(campanel::test::sourcePath(qPrintable(part)));
        QDir().mkpath(folder + '/' + part);
        for (const QString& name : texts.entryList({"*.ts"})) {
            paths << folder + '/' + part + '/' + name;
            QFile::copy(texts.filePath(name), paths.last());
        }
    }
    return paths;
}

bool replaceIn(const QString& path, const QByteArray& text, const QByteArray& other)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return false;
    const QByteArray before = file.readAll();
    file.close();
    return before.count(text) == 1 && file.open(QIODevice::WriteOnly) &&
           file.write(QByteArray(before).replace(text, other)) > 0;
}

bool updateTranslations(const QString& folder)
{
    const QString script = campanel::test::sourcePath("app/i18n/update_translations");
    return QProcess::execute(script, {QStringLiteral(CAMPANEL_LUPDATE), folder}) == 0;
}

} // namespace

class TestTranslation : public QObject {
    Q_OBJECT

private slots:
    void everyTextIsTranslatedWithItsPlaces_data()
    {
        QTest::addColumn<QString>("path");
        for (const QString& folder : folders) {
            const QDir texts(campanel::test::sourcePath(qPrintable(folder)));
            for (const QString& name : texts.entryList({"*.ts"}))
                QTest::newRow(qPrintable(name)) << texts.filePath(name);
        }
    }

    void everyTextIsTranslatedWithItsPlaces()
    {
        QFETCH(QString, path);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QXmlStreamReader xml(&file);
        QString source;
        int texts = 0;
        while (!xml.atEnd()) {
            if (xml.readNext() != QXmlStreamReader::StartElement)
                continue;
            if (xml.name() == QLatin1String("source")) {
                source = xml.readElementText();
            } else if (xml.name() == QLatin1String("translation")) {
                QVERIFY2(!xml.attributes().hasAttribute(QLatin1String("type")), qPrintable(source));
                const QString translation =
                    xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed(); // plural forms
                QVERIFY2(!translation.isEmpty(), qPrintable(source));
                QVERIFY2(placesIn(source) == placesIn(translation), qPrintable(source));
                ++texts;
            }
        }
        QVERIFY(!xml.hasError());
        QVERIFY(texts > 200);
    }

    void everyLanguageHasTheSameTexts()
    {
        for (const QString& folder : folders) {
            const QDir texts(campanel::test::sourcePath(qPrintable(folder)));
            const QStringList names = texts.entryList({"*.ts"});
            QVERIFY(names.size() >= 2);
            const QStringList first = sourcesIn(texts.filePath(names.first()));
            for (const QString& name : names)
                QCOMPARE(sourcesIn(texts.filePath(name)), first);
        }
    }

    // Fails on a text of the sources that the files do not have, and on a text that no source has any more.
    void theFilesHaveTheTextsOfTheSources()
    {
        const QTemporaryDir folder;
        const QStringList paths = copiesIn(folder.path());
        QVERIFY(paths.size() >= 4);
        QList<QStringList> before;
        for (const QString& path : paths)
            before << sourcesIn(path);
        QVERIFY(updateTranslations(folder.path()));
        for (qsizetype i = 0; i < paths.size(); ++i)
            QCOMPARE(sourcesIn(paths[i]), before[i]);
    }

    void aMissingAndASuperfluousTextAreFound()
    {
        const QTemporaryDir folder;
        const QString path = copiesIn(folder.path()).first();
        const QStringList whole = sourcesIn(path);
        QVERIFY(replaceIn(path, "<source>Cubic</source>", "<source>Planted</source>"));
        QVERIFY(sourcesIn(path) != whole);
        QVERIFY(updateTranslations(folder.path()));
        QCOMPARE(sourcesIn(path), whole);
    }

    void everyLawIsTranslated()
    {
        QTranslator translator;
        QVERIFY(translator.load(campanel::test::languageFile("zh_CN")));
        for (const profile::Law& law : profile::laws()) {
            for (const std::string_view text : {law.name, law.strength, law.weakness})
                QVERIFY2(!translator.translate("Recipe", text.data()).isEmpty(), text.data());
        }
    }

    void switchesWhileItRuns()
    {
        PanelRig rig;
        rig.connectRunning();
        QCOMPARE(rig.machine.stateText(), "Running");
        QCOMPARE(rig.editor.bagLength()->label(), "Bag length");
        rig.machine.start();
        QVERIFY(!rig.machine.commandMessage().isEmpty()); // refused: it runs
        QSignalSpy states(&rig.machine, &panel::Controller::stateChanged);
        QSignalSpy languages(panel::LanguageNotifier::ofApplication(),
                             &panel::LanguageNotifier::languageChanged);
        QTranslator translator;
        QVERIFY(translator.load(campanel::test::languageFile("zh_CN")));
        QVERIFY(QCoreApplication::installTranslator(&translator));
        QCOMPARE(rig.machine.stateText(), "运行");
        QCOMPARE(states.size(), 1);
        QCOMPARE(rig.machine.commandMessage(), QString()); // not in the previous language
        QCOMPARE(languages.size(), 1);
        QCOMPARE(rig.editor.bagLength()->label(), "袋长");
        QCOMPARE(rig.editor.rate()->unit(), "袋/分");
        QVERIFY(rig.editor.verdict().startsWith("在所有限值之内"));
        QCOMPARE(rig.editor.lawName(), "三次");
        QCoreApplication::removeTranslator(&translator);
        QCOMPARE(rig.editor.bagLength()->label(), "Bag length");
    }
};

CAMPANEL_TEST(TestTranslation)

} // namespace test_translation

#include "test_translation.moc"
