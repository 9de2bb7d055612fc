// SPDX-License-Identifier: Apache-2.0
// Solves the mode step by step. The drive of the error e = x - u is -a - 2 z w v, a parabola within each
// step, for which the solution is exact. A cycle that repeats begins where it ends: (I - Phi) e0 = e(T) from
// rest. A step of the motor's speed is one of the error's, the other way.
#include "profile/model/vibration.h"

#include "profile/model/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace campanel::profile {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
// Steps in each smooth piece of a law, and per period of the mode; the latter up to maxSteps.
constexpr int minSteps = 32;
constexpr int maxSteps = 2000;
constexpr double stepsPerPeriod = 16;
// Points per period of free vibration: a peak between two of them is missed by less than 0.1 %.
constexpr double pointsPerPeriod = 80;

struct ModeState {
    double error = 0;
    double errorSpeed = 0;
};

// The motion of the mode over one step, computed once for all steps of the same length.
class ModeStep {
public:
    ModeStep(const ShaftMode& mode, double stepS)
        : m_w(2 * std::numbers::pi * mode.naturalFrequencyHz)
        , m_damping(mode.dampingRatio)
        , m_stepS(stepS)
        , m_damped(m_w * std::sqrt(1 - m_damping * m_damping))
        , m_decay(std::exp(-m_damping * m_w * stepS))
        , m_cosine(std::cos(m_damped * stepS))
        , m_sine(std::sin(m_damped * stepS))
    {
    }

    // Advances by one step; the drive in mm/s^2 at its beginning, its middle and its end.
    [[nodiscard]] ModeState after(const ModeState& state, const std::array<double, 3>& drive) const
    {
        const double h = m_stepS > 0 ? m_stepS : 1;
        const double slope = (4 * drive[1] - 3 * drive[0] - drive[2]) / h;
        const double curvature = 2 * (drive[0] - 2 * drive[1] + drive[2]) / (h * h);
        // e = c0 + c1 t + c2 t^2 follows the drive; the rest of the state decays freely.
        const double square = m_w * m_w;
        const double c2 = curvature / square;
        const double c1 = (slope - 4 * m_damping * m_w * c2) / square;
        const double c0 = (drive[0] - 2 * m_damping * m_w * c1 - 2 * c2) / square;
        const double a = state.error - c0;
        const double b = (state.errorSpeed - c1 + m_damping * m_w * a) / m_damped;
        const double free = m_decay * (a * m_cosine + b * m_sine);
        const double turned = m_decay * (b * m_cosine - a * m_sine);
        return {c0 + m_stepS * (c1 + m_stepS * c2) + free,
                c1 + 2 * m_stepS * c2 - m_damping * m_w * free + m_damped * turned};
    }

    // Advances by one step of a constant drive.
    [[nodiscard]] ModeState after(const ModeState& state, double drive) const
    {
        return after(state, {drive, drive, drive});
    }

private:
    double m_w;
    double m_damping;
    double m_stepS;
    double m_damped; // angular frequency of the damped mode
    double m_decay;
    double m_cosine;
    double m_sine;
};

// Carries the mode through a motion and records the error between two times.
class ModeRun {
public:
    ModeRun(const MotionProfile& motion, const ShaftMode& mode, bool repeats)
        : m_motion(motion)
        , m_mode(mode)
        , m_meanMmPerS(motion.durationS() > 0
                           ? (motion.at(motion.durationS()).positionMm - motion.at(0).positionMm) /
                                 motion.durationS()
                           : 0)
        , m_joinedS(1e-9 * motion.durationS())
        , m_beforeMmPerS(motion.at(repeats ? motion.durationS() : 0).velocityMmPerS)
    {
    }

    // Returns the state at the end.
    ModeState run(ModeState state, double fromS, double toS, Extent* range) const
    {
        double beforeMmPerS = m_beforeMmPerS;
        for (const Segment& segment : m_motion.segments()) {
            state.errorSpeed -= segment.at(segment.startS).velocityMmPerS - beforeMmPerS;
            beforeMmPerS = segment.at(segment.endS()).velocityMmPerS;
            double from = segment.startS;
            for (const double joint : jointsOf(segment, fromS, toS)) {
                const bool isRecorded =
                    range != nullptr && from >= fromS - m_joinedS && joint <= toS + m_joinedS;
                state = runPiece(segment, from, joint, state, isRecorded ? range : nullptr);
                from = joint;
            }
        }
        return state;
    }

private:
    // Returns the ends of the smooth pieces of a segment, and the given times inside it.
    [[nodiscard]] std::vector<double> jointsOf(const Segment& segment, double fromS, double toS) const
    {
        std::vector<double> joints;
        if (segment.law != nullptr) {
            for (const double joint : segment.law->pieces(segment.parameters).joints)
                joints.push_back(segment.startS +
                                 ((segment.isMirrored ? 1 - joint : joint) - segment.lawFrom) *
                                     segment.lawDurationS());
        }
        joints.insert(joints.end(), {fromS, toS});
        std::erase_if(joints, [&](double joint) {
            return joint < segment.startS + m_joinedS || joint > segment.endS() - m_joinedS;
        });
        joints.push_back(segment.endS());
        std::sort(joints.begin(), joints.end());
        joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
        return joints;
    }

