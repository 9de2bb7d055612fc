// SPDX-License-Identifier: Apache-2.0
// campanelctl fleet at mosquitto, with gateways whose panels the test plays.
#include "app/store/recipes/signed_recipe.h"
#include "gateway/fleet.h"
#include "tests/app/cli/campanelctl_call.h"
#include "tests/gateway/plant_bench.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QEventLoop>
#include <QFile>
#include <QJsonArray>
#include <QTest>
#include <QTimer>

namespace test_fleet {

using namespace campanel;
using namespace Qt::StringLiterals;
using gateway::Fleet;
using gateway::PayloadMetric;
using plant::Metric;
using plant::MetricValue;
using test::Machine;
using test::Mosquitto;

namespace {

constexpr std::uint32_t signedCrc = 0xC0FFEE01;

// Calls the program while the panels of the test go on.
test::Result called(const QStringList& arguments)
{
    QProcess process;
    QEventLoop untilEnd;
    QObject::connect(&process, &QProcess::finished, &untilEnd, &QEventLoop::quit);
    process.start(test::programPath("campanelctl"), QStringList{u"fleet"_s} + arguments);
    untilEnd.exec();
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

void run(Machine& machine, const QString& recipe, int version, std::uint32_t crc)
{
    machine.panel.set(Metric::RecipeName, recipe);
    machine.panel.set(Metric::RecipeVersion, std::int64_t(version));
    machine.panel.set(Metric::RecipeCrc, std::int64_t(crc));
    machine.panel.set(Metric::RecipeGeneration, std::int64_t(3));
}

void write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
}

PayloadMetric crcMetric(std::uint32_t crc, const QString& name = {}, std::int64_t timestampMs = 1000)
{
    return {.name = name,
            .alias = static_cast<std::uint64_t>(Metric::RecipeCrc),
            .timestampMs = timestampMs,
            .type = static_cast<std::uint32_t>(plant::MetricType::Int64),
            .value = std::int64_t(crc)};
}

PayloadMetric bdSeq(int number)
{
    return {.name = u"bdSeq"_s, .type = 4, .value = std::int64_t(number)};
}

} // namespace

class TestFleet : public QObject {
    Q_OBJECT

private slots:
    void birthsDataAndDeaths()
    {
        Fleet fleet(u"Hall"_s);
        const auto take = [&fleet](const char* type, const QList<PayloadMetric>& metrics,
                                   const QString& group = u"Hall"_s) {
            fleet.take(u"spBv1.0/%1/%2/M1"_s.arg(group, QLatin1String(type)),
                       gateway::encodedPayload({1000, {}, metrics}));
        };
        const QString name = u"CamPanel/Recipe/CRC-32"_s;
        take("NDATA", {crcMetric(1)}); // of a machine that is not known yet
        take("NBIRTH",
             {bdSeq(4), {.name = u"Temperature"_s, .alias = 12, .type = 4, .value = std::int64_t(5)}});
        take("NBIRTH", {bdSeq(4), crcMetric(1, name)}, u"Other"_s);
        fleet.take(u"spBv1.0/Hall/NBIRTH/M1"_s, "\xff\xff");
        fleet.take(u"spBv1.0/Hall/NBIRTH"_s, {});
        QVERIFY(fleet.machines().isEmpty());
        take("NBIRTH", {bdSeq(4), crcMetric(1, name)});
        QCOMPARE(fleet.machines().size(), 1);
        const auto machine = [&fleet] { return fleet.machines().first(); };
        QVERIFY(machine().isOnline);
        QCOMPARE(machine().value(Metric::RecipeCrc), MetricValue(std::int64_t(1)));
        take("NDATA", {crcMetric(2, {}, 5000)});
        QCOMPARE(machine().value(Metric::RecipeCrc), MetricValue(std::int64_t(2)));
        QCOMPARE(machine().crcSinceMs, 5000);
        PayloadMetric old = crcMetric(9);
        old.isHistorical = true;
        PayloadMetric wrong = crcMetric(9);
        wrong.value = u"nine"_s;
        PayloadMetric unknown = crcMetric(9);
        unknown.alias = 9999;
        take("NDATA", {old, wrong, unknown});
        QCOMPARE(machine().value(Metric::RecipeCrc), MetricValue(std::int64_t(2)));
        take("NDEATH", {bdSeq(3)}); // late, of the connection before
        QVERIFY(machine().isOnline);
        take("NDEATH", {bdSeq(4)});
        QVERIFY(!machine().isOnline);
    }

