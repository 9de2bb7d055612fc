// SPDX-License-Identifier: Apache-2.0
// The audit trail of actions at the panel, with a fake link, and its display.
#include "app/panel/audit/audit_words.h"
#include "tests/app/panel/access_rig.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>

namespace test_audit {

using namespace campanel;
using panel::Access;
using test::AccessRig;
using namespace Qt::StringLiterals;
using store::AuditEntry;

namespace {

const AuditEntry* find(const QList<AuditEntry>& entries, const QString& what, const QString& object = {})
{
    for (const AuditEntry& entry : entries) {
        if (entry.what == what && (object.isEmpty() || entry.object == object))
            return &entry;
    }
    return nullptr;
}

} // namespace

class TestAudit : public QObject {
    Q_OBJECT

private slots:
    void clockThatWasSetBackOrNotSetIsMarked()
    {
        AccessRig rig;
        AuditEntry noted;
        noted.what = u"command.other"_s;
        noted.outcome = u"done"_s;
        rig.trail.open();
        rig.trail.note(noted);
        QVERIFY(!rig.entries().last().isClockDoubtful);
        rig.wallMs -= 3'600'000;
        rig.trail.note(noted);
        QVERIFY(rig.entries().last().isClockDoubtful);
        rig.wallMs += 7'200'000;
        rig.trail.note(noted);
        QVERIFY(!rig.entries().last().isClockDoubtful);
        rig.records.setClockState([] { return store::ClockState::NotSet; });
        rig.trail.note(noted);
        QVERIFY(rig.entries().last().isClockDoubtful);
    }

    void commandsAreWrittenWithTheirOutcome()
    {
        AccessRig rig;
        rig.connectRunning();
        rig.addAnnaAndBo();
        rig.logIn(u"Bo"_s, u"1470"_s);
        rig.machine.stop();
        rig.machine.resetFault();
        QVERIFY(!find(rig.entries(), u"command.stop"_s)); // only after its end
        for (const link::CommandRequest& request : rig.link.requests) {
            link::CommandOutcome outcome{
                request.id, request.command, link::CommandEnd::Done, modbus::Refusal::None, {}};
            if (request.command == modbus::Command::ResetFault)
                outcome = {request.id,
                           request.command,
                           link::CommandEnd::Refused,
                           modbus::Refusal::NotStandstill,
                           {}};
            emit rig.link.commandEnded(outcome);
        }
        const auto entries = rig.entries();
        const AuditEntry* stop = find(entries, u"command.stop"_s);
        QVERIFY(stop);
        QCOMPARE(stop->who, u"Bo"_s);
        QCOMPARE(stop->level, 2);
        QCOMPARE(stop->object, u"Biscuit 250"_s);
        QCOMPARE(stop->timeMs, rig.wallMs);
        QCOMPARE(stop->outcome, u"done"_s);
        const AuditEntry* reset = find(entries, u"command.reset"_s);
        QVERIFY(reset);
        QCOMPARE(reset->outcome, u"refused %1"_s.arg(static_cast<int>(modbus::Refusal::NotStandstill)));
    }