    // The speed is taken from its mean: a constant error has no peaks.
    [[nodiscard]] double driveAt(const Segment& segment, double timeS) const
    {
        const MotionPoint point = segment.at(timeS);
        const double w = 2 * std::numbers::pi * m_mode.naturalFrequencyHz;
        return -point.accelerationMmPerS2 -
               2 * m_mode.dampingRatio * w * (point.velocityMmPerS - m_meanMmPerS);
    }

    ModeState runPiece(const Segment& segment, double fromS, double toS, ModeState state, Extent* range) const
    {
        const double duration = toS - fromS;
        if (segment.form == SegmentForm::Constant)
            return runConstant(driveAt(segment, fromS), duration, state, range);
        const double periods = duration * m_mode.naturalFrequencyHz;
        const double perPeriod = range ? pointsPerPeriod : stepsPerPeriod;
        const int steps = static_cast<int>(clamped(std::ceil(periods * perPeriod), minSteps, maxSteps));
        const ModeStep step(m_mode, duration / steps);
        // Inside the ends: the acceleration of a law may jump there.
        const double inside = duration * 1e-9;
        double drive = driveAt(segment, fromS + inside);
        if (range)
            range->add(state.error);
        for (int i = 1; i <= steps; ++i) {
            const double middle = driveAt(segment, fromS + duration * (i - 0.5) / steps);
            const double next = driveAt(segment, i < steps ? fromS + duration * i / steps : toS - inside);
            state = step.after(state, {drive, middle, next});
            drive = next;
            if (range)
                range->add(state.error);
        }
        return state;
    }

    // Free vibration about a constant error decays, so its peaks lie in the first period or at the end.
    ModeState runConstant(double drive, double durationS, ModeState state, Extent* range) const
    {
        const ModeState end = ModeStep(m_mode, durationS).after(state, drive);
        if (!range)
            return end;
        const double observedS =
            minOf(durationS, 1.25 / m_mode.naturalFrequencyHz /
                                 std::sqrt(1 - m_mode.dampingRatio * m_mode.dampingRatio));
        const int points = static_cast<int>(std::ceil(1.25 * pointsPerPeriod));
        const ModeStep step(m_mode, observedS / points);
        for (int i = 0; i <= points; ++i) {
            range->add(state.error);
            state = step.after(state, drive);
        }
        range->add(end.error);
        return end;
    }

    const MotionProfile& m_motion;
    ShaftMode m_mode;
    double m_meanMmPerS;
    double m_joinedS;      // times closer than this are one
    double m_beforeMmPerS; // the speed before the motion
};

// Returns the state at the beginning of each cycle of a motion that repeats.
ModeState steadyState(const ModeState& afterRest, const ShaftMode& mode, double cycleS)
{
    const ModeStep cycle(mode, cycleS);
    const ModeState ofError = cycle.after({1, 0}, 0.0);
    const ModeState ofSpeed = cycle.after({0, 1}, 0.0);
    const double a = 1 - ofError.error;
    const double b = -ofSpeed.error;
    const double c = -ofError.errorSpeed;
    const double d = 1 - ofSpeed.errorSpeed;
    const double determinant = a * d - b * c;
    return {(d * afterRest.error - b * afterRest.errorSpeed) / determinant,
            (a * afterRest.errorSpeed - c * afterRest.error) / determinant};
}

} // namespace

ShaftMode shaftMode(const Machine& machine)
{
    return {machine.naturalFrequencyHz, machine.dampingRatio};
}

double windowErrorMm(const MotionProfile& motion, double fromS, double toS, const ShaftMode& mode)
{
    const double cycleS = motion.durationS();
    if (!mode.isKnown() || !(cycleS > 0))
        return unknown;
    const ModeRun run(motion, mode, true);
    const ModeState afterRest = run.run({}, fromS, toS, nullptr);
    Extent range;
    run.run(steadyState(afterRest, mode, cycleS), fromS, toS, &range);
    return range.max >= range.min ? range.max - range.min : 0;
}

double cycleErrorMm(const MotionProfile& motion, const ShaftMode& mode)
{
    return windowErrorMm(motion, 0, motion.durationS(), mode);
}

double residualAmplitudeMm(const MotionProfile& motion, const ShaftMode& mode)
{
    if (!mode.isKnown() || !(motion.durationS() > 0))
        return unknown;
    const ModeState end = ModeRun(motion, {mode.naturalFrequencyHz, 0}, false).run({}, 0, 0, nullptr);
    return std::hypot(end.error, end.errorSpeed / (2 * std::numbers::pi * mode.naturalFrequencyHz));
}

} // namespace campanel::profile
