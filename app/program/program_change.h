// SPDX-License-Identifier: Apache-2.0
// The change of program of a running machine, predicted with the controller's own formula: the film's speed
// goes on over the boundary, and the machine slows down before it as far as the largest steps of the axes
// demand. A machine that follows an encoder cannot slow down: it leaves the encoder for such a change. See
// controller/core/motion/README.md.
#pragma once

#include "app/program/recipe.h"
#include "app/program/solved_program.h"

#include <optional>

namespace campanel::program {

// An encoder that leads the machine.
struct LeadingLine {
    double share = 1;    // its present speed, of the program's
    double maxShare = 1; // of a program's, at which it is still followed
    double engage = 0.5; // the minimum stretch in which the machine engages, of a cycle
};

// The parameters of the controller that the change depends on.
struct ChangeParameters {
    double knifeStepHz = 0;
    double filmStepHz = 0;
    double infeedStepHz = 0;
    double filmPulsesPerMm = 0; // 0: the machine has no packing line
    double flightPulses = 0;    // of the infeed motor per product
    double rampS = 0;           // of a program without its own ramp
    bool isReversed = false;    // the master of a point cam
    bool hasAntiCut = false;    // the knife stays open over a product
    std::optional<LeadingLine> line = {};
};

enum class ChangeWay {
    SlowsDown,   // as far as the steps demand, which may be not at all
    FollowsLine, // over the boundary at the line's speed
    LeavesLine,  // comes to rest at the boundary, then engages again
    TooFast      // the line is too fast for the new program
};

struct ProgramChange {
    ChangeWay way = ChangeWay::SlowsDown;
    double speedBefore = 1; // of full speed, when it is ordered,
    double speedBehind = 1; // and when it is over
    double shareBefore = 1; // of full speed at the boundary, 0..1
    double shareBehind = 1; // of the new program's full speed
    double speedRatio = 1;  // of film or master at the new program's full speed, to that at the old one's
    double slowingS = 0;    // until the boundary
    double timeS = 0;       // from full speed to full speed, without waiting for the boundary
    double cycles = 0;      // completed in that time
    // More when a product lies under the first cut: two cycles until the knife stands open, each from and to
    // the slowest speed. 0: none can.
    double productWaitS = 0;
};

// Returns true when a running machine can change from one program to the other: both repeat.
[[nodiscard]] bool changesWhileRunning(const Recipe& from, const Recipe& to);

// Returns the change between two programs of the same kind and machine; nothing when not even the smallest
// share of full speed, 1/2048, keeps the steps.
[[nodiscard]] std::optional<ProgramChange> programChange(const Recipe& from, const SolvedProgram& solvedFrom,
                                                         const Recipe& to, const SolvedProgram& solvedTo,
                                                         const ChangeParameters& parameters);

} // namespace campanel::program
