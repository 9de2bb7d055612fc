// SPDX-License-Identifier: Apache-2.0
// campanelctl package: signs and checks as a person calls it.
#include "campanelctl_call.h"
#include "tests/support/fake_package.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

namespace test_package {

using namespace campanel::test;
using namespace Qt::StringLiterals;

class PackageTest : public QObject {
    Q_OBJECT

private slots:
    void signsAndVerifies()
    {
        const QTemporaryDir folder;
        const auto path = [&folder](const QString& name) { return folder.filePath(name); };
        QVERIFY(QDir(folder.path()).mkdir(u"keys"_s));
        const QString package = makePackage(folder.path(), u"1.2.3+deb12"_s);
        QVERIFY(!package.isEmpty());
        QCOMPARE(call({u"recipe"_s, u"new-key"_s, u"--name"_s, u"Anna Plant"_s, u"--key"_s, path(u"anna"_s),
                       u"-o"_s, path(u"keys/anna.json"_s)})
                     .code,
                 Ok);
        const QStringList verify{u"package"_s, u"verify"_s, package, u"--keys"_s, path(u"keys"_s)};
        Result result = call(verify);
        QCOMPARE(result.code, Refused);
        QVERIFY2(result.complaint.contains("has no signature"), result.complaint);
        QCOMPARE(call({u"package"_s, u"sign"_s, package, u"--key"_s, path(u"anna"_s), u"-o"_s,
                       package + u".sig"_s})
                     .code,
                 Ok);
        result = call(verify);
        QCOMPARE(result.code, Ok);
        QCOMPARE(result.json()[u"signed_by"_s].toString(), u"Anna Plant"_s);
        QCOMPARE(result.json()[u"version"_s].toString(), u"1.2.3+deb12"_s);
        QFile file(package);
        QVERIFY(file.open(QIODevice::Append) && file.write("x") == 1);
        file.close();
        result = call(verify);
        QCOMPARE(result.code, Refused);
        QVERIFY2(result.complaint.contains("damaged or was changed"), result.complaint);
        QVERIFY(result.out.isEmpty());
    }

    void schemaIsOneWord()
    {
        const Result result = call(u"package schema"_s);
        QCOMPARE(result.code, Ok);
        QVERIFY2(QRegularExpression(u"^\\d+\\.\\d+\n$"_s).match(QString::fromLatin1(result.out)).hasMatch(),
                 result.out);
    }

    void refusals()
    {
        const QTemporaryDir folder;
        const QString plain = folder.filePath(u"plain.deb"_s);
        QVERIFY(writeFile(plain, "no package"));
        QCOMPARE(call({u"package"_s}).code, Usage);
        QCOMPARE(call({u"package"_s, u"sign"_s, plain}).code, Usage);
        QCOMPARE(call({u"package"_s, u"sign"_s, plain, u"--key"_s, plain}).code, File);
        QCOMPARE(call({u"package"_s, u"verify"_s, plain}).code, Usage);
        QCOMPARE(call({u"package"_s, u"verify"_s, plain, u"--keys"_s, plain}).code, File);
        QCOMPARE(
            call({u"recipe"_s, u"new-key"_s, u"--name"_s, u"Anna"_s, u"--key"_s, folder.filePath(u"a"_s)})
                .code,
            Ok);
        QCOMPARE(call({u"package"_s, u"sign"_s, plain, u"--key"_s, folder.filePath(u"a"_s)}).code, File);
    }
};

CAMPANEL_TEST(PackageTest)

} // namespace test_package

#include "test_package.moc"
