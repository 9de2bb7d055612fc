// SPDX-License-Identifier: Apache-2.0
// campanelctl doctor, link and frames, as a person calls them.
#include "campanelctl_call.h"
#include "tests/support/controller_process.h"
#include "tests/support/scripted_slave.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <QJsonArray>

#include <memory>

namespace test_line {

using namespace Qt::StringLiterals;
using namespace campanel::test;

class CliLineTest : public QObject {
    Q_OBJECT

private slots:
    void complaints_data()
    {
        QTest::addColumn<QString>("words");
        QTest::addColumn<int>("code");
        QTest::addColumn<QByteArray>("complaint");
        QTest::newRow("doctor without a port") << u"doctor"_s << int{Usage} << QByteArray("--port");
        QTest::newRow("no time") << u"link --port /dev/null --seconds 0"_s << int{Usage}
                                 << QByteArray("--seconds");
        QTest::newRow("no exchanges")
            << u"link --port /dev/null --exchanges none"_s << int{Usage} << QByteArray("--exchanges");
        QTest::newRow("no output") << u"output --port /dev/null"_s << int{Usage}
                                   << QByteArray("Name one output: Switch1, Switch2");
        QTest::newRow("no such output") << u"output Switch9 --port /dev/null"_s << int{Usage}
                                        << QByteArray("Name one output: Switch1, Switch2");
        QTest::newRow("output for too long")
            << u"output Switch1 --seconds 61 --port /dev/null"_s << int{Usage} << QByteArray("--seconds");
        QTest::newRow("endless") << u"link --port /dev/null --seconds inf"_s << int{Usage}
                                 << QByteArray("--seconds");
        QTest::newRow("negative exchanges")
            << u"link --port /dev/null --exchanges -1"_s << int{Usage} << QByteArray("--exchanges");
        for (const char* command : {"doctor", "doctor --scan", "status", "link", "frames"}) {
            const QString begin = QString::fromLatin1(command) + u" --port /dev/ttyNONE7 "_s;
            for (const char* value : {"0", "-1", "12345", "4294967296", "115200.5", "nan", "inf", ""})
                QTest::addRow("%s, baud rate %s", command, value)
                    << begin + u"--baud="_s + QString::fromLatin1(value) << int{Usage}
                    << QByteArray("--baud");
            for (const char* value : {"0", "-1", "3", "257", "65537", "nan", ""})
                QTest::addRow("%s, stop bits %s", command, value)
                    << begin + u"--stop-bits="_s + QString::fromLatin1(value) << int{Usage}
                    << QByteArray("--stop-bits");
            for (const char* value : {"0", "-1", "248", "257", "4294967297", "nan", ""})
                QTest::addRow("%s, unit %s", command, value)
                    << begin + u"--unit="_s + QString::fromLatin1(value) << int{Usage}
                    << QByteArray("--unit");
        }
        QTest::newRow("frames of no port")
            << u"frames --port /dev/ttyNONE7"_s << int{Link} << QByteArray("does not exist");
    }

    void complaints()
    {
        QFETCH(QString, words);
        QFETCH(int, code);
        QFETCH(QByteArray, complaint);
        const Result result = call(words.split(u' '));
        QCOMPARE(result.code, code);
        QVERIFY2(result.complaint.contains(complaint), result.complaint.constData());
        QCOMPARE(result.complaint.count('\n'), 1);
        QVERIFY(result.out.isEmpty());
    }

