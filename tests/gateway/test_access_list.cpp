// SPDX-License-Identifier: Apache-2.0
// The access list of docs/plant.md at a real mosquitto: each does what it must, and nobody does what is
// another's.
#include "app/store/recipes/signed_recipe.h"
#include "gateway/payload.h"
#include "tests/app/cli/campanelctl_call.h"
#include "tests/gateway/plant_bench.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QEventLoop>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

namespace test_access_list {

using namespace campanel;
using namespace Qt::StringLiterals;
using plant::Metric;
using test::Machine;
using test::Mosquitto;

namespace {

// Returns the block of the document that has this text, for the group of the test.
QByteArray blockWith(const QString& text)
{
    QFile file(test::sourcePath("docs/plant.md"));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("no docs/plant.md");
    const QStringList blocks = QString::fromUtf8(file.readAll()).split(u"```"_s);
    for (qsizetype i = 1; i < blocks.size(); i += 2) {
        if (blocks[i].contains(text))
            return blocks[i].section(u'\n', 1).replace(u"Hall 3"_s, u"Hall"_s).toUtf8();
    }
    qFatal("docs/plant.md has no block with %s", qPrintable(text));
}

struct Plant {
    QTemporaryDir folder;
    std::unique_ptr<Mosquitto> broker;

    Plant()
    {
        QString create = u"-c"_s;
        for (const char* user : {"P7", "P8", "scada", "recipes", "fleet"}) {
            QProcess tool;
            QStringList arguments{u"-b"_s, folder.filePath(u"passwords"_s), QString::fromLatin1(user),
                                  u"secret"_s};
            if (!create.isEmpty())
                arguments.insert(1, std::exchange(create, {}));
            tool.start(u"mosquitto_passwd"_s, arguments);
            if (!tool.waitForFinished() || tool.exitCode() != 0)
                qFatal("mosquitto_passwd: %s", tool.readAllStandardError().constData());
        }
        write(u"acl"_s, blockWith(u"pattern write"_s));
        write(u"password"_s, "secret\n");
        QByteArray lines = blockWith(u"acl_file"_s);
        lines.replace("/etc/mosquitto/campanel.passwords", folder.filePath(u"passwords"_s).toUtf8());
        lines.replace("/etc/mosquitto/campanel.acl", folder.filePath(u"acl"_s).toUtf8());
        broker = std::make_unique<Mosquitto>(lines);
    }
    void write(const QString& name, const QByteArray& bytes) const
    {
        QFile file(folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("no file %s", qPrintable(name));
        file.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
    }
    // Returns the lines of [gateway] with which a user logs in.
    [[nodiscard]] QByteArray login(const QByteArray& user) const
    {
        return "user = \"" + user + "\"\npassword_file = \"" + folder.filePath(u"password"_s).toUtf8() +
               "\"\n";
    }
    [[nodiscard]] QStringList client(const QString& user) const
    {
        return {u"-h"_s,     u"127.0.0.1"_s, u"-p"_s, QString::number(broker->port()), u"-u"_s, user, u"-P"_s,
                u"secret"_s, u"-q"_s,        u"1"_s};
    }
    void publish(const QString& user, const QString& topic, const QByteArray& bytes,
                 bool isRetained = false) const
    {
        QProcess publisher;
        publisher.start(u"mosquitto_pub"_s, client(user) + QStringList{u"-t"_s, topic, u"-s"_s} +
                                                (isRetained ? QStringList{u"-r"_s} : QStringList{}));
        publisher.write(bytes);
        publisher.closeWriteChannel();
        if (!publisher.waitForFinished() || publisher.exitCode() != 0)
            qFatal("mosquitto_pub: %s", publisher.readAllStandardError().constData());
    }
};

QByteArray payloadOf(const QString& name, const plant::MetricValue& value, std::uint32_t type)
{
    return gateway::encodedPayload({1000, {}, {{.name = name, .type = type, .value = value}}});
}

} // namespace

class TestAccessList : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY2(Mosquitto::isInstalled(), "mosquitto is not installed; see packaging/dependencies");
    }

