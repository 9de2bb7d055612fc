// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/run_sentences.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace campanel::panel {

namespace {

using modbus::MarkState;
using modbus::State;
using Program = RunFacts::Program;

struct Row {
    RunRow row;
    RunPlace place;
    bool (*isTrue)(const RunFacts&);
    const char* sentence;
};

bool anyTime(const RunFacts&)
{
    return true;
}

bool isReading(const RunFacts& facts)
{
    return facts.program == Program::Reading;
}

bool isLost(const RunFacts& facts)
{
    return facts.program == Program::Lost;
}

bool isOffline(const RunFacts& facts)
{
    return !facts.hasBags && !facts.isConnected;
}

bool hasNoBags(const RunFacts& facts)
{
    return !facts.hasBags;
}

bool runsWithoutBags(const RunFacts& facts)
{
    return !facts.hasBags && facts.state == State::Running;
}

bool canStart(const RunFacts& facts)
{
    return facts.canStart;
}

bool canHoldStart(const RunFacts& facts)
{
    return facts.canStart && facts.isStartHeld;
}

bool canMakeBags(const RunFacts& facts)
{
    return !facts.hasBags && facts.canStart;
}

bool canMakeBagsByHold(const RunFacts& facts)
{
    return canMakeBags(facts) && facts.isStartHeld;
}

bool runs(const RunFacts& facts)
{
    return facts.state == State::Running;
}

template <MarkState marks> bool are(const RunFacts& facts)
{
    return facts.marks == marks;
}

template <MarkState marks> bool areMoving(const RunFacts& facts)
{
    return facts.marks == marks && facts.isMoving();
}

template <MarkState marks> bool areWithoutBags(const RunFacts& facts)
{
    return runsWithoutBags(facts) && facts.marks == marks;
}

bool areOff(const RunFacts& facts)
{
    return facts.marks == MarkState::Off && !facts.areMarksWanted;
}

bool isChanging(const RunFacts& facts)
{
    return facts.isChanging && facts.isMoving();
}

bool isFilmWaiting(const RunFacts& facts)
{
    return facts.isFilmWaiting && facts.isMoving();
}

bool isKnifeWaiting(const RunFacts& facts)
{
    return facts.isKnifeWaiting && facts.isMoving();
}

bool isThreading(const RunFacts& facts)
{
    return facts.isThreading && facts.isMoving();
}

bool threadsWithoutBags(const RunFacts& facts)
{
    return runsWithoutBags(facts) && facts.isThreading;
}

// The first true row of a place counts.
constexpr std::array rows{
    Row{RunRow::ProgramReading, RunPlace::Program, &isReading,
        QT_TRANSLATE_NOOP("RunSentences", "Reading the program of the controller …")},
    Row{RunRow::ProgramLost, RunPlace::Program, &isLost,
        QT_TRANSLATE_NOOP("RunSentences", "The controller has lost its program: the program was not saved "
                                          "before the restart. Download again.")},
    Row{RunRow::ProgramAbsent, RunPlace::Program, &anyTime,
        QT_TRANSLATE_NOOP("RunSentences",
                          "The controller has no program yet. Download one on the Motion page.")},

    Row{RunRow::BagsOffline, RunPlace::Bags, &isOffline,
        QT_TRANSLATE_NOOP("RunSentences", "No connection. New bags are not shown.")},
    Row{RunRow::BagsThreading, RunPlace::Bags, &threadsWithoutBags,
        QT_TRANSLATE_NOOP("RunSentences", "Threading up: no bags before a mark is at the knife")},
    Row{RunRow::BagsSearching, RunPlace::Bags, &areWithoutBags<MarkState::Searching>,
        QT_TRANSLATE_NOOP("RunSentences", "Searching for marks: the bags are scrap")},
    Row{RunRow::BagsAligning, RunPlace::Bags, &areWithoutBags<MarkState::Aligning>,
        QT_TRANSLATE_NOOP("RunSentences", "Aligning with the marks: the bags are scrap")},
    Row{RunRow::BagsFirst, RunPlace::Bags, &runsWithoutBags,
        QT_TRANSLATE_NOOP("RunSentences", "Running; first bag not measured yet")},
    Row{RunRow::BagsHoldStart, RunPlace::Bags, &canMakeBagsByHold,
        QT_TRANSLATE_NOOP("RunSentences", "No bag measured yet. Hold Start.")},
    Row{RunRow::BagsStart, RunPlace::Bags, &canMakeBags,
        QT_TRANSLATE_NOOP("RunSentences", "No bag measured yet. Press Start.")},
    Row{RunRow::BagsNone, RunPlace::Bags, &hasNoBags,
        QT_TRANSLATE_NOOP("RunSentences", "No bag measured yet.")},

    Row{RunRow::MarksOff, RunPlace::Marks, &areOff, QT_TRANSLATE_NOOP("RunSentences", "Mark tracking off")},
    Row{RunRow::MarksNotYet, RunPlace::Marks, &are<MarkState::Off>,
        QT_TRANSLATE_NOOP("RunSentences", "Marks not searched for yet")},
    Row{RunRow::MarksSearching, RunPlace::Marks, &areMoving<MarkState::Searching>,
        QT_TRANSLATE_NOOP("RunSentences", "Searching for marks")},
    Row{RunRow::MarksNotFound, RunPlace::Marks, &are<MarkState::Searching>,
        QT_TRANSLATE_NOOP("RunSentences", "No marks found")},
    Row{RunRow::MarksAligning, RunPlace::Marks, &areMoving<MarkState::Aligning>,
        QT_TRANSLATE_NOOP("RunSentences", "Aligning cuts with marks")},
    Row{RunRow::MarksNotAligned, RunPlace::Marks, &are<MarkState::Aligning>,
        QT_TRANSLATE_NOOP("RunSentences", "Cuts not aligned with marks yet")},
    Row{RunRow::MarksTracking, RunPlace::Marks, &are<MarkState::Tracking>,
        QT_TRANSLATE_NOOP("RunSentences", "Tracking marks")},

    Row{RunRow::FilmChanging, RunPlace::Film, &isChanging,
        QT_TRANSLATE_NOOP("RunSentences", "Changing to the new program")},
    Row{RunRow::FilmWaiting, RunPlace::Film, &isFilmWaiting,
        QT_TRANSLATE_NOOP("RunSentences", "Film waits for a product")},
    Row{RunRow::FilmThreading, RunPlace::Film, &isThreading,
        QT_TRANSLATE_NOOP("RunSentences", "Knife stays open while the film is threaded up")},
    Row{RunRow::KnifeWaiting, RunPlace::Film, &isKnifeWaiting,
        QT_TRANSLATE_NOOP("RunSentences", "Knife stays open: product in its path")},

    Row{RunRow::StrokeHoldStart, RunPlace::Stroke, &canHoldStart,
        QT_TRANSLATE_NOOP("RunSentences", "No stroke yet. Hold Start.")},
    Row{RunRow::StrokeStart, RunPlace::Stroke, &canStart,
        QT_TRANSLATE_NOOP("RunSentences", "No stroke yet. Press Start.")},
    Row{RunRow::StrokeNone, RunPlace::Stroke, &anyTime, QT_TRANSLATE_NOOP("RunSentences", "No stroke yet.")},

    Row{RunRow::TrendsHoldStart, RunPlace::Trends, &canHoldStart,
        QT_TRANSLATE_NOOP(
            "RunSentences",
            "There are no data of these curves yet. Hold Start, or choose other curves with Curves.")},
    Row{RunRow::TrendsStart, RunPlace::Trends, &canStart,
        QT_TRANSLATE_NOOP(
            "RunSentences",
            "There are no data of these curves yet. Press Start, or choose other curves with Curves.")},
    Row{RunRow::TrendsNone, RunPlace::Trends, &anyTime,
        QT_TRANSLATE_NOOP("RunSentences",
                          "There are no data of these curves yet. Choose other curves with Curves.")},

    Row{RunRow::DownloadedRuns, RunPlace::Downloaded, &runs,
        QT_TRANSLATE_NOOP("RunSentences", "Downloaded. The machine is running this recipe.")},
    Row{RunRow::DownloadedHoldStart, RunPlace::Downloaded, &canHoldStart,
        QT_TRANSLATE_NOOP("RunSentences", "Downloaded. Hold Start to run this recipe.")},
    Row{RunRow::DownloadedStart, RunPlace::Downloaded, &canStart,
        QT_TRANSLATE_NOOP("RunSentences", "Downloaded. Press Start to run this recipe.")},
    Row{RunRow::DownloadedOnly, RunPlace::Downloaded, &anyTime,
        QT_TRANSLATE_NOOP("RunSentences", "Downloaded. The controller has this recipe.")},
};
static_assert(rows.size() == static_cast<std::size_t>(RunRow::Count));
static_assert(std::ranges::all_of(rows, [](const Row& row) {
    return &row == &rows[static_cast<std::size_t>(row.row)];
}));

} // namespace

std::optional<RunRow> RunSentences::row(RunPlace place, const RunFacts& facts)
{
    for (const Row& row : rows) {
        if (row.place == place && row.isTrue(facts))
            return row.row;
    }
    return std::nullopt;
}

QString RunSentences::text(RunRow row)
{
    return QCoreApplication::translate("RunSentences", rows[static_cast<std::size_t>(row)].sentence);
}

} // namespace campanel::panel
