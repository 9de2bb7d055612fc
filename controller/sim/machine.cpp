// SPDX-License-Identifier: Apache-2.0
#include "machine.h"

#include "base/ctl_words.h"
#include "engine/ctl_press.h"
#include "engine/ctl_step.h"
#include "packer/ctl_feed.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace campanel::controller {
namespace {

constexpr double fullCircle = 36000.0;  // bank angles in 0.01 degrees
constexpr double sameRevolution = 1e-6; // pulses
// The sizes of what the pins see.
constexpr double indexMarkShare = 0.01; // of a revolution
constexpr double degreesPerTurn = 360.0;
constexpr double slowestPulses = 1.0; // per second; slower ones have no friction
constexpr double driftS = 600.0;      // of the friction, there and back
constexpr double tenthsPerPercent = 10.0;
constexpr double limitShare = 0.99; // of the maximum torque, from which the drive says so

constexpr std::uint16_t pinBit(unsigned number)
{
    return static_cast<std::uint16_t>(1u << number);
}

double wide(const ctl_bank& bank, unsigned offset)
{
    return ctl_get32(&bank.registers[offset]);
}

// Returns the pulses of one turn of the knife shaft.
double knifeRevolution(const ctl_bank& bank)
{
    return wide(bank, CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV) *
           bank.registers[CTL_OFFSET_PROGRAM_GEAR_NUMERATOR] /
           bank.registers[CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR];
}

double shareOf(double position, double before, double now)
{
    return now > before ? std::clamp((position - before) / (now - before), 0.0, 1.0) : 1.0;
}

// Returns the pulses of the table from the start of the cycle to a master angle.
double pulsesAtAngle(const ctl_bank& bank, double angle)
{
    double ticks = wide(bank, CTL_OFFSET_BANK_CYCLE_TICKS) * angle / fullCircle;
    double pulses = 0.0;
    for (std::uint32_t i = 0; i < ctl_bank_row_count(&bank) && ticks > 0.0; ++i) {
        const ctl_row row = ctl_step_row(&bank, i);
        const double part = std::min(1.0, ticks / row.ticks);
        pulses += part * row.pulses;
        ticks -= row.ticks;
    }
    return pulses;
}

} // namespace

Machine::Machine(const MachineOptions& options)
    : m_options(options)
    , m_inputs(options.inputs)
    , m_outputs(pinBit(CTL_OUTPUT_BIT_DRIVE_ENABLE))
    , m_main(options.servoBandwidthHz)
    , m_filmMotor(options.feedBandwidthHz)
    , m_infeedMotor(options.feedBandwidthHz)
    , m_indexRandom(options.seed ^ 0xC2B2AE3D27D4EB4Fu)
    , m_film(options.film, options.seed)
    , m_infeed(options.products, options.seed)
    , m_shaft(options.shaft)
    , m_markSensor(options.sensors, options.seed ^ 0xA0761D6478BD642Fu)
    , m_eye(options.sensors, options.seed ^ 0xE7037ED1A0B428DBu)
    , m_jaws(options.jaws, options.seed ^ 0x8EBC6AF09C88C6E3u)
    , m_report(options.report, options.seed ^ 0x589965CC75374CC3u)
{
    m_mark = -m_revolution * options.startAngleDegrees / 360.0;
    setReversed(0);
    switchDrives();
}

void Machine::setReversed(unsigned axes)
{
    const unsigned other = static_cast<unsigned>(m_options.reversed) ^ axes;
    const std::array<const Servo*, Axes> motors{&m_main, &m_filmMotor, &m_infeedMotor};
    for (unsigned axis = 0; axis < Axes; ++axis)
        m_ways[axis].setReversed((other & 1u << axis) != 0, motors[axis]->position());
}

void Machine::commandMotor(Servo& servo, Axis axis, std::int64_t pulses)
{
    servo.command(m_ways[axis].isReversed() ? -pulses : pulses);
}