    void parametersAreWrittenWithOldNewAndProof()
    {
        AccessRig rig;
        rig.connectRunning();
        rig.addAnnaAndBo();
        rig.logIn(u"Bo"_s, u"1470"_s);
        rig.link.parameters.clear();
        const std::string name = "parameter.mark_distance";
        rig.maintenance.packing()->fields()->write(name.c_str(), 903.02);
        QCOMPARE(rig.link.parameters.size(), 2); // read first, then written
        QVERIFY(!rig.link.parameters[0].value);
        QCOMPARE(rig.link.parameters[1].value, 903.02);
        emit rig.link.parameterEnded({rig.link.parameters[0].id, name, link::ParameterEnd::Done, 900.0, {}});
        emit rig.link.parameterEnded({rig.link.parameters[1].id, name, link::ParameterEnd::Done, 903.0, {}});
        rig.maintenance.packing()->fields()->write(name.c_str(), 905);
        emit rig.link.parameterEnded({rig.link.parameters[2].id, name, link::ParameterEnd::NotSent, {}, {}});
        emit rig.link.parameterEnded({rig.link.parameters[3].id, name, link::ParameterEnd::NotSent, {}, {}});
        const auto entries = rig.entries();
        const AuditEntry* done = find(entries, u"parameter.write"_s);
        QVERIFY(done);
        QCOMPARE(done->object, u"parameter.mark_distance"_s);
        QCOMPARE(done->before, u"900"_s);
        QCOMPARE(done->after, u"903.02"_s);
        QCOMPARE(done->readBack, u"903"_s);
        QCOMPARE(done->who, u"Bo"_s);
        QCOMPARE(panel::AuditWords::object(*done), u"Mark sensor to knife"_s);
        const AuditEntry& last = entries.last();
        QCOMPARE(last.what, u"parameter.write"_s);
        QCOMPARE(last.before, QString());
        QCOMPARE(last.readBack, QString());
        QCOMPARE(last.outcome, u"not_sent"_s);
    }

    void aDownloadIsWrittenWithItsValuesAndProof()
    {
        AccessRig rig;
        rig.connectRunning();
        const std::uint32_t crcBefore = rig.image().crc;
        rig.editor.bagLength()->set(260);
        rig.editor.rate()->set(70);
        rig.editor.download();
        const auto image = rig.image();
        link::DownloadReport report;
        report.stage = link::DownloadStage::Active;
        report.crc = image.crc;
        report.fraction = 1;
        emit rig.link.downloadReported(report);
        QVERIFY(!find(rig.entries(), u"program.download"_s)); // the controller's status has not arrived
        rig.link.activate(image, rig.now);
        const auto entries = rig.entries();
        const AuditEntry* program = find(entries, u"program.download"_s);
        QVERIFY(program);
        const auto hex = [](std::uint32_t crc) {
            return QString::number(crc, 16).toUpper().rightJustified(8, u'0');
        };
        QCOMPARE(program->before, u"Biscuit 250 · v1 · CRC-32 "_s + hex(crcBefore));
        QCOMPARE(program->after, u"Biscuit 250 · v2 · CRC-32 "_s + hex(image.crc));
        QCOMPARE(program->readBack,
                 u"generation %1 · CRC-32 %2"_s.arg(rig.link.status.generation).arg(hex(image.crc)));
        const AuditEntry* length = find(entries, u"program.value"_s, u"program.bag_length"_s);
        QVERIFY(length);
        QCOMPARE(length->before, u"250"_s);
        QCOMPARE(length->after, u"260"_s);
        QCOMPARE(length->readBack, program->readBack);
        const AuditEntry* rate = find(entries, u"program.value"_s, u"program.rate"_s);
        QVERIFY(rate);
        QCOMPARE(rate->after, u"70"_s);
    }

    void aFailedDownloadIsOneRow()
    {
        AccessRig rig;
        rig.connectRunning();
        rig.editor.bagLength()->set(260);
        rig.editor.download();
        link::DownloadReport report;
        report.stage = link::DownloadStage::Failed;
        report.isConnectionMissing = true;
        emit rig.link.downloadReported(report);
        const auto entries = rig.entries();
        QCOMPARE(entries.size(), 1);
        QCOMPARE(entries.first().outcome, u"failed"_s);
        QVERIFY(entries.first().readBack.isEmpty());
    }

