// SPDX-License-Identifier: Apache-2.0
// Mean and scatter of the last bags, as measured on the cut film.
#pragma once

#include "app/link/link_values.h"
#include "app/panel/kit/numbers.h"

#include <QList>

#include <cstdint>
#include <optional>

namespace campanel::machine {

class BagStatistics {
public:
    static constexpr int bagsKept = 60;

    // Of a controller that does not record its bags: to be given every status; a bag is noted once. True when
    // something changed.
    bool note(std::uint32_t bagCount, std::optional<double> lengthMm, std::optional<double> deviationMm);
    // Of one that does: every record once. A bag of several lengths counts by its deviation from so many.
    // `setLengthMm` of one bag; NaN while it is not known: such a bag does not count.
    void note(const modbus::BagRecord& bag, double setLengthMm);
    // The last bag's length before the first record of it. True when something changed.
    bool noteLength(std::optional<double> lengthMm);
    // Another set length holds from now on. The next bag was begun under the old one and does not count.
    void restart();

    [[nodiscard]] double lengthMm() const { return m_lengthMm; }
    // Bag lengths in the last bag: more than one where cuts were left out.
    [[nodiscard]] int lengths() const { return m_lengths; }
    [[nodiscard]] double deviationMm() const
    {
        return m_deviationsMm.isEmpty() ? unknown : m_deviationsMm.last();
    }
    [[nodiscard]] double meanMm() const; // of the lengths, of a bag of several lengths by one of them
    [[nodiscard]] double meanDeviationMm() const;
    [[nodiscard]] double scatterMm() const; // standard deviation; NaN below two bags
    [[nodiscard]] int countWithin(double toleranceMm) const;
    [[nodiscard]] const QList<double>& deviationsMm() const { return m_deviationsMm; }

private:
    // Counts a bag, unless it is the one that was begun under another set length.
    void count(double deviationMm, double setLengthMm);

    std::optional<std::uint32_t> m_bagCount;
    double m_lengthMm = unknown;
    int m_lengths = 1;
    double m_setLengthMm = unknown; // of the bags that count
    bool m_isNextOfTwoLengths = false;
    bool m_isRecorded = false;    // m_lengthMm is of a record
    QList<double> m_deviationsMm; // oldest first
};

} // namespace campanel::machine
