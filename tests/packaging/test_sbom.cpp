// SPDX-License-Identifier: Apache-2.0
// packaging/sbom on a tiny program: every library that it loads is listed, and nothing that is compiled in
// goes unnamed.
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>

namespace test_sbom {

using namespace Qt::StringLiterals;
using campanel::test::sourcePath;

class TestSbom : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    QString m_errors;

    QString path(const QString& name) { return m_folder.filePath(name); }
    // Builds the program anew, linked with one more library.
    void build(const QStringList& options)
    {
        const QByteArray text = "int main(void) { return 0; }\n";
        QFile source(path(u"program.c"_s));
        QVERIFY(source.open(QIODevice::WriteOnly) && source.write(text) == text.size());
        source.close();
        QVERIFY(QDir(m_folder.path()).mkpath(u"tree/usr/bin"_s));
        const QStringList fixed{u"-o"_s, path(u"tree/usr/bin/program"_s), source.fileName(),
                                u"-Wl,--no-as-needed"_s};
        QCOMPARE(QProcess::execute(u"cc"_s, fixed + options), 0);
    }
    // Returns what the script prints; empty when it fails.
    QByteArray print(const QString& dependencies, const QString& tree = u"tree"_s)
    {
        return run({u"--dependencies"_s, dependencies, u"campanel"_s, u"1.2.3+deb12"_s, path(tree)});
    }
    QByteArray run(const QStringList& arguments)
    {
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(u"SOURCE_DATE_EPOCH"_s, u"1795000000"_s);
        process.setProcessEnvironment(environment);
        process.start(sourcePath("packaging/sbom"), arguments);
        const bool isDone = process.waitForFinished(120'000) && process.exitCode() == 0;
        m_errors = QString::fromUtf8(process.readAllStandardError());
        return isDone ? process.readAllStandardOutput() : QByteArray();
    }
    // Prints the bill with a list that has what the tiny program is built with.
    QByteArray printTiny(const QByteArray& more = {})
    {
        QFile list(sourcePath("packaging/dependencies"));
        QFile shorter(path(u"dependencies"_s));
        if (!list.open(QIODevice::ReadOnly) || !shorter.open(QIODevice::WriteOnly))
            return {};
        static const QSet<QByteArray> built{"g++", "libexpected-dev", "libtomlplusplus-dev", "qt6-tools-dev"};
        for (const QByteArray& line : list.readAll().split('\n')) {
            if (!line.startsWith("build ") || built.contains(line.simplified().split(' ')[1]))
                shorter.write(line + '\n');
        }
        shorter.write(more);
        shorter.close();
        return print(shorter.fileName());
    }
    // Returns "name relationship" of each component.
    static QSet<QString> components(const QByteArray& json)
    {
        const QJsonObject root = QJsonDocument::fromJson(json).object();
        QHash<QString, QString> names;
        for (const QJsonValue& package : root[u"packages"_s].toArray())
            names.insert(package[u"SPDXID"_s].toString(), package[u"name"_s].toString());
        QSet<QString> all;
        for (const QJsonValue& relation : root[u"relationships"_s].toArray()) {
            const QString type = relation[u"relationshipType"_s].toString();
            const bool isOf = type.endsWith(u"_OF"_s);
            const QString id = relation[isOf ? u"spdxElementId"_s : u"relatedSpdxElement"_s].toString();
            all << names.value(id, u"missing"_s) + u' ' + type;
        }
        return all;
    }

private slots:
    void aFurtherLibraryIsListed()
    {
        build({});
        const QByteArray before = printTiny();
        QVERIFY2(!before.isEmpty(), qPrintable(m_errors));
        build({u"-lsodium"_s});
        const QByteArray after = printTiny();
        QVERIFY2(!after.isEmpty(), qPrintable(m_errors));
        QVERIFY(components(before).contains(u"libc6 DYNAMIC_LINK"_s));
        const QSet<QString> added = components(after) - components(before);
        QVERIFY2(added.size() == 1 &&
                     added.begin()->contains(QRegularExpression(u"^libsodium\\d+ DYNAMIC_LINK$"_s)),
                 after);
    }

    void whatIsCompiledInOrLoadedLaterIsListed()
    {
        build({});
        const QSet<QString> all = components(printTiny());
        for (const QString& component :
             {u"libexpected-dev STATIC_LINK"_s, u"libtomlplusplus-dev STATIC_LINK"_s,
              u"fonts-open-sans RUNTIME_DEPENDENCY_OF"_s, u"qml6-module-qtquick RUNTIME_DEPENDENCY_OF"_s,
              u"libqt6sql6-sqlite RUNTIME_DEPENDENCY_OF"_s, u"campanel DESCRIBES"_s})
            QVERIFY2(all.contains(component), qPrintable(component));
        QVERIFY(!all.contains(u"missing DESCRIBES"_s));
        QVERIFY(!all.contains(u"qt6-tools-dev STATIC_LINK"_s));
    }

    void eachComponentHasWhatTheLawAsks()
    {
        build({u"-lsodium"_s});
        const QJsonObject root = QJsonDocument::fromJson(printTiny()).object();
        QCOMPARE(root[u"spdxVersion"_s].toString(), u"SPDX-2.3"_s);
        QCOMPARE(root[u"creationInfo"_s][u"created"_s].toString(), u"2026-11-18T11:06:40Z"_s);
        const QJsonArray packages = root[u"packages"_s].toArray();
        QVERIFY(packages.size() > 10);
        for (const QJsonValue& package : packages) {
            for (const QString& key : {u"name"_s, u"versionInfo"_s, u"supplier"_s, u"licenseDeclared"_s})
                QVERIFY2(!package[key].toString().isEmpty(), qPrintable(key));
            QVERIFY(package[u"externalRefs"_s][0][u"referenceLocator"_s].toString().startsWith(u"pkg:"_s));
        }
    }

    void aSystemIsListedByItsPackages()
    {
        const auto write = [this](const QString& name, const QByteArray& text) {
            QVERIFY(QDir().mkpath(QFileInfo(path(name)).path()));
            QFile file(path(name));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
        };
        const auto package = [](const QByteArray& name, const QByteArray& state) {
            return "Package: " + name + "\nStatus: " + state +
                   "\nMaintainer: a\nArchitecture: amd64\nVersion: 1.2\nDescription: b\n\n";
        };
        write(u"root/etc/os-release"_s, "ID=debian\nVERSION_ID=12\n");
        write(u"root/var/lib/dpkg/status"_s, package("campanel", "install ok installed") +
                                                 package("libkept", "install ok installed") +
                                                 package("removed", "deinstall ok config-files"));
        write(u"root/usr/share/doc/libkept/copyright"_s, "Files: *\nLicense: Expat\n");
        write(u"root/usr/share/campanel-image/unpacked"_s, "installed raspi-firmware 1.20220830+ds-1 all\n");
        const QByteArray json = run({u"--root"_s, path(u"root"_s), u"system"_s, u"1.2.3"_s});
        QVERIFY2(!json.isEmpty(), qPrintable(m_errors));
        QCOMPARE(components(json), (QSet<QString>{u"campanel CONTAINS"_s, u"libkept CONTAINS"_s,
                                                  u"raspi-firmware CONTAINS"_s, u"system DESCRIBES"_s}));
        for (const QJsonValue& each : QJsonDocument::fromJson(json).object()[u"packages"_s].toArray()) {
            const QString name = each[u"name"_s].toString();
            QCOMPARE(each[u"supplier"_s].toString() == u"Organization: Debian",
                     name == u"libkept" || name == u"raspi-firmware");
            if (name == u"libkept")
                QCOMPARE(each[u"licenseDeclared"_s].toString(), u"MIT"_s);
        }
        QVERIFY(run({u"--root"_s, path(u"nowhere"_s), u"system"_s, u"1.2.3"_s}).isEmpty());
        QVERIFY2(m_errors.contains(u"is not the root of a Debian system"_s), qPrintable(m_errors));
    }

    void theSameInputGivesTheSameBytes()
    {
        build({u"-lsodium"_s});
        const QByteArray first = printTiny();
        QVERIFY(!first.isEmpty());
        QCOMPARE(printTiny(), first);
    }

    // With the whole list: whatever is built with is a tool, a library that a program loads, or named as
    // compiled in.
    void theProgramsOfThisBuildAreExplained()
    {
        QVERIFY(QDir(m_folder.path()).mkpath(u"whole/tree"_s));
        for (const char* program : {"campanel", "campanelctl", "campanel-gateway", "campanel-controller"})
            QVERIFY(QFile::copy(campanel::test::programPath(program),
                                path(u"whole/tree/"_s + QLatin1String(program))));
        const QSet<QString> all = components(print(sourcePath("packaging/dependencies"), u"whole/tree"_s));
        QVERIFY2(!all.isEmpty(), qPrintable(m_errors));
        QVERIFY(all.contains(u"libexpected-dev STATIC_LINK"_s));
        const QStringList qwt =
            QStringList(all.values())
                .filter(QRegularExpression(u"^(qwt STATIC_LINK|libqwt.* DYNAMIC_LINK)$"_s));
        QCOMPARE(qwt.size(), 1);
    }

    // libc6-dev has headers, and the table of the script does not name it.
    void headersThatNobodyNamesFail()
    {
        build({});
        QCOMPARE(printTiny("build libc6-dev planted\n"), QByteArray());
        QVERIFY2(m_errors.contains(u"does not know if libc6-dev becomes part of the programs"_s),
                 qPrintable(m_errors));
    }

    void aLibraryOfNoPackageFails()
    {
        QFile source(path(u"own.c"_s));
        QVERIFY(source.open(QIODevice::WriteOnly) && source.write("int own(void) { return 1; }\n") > 0);
        source.close();
        QCOMPARE(QProcess::execute(
                     u"cc"_s, {u"-shared"_s, u"-fPIC"_s, u"-o"_s, path(u"libown.so"_s), source.fileName()}),
                 0);
        build({u"-L"_s + m_folder.path(), u"-lown"_s, u"-Wl,-rpath,"_s + m_folder.path()});
        QCOMPARE(printTiny(), QByteArray());
        QVERIFY2(m_errors.contains(u"no Debian package owns"_s) && m_errors.contains(u"libown.so"_s),
                 qPrintable(m_errors));
    }
};

CAMPANEL_TEST(TestSbom)

} // namespace test_sbom

#include "test_sbom.moc"
