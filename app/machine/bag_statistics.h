// SPDX-License-Identifier: Apache-2.0
// Mean and scatter of the last bags, as measured on the cut film.
#pragma once

#include <QList>

#include <cstdint>
#include <limits>
#include <optional>

namespace campanel::machine {

class BagStatistics {
public:
    static constexpr int bagsKept = 60;

    // To be given every status; a bag is noted once. True when something changed.
    bool note(std::uint32_t bagCount, std::optional<double> lengthMm, std::optional<double> deviationMm);
    // Another set length holds from now on. The next bag was begun under the old one and does not count.
    void restart();

    [[nodiscard]] double lengthMm() const { return m_lengthMm; }
    [[nodiscard]] double deviationMm() const
    {
        return m_deviationsMm.isEmpty() ? unknown : m_deviationsMm.last();
    }
    [[nodiscard]] double meanMm() const;    // of the lengths
    [[nodiscard]] double scatterMm() const; // standard deviation; NaN below two bags
    [[nodiscard]] const QList<double>& deviationsMm() const { return m_deviationsMm; }

private:
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    std::optional<std::uint32_t> m_bagCount;
    double m_lengthMm = unknown;
    double m_setLengthMm = unknown; // of the bags that count
    bool m_isNextOfTwoLengths = false;
    QList<double> m_deviationsMm; // oldest first
};

} // namespace campanel::machine
