// SPDX-License-Identifier: Apache-2.0
// Mean and scatter of the last bags, as measured on the cut film.
#pragma once

#include "app/link/link_values.h"
#include "app/panel/kit/numbers.h"

#include <QList>

#include <cstdint>
#include <optional>

namespace campanel::panel {

class BagStatistics {
public:
    static constexpr int bagsKept = 60;

    // Adds the status of a controller that does not record its bags; a bag is counted once. Returns true when
    // something changed.
    bool note(std::uint32_t bagCount, std::optional<double> lengthMm, std::optional<double> deviationMm);
    // Adds one record of a controller that records its bags. A bag of several lengths counts by its deviation
    // from that many lengths. Start-up scrap and bags of two programs are left out and counted as such.
    // `setLengthMm` is that of one bag; when it is NaN, the bag does not count.
    void note(const modbus::BagRecord& bag, double setLengthMm);
    // Sets the last bag's length before its first record. Returns true when something changed.
    bool noteLength(std::optional<double> lengthMm);
    // Restarts with another set length, and counts what is left out anew. `isNextOfTwo`: the next bag was
    // begun under the old length and does not count.
    void restart(bool isNextOfTwo);
    // Marks in the series that bags before the next one are unknown.
    void noteGap();

    [[nodiscard]] double lengthMm() const { return m_lengthMm; }
    // Returns the bag lengths in the last bag: more than one after skipped cuts.
    [[nodiscard]] int lengths() const { return m_lengths; }
    [[nodiscard]] double deviationMm() const
    {
        return m_deviationsMm.isEmpty() ? unknown : m_deviationsMm.last();
    }
    [[nodiscard]] double meanMm() const; // mean length; a bag of several lengths counts as one
    [[nodiscard]] double meanDeviationMm() const;
    [[nodiscard]] double scatterMm() const; // standard deviation; NaN below two bags
    [[nodiscard]] int countWithin(double toleranceMm) const;
    // Returns the bags left out since the last restart.
    [[nodiscard]] int scrap() const { return m_scrap; }
    // Returns true when the last bag was left out.
    [[nodiscard]] bool isLastScrap() const { return m_isLastScrap; }
    [[nodiscard]] const QList<double>& deviationsMm() const { return m_deviationsMm; }
    // Returns the deviations with NaN where bags between them are unknown.
    [[nodiscard]] const QList<double>& series() const { return m_series; }

private:
    // Counts a bag, unless it was begun under another set length.
    void count(double deviationMm, double setLengthMm);

    std::optional<std::uint32_t> m_bagCount;
    double m_lengthMm = unknown;
    int m_lengths = 1;
    double m_setLengthMm = unknown; // set length of the counted bags
    bool m_isNextOfTwoLengths = false;
    bool m_isRecorded = false; // m_lengthMm comes from a record
    bool m_isLastScrap = false;
    int m_scrap = 0;
    QList<double> m_deviationsMm; // oldest first
    QList<double> m_series;       // the same with gaps
};

} // namespace campanel::panel
