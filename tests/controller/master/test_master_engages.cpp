// SPDX-License-Identifier: Apache-2.0
// Random engages and disengages of random programs on random lines. What the axes did is measured from the
// times of their pulses, and compared with the line's true position and with curves on paper:
// - The line that film or axis follow is never faster than its master, and never goes back where it must not.
// - Its acceleration is the clock's ramp at most (`parameter.ramp_time`, the bank's of a cam), and what the
//   master itself does: 4 x (1 - x) ramp + (15 x^2 - 14 x^3) master where it engages, which is at most
//   ramp + 2.55 master.
// - It meets the curve of the master: behind each engage the bags begin where they began behind the first.
// - No pulse is lost or given twice: the main axis stands where its table has it for the film drawn.
#include "line_record.h"

#include "base/ctl_words.h"
#include "master/ctl_master.h"
#include "motion/ctl_start.h"
#include "support/cam_image.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <random>

namespace test_master_engages {

using namespace campanel::test;
using campanel::controller::MachineOptions;

namespace {

constexpr double filmPulseMm = 150.0 / 10'000.0;
constexpr double revolutionMm = 250.0;

enum class Kind { Cutter, PointCam, SegmentCam };

struct Case {
    std::mt19937_64 random;
    Kind kind = Kind::Cutter;
    double cycleS = 0.2;
    double cycleMm = 250.0; // of the line
    double fullMmPerS = 0.0;
    double rampS = 0.8;
    bool goesBack = false;
    double net = 10'000.0; // pulses of the axis a cycle
    double swing = 0.0;    // of a cam
    MachineOptions machine;
    BankImage bank;
    CamImage cam;

    double pick(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }
    [[nodiscard]] bool isCutter() const { return kind == Kind::Cutter; }

