// SPDX-License-Identifier: Apache-2.0
// The frame log on a fake link: texts, filters, ring, pause, export.
#include "modbus/line/crc16.h"
#include "tests/app/panel/panel_rig.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTest>

#include <algorithm>

namespace test_frame_list {

using namespace campanel;
using modbus::FrameVerdict;
using panel::FrameList;
using test::PanelRig;

namespace {

QString textAt(const QAbstractItemModel& model, int row, int role)
{
    return model.data(model.index(row, 0), role).toString();
}

// Returns a complete frame; its number is one higher than the last one.
modbus::FrameRecord frame(quint64 number, FrameVerdict verdict, std::vector<std::uint8_t> bytes,
                          modbus::RegisterSpan read = {})
{
    modbus::FrameRecord record;
    record.number = number;
    record.at = link::SteadyTime(std::chrono::milliseconds(number));
    record.verdict = verdict;
    record.readAddress = read.address;
    record.readCount = read.count;
    if (!bytes.empty()) {
        const std::uint16_t crc = modbus::crc16(bytes);
        bytes.push_back(static_cast<std::uint8_t>(crc & 0xFF));
        bytes.push_back(static_cast<std::uint8_t>(crc >> 8));
    }
    record.length = static_cast<std::uint16_t>(bytes.size());
    std::ranges::copy(bytes, record.data.begin());
    return record;
}

modbus::FrameRecord statusQuestion(quint64 number)
{
    return frame(number, FrameVerdict::Sent, {1, 23, 1, 0, 0, 40, 2, 0, 0, 3, 6, 0, 5, 0, 42, 0, 0});
}

modbus::FrameRecord startCommand(quint64 number)
{
    return frame(number, FrameVerdict::Sent,
                 {1, 23, 2, 0x30, 0, 4, 2, 0x20, 0, 6, 12, 0, 9, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0});
}

modbus::FrameRecord rampWrite(quint64 number)
{
    return frame(number, FrameVerdict::Sent, {1, 16, 0, 0x82, 0, 1, 2, 3, 0x84});
}

QStringList words(const FrameList& frames)
{
    QStringList all;
    for (int i = 0; i < frames.count(); ++i)
        all << textAt(frames, i, FrameList::WordsRole);
    return all;
}

} // namespace

class TestFrameList : public QObject {
    Q_OBJECT

private slots:
    void framesAreToldInWords()
    {
        PanelRig rig;
        FrameList& frames = *rig.maintenance.frames();
        frames.setWatched(true);
        QVERIFY(rig.link.areFramesWatched);
        emit rig.link.framesRecorded(
            {statusQuestion(1), frame(2, FrameVerdict::Silence, {}), startCommand(3),
             frame(4, FrameVerdict::Answer, {1, 23, 8, 0, 9, 0, 1, 0, 1, 0, 0}, {0x230, 4}), rampWrite(5),
             frame(6, FrameVerdict::Answer, {1, 16, 0, 0x82, 0, 1}),
             frame(7, FrameVerdict::Sent, {1, 3, 0x10, 0, 0, 2}),
             frame(8, FrameVerdict::Exception, {1, 0x83, 2})});
        const QStringList all{"Status request, heartbeat 42",
                              "Response timeout",
                              "Command Start, counter 9",
                              "Command Start: Done",
                              "Write parameter.ramp_time = 900 ms",
                              "Response: done",
                              "Read 0x1000, count 2",
                              "Exception 2: illegal register address"};
        QCOMPARE(words(frames), all);
        frames.setFilter(FrameList::Filter::Errors);
        QCOMPARE(words(frames), (QStringList{all[0], all[1], all[6], all[7]}));
        frames.setFilter(FrameList::Filter::Commands);
        QCOMPARE(words(frames), all.mid(2, 2));
        frames.setFilter(FrameList::Filter::Writes);
        QCOMPARE(words(frames), all.mid(4, 2));
        frames.showDetail(0);
        QCOMPARE(frames.detailBytes(), "01 10 00 82 00 01 02 03 84 B8 E1");
        QVERIFY(frames.detailLines().contains("parameter.ramp_time = 900 ms"));
        QVERIFY(!frames.hasPrevious() && frames.hasNext());
        frames.showNext();
        QVERIFY(!frames.hasNext());
        // A question is listed with its error, even if the error comes later.
        frames.setFilter(FrameList::Filter::Errors);
        emit rig.link.framesRecorded({statusQuestion(9)});
        QCOMPARE(frames.count(), 4);
        emit rig.link.framesRecorded({frame(10, FrameVerdict::Incomplete, {1, 23})});
        QCOMPARE(frames.count(), 6);
    }

    void framesNeverGrow()
    {
        PanelRig rig;
        FrameList& frames = *rig.maintenance.frames();
        frames.setWatched(true);
        quint64 number = 0;
        for (int batch = 0; batch < 100; ++batch) {
            QList<modbus::FrameRecord> records;
            for (int i = 0; i < 50; ++i)
                records << statusQuestion(++number);
            emit rig.link.framesRecorded(records);
        }
        QCOMPARE(frames.count(), static_cast<int>(FrameList::capacity));
        frames.showDetail(frames.count() - 1);
        QVERIFY(frames.hasPrevious() && !frames.hasNext());
        frames.setFilter(FrameList::Filter::Errors);
        QCOMPARE(frames.count(), 0);
        frames.setFilter(FrameList::Filter::All);
        frames.clear();
        QCOMPARE(frames.count(), 0);
        emit rig.link.framesRecorded({statusQuestion(number), statusQuestion(number + 1)});
        QCOMPARE(frames.count(), 1); // the first one was cleared
    }

    void aPauseHoldsTheFrames()
    {
        PanelRig rig;
        FrameList& frames = *rig.maintenance.frames();
        frames.setWatched(true);
        emit rig.link.framesRecorded({statusQuestion(1)});
        frames.setPaused(true);
        QVERIFY(!rig.link.areFramesWatched);
        emit rig.link.framesRecorded({statusQuestion(2)}); // arrived late
        QCOMPARE(frames.count(), 1);
        frames.setPaused(false);
        QVERIFY(rig.link.areFramesWatched);
        emit rig.link.framesRecorded({statusQuestion(1), statusQuestion(2), statusQuestion(3)});
        QCOMPARE(frames.count(), 3);
        frames.setWatched(false);
        QVERIFY(!rig.link.areFramesWatched);
    }

    void framesAreWrittenAsText()
    {
        PanelRig rig;
        FrameList& frames = *rig.maintenance.frames();
        frames.setWatched(true);
        emit rig.link.framesRecorded({statusQuestion(1), rampWrite(2)});
        frames.setFilter(FrameList::Filter::Writes);
        panel::ReportFiles& files = *rig.maintenance.files();
        files.setScanner([](const QString& folder) { return store::exchangePlaces(folder).last(1); });
        frames.exportText();
        QTRY_VERIFY(!files.busy());
        files.write(0);
        QTRY_VERIFY(!files.busy());
        QFile file(rig.folder.filePath(QStringLiteral("reports/link frames.txt")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray text = file.readAll();
        QVERIFY2(text.contains("parameter.ramp_time = 900") && !text.contains("exchange.tag"),
                 text.constData());
    }
};

CAMPANEL_TEST(TestFrameList)

} // namespace test_frame_list

#include "test_frame_list.moc"