    void settingsAndUsersAreWritten()
    {
        AccessRig rig;
        rig.settings.set("display.theme", u"dark"_s);
        rig.settings.set("bags.tolerance_mm", panel::settingText(1.25));
        rig.settings.set("stops.shift_starts", u"05:00 17:00"_s);
        rig.settings.set("stops.working_days", u"12345"_s);
        rig.settings.set("stops.reasons", u"Foil\nplanned:Break"_s);
        rig.settings.setSimulated(false);
        rig.settings.setPortName(u"/dev/ttyUSB0"_s);
        rig.settings.applyConnection();
        rig.add(u"Anna"_s, Access::Service, u"258036"_s);
        rig.add(u"Bo"_s, Access::Technician, u"1470"_s);
        rig.access.logOut();
        rig.logIn(u"Bo"_s, u"9999"_s);
        rig.logIn(u"Anna"_s, u"258036"_s);
        rig.access.changeLevel(rig.idOf(u"Bo"_s), Access::Operator);
        rig.settle();
        rig.access.removeUser(rig.idOf(u"Bo"_s));
        const auto entries = rig.entries();
        const AuditEntry* theme = find(entries, u"setting.change"_s, u"theme"_s);
        QVERIFY(theme && theme->before == u"light" && theme->after == u"dark" && theme->who.isEmpty());
        const AuditEntry* tolerance = find(entries, u"setting.change"_s, u"bag_tolerance_mm"_s);
        QVERIFY(tolerance && tolerance->before == u"0.5" && tolerance->after == u"1.25");
        const AuditEntry* shifts = find(entries, u"setting.change"_s, u"shift_starts"_s);
        QVERIFY(shifts && shifts->before == u"06:00 14:00 22:00" && shifts->after == u"05:00 17:00");
        QCOMPARE(panel::AuditWords::object(*shifts), u"start of the shifts"_s);
        QVERIFY(find(entries, u"setting.change"_s, u"working_days"_s));
        const AuditEntry* reasons = find(entries, u"setting.change"_s, u"reasons"_s);
        QVERIFY(reasons);
        QCOMPARE(panel::AuditWords::change(*reasons), u"Foil, planned:Break"_s);
        const AuditEntry* connection = find(entries, u"setting.change"_s, u"connection"_s);
        QVERIFY(connection);
        QCOMPARE(connection->after, u"/dev/ttyUSB0 115200 8N1 unit 1"_s);
        QVERIFY(find(entries, u"user.add"_s, u"Anna"_s));
        const AuditEntry* wrong = find(entries, u"user.login"_s, u"Bo"_s);
        QVERIFY(wrong && wrong->outcome == u"wrong_pin" && wrong->who.isEmpty());
        const AuditEntry* level = find(entries, u"user.level"_s, u"Bo"_s);
        QVERIFY(level && level->before == u"technician" && level->after == u"operator");
        QCOMPARE(level->who, u"Anna"_s);
        QVERIFY(find(entries, u"user.remove"_s, u"Bo"_s));
        for (const AuditEntry& entry : entries) {
            for (const QString& text : {entry.before, entry.after, entry.object, entry.readBack})
                QVERIFY(!text.contains(u"258036") && !text.contains(u"1470"));
        }
    }

    void whatOthersNoteGetsTimeAndPerson()
    {
        AccessRig rig;
        rig.addAnnaAndBo();
        rig.logIn(u"Bo"_s, u"1470"_s);
        AuditEntry noted;
        noted.what = u"alarm.acknowledge"_s;
        noted.object = u"film.torn"_s;
        noted.outcome = u"done"_s;
        rig.trail.note(noted);
        const AuditEntry last = rig.entries().last();
        QCOMPARE(last.what, u"alarm.acknowledge"_s);
        QCOMPARE(last.who, u"Bo"_s);
        QCOMPARE(last.timeMs, rig.wallMs);
    }

