// SPDX-License-Identifier: Apache-2.0
// The torque of a motor: inertia times acceleration, plus friction against the direction of motion. Peak and
// RMS of a motion, and the acceleration that the motor's limits leave.
#pragma once

#include "profile/model/machine.h"
#include "profile/model/motion_profile.h"

#include <limits>

namespace campanel::profile {

// The means over a motion that its RMS torque is made of.
struct TorqueMeans {
    double squareMm2PerS4 = 0;   // mean of a^2
    double speedGainMmPerS2 = 0; // gain of |v| per second: the mean of a times the direction
    double movingShare = 1;      // share of the time without standstill
};

// The largest magnitudes of an acceleration, parted by what friction does: while the motion speeds up it adds
// to the torque, while it slows down it helps the motor.
struct AccelerationExtremes {
    double speedingMmPerS2 = 0; // 0: the motion never speeds up
    double speedingTimeS = 0;
    double slowingMmPerS2 = 0; // 0: it never slows down
    double slowingTimeS = 0;
    // The smallest while it does not speed up; infinite when it always does, or stands.
    double leastMmPerS2 = std::numeric_limits<double>::infinity();
    double leastTimeS = 0;

    // Includes a place with this acceleration along the direction of motion, in mm/s^2.
    void add(double alongMmPerS2, double timeS);
};

// The largest magnitude of a torque.
struct TorquePeak {
    double nm = 0; // NaN while the inertia is unknown
    double timeS = 0;
};

// The load of the motor, seen from the axis in mm.
struct TorqueLoad {
    double nmPerMmPerS2 = 0; // 0: the inertia is unknown
    double frictionNm = 0;

    [[nodiscard]] bool isKnown() const { return nmPerMmPerS2 > 0; }
    // Return torques in Nm, NaN while the inertia is unknown. at() has a sign: positive accelerates forward.
    [[nodiscard]] double at(double velocityMmPerS, double accelerationMmPerS2) const;
    // The largest magnitude of k a + M_f sign(v): k |a| + M_f while speeding up, |k |a| - M_f| while slowing.
    [[nodiscard]] TorquePeak peak(const AccelerationExtremes& extremes) const;
    // sqrt(k^2 mean(a^2) + 2 k M_f mean(a sign v) + M_f^2 share).
    [[nodiscard]] double rmsNm(const TorqueMeans& means) const;
    // Return the acceleration in mm/s^2 that this torque leaves: the largest one to speed up against
    // friction, the largest one to slow down with its help, and the largest RMS. The largest double while
    // torque or inertia are unknown; the first and the last are negative when friction alone exceeds the
    // torque.
    [[nodiscard]] double speedingAllowance(double maxTorqueNm) const;
    [[nodiscard]] double slowingAllowance(double maxTorqueNm) const;
    [[nodiscard]] double rmsAllowance(double ratedTorqueNm, double movingShare = 1) const;
    // Returns the largest factor for the accelerations of a motion with which this torque suffices; 0 when
    // friction alone exceeds it.
    [[nodiscard]] double peakShare(const AccelerationExtremes& extremes, double maxTorqueNm) const;
};

[[nodiscard]] TorqueLoad knifeLoad(const Machine& machine); // k = J Z / R
[[nodiscard]] TorqueLoad axisLoad(const Machine& machine);  // k = 2 pi J / feed

// Computes the means from the closed integrals of each segment.
[[nodiscard]] TorqueMeans torqueMeans(const MotionProfile& motion);

// Return the integrals of g'^2 and g''^2 from 0 to 1: cubic 1.2 and 12, quintic 10/7 and 120/7. Infinite
// derivatives do not occur.
[[nodiscard]] double lawSpeedSquare(const Law& law, const LawParameters& parameters);
[[nodiscard]] double lawAccelerationSquare(const Law& law, const LawParameters& parameters);

} // namespace campanel::profile
