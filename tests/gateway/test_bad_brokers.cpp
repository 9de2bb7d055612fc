// SPDX-License-Identifier: Apache-2.0
// Brokers that refuse, hang, break off or send garbage, and TLS: the gateway says why and goes on trying.
#include "tests/gateway/plant_bench.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>
#include <QProcess>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>

#include <random>

namespace test_bad_brokers {

using namespace campanel;
using namespace Qt::StringLiterals;
using plant::Metric;
using test::Host;
using test::Machine;
using test::Mosquitto;

namespace {

// Returns false when openssl cannot make it.
bool runOpenssl(const QStringList& arguments)
{
    QProcess openssl;
    openssl.start(u"openssl"_s, arguments);
    return openssl.waitForFinished() && openssl.exitCode() == 0;
}

// An authority and what it signs, as files in a folder.
struct Authority {
    QTemporaryDir folder;

    [[nodiscard]] QString path(const QString& name) const { return folder.filePath(name); }

    [[nodiscard]] bool make() const
    {
        return runOpenssl({u"req"_s, u"-x509"_s, u"-newkey"_s, u"ec"_s, u"-pkeyopt"_s,
                           u"ec_paramgen_curve:prime256v1"_s, u"-nodes"_s, u"-days"_s, u"2"_s, u"-subj"_s,
                           u"/CN=authority"_s, u"-keyout"_s, path(u"ca.key"_s), u"-out"_s,
                           path(u"ca.pem"_s)});
    }
    [[nodiscard]] bool sign(const QString& name, const QString& subject) const
    {
        QFile extension(path(u"extension"_s));
        if (!extension.open(QIODevice::WriteOnly) || extension.write("subjectAltName=IP:127.0.0.1\n") < 0)
            return false;
        extension.close();
        return runOpenssl({u"req"_s, u"-newkey"_s, u"ec"_s, u"-pkeyopt"_s, u"ec_paramgen_curve:prime256v1"_s,
                           u"-nodes"_s, u"-subj"_s, u"/CN="_s + subject, u"-keyout"_s, path(name + u".key"_s),
                           u"-out"_s, path(name + u".csr"_s)}) &&
               runOpenssl({u"x509"_s, u"-req"_s, u"-days"_s, u"2"_s, u"-in"_s, path(name + u".csr"_s),
                           u"-CA"_s, path(u"ca.pem"_s), u"-CAkey"_s, path(u"ca.key"_s), u"-CAcreateserial"_s,
                           u"-extfile"_s, path(u"extension"_s), u"-out"_s, path(name + u".pem"_s)});
    }
};

QByteArray keyLine(const char* key, const QString& path)
{
    return QByteArray(key) + " = \"" + path.toUtf8() + "\"\n";
}

// Answers each connection as the test wants.
struct BadBroker {
    QTcpServer server;
    int connections = 0;

