// SPDX-License-Identifier: Apache-2.0
// What a run of the simulated packing machine says: a row for each bag, figures over all, how it ended.
#pragma once

#include "app/cli/failure.h"
#include "packing_run.h"

#include <QByteArray>
#include <QJsonArray>
#include <QJsonObject>

#include <optional>

namespace campanel::cli {

// Mean, standard deviation and largest magnitude of what was added.
class Spread {
public:
    void add(double value);
    [[nodiscard]] std::optional<double> mean() const;
    [[nodiscard]] std::optional<double> deviation() const;
    [[nodiscard]] std::optional<double> largest() const;
    [[nodiscard]] std::uint32_t count() const { return m_count; }

private:
    std::uint32_t m_count = 0;
    double m_mean = 0.0;
    double m_squares = 0.0; // of the distances from the mean
    double m_largest = 0.0;
};

// Counts bag by bag. Figures of accuracy are those of the settled bags, all others those of every bag.
class PackingFigures {
public:
    explicit PackingFigures(double toleranceMm)
        : m_toleranceMm(toleranceMm)
    {
    }
    void add(const controller::PackedBag& bag);

    [[nodiscard]] const Spread& lengthMm() const { return m_length; } // deviation from the set one
    [[nodiscard]] std::optional<double> shareWithin() const;
    [[nodiscard]] QJsonObject object(const controller::PackingResult& result, double cpuS) const;

private:
    double m_toleranceMm;
    Spread m_length;
    Spread m_mark;
    std::uint32_t m_outside = 0;
    std::uint32_t m_firstOutside = 0; // bag number
    std::uint32_t m_lastOutside = 0;
    std::uint32_t m_throughProduct = 0;
    std::uint32_t m_phaseLost = 0;
};

[[nodiscard]] QByteArray bagHeader();
[[nodiscard]] QByteArray bagRow(const controller::PackedBag& bag);
[[nodiscard]] QJsonObject bagObject(const controller::PackedBag& bag);

// Nothing when every bag was cut; otherwise why not, and what to do.
[[nodiscard]] Outcome outcomeOf(const controller::PackingResult& result);

} // namespace campanel::cli
