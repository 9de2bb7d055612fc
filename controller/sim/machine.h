// SPDX-License-Identifier: Apache-2.0
// The simulated machine: servos that follow the pulses with a lag. With a cutter's program the main axis
// turns a knife with encoder and index mark, the second draws the film, and the third brings products. The
// bags are measured at the cut. With a press's program it drives the ram; with any other it is a plain axis
// with a mark at each motor revolution. The same seed and calls give the same results.
#pragma once

#include "base/ctl_bank.h"
#include "base/ctl_port.h"
#include "film.h"
#include "infeed.h"
#include "jaws.h"
#include "late_sensor.h"
#include "line_shaft.h"
#include "motor_way.h"
#include "press_ram.h"
#include "servo.h"
#include "torque_report.h"

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

namespace campanel::controller {

inline constexpr double umPerMm = 1000.0;

// The torque of the main drive is inertia x acceleration + friction, against its direction.
struct DriveOptions {
    double inertiaKgM2 = 0.002; // at the shaft with the index mark
    double frictionNm = 0.25;
    double ratedTorqueNm = 2.4;
    double frictionDrift = 0.0; // largest share by which friction rises and falls, in ten minutes
    double peakTorque = 3.0;    // maximum, times the rated one; for jaws that press on something
};

struct MachineOptions {
    std::uint64_t seed = 1;
    FilmOptions film;
    ProductOptions products;
    SensorOptions sensors;            // of marks and products
    double servoBandwidthHz = 80.0;   // critically damped; the knife lags by 1 / (pi * bandwidth)
    double feedBandwidthHz = 60.0;    // for film and infeed
    double startAngleDegrees = 300.0; // shaft angle at power-up, from its index mark
    double filmFeedMm = 150.0;        // per revolution of the film motor
    double filmPulses = 10'000.0;
    double flightPulses = 20'000.0;   // infeed motor, per product
    double knifePulses = 0.0;         // per turn of the knife's shaft; 0: what the program says
    double reversed = 0.0;            // bits: the motors of knife, film and infeed turn the other way
    double indexScatterDegrees = 0.1; // of the index marks of film and infeed, standard deviation
    PressOptions press;
    DriveOptions drive;
    ReportOptions report; // of the torque
    JawOptions jaws;
    ShaftOptions shaft;
    double knifeOffMm = 0.0;   // the second of several knives cuts so far behind its place, along the film
    double jawsDegrees = 20.0; // of the shaft, so far before and behind the cut they touch the film
    std::uint16_t inputs = 0;  // bits of InputBit that are on at power-up
};

// The result of a cut, as measured with a ruler.
struct BagCut {
    std::int64_t filmEncoder =
        0; // 1/256 pulse or counts of the line's encoder, latched when the knife closed
    std::optional<std::uint32_t> lengthUm; // none: the previous cut is not valid
    double markErrorMm = 0.0;              // from the printed cut, positive: late
    double drawnMm = 0.0;                  // film drawn, including slip
    std::vector<Infeed::Laid> products;    // products in the bag
    bool throughProduct = false;
};

class Machine {
public:
    explicit Machine(const MachineOptions& options);

    // Sets the program to execute; the shaft keeps its angle.
    void setProgram(const ctl_bank& bank);
    // Move the commands of the axes; within a time step they rise evenly. Feeds in 1/256 pulse.
    void command(std::int64_t pulses) { commandMotor(m_main, Knife, pulses); }
    void commandFeed(ctl_axis axis, std::int64_t from, std::int64_t to);
    // Cuts the power of the main drive.
    void setDriveOn(bool on);
    // Sets the output pins; the drives follow only while they are enabled.
    void setOutputs(std::uint32_t levels);
    // Sets an input pin that no movement sets: drive alarm, emergency stop, limit switches. A drive with an
    // alarm does not follow; the others have no effect.
    void setInput(unsigned bit, bool isOn);
    // Turns the motors of these axes, bits, the other way than they are wired and mounted; at standstill.
    void setReversed(unsigned axes);
    // Sets what edges and cuts latch: the counts of the line's encoder, or film and infeed.
    void latchMaster(bool on) { m_latchesMaster = on; }

    // The axes stand at once: the power is cut. Then somebody may turn the shaft and pull the film and the
    // infeed.
    struct ByHand {
        double turns = 0.0;    // of the shaft
        double filmMm = 0.0;   // over its roll
        double products = 0.0; // of the infeed
    };
    void standStill(const ByHand& byHand);
    // Return the jaws, with what lies between them.
    [[nodiscard]] Jaws& jaws() { return m_jaws; }
    [[nodiscard]] const Jaws& jaws() const { return m_jaws; }
    // Advances by one time step.
    void advance(double stepS);
    // Invalidates the last cut: the knife was turned by hand.
    void forgetLastCut() { m_materialAtCutMm.reset(); }

