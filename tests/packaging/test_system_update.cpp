// SPDX-License-Identifier: Apache-2.0
// campanel-update in the image, where a version is a whole system: the computer is stood for by a boot loader
// that starts what partition 1 says, or once what it was asked for. At each moment the system that every boot
// starts is whole; in the end the right one runs, with its data.
#include "script_root.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QRegularExpression>

namespace test_system_update {

using namespace Qt::StringLiterals;
using campanel::test::ScriptRoot;

namespace {

const QString home = u"var/lib/campanel-update/"_s;
const QString data = u"var/lib/campanel/"_s;
const QString variable =
    u"sys/firmware/efi/efivars/LoaderEntryOneShot-4a67b082-0a4c-41cf-b6c7-440b29bb8c4f"_s;
const QString loader = u"run/campanel-boot/loader/loader.conf"_s;

QByteArray system(const QByteArray& version)
{
    return "system " + version + ' ' + QByteArray(5000, 'x') + " end\n";
}

QByteArray value(const QByteArray& text, const QString& pattern)
{
    return QRegularExpression(pattern, QRegularExpression::MultilineOption)
        .match(QString::fromUtf8(text))
        .captured(1)
        .toUtf8();
}

// A computer with the image, version 2.0 in partition a.
struct Computer : ScriptRoot {
    QByteArray running = "a";

