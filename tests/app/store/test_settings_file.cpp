// SPDX-License-Identifier: Apache-2.0
// The settings file: settings are read back, also those of earlier versions; a damaged file never counts as
// missing settings.
#include "app/store/files/files.h"
#include "app/store/files/settings_file.h"
#include "app/store/recipes/recipe_file.h"
#include "tests/support/full_disk.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

namespace test_settings_file {

using namespace campanel::store;
using namespace Qt::StringLiterals;
using Origin = SettingsFile::Origin;
using campanel::test::FullDisk;

namespace {

const QStringList known{u"language"_s, u"connection/port"_s, u"connection/simulated"_s};

struct Folder {
    QTemporaryDir dir;
    QString path = dir.filePath(u"settings.ini"_s);

    void put(const QByteArray& bytes) const
    {
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("%s", qPrintable(file.errorString()));
    }

    [[nodiscard]] QByteArray bytes() const { return readBytes(path).value_or(QByteArray()); }
    [[nodiscard]] SettingsFile read() const { return SettingsFile(path, known); }

    // Writes the settings of a real machine.
    void fill() const
    {
        read().set({{u"language"_s, u"en"_s},
                    {u"connection/simulated"_s, u"false"_s},
                    {u"connection/port"_s, u"/dev/ttyS1"_s}});
    }
};

} // namespace

class TestSettingsFile : public QObject {
    Q_OBJECT

private slots:
    void whatWasSetIsReadAgain()
    {
        const Folder folder;
        QVERIFY(folder.read().isEmpty());
        QVERIFY(folder.read().origin() == Origin::None);
        const QString strange = u" /dev/\"a\\b;c,d=e é"_s;
        {
            SettingsFile file = folder.read();
            file.set(u"connection/port"_s, strange);
            file.set(u"language"_s, u"zh_CN"_s);
            QVERIFY(file.isKept());
        }
        const SettingsFile again = folder.read();
        QVERIFY(again.origin() == Origin::File);
        QCOMPARE(again.value(u"connection/port"_s), strange);
        QCOMPARE(again.value(u"language"_s), u"zh_CN"_s);
        QCOMPARE(again.value(u"theme"_s, u"light"_s), u"light"_s);
        QCOMPARE(again.contents(), folder.bytes());
    }

    void aFileOfAnEarlierVersionIsTaken()
    {
        const Folder folder;
        folder.put("[General]\nlanguage=en\n\n[connection]\nport=\"/dev/a,b\"\nsimulated=false\n");
        QVERIFY(folder.read().origin() == Origin::File);
        QCOMPARE(folder.read().value(u"connection/port"_s), u"/dev/a,b"_s);
        QVERIFY(folder.bytes().startsWith("; sha256="));
    }

    void damageIsMendedFromTheCopy_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        Folder folder;
        folder.fill();
        const QByteArray whole = folder.bytes();
        QTest::newRow("empty") << QByteArray("");
        QTest::newRow("zeros") << QByteArray(whole.size(), '\0');
        QTest::newRow("another file") << QByteArray("angle,position\n0,0\n");
        for (qsizetype length = 1; length < whole.size(); length += 13)
            QTest::addRow("first %d bytes", static_cast<int>(length)) << whole.left(length);
        for (qsizetype at = 0; at < whole.size(); at += 7) {
            QByteArray flipped = whole;
            flipped[at] = static_cast<char>(flipped[at] ^ 4);
            QTest::addRow("byte %d", static_cast<int>(at)) << flipped;
        }
    }

    void damageIsMendedFromTheCopy()
    {
        QFETCH(QByteArray, bytes);
        const Folder folder;
        folder.fill();
        const QByteArray whole = folder.bytes();
        folder.put(bytes);
        const SettingsFile mended = folder.read();
        QVERIFY(mended.origin() == Origin::Copy);
        QCOMPARE(mended.value(u"connection/port"_s), u"/dev/ttyS1"_s);
        QCOMPARE(folder.bytes(), whole);
        QVERIFY(QFile::exists(folder.path + u".damaged"_s));
        QVERIFY(folder.read().origin() == Origin::File);
    }

    void aFileThatIsGoneIsMendedFromTheCopy()
    {
        const Folder folder;
        folder.fill();
        QVERIFY(QFile::remove(folder.path));
        QVERIFY(folder.read().origin() == Origin::Copy);
        QVERIFY(QFile::exists(folder.path));
    }

    void withoutAGoodCopyNothingIsKnown()
    {
        const Folder folder;
        folder.fill();
        folder.put("");
        QVERIFY(QFile::remove(backupPath(folder.path)));
        QVERIFY(folder.read().origin() == Origin::Defaults);
        // A misspelled section of a file without a checksum.
        folder.put("[connektion]\nsimulated=false\n");
        QVERIFY(folder.read().origin() == Origin::Defaults);
    }

    void aPipeIsNotWaitedFor()
    {
        const Folder folder;
        QCOMPARE(mkfifo(QFile::encodeName(folder.path).constData(), 0600), 0);
        QVERIFY(folder.read().origin() == Origin::Defaults);
    }

    void aFullDiskKeepsWhatWasThere()
    {
        const Folder folder;
        folder.fill();
        const QByteArray whole = folder.bytes();
        {
            SettingsFile file = folder.read();
            const FullDisk full;
            file.set(u"language"_s, u"zh_CN"_s);
            QVERIFY(!file.isKept());
        }
        QCOMPARE(folder.bytes(), whole);
        QVERIFY(folder.read().origin() == Origin::File);
    }
};

CAMPANEL_TEST(TestSettingsFile)

} // namespace test_settings_file

#include "test_settings_file.moc"