void Machine::commandFeed(ctl_axis axis, std::int64_t from, std::int64_t to)
{
    const bool isFilm = axis == CTL_AXIS_FILM;
    commandMotor(isFilm ? m_filmMotor : m_infeedMotor, isFilm ? FilmRoll : Flights,
                 ctl_whole_pulses(to) - ctl_whole_pulses(from));
}

void Machine::standStill(const ByHand& byHand)
{
    m_main.turnByHand(byHand.turns * m_revolution);
    m_filmMotor.turnByHand(0.0);
    m_infeedMotor.turnByHand(byHand.products * m_options.flightPulses);
    m_film.pull(byHand.filmMm);
    m_materialAtCutMm.reset();
}

void Machine::setDriveOn(bool on)
{
    m_hasPower = on;
    switchDrives();
}

void Machine::setOutputs(std::uint32_t levels)
{
    const unsigned begins = levels & ~m_outputs;
    m_outputs = levels;
    if ((begins & 1u << CTL_OUTPUT_BIT_CODER_PULSE) != 0)
        m_coderPulseMm = drawnMm();
    switchDrives();
}

void Machine::setInput(unsigned number, bool isOn)
{
    m_inputs = static_cast<std::uint16_t>(isOn ? m_inputs | pinBit(number) : m_inputs & ~pinBit(number));
    switchDrives();
}

void Machine::switchDrives()
{
    const bool isEnabled = areDrivesOn();
    m_main.setDriveOn(isEnabled && m_hasPower && (m_inputs & pinBit(CTL_INPUT_BIT_DRIVE_ALARM)) == 0);
    m_filmMotor.setDriveOn(isEnabled);
    m_infeedMotor.setDriveOn(isEnabled);
}

bool Machine::areDrivesOn() const
{
    return (m_outputs & pinBit(CTL_OUTPUT_BIT_DRIVE_ENABLE)) != 0;
}

std::uint16_t Machine::inputs() const
{
    const double turns = (m_main.position() - m_mark) / m_revolution;
    unsigned levels = m_inputs;
    if (!m_ram && turns - std::floor(turns) < indexMarkShare)
        levels |= pinBit(CTL_INPUT_BIT_INDEX_MARK);
    if (m_filmIndex.isOn)
        levels |= pinBit(CTL_INPUT_BIT_FILM_INDEX);
    if (m_infeedIndex.isOn)
        levels |= pinBit(CTL_INPUT_BIT_INFEED_INDEX);
    if (m_hasKnife && m_isMarkThere)
        levels |= pinBit(CTL_INPUT_BIT_MARK_SENSOR);
    if (m_hasKnife && m_isEyeCovered)
        levels |= pinBit(CTL_INPUT_BIT_PRODUCT_EYE);
    const DriveOptions& drive = m_options.drive;
    if (!m_jaws.areIdle() && std::abs(driveTorqueNm()) > limitShare * drive.peakTorque * drive.ratedTorqueNm)
        levels |= pinBit(CTL_INPUT_BIT_TORQUE_LIMIT);
    return static_cast<std::uint16_t>(levels);
}

std::int32_t Machine::torqueTenthPercent() const
{
    return static_cast<std::int32_t>(std::lround(tenthsPerPercent * m_report.percent()));
}

double Machine::shaftDegrees() const
{
    return 360.0 * m_main.position() / m_revolution;
}

double Machine::driveTorqueNm() const
{
    const DriveOptions& drive = m_options.drive;
    const double radiansPerPulse = 2.0 * std::numbers::pi / m_revolution;
    const double drift = 1.0 + drive.frictionDrift * std::sin(2.0 * std::numbers::pi * m_timeS / driftS);
    const double friction = std::abs(m_main.speed()) < slowestPulses
                                ? 0.0
                                : std::copysign(drive.frictionNm * drift, m_main.speed());
    return drive.inertiaKgM2 * m_main.acceleration() * radiansPerPulse + friction;
}