    Computer()
    {
        write(u"version"_s, "2.0\n");
        write(u"opens"_s, {});
        write(u"usr/x"_s, {});
        write(u"dev/tty1"_s, {});
        write(u"can-try"_s, "s \"yes\"\n");
        write(partition("a"), system("2.0"));
        write(partition("b"), QByteArray(20'000, '\0'));
        write(loader, "timeout 0\ndefault campanel-a.conf\neditor no\n");
        write(u"run/campanel-boot/config.txt"_s, "arm_64bit=1\nos_prefix=a/\n");
        write(u"run/campanel-boot/tryboot.txt"_s, "arm_64bit=1\nos_prefix=b/\n");
        write(u"run/campanel-boot/a/linux"_s, "kernel 2.0");
        write(data + u"recipes"_s, "2.0");
        QVERIFY(QDir(path({})).mkpath(u"usr/libexec/campanel-card"_s) &&
                QDir(path({})).mkpath(QFileInfo(variable).path()));
        QVERIFY(
            QFile::link(campanel::test::sourcePath("packaging/card/files/usr/libexec/campanel-card/system"),
                        path(u"usr/libexec/campanel-card/system"_s)));
        start("a");
    }

    static QString partition(const QByteArray& name)
    {
        return u"dev/disk/by-partlabel/campanel-"_s + QString::fromLatin1(name);
    }
    static QByteArray versionOf(const QByteArray& system)
    {
        return value(system, u"^system (\\S+) x+ end$"_s);
    }
    [[nodiscard]] QByteArray versionIn(const QByteArray& name) const
    {
        return versionOf(read(partition(name)).left(system("2.0").size()));
    }
    [[nodiscard]] QByteArray everyBoot() const
    {
        return value(read(loader), u"^default campanel-(.)\\.conf$"_s);
    }
    [[nodiscard]] QByteArray outcome(const QString& key) const
    {
        return value(read(home + u"outcome"_s), u"\"%1\": \"(.*)\""_s.arg(key));
    }

    void start(const QByteArray& name)
    {
        running = name;
        write(u"proc/cmdline"_s, "BOOT root=PARTLABEL=campanel-" + name + " ro\n");
        write(u"usr/lib/os-release"_s, "ID=debian\nIMAGE_VERSION=" + versionIn(name) + "\n");
        QFile::remove(path(u"reboots"_s));
    }
    void runUpdate() const
    {
        QVERIFY(
            run(campanel::test::sourcePath("packaging/kiosk/campanel-update"), u"CAMPANEL_UPDATE_ROOT"_s));
    }
    // Starts the computer again. After a power cut the request of one start may be lost.
    void boot(bool keepsRequest = true)
    {
        const QByteArray once = value(read(variable).replace('\0', ""), u"^\\x07campanel-(.)\\.conf$"_s);
        QFile::remove(path(variable));
        start(keepsRequest && !once.isEmpty() ? once : everyBoot());
    }
    // A new version changes the data at its first start.
    void toTheEnd()
    {
        for (int boots = 0; exists(home + u"unfinished"_s); ++boots) {
            QVERIFY2(boots < 12, read(u"log"_s));
            boot();
            if (versionIn(running) == "3.0")
                write(data + u"recipes"_s, "3.0");
            runUpdate();
        }
        if (exists(u"reboots"_s))
            boot();
    }
    void request(const QByteArray& version = "3.0", int size = 8)
    {
        write(u"run/campanel/update-request"_s, "update\n");
        write(data + u"update/package.deb"_s,
              "Package: campanel-system\nVersion: " + version +
                  "\nArchitecture: amd64\nInstalled-Size: " + QByteArray::number(size) + "\n");
        write(data + u"update/package.deb.sig"_s, "signed");
        write(u"bundle/system.img"_s, system(version));
        write(u"bundle/boot/linux"_s, "kernel " + version);
        write(u"bundle/boot/initrd"_s, "initrd " + version);
    }
    void requestBack() const { write(u"run/campanel/update-request"_s, "back\n"); }
    [[nodiscard]] QByteArray told() const { return outcome(u"result"_s) + ' ' + outcome(u"reason"_s); }
};

} // namespace

class TestSystemUpdate : public QObject {
    Q_OBJECT

private slots:
    void updatesIntoTheOtherPartitionAndGoesBack()
    {
        Computer computer;
        computer.request();
        computer.runUpdate();
        QVERIFY2(computer.exists(u"reboots"_s) && computer.exists(variable), computer.read(u"log"_s));
        QCOMPARE(computer.read(variable).size(), 4 + 2 * 16);
        QCOMPARE(computer.everyBoot(), "a"_ba);
        computer.toTheEnd();
        QVERIFY2(computer.told() == "done ", computer.read(u"log"_s));
        QCOMPARE(computer.running + computer.everyBoot() + computer.versionIn("b"), "bb3.0"_ba);
        QCOMPARE(computer.read(u"run/campanel-boot/b/linux"_s), "kernel 3.0"_ba);
        QVERIFY(computer.read(u"run/campanel-boot/config.txt"_s).endsWith("os_prefix=b/\n"));
        QVERIFY(computer.read(u"run/campanel-boot/tryboot.txt"_s).endsWith("os_prefix=a/\n"));
        QVERIFY(!computer.exists(home + u"system.deb"_s));
        // The schema of the stand-in is the same, so the data stay.
        computer.requestBack();
        computer.runUpdate();
        computer.toTheEnd();
        QVERIFY2(computer.told() == "done ", computer.read(u"log"_s));
        QCOMPARE(computer.running + computer.everyBoot() + computer.read(data + u"recipes"_s), "aa3.0"_ba);
        QVERIFY(!computer.exists(home + u"way-back"_s));
    }

    void aSystemThatDoesNotOpenIsLeft()
    {
        Computer computer;
        computer.request();
        QVERIFY(QFile::remove(computer.path(u"opens"_s)));
        computer.runUpdate();
        computer.toTheEnd();
        QVERIFY2(computer.told() == "returned not-shown", computer.read(u"log"_s));
        QCOMPARE(computer.running + computer.everyBoot() + computer.read(data + u"recipes"_s), "aa2.0"_ba);
        // It was written over what the way back would need.
        computer.requestBack();
        computer.runUpdate();
        QCOMPARE(computer.told(), "refused no-way-back"_ba);
    }

    void aSystemThatDoesNotStartIsLeft()
    {
        Computer computer;
        computer.request();
        computer.runUpdate();
        int trials = 0;
        for (; computer.exists(home + u"unfinished"_s) && trials < 9; ++trials) {
            computer.boot(false); // its kernel has stopped; the computer has started again
            computer.runUpdate();
        }
        QCOMPARE(trials, 3);
        QVERIFY2(computer.told() == "returned not-shown", computer.read(u"log"_s));
        QCOMPARE(computer.running + computer.everyBoot(), "aa"_ba);
    }

