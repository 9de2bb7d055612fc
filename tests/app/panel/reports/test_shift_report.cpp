// SPDX-License-Identifier: Apache-2.0
// The orders of a shift in its report.
#include "app/panel/reports/shift_report.h"
#include "app/panel/stops/stops.h"
#include "tests/app/panel/access_rig.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_shift_report {

using namespace campanel;
using namespace Qt::StringLiterals;
using store::OrderRow;

class TestShiftReport : public QObject {
    Q_OBJECT

private slots:
    void theOrdersOfTheShiftAreListed()
    {
        test::AccessRig rig;
        panel::Stops stops(rig.machine, rig.settings, rig.records, nullptr);
        stops.setWallClock([&rig] { return rig.wallMs; });
        stops.shift()->setWatched(true);
        rig.settle();
        const panel::Shift shift = stops.shift()->summary().shift;
        QVERIFY(shift.durationMs() > 0);
        OrderRow before{.id = 1, .text = u"4710"_s, .quantity = 10};
        before.state = OrderRow::State::Complete;
        before.startedMs = shift.beginMs - 7'200'000;
        before.endedMs = shift.beginMs - 3'600'000;
        OrderRow present{.id = 2, .text = u"4711"_s, .lot = u"L17"_s, .quantity = 5000};
        present.state = OrderRow::State::Active;
        present.good = 1240;
        present.rejected = 3;
        present.startedMs = shift.beginMs + 1000;
        rig.records.store().run(
            &rig.records,
            [before, present](store::Database& database) {
                return store::OrderLog::write(database, {{before, present}, {}}).has_value();
            },
            [](bool isWritten) { QVERIFY(isWritten); });
        panel::ShiftReport report(rig.machine, stops, rig.records, *rig.maintenance.files(), nullptr);
        panel::ReportData printed;
        report.setPrinter([&printed](const panel::ReportData& data) {
            printed = data;
            return QByteArray("PDF");
        });
        report.offer();
        rig.settle();
        const auto found = std::ranges::find(printed.sections, u"Orders"_s, &panel::ReportSection::title);
        QVERIFY(found != printed.sections.end());
        QCOMPARE(found->rows.size(), 1);
        QCOMPARE(found->rows[0].first, u"4711 · L17"_s);
        QVERIFY2(found->rows[0].second.startsWith(u"1,240 of 5,000, Under way; rejected 3, empty 0"_s),
                 qPrintable(found->rows[0].second));
        QVERIFY(found->lines.isEmpty());
    }

    void aShiftWithoutOrdersSaysSo()
    {
        test::AccessRig rig;
        panel::Stops stops(rig.machine, rig.settings, rig.records, nullptr);
        const panel::ShiftReport report(rig.machine, stops, rig.records, *rig.maintenance.files(), nullptr);
        const QList<panel::ReportSection> sections = report.data().sections;
        const auto found = std::ranges::find(sections, u"Orders"_s, &panel::ReportSection::title);
        QVERIFY(found != sections.end());
        QVERIFY(found->rows.isEmpty());
        QCOMPARE(found->lines, QStringList{u"No order in this shift."_s});
    }
};

CAMPANEL_TEST(TestShiftReport)

} // namespace test_shift_report

#include "test_shift_report.moc"
