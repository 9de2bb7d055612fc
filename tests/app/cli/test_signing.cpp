// SPDX-License-Identifier: Apache-2.0
// campanelctl recipe new-key, sign and verify, as a person calls them.
#include "campanelctl_call.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

namespace test_signing {

using namespace campanel::test;
using namespace Qt::StringLiterals;

class SigningTest : public QObject {
    Q_OBJECT

private slots:
    void signsAndVerifies()
    {
        const QTemporaryDir folder;
        const auto path = [&folder](const QString& name) { return folder.filePath(name); };
        QVERIFY(QDir(folder.path()).mkdir(u"keys"_s));
        QCOMPARE(call({u"recipe"_s, u"new-key"_s, u"--name"_s, u"Anna Plant"_s, u"--key"_s, path(u"anna"_s),
                       u"-o"_s, path(u"keys/anna.json"_s)})
                     .code,
                 Ok);
        QCOMPARE(QFileInfo(path(u"anna"_s)).permissions() &
                     (QFile::ReadGroup | QFile::ReadOther | QFile::WriteGroup | QFile::WriteOther),
                 QFile::Permissions());
        QCOMPARE(call({u"recipe"_s, u"--name"_s, u"Biscuit 250"_s, u"-o"_s, path(u"plain.json"_s)}).code, Ok);
        QCOMPARE(call({u"recipe"_s, u"sign"_s, path(u"plain.json"_s), u"--key"_s, path(u"anna"_s), u"-o"_s,
                       path(u"signed.json"_s)})
                     .code,
                 Ok);
        const Result verified =
            call({u"recipe"_s, u"verify"_s, path(u"signed.json"_s), u"--keys"_s, path(u"keys"_s)});
        QCOMPARE(verified.code, Ok);
        QCOMPARE(verified.json()[u"signed_by"_s].toString(), u"Anna Plant"_s);
        QCOMPARE(verified.json()[u"name"_s].toString(), u"Biscuit 250"_s);
        QVERIFY(verified.json()[u"table_is_the_signed_one"_s].toBool());

        QFile file(path(u"signed.json"_s));
        QVERIFY(file.open(QIODevice::ReadWrite));
        QByteArray bytes = file.readAll();
        QVERIFY(bytes.contains("\"bag_length_mm\\\": 250") || bytes.contains("\\\"bag_length_mm\\\": 250"));
        bytes.replace("\\\"bag_length_mm\\\": 250", "\\\"bag_length_mm\\\": 251");
        QVERIFY(file.seek(0) && file.write(bytes) == bytes.size());
        file.close();
        const Result altered =
            call({u"recipe"_s, u"verify"_s, path(u"signed.json"_s), u"--keys"_s, path(u"keys"_s)});
        QCOMPARE(altered.code, Refused);
        QVERIFY2(altered.complaint.contains("does not match the signature of Anna Plant"), altered.complaint);
        QVERIFY(altered.out.isEmpty());
    }

    void ordersAreSignedForAMachine()
    {
        const QTemporaryDir folder;
        const auto path = [&folder](const QString& name) { return folder.filePath(name); };
        QVERIFY(QDir(folder.path()).mkdir(u"keys"_s));
        QCOMPARE(call({u"recipe"_s, u"new-key"_s, u"--name"_s, u"Anna Plant"_s, u"--key"_s, path(u"anna"_s),
                       u"-o"_s, path(u"keys/anna.json"_s)})
                     .code,
                 Ok);
        const QStringList order{u"order"_s, u"sign"_s,    u"--quantity"_s, u"5000"_s,  u"--lot"_s,
                                u"L17"_s,   u"--order"_s, u"4711"_s,       u"--key"_s, path(u"anna"_s)};
        QCOMPARE(call(order + QStringList{u"--machine"_s, u"Packer 7"_s, u"--recipe"_s, u"Biscuit 250"_s,
                                          u"-o"_s, path(u"order.json"_s)})
                     .code,
                 Ok);
        const Result verified =
            call({u"order"_s, u"verify"_s, path(u"order.json"_s), u"--keys"_s, path(u"keys"_s)});
        QCOMPARE(verified.code, Ok);
        QCOMPARE(verified.json()[u"machine"_s].toString(), u"Packer 7"_s);
        QCOMPARE(verified.json()[u"quantity"_s].toInt(), 5000);
        QCOMPARE(verified.json()[u"action"_s].toString(), u"stop"_s);
        QCOMPARE(verified.json()[u"signed_by"_s].toString(), u"Anna Plant"_s);

        QCOMPARE(call(order).code, Usage); // no machine
        for (const QString& quantity : {u"0"_s, u"1000000000"_s, u"-1"_s, u"many"_s}) {
            QStringList wrong = order + QStringList{u"--machine"_s, u"P1"_s};
            wrong[3] = quantity;
            QCOMPARE(call(wrong).code, Usage);
        }
        QStringList wrong = order + QStringList{u"--machine"_s, u"P1"_s};
        wrong[7] = u"47\n11"_s;
        QCOMPARE(call(wrong).code, Usage);
        wrong[7] = QString(500, u'x');
        QCOMPARE(call(wrong).code, Usage);
        const Result plain =
            call({u"order"_s, u"verify"_s, path(u"keys/anna.json"_s), u"--keys"_s, path(u"keys"_s)});
        QCOMPARE(plain.code, Refused);
        QVERIFY2(plain.complaint.contains("anna.json"), plain.complaint);
    }

    void refusals()
    {
        const QTemporaryDir folder;
        const QString plain = folder.filePath(u"plain.json"_s);
        QCOMPARE(call({u"recipe"_s, u"-o"_s, plain}).code, Ok);
        QCOMPARE(call({u"recipe"_s, u"verify"_s, plain, u"--keys"_s, folder.path()}).code, Refused);
        QCOMPARE(call({u"recipe"_s, u"verify"_s, plain}).code, Usage);
        QCOMPARE(call({u"recipe"_s, u"verify"_s, plain, u"--keys"_s, plain}).code, File);
        QCOMPARE(call({u"recipe"_s, u"sign"_s, plain}).code, Usage);
        QCOMPARE(call({u"recipe"_s, u"sign"_s, plain, u"--key"_s, plain}).code, File);
        QCOMPARE(call({u"recipe"_s, u"new-key"_s, u"--name"_s, u"Anna"_s, u"--key"_s, plain}).code, File);
        QCOMPARE(call({u"recipe"_s, u"new-key"_s, u"--key"_s, folder.filePath(u"a"_s)}).code, Usage);
        QCOMPARE(call({u"recipe"_s, plain, plain}).code, Usage);
        // Without its public key a secret one is not left behind.
        QCOMPARE(call({u"recipe"_s, u"new-key"_s, u"--name"_s, u"Anna"_s, u"--key"_s, folder.filePath(u"a"_s),
                       u"-o"_s, folder.filePath(u"none/a.json"_s)})
                     .code,
                 File);
        QVERIFY(!QFile::exists(folder.filePath(u"a"_s)));
    }
};

CAMPANEL_TEST(SigningTest)

} // namespace test_signing

#include "test_signing.moc"