    void theTrailIsShownPageByPage()
    {
        AccessRig rig;
        for (int i = 0; i < 250; ++i) {
            AuditEntry noted;
            noted.what = i % 2 == 0 ? u"setting.change"_s : u"command.start"_s;
            noted.object = QString::number(i);
            noted.outcome = u"done"_s;
            rig.trail.note(noted);
        }
        rig.audit.open();
        rig.settle();
        QTRY_VERIFY(!rig.audit.checking());
        QCOMPARE(rig.audit.rows()->count(), store::logPageRows);
        QVERIFY2(rig.audit.chainText().contains(u"250"), qPrintable(rig.audit.chainText()));
        QVERIFY(!rig.audit.broken());
        rig.audit.rows()->fetchMore({});
        rig.settle();
        rig.audit.rows()->fetchMore({});
        rig.settle();
        rig.audit.rows()->fetchMore({});
        rig.settle();
        QCOMPARE(rig.audit.rows()->count(), 250);
        rig.audit.setArea(u"command"_s);
        rig.settle();
        rig.audit.rows()->fetchMore({});
        rig.settle();
        QCOMPARE(rig.audit.rows()->count(), 125);
        QCOMPARE(rig.audit.rows()->row(0).object(), u"249"_s);
        rig.machine.stop();
        emit rig.link.commandEnded({rig.link.requests.last().id,
                                    modbus::Command::StopAtCycleEnd,
                                    link::CommandEnd::Done,
                                    modbus::Refusal::None,
                                    {}});
        rig.settle();
        QCOMPARE(rig.audit.rows()->count(), 126); // new rows appear at once
        rig.audit.select(0);
        QCOMPARE(rig.audit.detailTitle(), u"Stop"_s);
        rig.audit.setWho(u"Anna"_s);
        rig.settle();
        QCOMPARE(rig.audit.rows()->count(), 0);
    }

    void filesAndDiagnosesAreInTheTrail()
    {
        AccessRig rig;
        rig.trail.noteExport({u"/stick/alarms.csv"_s, u"/stick/more.csv"_s}, {});
        rig.trail.noteExport({}, u"full"_s);
        rig.maintenance.doctor()->diagnose();
        rig.maintenance.figures()->reset();
        rig.machine.accessCheck().setLevel(panel::Level::Viewer);
        rig.maintenance.doctor()->search();
        rig.maintenance.figures()->reset();
        QStringList rows;
        for (const AuditEntry& entry : rig.entries())
            rows << QStringList{entry.what, entry.object, entry.after, entry.outcome}.join(u'|');
        QCOMPARE(rows,
                 (QStringList{u"export.write|/stick/alarms.csv|2 files|done"_s, u"export.write|||failed"_s,
                              u"line.diagnose|connection||done"_s, u"line.reset|||done"_s}));
    }

    void aBrokenChainIsTold()
    {
        AccessRig rig;
        rig.settings.set("display.theme", u"dark"_s);
        rig.settings.set("display.theme", u"light"_s);
        rig.settle();
        rig.records.store().run(
            &rig.records,
            [](store::Database& database) {
                return database.execute(u"UPDATE audit SET who = 'Eve' WHERE sequence = 1"_s).has_value();
            },
            [](bool isDone) { QVERIFY(isDone); });
        rig.audit.check();
        QTRY_VERIFY(!rig.audit.checking());
        QVERIFY(rig.audit.broken());
        QVERIFY2(rig.audit.chainText().startsWith(u"Row 1 "), qPrintable(rig.audit.chainText()));
    }

    void theTrailIsTakenAwayAsCsv()
    {
        AccessRig rig;
        rig.settings.set("display.theme", u"dark"_s);
        AuditEntry noted;
        noted.what = u"setting.change"_s;
        noted.object = u"a \"quoted\", name"_s;
        noted.outcome = u"done"_s;
        rig.trail.note(noted);
        rig.settle();
        const QString folder = rig.folder.path();
        panel::ReportFiles& files = *rig.maintenance.files();
        files.setScanner([folder](const QString&) {
            return QList<store::Place>{{folder, u"stick"_s, false}};
        });
        rig.audit.log()->csv()->make(&files);
        rig.settle();
        QTRY_VERIFY(!files.busy() && files.places()->count() == 1);
        files.write(0);
        QTRY_VERIFY(!files.busy() && !files.message().isEmpty());
        QVERIFY2(!files.failed(), qPrintable(files.message()));
        const QStringList found = QDir(folder).entryList({u"*.csv"_s});
        QCOMPARE(found.size(), 1);
        QFile file(QDir(folder).filePath(found.first()));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = file.readAll().trimmed().split('\n');
        QCOMPARE(lines.size(), 3);
        QVERIFY(lines[1].contains("\"a \"\"quoted\"\", name\""));
        QVERIFY(lines[2].contains(",theme,light,dark,"));
    }
};

CAMPANEL_TEST(TestAudit)

} // namespace test_audit

#include "test_audit.moc"