    void nobodyPublishesForAnother()
    {
        const Plant plant;
        QProcess host;
        host.start(u"mosquitto_sub"_s,
                   plant.client(u"scada"_s) + QStringList{u"-t"_s, u"spBv1.0/#"_s, u"-F"_s, u"%t"_s});
        QVERIFY(host.waitForStarted());
        QByteArray heard;
        const auto hears = [&](const QByteArray& topic) {
            heard += host.readAllStandardOutput();
            return heard.split('\n').contains(topic);
        };
        Machine machine(plant.broker->port(), plant.login("P7") + "primary_host = \"scada\"\n", u"P7"_s);
        QTRY_VERIFY2(machine.log().contains(u"Connected"_s), qPrintable(machine.log()));
        QTRY_VERIFY(machine.panel.hasGateway());
        const QString offline = u"spBv1.0/STATE/scada"_s;
        plant.publish(u"scada"_s, offline, R"({"online":true,"timestamp":1000})", true);
        QTRY_VERIFY(hears("spBv1.0/Hall/NBIRTH/P7"));
        machine.panel.countBags(1, 3);
        QTRY_VERIFY(hears("spBv1.0/Hall/NDATA/P7"));

        const QByteArray command = payloadOf(u"Command/CntrlCmd"_s, std::int64_t(2), 3);
        const QByteArray twin = payloadOf(u"CamPanel/Gateway/Instance"_s, u"0"_s, 12);
        for (const QString& intruder : {u"P8"_s, u"recipes"_s, u"fleet"_s}) {
            for (int times = 0; times < 2; ++times)
                plant.publish(intruder, u"spBv1.0/Hall/NBIRTH/P7"_s, twin);
            plant.publish(intruder, u"spBv1.0/Hall/NCMD/P7"_s, command);
            plant.publish(intruder, offline, R"({"online":false,"timestamp":2000})", true);
            plant.publish(intruder, u"spBv1.0/Hall/NDEATH/P7"_s, twin);
            if (intruder != u"recipes")
                plant.publish(intruder, u"campanel/Hall/recipes/X"_s, "x", true);
        }
        plant.publish(u"P8"_s, u"spBv1.0/Hall/NDATA/P8"_s, command); // its own

        plant.publish(u"recipes"_s, u"campanel/Hall/recipes/Biscuit"_s, "a recipe", true);
        QTRY_COMPARE(machine.panel.offers, (QMap<QString, QByteArray>{{u"Biscuit"_s, "a recipe"}}));
        plant.publish(u"scada"_s, u"spBv1.0/Hall/NCMD/P7"_s,
                      payloadOf(u"Command/Reset"_s, std::int64_t(1), 3));
        QTRY_COMPARE(machine.panel.commands, (QList<plant::CommandMessage>{{u"Command/Reset"_s, u"1"_s}}));
        QTRY_VERIFY(hears("spBv1.0/Hall/NDATA/P8"));
        QVERIFY(!hears("spBv1.0/Hall/NDEATH/P7"));
        QVERIFY2(!machine.log().contains(u"Another program"_s) && !machine.log().contains(u"is offline"_s),
                 qPrintable(machine.log()));

        plant.write(u"fleet.toml"_s,
                    "[gateway]\nhost = \"127.0.0.1\"\nport = " + QByteArray::number(plant.broker->port()) +
                        "\ngroup = \"Hall\"\n" + plant.login("fleet"));
        QProcess fleet;
        QEventLoop untilEnd;
        QObject::connect(&fleet, &QProcess::finished, &untilEnd, &QEventLoop::quit);
        fleet.start(test::programPath("campanelctl"),
                    {u"fleet"_s, u"--config"_s, plant.folder.filePath(u"fleet.toml"_s), u"--wait"_s, u"2"_s});
        untilEnd.exec();
        QVERIFY2(fleet.readAllStandardOutput().contains("P7"), fleet.readAllStandardError());
        host.kill();
        host.waitForFinished();
    }
};

CAMPANEL_TEST(TestAccessList)

} // namespace test_access_list

#include "test_access_list.moc"