    template <typename Answer> explicit BadBroker(Answer answer)
    {
        if (!server.listen(QHostAddress::LocalHost))
            qFatal("no port");
        QObject::connect(&server, &QTcpServer::newConnection, &server, [this, answer] {
            while (QTcpSocket* socket = server.nextPendingConnection()) {
                ++connections;
                QObject::connect(socket, &QTcpSocket::readyRead, &server, [socket, answer] {
                    const QByteArray bytes = socket->readAll();
                    answer(*socket, bytes);
                });
            }
        });
    }
};

const QByteArray accepted = QByteArray::fromHex("20020000");
const QByteArray refused = QByteArray::fromHex("20020005"); // not authorised

} // namespace

class TestBadBrokers : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY2(Mosquitto::isInstalled(),
                 "mosquitto or mosquitto_sub is not installed; see packaging/dependencies");
    }

    void noBrokerAtAll()
    {
        Machine machine(test::freePort());
        QTRY_VERIFY(machine.log().contains(u"No connection to the broker"_s));
        QTRY_VERIFY(machine.panel.hasGateway());
        machine.panel.countBags(1, 100);
        QVERIFY(machine.isGatewayRunning());
        machine.endGateway();
    }

    void nothingIsPublishedWithoutAHost()
    {
        QTemporaryDir folder;
        QProcess gateway;
        gateway.setProcessChannelMode(QProcess::MergedChannels);
        gateway.start(test::programPath("campanel-gateway"),
                      {u"--config"_s, folder.filePath(u"none.toml"_s)});
        QVERIFY(gateway.waitForFinished());
        QCOMPARE(gateway.exitCode(), 0);
        QVERIFY(gateway.readAll().contains("names no broker"));
    }

    void aWrongConfigurationIsRefused()
    {
        Machine machine(0);
        QTRY_VERIFY(!machine.isGatewayRunning());
        QVERIFY(machine.log().contains(u"gateway.port must be a whole number from 1 to 65535"_s));
    }

    // Each of them is tried again, and the log says why.
    void brokersThatMisbehave_data()
    {
        QTest::addColumn<QByteArray>("answer");
        QTest::addColumn<bool>("closes");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("closes at once") << QByteArray() << true << u"No connection to the broker"_s;
        QTest::newRow("refuses") << refused << true << u"The broker refuses the connection"_s;
        QTest::newRow("closes in the middle")
            << accepted << true << u"The connection to the broker is lost"_s;
        QTest::newRow("garbage") << QByteArray("HTTP/1.1 400 Bad Request\r\n\r\n") << true
                                 << u"onnection to the broker"_s;
        QTest::newRow("garbage later")
            << accepted + QByteArray(64, '\xff') << true << u"onnection to the broker"_s;
        QTest::newRow("a message that does not end")
            << accepted + QByteArray::fromHex("30ffffff7f0003") + "a/b" << true
            << u"onnection to the broker"_s;
    }
    void brokersThatMisbehave()
    {
        QFETCH(QByteArray, answer);
        QFETCH(bool, closes);
        QFETCH(QString, sentence);
        BadBroker broker([answer, closes](QTcpSocket& socket, const QByteArray&) {
            socket.write(answer);
            if (closes)
                socket.disconnectFromHost();
        });
        Machine machine(broker.server.serverPort());
        QTRY_VERIFY(broker.connections >= 2);
        QVERIFY2(machine.log().contains(sentence), qPrintable(machine.log()));
        QTRY_VERIFY(machine.panel.hasGateway());
        QVERIFY(machine.isGatewayRunning());
        machine.endGateway();
    }

    // The number of a connection is written when a broker has accepted one, not for each attempt.
    void attemptsWriteNothing()
    {
        BadBroker broker([](QTcpSocket& socket, const QByteArray&) { socket.disconnectFromHost(); });
        Machine machine(broker.server.serverPort());
        QTRY_VERIFY_WITH_TIMEOUT(broker.connections >= 3, 30'000);
        QFile file(machine.file(u"bdseq"_s));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("0\n"));
        machine.endGateway();
        QCOMPARE(machine.log().count(u"No connection to the broker"_s), 1);
    }

    // It accepts the connection and then answers nothing: nothing is believed to have arrived.
    void aBrokerThatHangs()
    {
        BadBroker broker([](QTcpSocket& socket, const QByteArray& bytes) {
            if (bytes.startsWith('\x10'))
                socket.write(accepted);
        });
        Machine machine(broker.server.serverPort());
        QTRY_VERIFY(machine.panel.hasGateway());
        machine.panel.countBags(1, 100);
        QTRY_VERIFY_WITH_TIMEOUT(machine.log().contains(u"does not handle what it gets"_s), 30'000);
        QTRY_VERIFY_WITH_TIMEOUT(broker.connections >= 2, 30'000);
    }

    // Random bytes as answers. Mosquitto comes afterwards at the same place.
    void aBrokerThatSendsGarbage()
    {
        constexpr unsigned seed = 23;
        qInfo("seed %u", seed);
        auto random = std::make_shared<std::mt19937>(seed);
        BadBroker broker([random](QTcpSocket& socket, const QByteArray& bytes) {
            if (bytes.startsWith('\x10'))
                socket.write(accepted);
            QByteArray garbage(static_cast<qsizetype>((*random)() % 200U), Qt::Uninitialized);
            for (char& byte : garbage)
                byte = char((*random)());
            socket.write(garbage);
        });
        Machine machine(broker.server.serverPort());
        QTRY_VERIFY_WITH_TIMEOUT(broker.connections >= 5, 60'000);
        QVERIFY2(machine.isGatewayRunning(), qPrintable(machine.log()));
    }

    void certificates()
    {
        Authority ours;
        Authority theirs;
        QVERIFY2(ours.make() && theirs.make() && ours.sign(u"broker"_s, u"broker"_s) &&
                     ours.sign(u"machine"_s, u"machine"_s) && theirs.sign(u"machine"_s, u"machine"_s),
                 "openssl cannot make certificates");
        const int tls = test::freePort();
        const Mosquitto broker(
            "listener " + QByteArray::number(tls) + " 127.0.0.1\nrequire_certificate true\ncafile " +
            ours.path(u"ca.pem"_s).toUtf8() + "\ncertfile " + ours.path(u"broker.pem"_s).toUtf8() +
            "\nkeyfile " + ours.path(u"broker.key"_s).toUtf8() + '\n');
        Host host(broker);
        const auto linesOf = [](const Authority& signer, const Authority& own) {
            return keyLine("ca", signer.path(u"ca.pem"_s)) +
                   keyLine("certificate", own.path(u"machine.pem"_s)) +
                   keyLine("key", own.path(u"machine.key"_s));
        };
        // It does not trust the broker.
        Machine distrusting(tls, linesOf(theirs, ours));
        QTRY_VERIFY2(distrusting.log().contains(u"No connection to the broker"_s),
                     qPrintable(distrusting.log()));
        QVERIFY2(distrusting.log().contains(u"certificate"_s, Qt::CaseInsensitive),
                 qPrintable(distrusting.log()));
        // The broker does not trust it.
        Machine distrusted(tls, linesOf(ours, theirs));
        QTRY_VERIFY2(distrusted.log().contains(u"onnection to the broker"_s), qPrintable(distrusted.log()));
        // It does not speak TLS.
        Machine plain(tls);
        QTRY_VERIFY2(plain.log().contains(u"onnection to the broker"_s), qPrintable(plain.log()));
        QVERIFY(host.messages().isEmpty());
        Machine good(tls, linesOf(ours, ours));
        QTRY_COMPARE(host.ofType(u"NBIRTH"_s).size(), 1);
        QVERIFY(distrusting.isGatewayRunning() && distrusted.isGatewayRunning() && plain.isGatewayRunning());
    }
};

CAMPANEL_TEST(TestBadBrokers)

} // namespace test_bad_brokers

#include "test_bad_brokers.moc"