    void machinesAreListedAndComparedWithTheSignedTable()
    {
        QVERIFY2(Mosquitto::isInstalled(), "mosquitto is not installed; see packaging/dependencies");
        const QTemporaryDir folder;
        const auto key = store::newSigningKey(u"Anna Plant"_s).value();
        QVERIFY(QDir(folder.path()).mkdir(u"keys"_s) && QDir(folder.path()).mkdir(u"signed"_s));
        write(folder.filePath(u"keys/anna.json"_s), store::publicKeyFile(key));
        const QString file = folder.filePath(u"signed/biscuit.json"_s);
        write(file, store::signRecipe({}, 1'790'000'000'000, signedCrc, key));
        Mosquitto broker;
        Machine first(broker.port(), {}, u"M1"_s);
        Machine second(broker.port(), {}, u"M2"_s);
        Machine silent(broker.port(), {}, u"M3"_s); // says nothing more after its birth
        run(first, u"Biscuit 250"_s, 8, signedCrc);
        run(second, u"Biscuit, \"old\""_s, 7, 0xBEEF);
        for (Machine* each : {&first, &second, &silent})
            QTRY_VERIFY(each->log().contains(u"Connected"_s) && each->panel.hasGateway());
        QTest::qWait(500);
        const QStringList call{u"--broker"_s, u"127.0.0.1:%1"_s.arg(broker.port()),
                               u"--group"_s,  u"Hall"_s,
                               u"--wait"_s,   u"2"_s};
        const auto listed = called(call + QStringList{u"--format"_s, u"json"_s});
        QVERIFY2(listed.code == test::Ok, listed.complaint);
        const QJsonArray machines = listed.json()[u"machines"_s].toArray();
        QCOMPARE(machines.size(), 3);
        QCOMPARE(machines[0][u"machine"_s], u"M1"_s);
        QCOMPARE(machines[0][u"recipe"_s], u"Biscuit 250"_s);
        QCOMPARE(machines[0][u"version"_s], 8);
        QCOMPARE(machines[0][u"table_crc32"_s], u"C0FFEE01"_s);
        QCOMPARE(machines[0][u"generation"_s], 3);
        const QDateTime since = QDateTime::fromString(machines[0][u"since_utc"_s].toString(), Qt::ISODate);
        QVERIFY(since.isValid() && qAbs(since.secsTo(QDateTime::currentDateTimeUtc())) < 60);
        QVERIFY(machines[2][u"recipe"_s].isNull() && machines[2][u"online"_s].toBool());
        QVERIFY(!machines[0].toObject().contains(u"table_is_a_signed_one"_s));

        const auto text = called(call);
        QCOMPARE(text.code, test::Ok);
        QVERIFY2(text.lines().value(1).startsWith("M1       Biscuit 250"), text.out);
        const auto csv = called(call + QStringList{u"--format"_s, u"csv"_s});
        QVERIFY2(csv.out.contains("\"Biscuit, \"\"old\"\"\""), csv.out);

        for (const QString& place : {file, folder.filePath(u"signed"_s)}) {
            const auto compared =
                called(call + QStringList{u"--signed"_s, place, u"--keys"_s, folder.filePath(u"keys"_s)});
            QCOMPARE(compared.code, test::Refused);
            QVERIFY2(compared.complaint.contains("2 of 3 machines do not report a signed table: M2, M3."),
                     compared.complaint);
            QVERIFY(compared.lines().value(1).endsWith("yes") && compared.lines().value(2).endsWith("no"));
        }
        run(second, u"Biscuit 250"_s, 8, signedCrc);
        run(silent, u"Biscuit 250"_s, 8, signedCrc);
        QTest::qWait(500);
        const auto same =
            called(call + QStringList{u"--signed"_s, file, u"--keys"_s, folder.filePath(u"keys"_s)});
        QVERIFY2(same.code == test::Ok, same.complaint);
        write(folder.filePath(u"keys/anna.json"_s), "{}");
        const auto untrusted =
            called(call + QStringList{u"--signed"_s, file, u"--keys"_s, folder.filePath(u"keys"_s)});
        QCOMPARE(untrusted.code, test::Refused);
        QVERIFY2(untrusted.complaint.contains("signed by Anna Plant"), untrusted.complaint);
        const auto nobody =
            called({u"--broker"_s, u"127.0.0.1:%1"_s.arg(broker.port()), u"--wait"_s, u"0.5"_s});
        QCOMPARE(nobody.code, test::Link);
        QVERIFY2(nobody.complaint.contains("No machine of the group CamPanel"), nobody.complaint);
    }