// The jaws press against the shaft, and the drive has a maximum torque.
void Machine::loadShaft(double stepS)
{
    m_timeS += stepS;
    const double inertia = m_options.drive.inertiaKgM2;
    if (!m_hasKnife || inertia <= 0.0 || m_jaws.areIdle()) {
        m_main.setLoad(0.0, std::numeric_limits<double>::infinity());
        return;
    }
    const double stroke = nearestCut();
    const double degrees = 360.0 * (m_main.position() - positionOfCut(stroke)) / m_revolution;
    const double radiusMm = m_revolution / (2.0 * std::numbers::pi * m_pulsesPerMm);
    const double pulsesPerNm = m_revolution / (2.0 * std::numbers::pi * inertia);
    m_main.setLoad(-m_jaws.moveTo(degrees, stroke, radiusMm) * pulsesPerNm,
                   m_options.drive.peakTorque * m_options.drive.ratedTorqueNm * pulsesPerNm);
}

void Machine::setProgram(const ctl_bank& bank)
{
    const std::uint16_t kind = ctl_bank_kind(&bank);
    m_hasKnife = kind == CTL_PROGRAM_KIND_ROTARY_CUTTER;
    const double revolution = m_hasKnife ? knifeRevolution(bank) : ctl_bank_revolution_pulses(&bank, 1);
    turnBy(m_options.knifePulses > 0.0 ? m_options.knifePulses : revolution);
    if (m_hasKnife)
        setKnife(bank);
    else
        forgetLastCut();
    if (kind == CTL_PROGRAM_KIND_PRESS)
        setPress(bank);
    else
        m_ram.reset();
}

// Sets the pulses between two index marks; the shaft keeps its angle.
void Machine::turnBy(double revolution)
{
    const double revolutions = (m_main.position() - m_mark) / m_revolution;
    if (std::abs(revolution - m_revolution) > sameRevolution) {
        m_revolution = revolution;
        m_mark = m_main.position() - revolutions * revolution;
    }
}

// Another press starts with its ram up.
void Machine::setPress(const ctl_bank& bank)
{
    const double pulseMm =
        wide(bank, CTL_OFFSET_PRESS_FEED) / umPerMm / wide(bank, CTL_OFFSET_PRESS_PULSES_PER_MOTOR_REV);
    if (m_ram && pulseMm == m_pulseMm)
        return;
    m_ram.emplace(m_options.press, m_options.seed);
    m_pulseMm = pulseMm;
    m_top = m_main.position();
}

// The film is printed for the program's bags, and in register.
void Machine::setKnife(const ctl_bank& bank)
{
    m_stroke = m_revolution / bank.registers[CTL_OFFSET_PROGRAM_KNIVES];
    m_cutOffset =
        pulsesAtAngle(bank, bank.registers[CTL_OFFSET_BANK_CUT_ANGLE]) * m_revolution / knifeRevolution(bank);
    const double radiusMm = wide(bank, CTL_OFFSET_PROGRAM_KNIFE_RADIUS) / umPerMm;
    m_pulsesPerMm = m_revolution / (2.0 * std::numbers::pi * radiusMm);
    const double bagMm = wide(bank, CTL_OFFSET_PROGRAM_BAG_LENGTH) / umPerMm;
    const double cutShare = bank.registers[CTL_OFFSET_BANK_CUT_ANGLE] / fullCircle;
    m_film.load(bagMm, bagMm * cutShare, m_feed.filmMm);
    if (m_options.shaft.drivesFilm)
        layOnPrint();
    m_infeed.load(bagMm, m_feed.products);
}

// A product is laid half a bag from the cuts when a printed cut is at the knife.
void Machine::layOnPrint()
{
    const double bags = m_film.bagsAt(m_film.drawnMm(m_feed.filmMm));
    m_firstProduct = std::ceil(m_feed.products - bags) + 0.5;
    m_feed.products = m_firstProduct + bags;
}

