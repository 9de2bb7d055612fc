// SPDX-License-Identifier: Apache-2.0
// How far the knife is behind the line that leads it, from the times of its pulses and the line's true
// position, with the lead and without it: over a ramp, a ripple and a stop. With CAMPANEL_LAG the curves are
// written into that file, for docs/draw_lag.py.
#include "line_record.h"

#include "support/cam_image.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTest>
#include <QTextStream>

#include <algorithm>
#include <cmath>

namespace test_master_lag {

using namespace campanel::test;

namespace {

constexpr double bagMm = 250.0;
constexpr double knifePulses = 10'000.0; // a bag, at an even speed
constexpr double fastMmPerS = 1250.0;
constexpr std::uint32_t cycleTicks = 1'600'000; // at this speed

BankImage evenKnife()
{
    BankImage bank = camBank(static_cast<std::uint32_t>(knifePulses), 1, cycleTicks);
    for (BankRow& row : bank.rows)
        row.pulses = static_cast<std::uint16_t>(knifePulses / static_cast<double>(bank.rows.size()));
    return bank;
}

struct Curve {
    std::vector<double> lagMm; // of each slice
    std::vector<double> speedMmPerS;
};

// The line stands, runs up within half a second, ripples and stops.
Curve lagOf(bool isLed)
{
    campanel::controller::MachineOptions options;
    options.shaft = {.counts = 10'000, .accelerationMmPerS2 = 2500.0, .ripple = 0.01};
    Rig rig(options);
    rig.install(evenKnife());
    rig.setParameter(CTL_REG_PARAMETER_MARK_TRACKING, 0);
    rig.setParameter(CTL_REG_PARAMETER_ANTI_CUT, 0);
    rig.setParameter(CTL_REG_MASTER_SOURCE, CTL_MASTER_SOURCE_ENCODER);
    rig.setParameter(CTL_REG_MASTER_LEAD, isLed ? 1 : 0);
    auto& shaft = rig.controller().machine().shaft();
    shaft.setSpeed(100.0);
    rig.run(500'000);
    rig.start();
    for (int i = 0; i < 1000 && rig.core().master.clutch.state != CTL_CLUTCH_ON; ++i)
        rig.run(10'000);
    shaft.setSpeed(0.0);
    rig.run(1'000'000);
    // Where it stands, a count is where its edge is.
    const double atRestMm = static_cast<double>(shaft.counts()) * 250.0 / options.shaft.counts;
    const auto axisAtRest = static_cast<double>(rig.core().motion.commanded);
    LineRecord record(rig);
    record.run(0.1);
    shaft.setSpeed(fastMmPerS);
    record.run(1.9);
    shaft.setSpeed(0.0);
    record.run(0.8);
    Curve curve;
    const std::vector<double> axis = record.axis();
    for (std::size_t i = 0; i < axis.size(); ++i) {
        const double knifeMm = (axis[i] - axisAtRest) / knifePulses * bagMm;
        curve.lagMm.push_back(record.lineMm[i] - atRestMm - knifeMm);
        curve.speedMmPerS.push_back(record.lineMmPerS[i]);
    }
    return curve;
}

double largest(const std::vector<double>& values)
{
    double result = 0.0;
    for (const double value : values)
        result = std::max(result, std::abs(value));
    return result;
}

} // namespace

class TestMasterLag : public QObject {
    Q_OBJECT

private slots:
    void theKnifeIsWhereTheLineIs();
};

void TestMasterLag::theKnifeIsWhereTheLineIs()
{
    const Curve led = lagOf(true);
    const Curve late = lagOf(false);
    qInfo("largest lag %.3f mm, without the lead %.3f mm", largest(led.lagMm), largest(late.lagMm));
    // A slice of 250 us at full speed, and the counting.
    QVERIFY(largest(late.lagMm) > 0.3 && largest(late.lagMm) < 0.4);
    QVERIFY(largest(led.lagMm) < 0.08);
    if (!qEnvironmentVariableIsSet("CAMPANEL_LAG"))
        return;
    QFile file(qEnvironmentVariable("CAMPANEL_LAG"));
    QVERIFY2(file.open(QIODevice::WriteOnly), qPrintable(file.errorString()));
    QTextStream out(&file);
    out << "time_s,line_mm_per_s,without_mm,with_mm\n";
    for (std::size_t i = 0; i < led.lagMm.size(); i += 4)
        out << static_cast<double>(i + 1) * LineRecord::sliceS << ',' << led.speedMmPerS[i] << ','
            << late.lagMm[i] << ',' << led.lagMm[i] << '\n';
}

CAMPANEL_TEST(TestMasterLag)

} // namespace test_master_lag

#include "test_master_lag.moc"
