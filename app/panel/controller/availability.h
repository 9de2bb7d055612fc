// SPDX-License-Identifier: Apache-2.0
// The actions that the state of machine and connection may block; Controller::blockedReason() says why.
#pragma once

namespace campanel::panel {

enum class Action {
    Start,
    Home,
    JogBag,    // one bag out of standstill
    SingleCut, // of the knife alone
    TakeBag,   // the next one of a run is for a person
    Measure,   // the pulses of an axis, or its direction
    Jog,
    TryOutput, // at standstill, while a key is held
    Download,
    ChangeMachineData, // a download with another kind of program or other machine data
    Compare,           // the controller's program with the recipe
    ReverseMaster,
    SetUpMarks,
    MeasureMarks, // while the film runs
    Diagnose,
    RotateScreen,
    CalibrateTouch,
    UpdateSoftware,
    RestoreBackup,
};

} // namespace campanel::panel
