// SPDX-License-Identifier: Apache-2.0
// The price of a change of a cutter's running program: scrap until the cuts follow the marks again, and cuts
// that are skipped because products of the old spacing lie under them. Where the marks of the new film will
// be is unknown before: the price is a range over all places. See controller/core/packer/README.md.
#pragma once

#include "app/program/program_change.h"

namespace campanel::program {

// The line that makes the bags; all in mm.
struct PriceParameters {
    bool tracksMarks = true;
    double phaseLimitMm = 0;  // of one cut, once it follows its mark; 0: a tenth of a bag
    double productMm = 0;     // length of a product; 0: none is seen
    double clearanceMm = 0;   // between product and cut
    double layDistanceMm = 0; // from the laying place to the knife
    bool hasAntiCut = false;  // cuts over products are skipped
};

struct ChangePrice {
    int minScrap = 0; // bags that do not count
    int maxScrap = 0;
    int maxSkipped = 0;      // cuts
    double longestBagMm = 0; // of several lengths; 0: no cut is skipped
    double maxSeconds = 0;   // from the order to the end of the first bag that counts
};

// Returns the price of the change between two programs of the same cutter while it runs at full speed.
[[nodiscard]] ChangePrice changePrice(const SolvedProgram& from, const SolvedProgram& to,
                                      const ProgramChange& change, const PriceParameters& parameters);

} // namespace campanel::program