// Forward by the encoder, whose counts have the sign of the command.
void Machine::passIndex()
{
    const double mark = m_ways[Knife].commanded(m_mark);
    const double turns = std::floor((m_ways[Knife].commanded(m_main.position()) - mark) / m_revolution);
    if (turns > std::floor((m_ways[Knife].commanded(m_main.positionBefore()) - mark) / m_revolution))
        m_index = std::llround(mark + turns * m_revolution);
}

void Machine::turnIndexMark(IndexMark& mark, double turns)
{
    const double turn = std::round(turns);
    if (turn != mark.turn)
        mark.offTurns = m_options.indexScatterDegrees / degreesPerTurn * m_normal(m_indexRandom);
    mark.turn = turn;
    const double beyond = turns - turn - mark.offTurns;
    mark.isOn = beyond >= 0.0 && beyond < indexMarkShare;
}

double Machine::rollMm(double pulses) const
{
    return pulses / m_options.filmPulses * m_options.filmFeedMm;
}

// Somebody else's film goes on whatever the knife does, and their infeed lays a product on each printed bag.
void Machine::moveFeeds(double stepS)
{
    m_feedBefore = m_feed;
    m_feed.counts = m_shaft.counts();
    if (m_options.shaft.drivesFilm) {
        const double passed = m_shaft.positionMm() - m_shaftMm;
        m_shaftMm = m_shaft.positionMm();
        m_feed.filmMm += passed;
        m_feed.products = m_firstProduct + m_film.bagsAt(m_film.drawnMm(m_feed.filmMm));
        m_feed.filmMmPerS = m_shaft.speedMmPerS();
        return;
    }
    m_filmMotor.advance(stepS);
    m_infeedMotor.advance(stepS);
    m_feed.filmMm = rollMm(m_filmMotor.position());
    m_feed.products = m_infeedMotor.position() / m_options.flightPulses;
    m_feed.filmMmPerS = rollMm(m_filmMotor.speed());
    turnIndexMark(m_filmIndex, m_filmMotor.position() / m_options.filmPulses);
    turnIndexMark(m_infeedIndex, m_feed.products);
}

// Returns what is latched at this share of the last step, where an axis is at `fine`, 1/256 pulse.
std::int64_t Machine::latched(double share, double fine) const
{
    if (!m_latchesMaster)
        return std::llround(fine);
    const auto counts = static_cast<double>(m_feed.counts - m_feedBefore.counts);
    return m_feedBefore.counts + static_cast<std::int64_t>(std::floor(share * counts));
}

void Machine::moveFilm(double stepS)
{
    const double before = m_feedBefore.filmMm;
    const double now = m_feed.filmMm;
    const double drawnBefore = m_film.drawnMm(before);
    m_film.drawTo(now, m_filmAcceleration.step(m_feed.filmMmPerS / mmPerM, stepS));
    Film::Edge mark;
    while (m_film.takeEdge(mark))
        m_markSensor.pass(mark.rollMm, mark.on);
    m_markSensor.advance(stepS, before, now);
    m_infeed.moveTo(m_feed.products, drawnBefore, m_film.drawnMm(now));
    while (const auto edge = m_infeed.takeEdge())
        m_eye.pass(edge->position, edge->covered);
    m_eye.advance(stepS, m_feedBefore.products, m_feed.products);
}

// The shaft's position at a cut of the knives in turn.
double Machine::positionOfCut(double stroke) const
{
    const double knives = std::round(m_revolution / m_stroke);
    const double knife = stroke - knives * std::floor(stroke / knives);
    const double offMm = knife == 1.0 ? m_options.knifeOffMm : 0.0;
    return m_mark + m_cutOffset + stroke * m_stroke + offMm * m_pulsesPerMm;
}

double Machine::nearestCut() const
{
    return std::floor((m_main.position() - m_mark - m_cutOffset) / m_stroke + 0.5);
}