    // A machine's names and texts are cells of its own row, and the machines that are named are in one line.
    void aMachineForgesNoRows()
    {
        Mosquitto broker;
        const QString forged = u"P7\n\nP8        Biscuit 250  8  C0FFEE01  3   yes\u2028x\u202ey"_s;
        const QByteArray birth =
            gateway::encodedPayload({1000,
                                     0,
                                     {bdSeq(1),
                                      crcMetric(7, u"CamPanel/Recipe/CRC-32"_s),
                                      {.name = u"CamPanel/Recipe/Name"_s,
                                       .alias = static_cast<std::uint64_t>(Metric::RecipeName),
                                       .timestampMs = 1000,
                                       .type = static_cast<std::uint32_t>(plant::MetricType::String),
                                       .value = forged}}});
        Machine listener(broker.port(), {}, u"M1"_s);
        QTRY_VERIFY(listener.log().contains(u"Connected"_s));
        // Births of one who says all names of machines, while the list is made.
        QTimer births;
        QObject::connect(&births, &QTimer::timeout, &births, [&broker, &birth] {
            broker.publish(u"spBv1.0/Hall/NBIRTH/P7      Biscuit \u202e8"_s, birth);
        });
        births.start(200);
        const QStringList call{u"--broker"_s, u"127.0.0.1:%1"_s.arg(broker.port()),
                               u"--group"_s,  u"Hall"_s,
                               u"--wait"_s,   u"2"_s};
        for (const QString& format : {u"text"_s, u"csv"_s}) {
            const auto listed = called(call + QStringList{u"--format"_s, format});
            QVERIFY2(listed.code == test::Ok, listed.complaint);
            QCOMPARE(listed.lines().size(), 3); // the titles and two machines
            QVERIFY2(!listed.out.contains("\u202e") && !listed.out.contains("P7  "), listed.out);
            QVERIFY2(listed.out.contains("P7 Biscuit \\u202e8"), listed.out);
        }
        const auto json = called(call + QStringList{u"--format"_s, u"json"_s}).json();
        QCOMPARE(json[u"machines"_s][1][u"recipe"_s].toString(), forged); // whole
    }

    void wrongCalls()
    {
        const QTemporaryDir folder;
        write(folder.filePath(u"c.toml"_s), "[gateway]\nport = 0\n");
        write(folder.filePath(u"empty.toml"_s), "");
        QCOMPARE(called({u"--broker"_s, u":80"_s}).code, test::Usage);
        QCOMPARE(called({u"--broker"_s, u"127.0.0.1"_s, u"--wait"_s, u"0"_s}).code, test::Usage);
        QCOMPARE(called({u"--broker"_s, u"127.0.0.1"_s, u"--group"_s, u"#"_s}).code, test::Usage);
        QCOMPARE(called({u"--broker"_s, u"127.0.0.1"_s, u"--signed"_s, u"x"_s}).code, test::Usage);
        QCOMPARE(called({u"--config"_s, folder.filePath(u"empty.toml"_s)}).code, test::Usage);
        QCOMPARE(called({u"--config"_s, folder.filePath(u"c.toml"_s)}).code, test::File);
        const auto dead = called({u"--broker"_s, u"127.0.0.1:%1"_s.arg(test::freePort())});
        QCOMPARE(dead.code, test::Link);
        QVERIFY2(dead.complaint.contains("No connection to the broker"), dead.complaint);
    }

    void aPasswordIsSent()
    {
        const QTemporaryDir folder;
        const QString passwords = folder.filePath(u"passwords"_s);
        QProcess tool;
        tool.start(u"mosquitto_passwd"_s, {u"-b"_s, u"-c"_s, passwords, u"packers"_s, u"se cret"_s});
        QVERIFY(tool.waitForFinished() && tool.exitCode() == 0);
        const auto file = [&folder](const QString& name, const QByteArray& text) {
            write(folder.filePath(name), text);
            QFile::setPermissions(folder.filePath(name), QFile::ReadOwner | QFile::WriteOwner);
            return folder.filePath(name);
        };
        Mosquitto broker("allow_anonymous false\npassword_file " + passwords.toUtf8() + '\n');
        const QByteArray good =
            "user = \"packers\"\npassword_file = \"" + file(u"good"_s, "se cret\n").toUtf8() + "\"";
        const QByteArray bad =
            "user = \"packers\"\npassword_file = \"" + file(u"bad"_s, "secret\n").toUtf8() + "\"";
        Machine refused(broker.port(), bad, u"M1"_s);
        QTRY_VERIFY(refused.log().contains(u"The broker refuses the connection"_s));
        QVERIFY(!refused.log().contains(u"secret"_s));
        Machine accepted(broker.port(), good, u"M2"_s);
        QTRY_VERIFY(accepted.log().contains(u"Connected"_s));
        const auto listed = called({u"--config"_s, accepted.file(u"campanel.toml"_s), u"--wait"_s, u"2"_s});
        QVERIFY2(listed.code == test::Ok && listed.out.contains("M2"), listed.complaint);
    }
};

CAMPANEL_TEST(TestFleet)

} // namespace test_fleet

#include "test_fleet.moc"
