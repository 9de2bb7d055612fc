// SPDX-License-Identifier: Apache-2.0
// The section [gateway]: what is valid, what only warns, and what keeps the gateway from starting.
#include "gateway/gateway_settings.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace test_gateway_settings {

using namespace campanel;
using namespace campanel::gateway;
using namespace Qt::StringLiterals;

namespace {

ReadGatewaySettings settingsOf(const QByteArray& text)
{
    return gatewaySettings(shell::configurationFrom(text, u"c.toml"_s), u"packer-7"_s);
}

} // namespace

class TestGatewaySettings : public QObject {
    Q_OBJECT

private slots:
    void withoutASectionNothingIsPublished()
    {
        const auto read = settingsOf("");
        QVERIFY(read.settings.host.isEmpty());
        QCOMPARE(read.errors, QStringList());
        QCOMPARE(read.warnings, QStringList());
        QCOMPARE(read.settings.node, u"packer-7"_s);
        QCOMPARE(read.settings.group, u"CamPanel"_s);
        QCOMPARE(read.settings.port, 8883);
    }

    void everyKeyIsTaken()
    {
        QTemporaryDir folder;
        for (const char* name : {"ca.pem", "own.pem", "own.key"}) {
            QFile file(folder.filePath(QString::fromLatin1(name)));
            QVERIFY(file.open(QIODevice::WriteOnly));
        }
        const auto read = settingsOf(QByteArray(R"(
[gateway]
host = "broker.example"
port = 8884
ca = "FOLDER/ca.pem"
certificate = "FOLDER/own.pem"
key = "FOLDER/own.key"
group = "Hall 3"
node = "包装机 7"
primary_host = "scada"
)")
                                         .replace("FOLDER", folder.path().toUtf8()));
        QCOMPARE(read.errors, QStringList());
        QCOMPARE(read.warnings, QStringList());
        QCOMPARE(read.settings.host, u"broker.example"_s);
        QCOMPARE(read.settings.port, 8884);
        QVERIFY(read.settings.isEncrypted());
        QCOMPARE(read.settings.group, u"Hall 3"_s);
        QCOMPARE(read.settings.node, u"包装机 7"_s);
        QCOMPARE(read.settings.primaryHost, u"scada"_s);
    }

