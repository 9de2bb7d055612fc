// SPDX-License-Identifier: Apache-2.0
// The sentences that hold for the present state of the machine. One table of conditions and sentences:
// a page shows the sentence of the first row of its place that is true, and writes none of its own.
#pragma once

#include "app/link/link_values.h"

#include <QString>

#include <optional>

namespace campanel::panel {

// The facts that a sentence on Run depends on.
struct RunFacts {
    enum class Program { Absent, Lost, Reading, Present };

    bool isConnected = false;           // and the data is fresh
    std::optional<modbus::State> state; // empty: unknown
    Program program = Program::Absent;
    bool canStart = false;
    bool isStartHeld = false;               // Start is a key that is held
    bool areMarksWanted = true;             // false once the controller's mark tracking is known to be off
    std::optional<modbus::MarkState> marks; // empty: the controller reports no film
    bool isFilmWaiting = false;
    bool isKnifeWaiting = false;
    bool isThreading = false; // the knife is open until its cut can follow a mark
    bool isChanging = false;  // a program waits for the end of the cycle
    bool hasBags = false;     // of those that count

    [[nodiscard]] bool isMoving() const
    {
        return state == modbus::State::Running || state == modbus::State::Stopping;
    }
    bool operator==(const RunFacts&) const = default;
};

// The places that have a sentence: on Run, in empty trends, and of a program that was just downloaded.
enum class RunPlace { Program, Bags, Marks, Film, Stroke, Trends, Downloaded };

// The rows of the table, in its order.
enum class RunRow {
    ProgramReading,
    ProgramLost,
    ProgramAbsent,
    BagsOffline,
    BagsThreading,
    BagsSearching,
    BagsAligning,
    BagsFirst,
    BagsHoldStart,
    BagsStart,
    BagsNone,
    MarksOff,
    MarksNotYet,
    MarksSearching,
    MarksNotFound,
    MarksAligning,
    MarksNotAligned,
    MarksTracking,
    FilmChanging,
    FilmWaiting,
    FilmThreading,
    KnifeWaiting,
    StrokeHoldStart,
    StrokeStart,
    StrokeNone,
    TrendsHoldStart,
    TrendsStart,
    TrendsNone,
    DownloadedRuns,
    DownloadedHoldStart,
    DownloadedStart,
    DownloadedOnly,
    Count
};

class RunSentences {
public:
    // Returns the row whose sentence stands in that place; empty: there is nothing to say.
    [[nodiscard]] static std::optional<RunRow> row(RunPlace place, const RunFacts& facts);
    // Returns its sentence in the language.
    [[nodiscard]] static QString text(RunRow row);
};

} // namespace campanel::panel
