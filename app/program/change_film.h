// SPDX-License-Identifier: Apache-2.0
// The film over a change of a cutter's running program: the cuts until the boundary lie as they are, then
// those of the new program follow. See docs/change-of-program.md.
#pragma once

#include "app/program/change_price.h"
#include "app/program/program_change.h"

#include <vector>

namespace campanel::program {

// Lengths in mm, speeds of the film in mm/s.
struct ChangeFilm {
    double fromMm = 0;       // bag length of the old program
    double toMm = 0;         // and of the new one
    double cutToEndMm = 0;   // from a cut of the old program to the end of its cycle, which is the boundary
    double endToCutMm = 0;   // and from there to the first cut of the new one
    double fullSpeed = 0;    // at which the old program runs when the change is ordered,
    double endSpeed = 0;     // to which it slows down,
    double deceleration = 0; // and how, mm/s^2
    int scrap = 0;           // bags that do not count, at most: the first of them is of both programs
};

struct FilmCut {
    // Next is of the new program; NextScrap has a bag at its front that does not count.
    enum class Kind { Present, Skipped, Next, NextScrap };
    double distanceMm = 0; // before the knife
    Kind kind = Kind::Present;

    bool operator==(const FilmCut&) const = default;
};

// Returns the place of the cut in the cycle, 0..1.
[[nodiscard]] double cutShare(const SolvedProgram& solved);

[[nodiscard]] ChangeFilm changeFilm(const SolvedProgram& from, const SolvedProgram& to,
                                    const ProgramChange& change, const ChangePrice& price);

// Returns the cuts up to `reachMm` before the knife, nearest first, for a change that is under way: from the
// next cuts of the old program and the film's present speed.
[[nodiscard]] std::vector<FilmCut>
cutsOverChange(const ChangeFilm& change, const std::vector<FilmCut>& present, double speed, double reachMm);

// Returns them for a change that is ordered with the last cut at the knife, up to the second bag of the new
// program that counts.
[[nodiscard]] std::vector<FilmCut> cutsOfChange(const ChangeFilm& change);

} // namespace campanel::program