    void anOutputIsOnWhileTheCommandRuns()
    {
        const ControllerProcess controller({u"--speed"_s, u"0.1"_s}); // its half second is five
        const QStringList port{u"--port"_s, controller.port()};
        const auto isOn = [&port](const QString& output) {
            const auto outputs = call(QStringList{u"status"_s, u"--format"_s, u"json"_s} + port).json();
            return outputs[u"io"_s][u"outputs"_s].toArray().contains(output);
        };
        const auto isOnAfterKill = [&] {
            QProcess held;
            held.start(programPath("campanelctl"),
                       QStringList{u"output"_s, u"switch3"_s, u"--seconds"_s, u"30"_s} + port);
            (void)held.waitForFinished(500);
            held.kill();
            return held.waitForFinished() && isOn(u"Switch3"_s);
        };
        QTRY_VERIFY_WITH_TIMEOUT(isOnAfterKill(), 20'000);
        QTRY_VERIFY_WITH_TIMEOUT(!isOn(u"Switch3"_s), 20'000); // nobody asks for it any more
        const Result result = call(QStringList{u"output"_s, u"Switch8"_s, u"--seconds"_s, u"0.4"_s} + port);
        QVERIFY2(result.code == Ok, result.complaint.constData());
        QCOMPARE(result.out, "Switch8 was on for 0.4 s.\n");
        QVERIFY(!isOn(u"Switch8"_s));
    }

    void anOutputIsRefusedWithItsReason()
    {
        const ControllerProcess controller;
        const QStringList port{u"--port"_s, controller.port()};
        for (const auto& command : {u"download"_s, u"start"_s})
            QCOMPARE(call(QStringList{command} + port).code, int{Ok});
        const Result running = call(QStringList{u"output"_s, u"Switch1"_s} + port);
        QCOMPARE(running.code, int{Refused});
        QVERIFY2(running.complaint.contains("only possible at standstill"), running.complaint.constData());
        const ControllerProcess older({u"--map-minor"_s, u"4"_s});
        const Result old = call({u"output"_s, u"Switch1"_s, u"--port"_s, older.port()});
        QCOMPARE(old.code, int{Refused});
        QVERIFY2(old.complaint.contains("does not support this command"), old.complaint.constData());
    }

    void doctorOfAGoodLine()
    {
        ControllerProcess controller;
        const Result result = call({u"doctor"_s, u"--port"_s, controller.port()});
        QVERIFY2(result.code == Ok, result.complaint.constData());
        QVERIFY2(result.out.contains("115200 baud, 8N1, unit 1"), result.out.constData());
    }

    void doctorNamesTheWrongUnit()
    {
        ControllerProcess controller({u"--unit"_s, u"2"_s});
        const Result result = call(
            {u"doctor"_s, u"--port"_s, controller.port(), u"--unit"_s, u"9"_s, u"--format"_s, u"json"_s});
        QCOMPARE(result.code, int{Link});
        QVERIFY(result.complaint.contains("unit number 9"));
        const QJsonObject finding = QJsonDocument::fromJson(result.out).array().first().toObject();
        QCOMPARE(finding[u"condition"_s].toString(), u"wrong_unit"_s);
        QCOMPARE(finding[u"unit"_s].toInt(), 2);
        QVERIFY(finding[u"sentence"_s].toString().contains(u"at unit number 2"_s));
    }

    void doctorNamesAPortThatDoesNotExist()
    {
        const Result result = call({u"doctor"_s, u"--port"_s, u"/dev/ttyNONE7"_s, u"--format"_s, u"json"_s});
        QCOMPARE(result.code, int{Link});
        const QJsonObject finding = QJsonDocument::fromJson(result.out).array().first().toObject();
        QCOMPARE(finding[u"condition"_s].toString(), u"port_absent"_s);
    }

    void doctorFindsAControllerByScanning()
    {
        ControllerProcess controller({u"--unit"_s, u"5"_s});
        const Result result = call({u"doctor"_s, u"--scan"_s, u"--port"_s, controller.port()});
        QVERIFY2(result.code == Ok, result.complaint.constData());
        QVERIFY2(result.out.contains("unit 5"), result.out.constData());
        QVERIFY(result.complaint.isEmpty()); // progress is for terminals
    }

    void doctorWritesNothingToAForeignDevice()
    {
        ScriptedSlave slave;
        slave.setRegister(0, 0x4711);
        const Result result = call({u"doctor"_s, u"--port"_s, QString::fromStdString(slave.port())});
        QCOMPARE(result.code, int{Link});
        QVERIFY2(result.out.contains("not a CamPanel controller"), result.out.constData());
        QCOMPARE(slave.writes(), 0);
    }

    void strayBytesAreCountedAndExplained()
    {
        ScriptedSlave slave;
        slave.surround({0x00}, {0x00, 0x00});
        const QStringList port{u"--port"_s, QString::fromStdString(slave.port()), u"--format"_s, u"json"_s};
        const Result doctor = call(QStringList{u"doctor"_s} + port);
        QVERIFY2(doctor.code == Ok, doctor.complaint.constData());
        const QJsonObject finding = QJsonDocument::fromJson(doctor.out).array().first().toObject();
        QVERIFY(finding[u"stray_bytes"_s].toInt() >= 3);
        QVERIFY(finding[u"sentence"_s].toString().contains(u"bias resistors"_s));
        const Result link = call(QStringList{u"link"_s, u"--exchanges"_s, u"5"_s} + port);
        QVERIFY2(link.code == Ok, link.complaint.constData());
        const QJsonObject figures = QJsonDocument::fromJson(link.out).object();
        QCOMPARE(figures[u"bytes"_s][u"stray"_s].toInt(), 3 * figures[u"requests"_s].toInt());
    }

    void busyDeviceIsNotTakenForAnother()
    {
        ScriptedSlave slave;
        slave.setException(6);
        const QStringList port{u"--port"_s, QString::fromStdString(slave.port())};
        const Result status = call(QStringList{u"status"_s} + port);
        QCOMPARE(status.code, int{Link});
        QVERIFY2(status.complaint.contains("is busy (Modbus exception 6)"), status.complaint.constData());
        const Result doctor = call(QStringList{u"doctor"_s, u"--format"_s, u"json"_s} + port);
        const QJsonObject finding = QJsonDocument::fromJson(doctor.out).array().first().toObject();
        QCOMPARE(finding[u"condition"_s].toString(), u"refused"_s);
        QCOMPARE(finding[u"exception"_s].toInt(), 6);
    }

    void linkCountsWhatHappens()
    {
        auto slave = std::make_unique<ScriptedSlave>();
        // The identity is read twice before the first status.
        slave->script(
            {Fault::None, Fault::None, Fault::None, Fault::BadChecksum, Fault::None, Fault::LostAnswer});
        const QStringList arguments{u"link"_s,        u"--port"_s, QString::fromStdString(slave->port()),
                                    u"--exchanges"_s, u"20"_s,     u"--format"_s};
        const Result json = call(arguments + QStringList{u"json"_s});
        QVERIFY2(json.code == Ok, json.complaint.constData());
        const QJsonObject figures = QJsonDocument::fromJson(json.out).object();
        QCOMPARE(figures[u"requests"_s].toInt(), 22);
        QCOMPARE(figures[u"answers"_s].toInt(), 20);
        QCOMPARE(figures[u"errors"_s][u"bad_checksum"_s].toInt(), 1);
        QCOMPARE(figures[u"errors"_s][u"no_answer"_s].toInt(), 1);
        QCOMPARE(figures[u"retries"_s].toInt(), 2);
        QVERIFY(figures[u"latency_ms"_s][u"p99"_s].toDouble() >=
                figures[u"latency_ms"_s][u"p50"_s].toDouble());
        const Result csv = call(arguments + QStringList{u"csv"_s});
        QVERIFY2(csv.out.contains("errors.bad_checksum,0\n"), csv.out.constData());
        QVERIFY(csv.out.contains("latency_ms.p99,"));
    }

    void linkOfAPacedLine()
    {
        ControllerProcess controller({u"--baud"_s, u"9600"_s});
        const Result result = call({u"link"_s, u"--port"_s, controller.port(), u"--baud"_s, u"9600"_s,
                                    u"--seconds"_s, u"2"_s, u"--format"_s, u"json"_s});
        QVERIFY2(result.code == Ok, result.complaint.constData());
        const QJsonObject figures = QJsonDocument::fromJson(result.out).object();
        const double share = figures[u"wire_share"_s].toDouble();
        QVERIFY2(share > 0.9 && share <= 1.01, qPrintable(QString::number(share)));
        QVERIFY(figures[u"latency_ms"_s][u"p50"_s].toDouble() > 100);
        QCOMPARE(figures[u"controller"_s][u"crc_errors"_s].toInt(), 0);
        QVERIFY(figures[u"controller"_s][u"requests"_s].toInt() >= 10);
    }

    void framesReadInWords()
    {
        ScriptedSlave slave;
        slave.script({Fault::None, Fault::None, Fault::LateAnswer});
        const Result result =
            call({u"frames"_s, u"--port"_s, QString::fromStdString(slave.port()), u"--seconds"_s, u"0.5"_s});
        QVERIFY2(result.code == Ok, result.complaint.constData());
        QVERIFY(result.out.contains("identity.device_type = 51773"));
        QVERIFY(result.out.contains("response timeout"));
        QVERIFY(result.out.contains("dropped: response to another request"));
        QVERIFY(result.out.contains("exchange.heartbeat = "));
        QVERIFY(result.out.contains("01 03 00 00 00 13 ")); // the bytes as sent
    }
};

CAMPANEL_TEST(CliLineTest)

} // namespace test_line

#include "test_line.moc"