    // Brokers in a cloud ask for such names, and DNS allows them.
    void namesOfTheWorldAreTaken_data()
    {
        QTest::addColumn<QString>("host");
        QTest::addColumn<QString>("user");
        QTest::addColumn<bool>("isTaken");
        const QString longHost =
            QString(60, u'a') + u".iot.eu-central-1."_s + QString(60, u'b') + u".example"_s;
        const QString longest = (QString(62, u'x') + u'.').repeated(4).left(253);
        QTest::newRow("azure") << longHost << u"hub.azure-devices.net/packer-7/?api-version=2021-04-12"_s
                               << true;
        QTest::newRow("tenant") << u"mqtt.example."_s << u"/:packers"_s << true;
        QTest::newRow("signs") << u"10.1.2.3"_s << u"$ConnectionString #1+ \u5305\u88c5 \U0001F600"_s << true;
        QTest::newRow("longest") << longest << QString(256, u'u') << true;
        QTest::newRow("IPv6") << u"fe80::1%eth0"_s << u"packers"_s << true;
        QTest::newRow("local") << u"broker_7"_s << u"p"_s << true;
        QTest::newRow("other letters") << u"b\u00fccher.example"_s << u"p"_s << true;
        QTest::newRow("too long a host") << longest + u".yz"_s << u"p"_s << false;
        QTest::newRow("too long a label") << QString(64, u'x') + u".example"_s << u"p"_s << false;
        QTest::newRow("space in a host") << u"broker example"_s << u"p"_s << false;
        QTest::newRow("scheme") << u"mqtts://broker"_s << u"p"_s << false;
        QTest::newRow("two points") << u"a..b"_s << u"p"_s << false;
        QTest::newRow("too long a user") << u"b"_s << QString(257, u'u') << false;
        QTest::newRow("line feed") << u"b"_s << u"packers\\nadmin"_s << false;
        QTest::newRow("direction") << u"b"_s << u"packers\u202e"_s << false;
    }
    void namesOfTheWorldAreTaken()
    {
        QFETCH(QString, host);
        QFETCH(QString, user);
        QFETCH(bool, isTaken);
        QTemporaryDir folder;
        QFile file(folder.filePath(u"password"_s));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("secret\n") > 0);
        file.close();
        file.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
        const auto read = settingsOf(u"[gateway]\nhost = \"%1\"\nuser = \"%2\"\npassword_file = \"%3\"\n"_s
                                         .arg(host, user, file.fileName())
                                         .toUtf8());
        QVERIFY2(read.errors.isEmpty() == isTaken, qPrintable(read.errors.join(u'\n')));
        QVERIFY(!isTaken || (read.settings.host == host && read.settings.user == user));
    }

    void aPasswordComesFromAFileOfItsOwn()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(u"password"_s);
        const auto read = [&path](const QByteArray& text, QFile::Permissions others = {}) {
            QFile file(path);
            if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
                qFatal("no file");
            file.close();
            QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner | others);
            return settingsOf("[gateway]\nhost = \"b\"\nuser = \"packers\"\npassword_file = \"" +
                              path.toUtf8() + "\"\n");
        };
        const auto good = read("se cret\nnote\n", QFile::ReadGroup);
        QCOMPARE(good.errors, QStringList());
        QCOMPARE(good.settings.user, u"packers"_s);
        QCOMPARE(good.settings.password, u"se cret"_s);
        QVERIFY(good.warnings.contains(u"The password is sent unencrypted: gateway.ca is not set."_s));
        QVERIFY(read("secret", QFile::ReadOther).errors.value(0).contains(u"everybody can open"_s));
        QVERIFY(read("\n").errors.value(0).contains(u"is empty"_s));
        QVERIFY(settingsOf("[gateway]\nuser = \"packers\"\n").errors.value(0).contains(u"belong together"_s));
        QVERIFY(settingsOf("[gateway]\nuser = \"p\"\npassword_file = \"/nowhere\"\n")
                    .errors.value(0)
                    .contains(u"cannot be read"_s));
    }

    void wrongValuesKeepItFromStarting_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("port")
            << QByteArray("[gateway]\nport = 0\n")
            << u"c.toml:2: gateway.port must be a whole number from 1 to 65535; it is ignored."_s;
        QTest::newRow("topic")
            << QByteArray("[gateway]\nnode = \"a/b\"\n")
            << u"c.toml:2: gateway.node must be up to 64 letters, without / + #; it is ignored."_s;
        QTest::newRow("ca") << QByteArray("[gateway]\nca = \"ca.pem\"\n")
                            << u"c.toml:2: gateway.ca must be the path of a file, such as "
                               "\"/etc/campanel/broker.pem\"; it is ignored."_s;
        QTest::newRow("missing file") << QByteArray("[gateway]\nca = \"/nowhere/ca.pem\"\n")
                                      << u"gateway.ca: /nowhere/ca.pem cannot be read."_s;
        QTest::newRow("misspelt") << QByteArray("[gateway]\ncertificat = \"/a\"\n")
                                  << u"c.toml:2: there is no key gateway.certificat; it is ignored."_s;
        QTest::newRow("section") << QByteArray("[gatway]\nca = \"/a\"\n")
                                 << u"c.toml:1: there is no section [gatway]; it is ignored."_s;
        QTest::newRow("no TOML") << QByteArray("[gateway]\nca /a\n") << u"c.toml:2: "_s;
        QTest::newRow("half")
            << QByteArray("[gateway]\nkey = \"/dev/null\"\n")
            << u"gateway.certificate and gateway.key belong together. Set both, or neither."_s;
        QTest::newRow("no group") << QByteArray("[gateway]\ngroup = \"\"\n")
                                  << u"gateway.group is empty. Name the group."_s;
    }
    void wrongValuesKeepItFromStarting()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, sentence);
        const auto read = settingsOf(text);
        QVERIFY2(!read.errors.isEmpty() && read.errors.first().startsWith(sentence),
                 qPrintable(read.errors.join(u'\n')));
    }

    void wrongValuesOfOtherSectionsDoNot()
    {
        const auto read = settingsOf("[display]\ntheme = \"pink\"\ncolour = 3\n[gateway]\nhost = \"b\"\n");
        QCOMPARE(read.errors, QStringList());
        QCOMPARE(read.warnings.size(), 3); // and that there is no TLS
        QCOMPARE(read.settings.host, u"b"_s);
    }
};

CAMPANEL_TEST(TestGatewaySettings)

} // namespace test_gateway_settings

#include "test_gateway_settings.moc"
