// SPDX-License-Identifier: Apache-2.0
// The sealing jaws of a knife: the arc in contact, the window that must hold it, the time of the seal. A
// contact angle of 0 is a thin knife, which needs no window and has no seal time.
#pragma once

#include "profile/cutter/rotary_cutter.h"

namespace campanel::profile {

// The angle by which the window must exceed the contact angle: the jaws close and open at the film's speed.
inline constexpr double jawMarginDeg = 2;

// Returns the arc of the jaws at the knife's tip in mm: A = R theta_c.
[[nodiscard]] double jawArcMm(const Machine& machine);
// Returns the angle of the knife's shaft that the window must hold: theta_c + 2 degrees, 0 for a thin knife.
[[nodiscard]] double requiredWindowDeg(const Machine& machine);
// Returns the angle of the knife's shaft within the synchronous window: v_b (tc - tb) / R = c L sigma / R.
[[nodiscard]] double windowDeg(const CycleNumbers& cycle, const Machine& machine);
// Returns the time during which the jaws are in contact, in ms: A / v_b = 60 R theta_c / (c L n).
[[nodiscard]] double sealTimeMs(const CycleNumbers& cycle, const Machine& machine);

// The bag lengths at which the behavior of a cutter changes, in mm.
struct CutterLengths {
    double equalSpeedMm = 0;    // h / c: v_a = v_b, the knife turns evenly
    double jawMm = 0;           // L_min = R theta_c / (c sigma): the jaws fill the window; 0 for a thin knife
    double jawWithMarginMm = 0; // the same with the margin: shorter bags are refused
    double dwellMm = 0;         // L_crit = (2 h - A) / c: beyond it even the longest ramps stop the knife
    double strokeMm = 0;        // h / (c w): beyond it the knife cannot close its stroke with these ratios
};

// Returns the lengths for the ratios and the law of the program, which must be valid.
[[nodiscard]] CutterLengths cutterLengths(const RotaryCutterProgram& program, const Machine& machine);

} // namespace campanel::profile