    // Returns where the axis of a cam is on paper, the line so many cycles on.
    [[nodiscard]] double axisAt(double cycles) const
    {
        return net * cycles + swing * std::sin(2.0 * M_PI * cycles);
    }
    // Returns the cycles of the line with the axis there; all rise everywhere.
    [[nodiscard]] double cyclesAt(double axis) const
    {
        if (isCutter()) {
            const double whole = std::floor(axis / net);
            double left = axis - whole * net;
            double ticks = 0.0;
            for (const BankRow& row : bank.rows) {
                ticks += row.ticks * std::clamp(left / row.pulses, 0.0, 1.0);
                left -= row.pulses;
            }
            return whole + ticks / bank.cycleTicks();
        }
        double cycles = axis / net;
        for (int i = 0; i < 30; ++i) {
            const double slope = net + 2.0 * M_PI * swing * std::cos(2.0 * M_PI * cycles);
            cycles += (axis - axisAt(cycles)) / slope;
        }
        return cycles;
    }
};

// Returns a knife's table that is nowhere slower than half of its mean speed.
BankImage knifeTable(Case& made, std::uint32_t ticks)
{
    BankImage bank = camBank(10'000, 1, ticks);
    const double phase = made.pick(0.0, 1.0);
    const double depth = made.pick(0.0, 0.5);
    const auto upTo = [&](double x) {
        return x + depth / (2.0 * M_PI) * (std::cos(2.0 * M_PI * phase) - std::cos(2.0 * M_PI * (x + phase)));
    };
    const auto count = static_cast<double>(bank.rows.size());
    for (std::size_t i = 0; i < bank.rows.size(); ++i)
        bank.rows[i].pulses =
            static_cast<std::uint16_t>(std::lround(10'000.0 * upTo(static_cast<double>(i + 1) / count)) -
                                       std::lround(10'000.0 * upTo(static_cast<double>(i) / count)));
    return bank;
}

Case randomCase(std::uint64_t seed)
{
    Case made;
    made.random.seed(seed);
    made.kind = static_cast<Kind>(seed % 3);
    made.rampS = made.whole(200, 2000) / 1000.0;
    made.goesBack = !made.isCutter() && made.whole(0, 1) == 1;
    if (made.isCutter()) {
        made.cycleMm = made.whole(100, 460);
        made.cycleS = made.pick(std::max(0.15, made.cycleMm / 1500.0), 1.5);
    } else {
        made.net = made.whole(2000, 8000);
        made.swing = made.net * made.pick(-0.5, 0.5) / (2.0 * M_PI);
        made.cycleS = made.pick(0.15, 1.5);
    }
    made.cam.masterRate = static_cast<std::int16_t>(made.whole(100, 3000)); // 0.1 r/min
    // The ratio of a cam is in millionths.
    const double turns = std::round(1e6 * made.cycleS * made.cam.masterRate / 600.0) / 1e6;
    if (!made.isCutter()) {
        made.cycleS = turns * 600.0 / made.cam.masterRate;
        made.cycleMm = turns * revolutionMm;
    }
    const auto ticks = static_cast<std::uint32_t>(std::lround(made.cycleS * LineRecord::clockHz));
    made.cycleS = ticks / LineRecord::clockHz;
    made.bank = knifeTable(made, ticks);
    made.bank.bagLengthUm = static_cast<std::uint32_t>(std::lround(made.cycleMm * 1000));
    const std::int16_t rate = made.cam.masterRate;
    made.cam = sineCam(made.net, made.swing, 400, ticks);
    made.cam.masterRate = rate;
    if (made.kind == Kind::SegmentCam) {
        made.cam.kind = CTL_PROGRAM_KIND_SEGMENT_CAM;
        made.cam.segments = 2;
    }
    made.cam.masterRampMs = static_cast<std::uint16_t>(std::lround(made.rampS * 1000));
    made.fullMmPerS = made.cycleMm / made.cycleS;
    auto& shaft = made.machine.shaft;
    constexpr std::array<std::uint32_t, 4> counts{2500, 5000, 10'000, 9973};
    shaft.counts = counts.at(static_cast<std::size_t>(made.whole(0, 3)));
    shaft.accelerationMmPerS2 = made.pick(0.2, 1.0) * made.fullMmPerS / made.rampS;
    shaft.ripple = made.whole(0, 1) * made.pick(0.0, 0.01);
    shaft.rippleHz = made.whole(0, 1) == 0 ? 3.0 : 11.0;
    made.machine.film.slipMm = 0.0;
    return made;
}

// A line that stands, runs or creeps back.
double anySpeed(Case& made)
{
    const int what = made.whole(0, 9);
    if (what < 2)
        return 0.0;
    return what < 4 ? -made.pick(0.005, 0.05) * made.fullMmPerS : made.pick(0.05, 1.05) * made.fullMmPerS;
}

void prepare(Rig& rig, Case& made)
{
    rig.install(made.isCutter() ? made.bank.registers() : made.cam.registers());
    rig.setParameter(CTL_REG_PARAMETER_RAMP_TIME, static_cast<std::uint16_t>(std::lround(made.rampS * 1000)));
    rig.setParameter(CTL_REG_PARAMETER_MARK_TRACKING, 0);
    rig.setParameter(CTL_REG_PARAMETER_ANTI_CUT, 0);
    rig.setParameter(CTL_REG_MASTER_SOURCE, CTL_MASTER_SOURCE_ENCODER);
    QCOMPARE(rig.write(CTL_REG_MASTER_COUNTS, {0, static_cast<std::uint16_t>(made.machine.shaft.counts)}), 0);
    rig.setParameter(CTL_REG_MASTER_ENGAGE, static_cast<std::uint16_t>(made.whole(10, 200)));
    rig.setParameter(CTL_REG_MASTER_SPEED_MAX, 150);
    rig.setParameter(CTL_REG_MASTER_BACKWARD, made.goesBack ? 1 : 0);
}

// The result of a case: the first thing that was wrong, and how near the limits were.
struct Found {
    QString wrong;
    double speed = 0.0;        // over the master's, of what is allowed
    double acceleration = 0.0; // of its limit
    double curve = 0.0;        // off the phase of the first engage, pulses of the axis
    int engages = 0;
    int disengages = 0;
};

class Walk {
public:
    Walk(Rig& rig, Case& made)
        : m_rig(rig)
        , m_case(made)
        , m_record(rig)
        , m_origin(rig.core().motion.commanded)
        , m_film(static_cast<double>(rig.core().packer.film_at) / 256.0)
    {
    }

    Found result(int engages)
    {
        for (int i = 0; i < engages && m_found.wrong.isEmpty(); ++i)
            engageOnce(i);
        if (m_found.wrong.isEmpty() && !m_record.isInOrder())
            m_found.wrong = QStringLiteral("pulses out of order");
        if (m_found.wrong.isEmpty())
            check();
        return m_found;
    }

private:
    auto& shaft() { return m_rig.controller().machine().shaft(); }
    [[nodiscard]] bool isHeld() { return m_rig.core().master.line > m_rig.core().master.wanted; }
    [[nodiscard]] bool isEngaged() { return m_rig.core().master.clutch.state == CTL_CLUTCH_ON; }

    bool waitFor(double longestS, const std::function<bool()>& what)
    {
        for (double timeS = 0.0; timeS < longestS; timeS += LineRecord::sliceS) {
            if (what())
                return true;
            m_record.step();
        }
        return what();
    }

    void engageOnce(int number)
    {
        shaft().setSpeed(anySpeed(m_case));
        m_record.run(m_case.pick(0.1, 2.0));
        const std::uint16_t refusal = ctl_start(&m_rig.core().motion, &m_rig.core().io);
        if (refusal != CTL_REFUSAL_NONE) {
            m_found.wrong = QStringLiteral("start %1 refused: %2").arg(number).arg(refusal);
            return;
        }
        ++m_found.engages;
        m_record.run(m_case.pick(0.0, 2.0));
        for (int i = m_case.whole(0, 2); i > 0; --i) {
            shaft().setSpeed(anySpeed(m_case));
            m_record.run(m_case.pick(0.05, 2.0));
        }
        if (number == 0 || m_case.whole(0, 2) == 0)
            meetCurve();
        disengage();
    }

    // Lets it engage and the line come to rest.
    void meetCurve()
    {
        shaft().setSpeed(m_case.pick(0.3, 1.0) * m_case.fullMmPerS);
        if (!waitFor(30.0 * m_case.cycleS + 20.0 * m_case.rampS,
                     [this] { return isEngaged() && !isHeld(); })) {
            m_found.wrong = QStringLiteral("it does not engage");
            return;
        }
        m_record.run(m_case.pick(0.0, 2.0));
        shaft().setSpeed(0.0);
        m_record.run(10.0 * m_case.rampS + 1.0);
        // Behind the last count, on the table: what is left is its fraction and that of a pulse.
        const double countMm = revolutionMm / m_case.machine.shaft.counts;
        const double countedMm =
            static_cast<double>(shaft().counts()) * countMm; // the position that a count stands for
        const double off = lineMm(static_cast<double>(m_record.axisAtEnd.back())) - countedMm;
        const double cycles = (off - m_phaseMm.value_or(off)) / m_case.cycleMm;
        const double curveMm = std::abs(cycles - std::round(cycles)) * m_case.cycleMm;
        m_phaseMm = m_phaseMm.value_or(off);
        m_found.curve = std::max(m_found.curve, curveMm / pulseMm());
    }

    void disengage()
    {
        const bool isAtEnd = m_case.whole(0, 9) < 7;
        (void)(isAtEnd ? ctl_motion_stop_at_cycle_end(&m_rig.core().motion)
                       : ctl_motion_stop_now(&m_rig.core().motion));
        const double slowestS =
            20.0 * m_case.cycleS + 10.0 * m_case.rampS + 10.0 * m_case.cycleMm / (0.05 * m_case.fullMmPerS);
        if (!waitFor(slowestS, [this] { return m_rig.core().motion.state == CTL_STATE_READY; })) {
            m_found.wrong = QStringLiteral("it does not disengage: state %1, line %2 mm/s")
                                .arg(m_rig.core().motion.state)
                                .arg(shaft().speedMmPerS());
            return;
        }
        ++m_found.disengages;
        const double cycles = lineMm(static_cast<double>(m_record.axisAtEnd.back())) / m_case.cycleMm;
        const double off = std::abs(cycles - std::round(cycles)) * m_case.net;
        if (ctl_table_between_cycles(&m_rig.core().motion.table) && off > 1.0)
            m_found.wrong = QStringLiteral("%1 pulses off the end of a cycle").arg(off);
    }

    // Of the master, of a pulse of the axis where it is slowest.
    [[nodiscard]] double pulseMm() const { return 2.0 * m_case.cycleMm / m_case.net; }
    // Returns where the line is by what the axis did.
    [[nodiscard]] double lineMm(double axis) const
    {
        return m_case.cyclesAt(axis - static_cast<double>(m_origin)) * m_case.cycleMm;
    }

    void check()
    {
        const std::vector<double> axis = m_record.axis();
        std::vector<double> line;
        for (const double each : axis)
            line.push_back(lineMm(each));
        // The film goes with the knife, but for shifts by what the drives lag at a cut.
        for (std::size_t i = 0; m_case.isCutter() && i < line.size(); ++i)
            line[i] = (m_record.filmPulses[i] - m_film) * filmPulseMm;
        checkSpeed(line);
        checkAcceleration(line);
    }

    [[nodiscard]] double countMm() const { return revolutionMm / m_case.machine.shaft.counts; }

    // Over 10 ms, against what the master did up to 60 ms before; a pulse or a count is a step.
    void checkSpeed(const std::vector<double>& line)
    {
        constexpr std::size_t span = 40;
        constexpr std::size_t before = 240;
        constexpr double spanS = span * LineRecord::sliceS;
        const double allowed = 0.01 * m_case.fullMmPerS + (pulseMm() + countMm()) / spanS;
        for (std::size_t i = before + span; i < line.size(); i += span / 4) {
            const auto end = m_record.lineMmPerS.begin() + static_cast<std::ptrdiff_t>(i);
            const double fastest = *std::max_element(end - before - span, end);
            const double slowest = *std::min_element(end - before - span, end);
            const double speed = (line[i] - line[i - span]) / spanS;
            const double over = std::max(speed - std::max(0.0, fastest),
                                         (m_case.goesBack ? std::min(0.0, slowest) : 0.0) - speed);
            m_found.speed = std::max(m_found.speed, over / allowed);
        }
    }

    // Over 50 ms and 50 ms, against what the master did since it engaged or disengaged, and before.
    void checkAcceleration(const std::vector<double>& line)
    {
        constexpr std::size_t span = 200;
        constexpr std::size_t part = span / 4;
        constexpr double spanS = span * LineRecord::sliceS;
        const double ramp = m_case.fullMmPerS / m_case.rampS;
        const double noise = 4.0 * (0.5 * countMm() + 0.25 * pulseMm()) / (spanS * spanS);
        double master = 0.0;
        for (std::size_t i = 4 * span; i < line.size(); i += part) {
            if (m_record.clutch[i] != m_record.clutch[i - part])
                master = 0.0;
            for (std::size_t j = i - 4 * span; j < i; j += part)
                master = std::max(master, std::abs(m_record.lineMmPerS[j + part] - m_record.lineMmPerS[j]) /
                                              (spanS / 4));
            const double measured =
                std::abs(line[i] - 2.0 * line[i - span] + line[i - 2 * span]) / (spanS * spanS);
            const double of = measured / (ramp + 2.55 * master + noise);
            m_found.acceleration = std::max(m_found.acceleration, of);
        }
    }

    Rig& m_rig;
    Case& m_case;
    LineRecord m_record;
    std::int64_t m_origin;
    double m_film;
    Found m_found;
    std::optional<double> m_phaseMm;
};

} // namespace

class TestMasterEngages : public QObject {
    Q_OBJECT

private slots:
    void randomEngagesKeepTheirLimits();
};

void TestMasterEngages::randomEngagesKeepTheirLimits()
{
    constexpr int engagesEach = 10;
    const int cases = std::max(60, qEnvironmentVariableIntValue("CAMPANEL_RANDOM_CASES")) / engagesEach;
    Found all;
    for (int i = 1; i <= cases; ++i) {
        Case made = randomCase(static_cast<std::uint64_t>(i));
        Rig rig(made.machine);
        prepare(rig, made);
        QCOMPARE(rig.command(CTL_COMMAND_HOME), CTL_REFUSAL_NONE);
        QVERIFY(rig.runUntilState(CTL_STATE_READY));
        const Found found = Walk(rig, made).result(engagesEach);
        QVERIFY2(found.wrong.isEmpty(), qPrintable(QStringLiteral("case %1: %2").arg(i).arg(found.wrong)));
        QVERIFY2(
            found.speed <= 1.0 && found.acceleration <= 1.0 && found.curve <= 1.0,
            qPrintable(QStringLiteral("case %1: speed %2 and acceleration %3 of their limits, %4 pulses off")
                           .arg(i)
                           .arg(found.speed)
                           .arg(found.acceleration)
                           .arg(found.curve)));
        all = {{},
               std::max(all.speed, found.speed),
               std::max(all.acceleration, found.acceleration),
               std::max(all.curve, found.curve),
               all.engages + found.engages,
               all.disengages + found.disengages};
    }
    qInfo(
        "%d engages, %d disengages: largest speed over the master %.3f of what is allowed, acceleration %.3f "
        "of its limit, %.2f pulses off the curve",
        all.engages, all.disengages, all.speed, all.acceleration, all.curve);
    QCOMPARE(all.engages, cases * engagesEach);
    QCOMPARE(all.disengages, cases * engagesEach);
}

CAMPANEL_TEST(TestMasterEngages)

} // namespace test_master_engages

#include "test_master_engages.moc"
