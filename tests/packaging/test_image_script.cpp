// SPDX-License-Identifier: Apache-2.0
// This tests what packaging/image refuses before it makes anything, and the lists that it reads. tests/image
// boots what it makes.
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>

namespace test_image_script {

using namespace Qt::StringLiterals;
using campanel::test::sourcePath;

class TestImageScript : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    QString path(const QString& name) const { return m_folder.filePath(name); }
    void standIn(const QString& name, const QByteArray& script)
    {
        QFile file(path(u"bin/"_s + name));
        QVERIFY(QDir(m_folder.path()).mkpath(u"bin"_s));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("#!/bin/sh\n" + script) > 0);
        QVERIFY(file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
    }
    // Returns the lines of a file without comments and empty ones.
    static QStringList entriesOf(const char* file)
    {
        QFile list(sourcePath(file));
        if (!list.open(QIODevice::ReadOnly))
            return {};
        QStringList lines = QString::fromUtf8(list.readAll()).split(u'\n', Qt::SkipEmptyParts);
        lines.removeIf([](const QString& line) { return line.startsWith(u'#'); });
        return lines;
    }

private slots:
    void refusals_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("sentence");
        const QString output = path(u"out"_s);
        QTest::newRow("unknown computer")
            << QStringList{u"--for"_s, u"nonsense"_s, output}
            << QByteArray("there is no image for nonsense, only for amd64 and arm64");
        QTest::newRow("no computer") << QStringList{output}
                                     << QByteArray("for which computer? --for amd64 or --for arm64");
        QTest::newRow("no output") << QStringList{u"--for"_s, u"amd64"_s}
                                   << QByteArray(
                                          "where does the image go? Name a folder behind the options.");
        QTest::newRow("two outputs") << QStringList{u"--for"_s, u"amd64"_s, u"a"_s, u"b"_s}
                                     << QByteArray("one OUTPUT is enough: a or b");
        QTest::newRow("no such package")
            << QStringList{u"--for"_s, u"amd64"_s, u"--package"_s, u"/nonexistent.deb"_s, output}
            << QByteArray("there is no file /nonexistent.deb");
        QTest::newRow("not root") << QStringList{u"--for"_s, u"amd64"_s, output}
                                  << QByteArray("an image is made by root; run it with sudo");
        QTest::newRow("output is a file")
            << QStringList{u"--for"_s, u"amd64"_s, path(u"bin/id"_s)}
            << path(u"bin/id"_s).toUtf8() + " is not a folder that can be written";
        QTest::newRow("disk too small")
            << QStringList{u"--for"_s, u"amd64"_s, output}
            << m_folder.path().toUtf8() + " has 97 MB free and needs 3000 MB; TMPDIR names another folder";
    }

    void refusals()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, sentence);
        standIn(u"id"_s, "echo "_ba + (sentence.contains("by root") ? "1000" : "0") + '\n');
        standIn(u"df"_s, "echo Avail\necho 100000\n");
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(u"PATH"_s, path(u"bin"_s) + u':' + environment.value(u"PATH"_s));
        environment.insert(u"TMPDIR"_s, m_folder.path());
        process.setProcessEnvironment(environment);
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(sourcePath("packaging/image"), arguments);
        QVERIFY(process.waitForFinished());
        QCOMPARE(process.readAll(), "campanel: " + sentence + '\n');
        QCOMPARE(process.exitCode(), 1);
    }

    void noPackageForAnUnknownComputer()
    {
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(sourcePath("packaging/deb"), {u"--for"_s, u"nonsense"_s});
        QVERIFY(process.waitForFinished());
        QVERIFY(process.readAll().startsWith("campanel: there is no package for nonsense, only for "));
        QCOMPARE(process.exitCode(), 1);
    }

    void leftOutIsInTheFormOfDpkg_data()
    {
        QTest::addColumn<QString>("architecture");
        QTest::newRow("amd64") << u"amd64"_s;
        QTest::newRow("arm64") << u"arm64"_s;
    }
    // dpkg ignores a line that it does not know, and the image would have what it is to leave out.
    void leftOutIsInTheFormOfDpkg()
    {
        QFETCH(QString, architecture);
        static const QRegularExpression form(u"^path-(in|ex)clude=[/*][^ ]*$"_s);
        QSet<QString> seen;
        const QStringList more =
            entriesOf(("packaging/card/left-out-" + architecture).toLatin1().constData());
        const QStringList entries = entriesOf("packaging/card/left-out") + more;
        QVERIFY(entries.size() > 50 && !more.isEmpty());
        for (const QString& line : entries) {
            QVERIFY2(form.match(line).hasMatch(), qPrintable(line));
            QVERIFY2(!seen.contains(line), qPrintable(line));
            seen.insert(line);
        }
    }

    // The boot needs these modules: none of them is left out.
    void modulesOfTheBootAreKept()
    {
        const QStringList left =
            entriesOf("packaging/card/left-out") + entriesOf("packaging/card/left-out-amd64");
        const QStringList modules = entriesOf("packaging/card/files/etc/initramfs-tools/modules");
        QVERIFY(modules.contains(u"nvme"_s) && modules.contains(u"mmc_block"_s));
        // The voltage of a Raspberry Pi's card.
        QVERIFY(modules.contains(u"fixed"_s) && modules.contains(u"gpio_regulator"_s));
        static const QRegularExpression notAName(u"[^a-z0-9_]"_s);
        for (const QString& module : modules) {
            QVERIFY2(!notAName.match(module).hasMatch(), qPrintable(module));
            QVERIFY2(!left.join(u'\n').contains(u'/' + module + u".ko"_s), qPrintable(module));
        }
    }

    // They run at night only.
    void programsOfTheBootTestAreProper()
    {
        const QDir folder(sourcePath("tests/image"));
        const QStringList programs = folder.entryList({u"*.py"_s});
        QVERIFY(programs.size() >= 3);
        for (const QString& program : programs)
            QCOMPARE(QProcess::execute(u"python3"_s,
                                       {u"-c"_s, u"import ast, sys; ast.parse(open(sys.argv[1]).read())"_s,
                                        folder.filePath(program)}),
                     0);
    }

    void scriptsOfTheBootAreProper_data()
    {
        QTest::addColumn<QString>("script");
        for (const char* script : {"packaging/image", "packaging/card/set-up",
                                   "packaging/card/files/etc/initramfs-tools/hooks/campanel",
                                   "packaging/card/files/etc/initramfs-tools/scripts/local-bottom/campanel"})
            QTest::newRow(script) << QString::fromLatin1(script);
    }
    // mkinitramfs leaves out a script that is not executable, without a word.
    void scriptsOfTheBootAreProper()
    {
        QFETCH(QString, script);
        const QString file = sourcePath(script.toLatin1().constData());
        QVERIFY(QFileInfo(file).isExecutable());
        QCOMPARE(QProcess::execute(u"sh"_s, {u"-n"_s, file}), 0);
    }
};

CAMPANEL_TEST(TestImageScript)

} // namespace test_image_script

#include "test_image_script.moc"