void Machine::passCut()
{
    const double before = m_main.positionBefore();
    const double stroke = nearestCut();
    const double at = positionOfCut(stroke);
    if (at <= before || at > m_main.position())
        return;
    const double passed = (at - before) / (m_main.position() - before);
    const double filmMm = m_feedBefore.filmMm + passed * (m_feed.filmMm - m_feedBefore.filmMm);
    const double drawnMm = m_film.drawnMm(filmMm);
    const double materialMm = m_film.materialMm(drawnMm);
    Infeed::Cut infeed = m_infeed.cut(drawnMm);
    BagCut cut;
    cut.filmEncoder = latched(
        passed, m_ways[FilmRoll].commanded(filmMm / m_options.filmFeedMm * m_options.filmPulses) * CTL_FINE);
    cut.markErrorMm = m_film.offMarkMm(materialMm);
    cut.drawnMm = drawnMm;
    cut.products = std::move(infeed.products);
    cut.throughProduct = infeed.through;
    if (m_materialAtCutMm)
        cut.lengthUm =
            static_cast<std::uint32_t>(std::max(0.0, umPerMm * (materialMm - *m_materialAtCutMm) + 0.5));
    m_materialAtCutMm = materialMm;
    m_cut = cut;
}

bool Machine::areJawsClosed() const
{
    const double fromCut = std::remainder(m_main.position() - m_mark - m_cutOffset, m_stroke);
    return m_hasKnife && std::abs(fromCut) * 360.0 < m_options.jawsDegrees * m_revolution;
}

void Machine::advance(double stepS)
{
    loadShaft(stepS);
    if (m_shaft.hasEncoder())
        m_shaft.advance(stepS);
    m_main.advance(stepS);
    m_report.advance(stepS, 100.0 * driveTorqueNm() / m_options.drive.ratedTorqueNm);
    if (m_ram)
        m_ram->follow((m_main.position() - m_top) * m_pulseMm);
    passIndex();
    if (!m_hasKnife)
        return;
    moveFeeds(stepS);
    moveFilm(stepS);
    passCut();
}

std::int64_t Machine::encoder() const
{
    return m_ram ? std::llround(m_top) + std::llround(m_ram->scaleMm() / m_pulseMm)
                 : std::llround(m_ways[Knife].commanded(m_main.position()));
}

std::int64_t Machine::scale() const
{
    if (!m_ram)
        return encoder() * CTL_PRESS_FINE;
    return std::llround(m_top) * CTL_PRESS_FINE + std::llround(m_ram->scaleMm() / m_pulseMm * CTL_PRESS_FINE);
}

std::optional<std::int64_t> Machine::takeIndex()
{
    return std::exchange(m_index, std::nullopt);
}

std::int64_t Machine::filmEncoder() const
{
    return std::llround(m_ways[FilmRoll].commanded(m_filmMotor.position()) * CTL_FINE);
}

std::int64_t Machine::infeedEncoder() const
{
    return std::llround(m_ways[Flights].commanded(m_infeedMotor.position()) * CTL_FINE);
}

std::optional<Machine::Edge> Machine::takeMark()
{
    LateSensor::Edge edge;
    if (!m_markSensor.take(edge))
        return std::nullopt;
    m_isMarkThere = edge.on;
    const double share = shareOf(edge.position, m_feedBefore.filmMm, m_feed.filmMm);
    const double pulses = edge.position / m_options.filmFeedMm * m_options.filmPulses;
    return Edge{latched(share, m_ways[FilmRoll].commanded(pulses) * CTL_FINE), edge.on};
}

std::optional<Machine::Edge> Machine::takeEdge()
{
    LateSensor::Edge edge;
    if (!m_eye.take(edge))
        return std::nullopt;
    m_isEyeCovered = edge.on;
    const double share = shareOf(edge.position, m_feedBefore.products, m_feed.products);
    const double pulses = m_ways[Flights].commanded(edge.position * m_options.flightPulses);
    return Edge{latched(share, pulses * CTL_FINE), edge.on};
}

std::optional<BagCut> Machine::takeCut()
{
    return std::exchange(m_cut, std::nullopt);
}

std::optional<double> Machine::takeCoderPulseMm()
{
    return std::exchange(m_coderPulseMm, std::nullopt);
}

} // namespace campanel::controller
