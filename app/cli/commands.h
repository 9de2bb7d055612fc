// SPDX-License-Identifier: Apache-2.0
// The commands; a new one is one function and one row in main.cpp.
#pragma once

#include "app/cli/failure.h"

namespace campanel::cli {

class Invocation;

[[nodiscard]] Outcome runProfile(const Invocation& call);
[[nodiscard]] Outcome runTable(const Invocation& call);
[[nodiscard]] Outcome runMap(const Invocation& call);
[[nodiscard]] Outcome runLaws(const Invocation& call);
[[nodiscard]] Outcome runCompare(const Invocation& call);
[[nodiscard]] Outcome runIntervals(const Invocation& call);
[[nodiscard]] Outcome runKnots(const Invocation& call);
[[nodiscard]] Outcome runSegments(const Invocation& call);
[[nodiscard]] Outcome runRecipe(const Invocation& call);
// Carry out recipe new-key, sign and verify.
[[nodiscard]] Outcome createKey(const Invocation& call);
[[nodiscard]] Outcome signFile(const Invocation& call);
[[nodiscard]] Outcome verifyFile(const Invocation& call);
[[nodiscard]] Outcome runSimulate(const Invocation& call);
[[nodiscard]] Outcome runSet(const Invocation& call);
[[nodiscard]] Outcome runDownload(const Invocation& call);
[[nodiscard]] Outcome runStatus(const Invocation& call);
[[nodiscard]] Outcome runVersions(const Invocation& call);
[[nodiscard]] Outcome runStart(const Invocation& call);
[[nodiscard]] Outcome runStop(const Invocation& call);
[[nodiscard]] Outcome runHome(const Invocation& call);
[[nodiscard]] Outcome runJogBag(const Invocation& call);
[[nodiscard]] Outcome runCut(const Invocation& call);
[[nodiscard]] Outcome runTake(const Invocation& call);
[[nodiscard]] Outcome runAcknowledge(const Invocation& call);
[[nodiscard]] Outcome runOutput(const Invocation& call);
[[nodiscard]] Outcome runMeasure(const Invocation& call);
[[nodiscard]] Outcome runOrder(const Invocation& call);
[[nodiscard]] Outcome runSave(const Invocation& call);
[[nodiscard]] Outcome runDoctor(const Invocation& call);
[[nodiscard]] Outcome runLink(const Invocation& call);
[[nodiscard]] Outcome runFrames(const Invocation& call);
[[nodiscard]] Outcome runRegisters(const Invocation& call);
[[nodiscard]] Outcome runFleet(const Invocation& call);
[[nodiscard]] Outcome runAudit(const Invocation& call);
[[nodiscard]] Outcome runPackage(const Invocation& call);

} // namespace campanel::cli