    void refusals_data()
    {
        QTest::addColumn<QString>("reason");
        QTest::newRow("another boot loader") << u"no-trial"_s;
        QTest::newRow("no variables") << u"no-trial"_s;
        QTest::newRow("large bundle") << u"too-large"_s;
        QTest::newRow("stranger") << u"signature"_s;
        QTest::newRow("older version") << u"package"_s;
    }
    void refusals()
    {
        QFETCH(QString, reason);
        const QByteArray row = QTest::currentDataTag();
        Computer computer;
        computer.request(row == "older version" ? "1.0" : "3.0", row == "large bundle" ? 100 : 8);
        if (row == "another boot loader")
            computer.write(u"can-try"_s, "s \"na\"\n");
        if (row == "no variables")
            QVERIFY(QDir(computer.path({})).rmdir(QFileInfo(variable).path()));
        if (row == "stranger")
            computer.write(data + u"update/package.deb.sig"_s, "another's");
        computer.runUpdate();
        QCOMPARE(computer.told(), "refused " + reason.toUtf8());
        QVERIFY(!computer.exists(u"reboots"_s) && !computer.exists(home + u"unfinished"_s));
        QCOMPARE(computer.read(Computer::partition("b")), QByteArray(20'000, '\0'));
    }

    void aPartitionThatCannotBeWritten()
    {
        Computer computer;
        computer.request();
        computer.write(u"unwritable"_s, {});
        computer.runUpdate();
        computer.toTheEnd();
        QVERIFY2(computer.told() == "returned not-installed", computer.read(u"log"_s));
        QCOMPARE(computer.running + computer.read(data + u"recipes"_s), "a2.0"_ba);
    }

    // The power goes at each step of each boot. Then the boot loader has the request of one start, or not.
    void aPowerCutAtAnyStepEndsInAWholeSystem()
    {
        int cuts = 0;
        for (int inBoot = 0; inBoot < 2; ++inBoot) {
            for (int killAt = 1;; ++killAt) {
                Computer computer;
                computer.request();
                if (inBoot > 0) {
                    computer.runUpdate();
                    computer.boot();
                    QFile::remove(computer.path(u"steps"_s));
                    computer.write(data + u"recipes"_s, "3.0");
                }
                computer.write(u"kill-at"_s, QByteArray::number(killAt));
                computer.runUpdate();
                const bool isCut = computer.read(u"steps"_s).trimmed().toInt() >= killAt;
                QVERIFY(QFile::remove(computer.path(u"kill-at"_s)));
                const QByteArray tag = "boot " + QByteArray::number(inBoot) + ", step " +
                                       QByteArray::number(killAt) + '\n' + computer.read(u"log"_s);
                const QByteArray version = computer.versionIn(computer.everyBoot());
                QVERIFY2(version == "2.0" || version == "3.0", tag);
                if (!isCut) {
                    QVERIFY(killAt > (inBoot > 0 ? 4 : 15));
                    break;
                }
                ++cuts;
                computer.boot(killAt % 2 != 0);
                if (computer.versionIn(computer.running) == "3.0")
                    computer.write(data + u"recipes"_s, "3.0");
                computer.runUpdate();
                computer.toTheEnd();
                QVERIFY2(computer.versionIn(computer.running) == computer.read(data + u"recipes"_s),
                         tag + computer.read(u"log"_s));
                QCOMPARE(computer.everyBoot(), computer.running);
                QVERIFY2(!computer.exists(home + u"unfinished"_s) && !computer.exists(home + u"installing"_s),
                         tag + computer.read(u"log"_s));
                if (computer.told() != " ") // the power went before the request was read
                    QVERIFY2(computer.told() == "done " || computer.told().startsWith("refused"),
                             computer.told() + '\n' + tag);
            }
        }
        QVERIFY(cuts > 20);
    }
};

CAMPANEL_TEST(TestSystemUpdate)

} // namespace test_system_update

#include "test_system_update.moc"
