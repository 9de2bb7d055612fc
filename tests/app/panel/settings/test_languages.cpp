// SPDX-License-Identifier: Apache-2.0
// The languages in folders: found, named by themselves, replaced by files of the panel's data, or skipped.
#include "app/panel/settings/languages.h"
#include "app/panel/settings/settings.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <QTranslator>

namespace test_languages {

using namespace campanel;

void copyLanguage(const char* code, const QTemporaryDir& folder, const char* name)
{
    QVERIFY(QFile::copy(test::languageFile(code), folder.filePath(name)));
}

QString nameOf(const QList<panel::Language>& languages, const QString& code)
{
    for (const panel::Language& language : languages) {
        if (language.code == code)
            return language.name;
    }
    return {};
}

class TestLanguages : public QObject {
    Q_OBJECT

private slots:
    void everyInstalledLanguageNamesItself()
    {
        const auto languages = panel::languagesIn(panel::languageFolders());
        QCOMPARE(panel::languageCodes(languages), QStringList({"en", "de", "zh_CN"}));
        QCOMPARE(nameOf(languages, "en"), "English");
        QCOMPARE(nameOf(languages, "de"), "Deutsch");
        QCOMPARE(nameOf(languages, "zh_CN"), "简体中文");
    }

    void aFileInAFolderIsALanguage()
    {
        const QTemporaryDir folder;
        copyLanguage("de", folder, "campanel_nl.qm");
        const auto languages = panel::languagesIn({folder.path()});
        QCOMPARE(panel::languageCodes(languages), QStringList({"en", "nl"}));
        QTranslator texts;
        QVERIFY(panel::loadLanguage(texts, languages, "nl"));
        QCOMPARE(texts.translate("CommandColumn", "Stop"), "Stopp");
        QVERIFY(!panel::loadLanguage(texts, languages, "en"));
        QVERIFY(!panel::loadLanguage(texts, languages, "fr"));
    }

    void theFirstFolderGoesFirst()
    {
        const QTemporaryDir own;
        const QTemporaryDir installed;
        copyLanguage("de", own, "campanel_zh_CN.qm"); // a corrected file, told apart by its name
        copyLanguage("zh_CN", installed, "campanel_zh_CN.qm");
        QCOMPARE(nameOf(panel::languagesIn({own.path(), installed.path()}), "zh_CN"), "Deutsch");
        QCOMPARE(nameOf(panel::languagesIn({installed.path(), own.path()}), "zh_CN"), "简体中文");
    }

    void unusableFilesAreSkipped()
    {
        const QTemporaryDir own;
        const QTemporaryDir installed;
        copyLanguage("de", installed, "campanel_de.qm");
        QFile damaged(own.filePath("campanel_de.qm"));
        QVERIFY(damaged.open(QIODevice::WriteOnly));
        damaged.write("no texts");
        damaged.close();
        copyLanguage("de", own, "campanel_nonsense.qm");
        copyLanguage("de", own, "campanel_.qm");
        copyLanguage("de", own, "other_fr.qm");
        for (const char* name : {"campanel_de", "campanel_nonsense", "campanel_"})
            QTest::ignoreMessage(QtWarningMsg,
                                 QRegularExpression(QString::fromLatin1(name) + "\\.qm is not"));
        const auto languages = panel::languagesIn({own.path(), installed.path()});
        QCOMPARE(panel::languageCodes(languages), QStringList({"en", "de"}));
        QCOMPARE(nameOf(languages, "de"), "Deutsch");
    }

    void theNearestLanguageIsUsed_data()
    {
        QTest::addColumn<QString>("wanted");
        QTest::addColumn<QString>("used");
        QTest::newRow("itself") << "zh_CN"
                                << "zh_CN";
        QTest::newRow("other country") << "de_AT"
                                       << "de";
        QTest::newRow("other script") << "zh_TW"
                                      << "zh_CN";
        QTest::newRow("English of another country") << "en_IN"
                                                    << "en";
        QTest::newRow("none") << "fr_FR"
                              << "en";
        QTest::newRow("C") << "C"
                           << "en";
        QTest::newRow("nonsense") << "tlh"
                                  << "en";
    }

    void theNearestLanguageIsUsed()
    {
        QFETCH(QString, wanted);
        QFETCH(QString, used);
        QCOMPARE(panel::nearestLanguage(panel::languagesIn(panel::languageFolders()), wanted), used);
    }

    void aStoredLanguageWithoutFileIsKept()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("settings.ini");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("language=it\n");
        file.close();
        panel::Settings settings(path, nullptr);
        QCOMPARE(settings.language(), "en");
        settings.set("display.gloves", panel::settingText(true)); // writes the file
        QCOMPARE(settings.file().value("language"), "it");        // used again when its file is back
        QLocale::setDefault(QLocale("en"));
    }
};

CAMPANEL_TEST(TestLanguages)

} // namespace test_languages

#include "test_languages.moc"