    // Return the encoder of the main motor, and the scale in 1/256 pulse. With a press's program the encoder
    // is the scale at the ram.
    [[nodiscard]] std::int64_t encoder() const;
    [[nodiscard]] std::int64_t scale() const;
    [[nodiscard]] std::int32_t forceN() const { return m_ram ? m_ram->forceN() : 0; }
    // Returns the levels of all input pins.
    [[nodiscard]] std::uint16_t inputs() const;
    // Returns the torque that the main drive reports, in 0.1 % of its rated torque.
    [[nodiscard]] std::int32_t torqueTenthPercent() const;
    // Returns the angle of the shaft, degrees since power-up.
    [[nodiscard]] double shaftDegrees() const;
    // Return the encoders in 1/256 pulse.
    [[nodiscard]] std::int64_t filmEncoder() const;
    [[nodiscard]] std::int64_t infeedEncoder() const;
    // Returns the ram; only with a press's program.
    [[nodiscard]] const PressRam& ram() const { return *m_ram; }
    // Returns the encoder position at the index mark, once for each forward passage.
    [[nodiscard]] std::optional<std::int64_t> takeIndex();
    // Return the edges that mark sensor and product eye saw: of a mark with the film's encoder, of a product
    // with the infeed's, 1/256 pulse.
    struct Edge {
        std::int64_t encoder = 0;
        bool covered = false;
    };
    [[nodiscard]] std::optional<Edge> takeMark();
    [[nodiscard]] std::optional<Edge> takeEdge();
    // Returns true when the jaws touch the film.
    [[nodiscard]] bool areJawsClosed() const;
    [[nodiscard]] bool areDrivesOn() const;
    // Returns the place of the infeed, in products.
    [[nodiscard]] double infeedTurns() const { return m_feed.products; }
    [[nodiscard]] double drawnMm() const { return m_film.drawnMm(m_feed.filmMm); }
    // Returns the shaft of the line that the machine may follow.
    [[nodiscard]] LineShaft& shaft() { return m_shaft; }
    [[nodiscard]] double filmMmPerS() const { return m_feed.filmMmPerS; }
    // Returns the cut of the last step.
    [[nodiscard]] std::optional<BagCut> takeCut();
    // Returns the film drawn when the last pulse of the date coder began.
    [[nodiscard]] std::optional<double> takeCoderPulseMm();

private:
    enum Axis { Knife, FilmRoll, Flights, Axes };
    struct IndexMark { // of a turn of film or infeed, at each turn somewhere else
        double turn = 0.0;
        double offTurns = 0.0;
        bool isOn = false;
    };

    void commandMotor(Servo& servo, Axis axis, std::int64_t pulses);
    void turnIndexMark(IndexMark& mark, double turns);
    void switchDrives();
    void turnBy(double revolution);
    void setKnife(const ctl_bank& bank);
    void setPress(const ctl_bank& bank);
    void passIndex();
    void passCut();
    [[nodiscard]] double positionOfCut(double stroke) const;
    [[nodiscard]] double nearestCut() const;
    [[nodiscard]] double driveTorqueNm() const;
    void loadShaft(double stepS);
    void layOnPrint();
    void moveFeeds(double stepS);
    void moveFilm(double stepS);
    [[nodiscard]] double rollMm(double pulses) const;
    [[nodiscard]] std::int64_t latched(double share, double fine) const;

    MachineOptions m_options;
    std::uint16_t m_inputs = 0;
    std::uint32_t m_outputs = 0;
    bool m_hasPower = true;
    bool m_isEyeCovered = false;
    bool m_isMarkThere = false;
    Servo m_main;
    Servo m_filmMotor;
    Servo m_infeedMotor;
    std::array<MotorWay, Axes> m_ways;
    IndexMark m_filmIndex;
    IndexMark m_infeedIndex;
    std::mt19937_64 m_indexRandom;
    std::normal_distribution<double> m_normal;
    // Where film and infeed are, whoever drives them.
    struct Feed {
        double filmMm = 0.0;
        double products = 0.0;
        double filmMmPerS = 0.0;
        std::int64_t counts = 0; // of the line's encoder
    };
    Feed m_feed;
    Feed m_feedBefore; // before the last step
    bool m_latchesMaster = false;
    double m_firstProduct = 0.0;   // on their infeed, at the first printed cut
    double m_shaftMm = 0.0;        // its position at the last step
    double m_revolution = 10000.0; // pulses from mark to mark
    double m_mark = 0.0;           // position of an index mark, pulses
    double m_stroke = 10000.0;     // pulses from one knife to the next
    double m_cutOffset = 0.0;      // pulses from an index mark to the cut
    double m_pulsesPerMm = 0.0;    // of the knife's tip
    bool m_hasKnife = false;
    Film m_film;
    Infeed m_infeed;
    LineShaft m_shaft;
    LateSensor m_markSensor;
    LateSensor m_eye;
    Jaws m_jaws;
    TorqueReport m_report;
    double m_timeS = 0.0;
    FilmAcceleration m_filmAcceleration;
    std::optional<double> m_materialAtCutMm;
    std::optional<std::int64_t> m_index;
    std::optional<BagCut> m_cut;
    std::optional<double> m_coderPulseMm;
    std::optional<PressRam> m_ram;
    double m_pulseMm = 0.0; // mm per pulse of the ram
    double m_top = 0.0;     // motor position at the ram's upper position, pulses
};

} // namespace campanel::controller
