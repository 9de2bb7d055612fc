// SPDX-License-Identifier: Apache-2.0
// The results of a run of the simulated packing machine: a row for each bag, statistics, and the end of the
// run.
#pragma once

#include "app/cli/failure.h"
#include "app/store/files/csv.h"
#include "packing_run.h"

#include <QByteArray>
#include <QJsonArray>
#include <QJsonObject>

#include <optional>

namespace campanel::cli {

// Mean, standard deviation and largest magnitude of the added values.
class Spread {
public:
    void add(double value);
    [[nodiscard]] std::optional<double> mean() const;
    [[nodiscard]] std::optional<double> deviation() const;
    [[nodiscard]] std::optional<double> rms() const; // of the values themselves
    [[nodiscard]] std::optional<double> largest() const;
    [[nodiscard]] std::uint32_t count() const { return m_count; }

private:
    std::uint32_t m_count = 0;
    double m_mean = 0.0;
    double m_squares = 0.0; // squares of the distances from the mean
    double m_largest = 0.0;
};

// Adds up bag by bag. Figures of accuracy use the settled bags, all others every bag.
class PackingFigures {
public:
    explicit PackingFigures(double toleranceMm)
        : m_toleranceMm(toleranceMm)
    {
    }
    void add(const controller::PackedBag& bag);

    [[nodiscard]] const Spread& lengthMm() const { return m_length; } // deviation from the set length
    [[nodiscard]] const Spread& markMm() const { return m_mark; }     // distance of the cuts from their print
    [[nodiscard]] std::optional<double> shareWithin() const;
    [[nodiscard]] std::optional<double> shareFarFromMark() const; // by more than 0.4 mm
    [[nodiscard]] QJsonObject object(const controller::PackingResult& result, double cpuS) const;

private:
    double m_toleranceMm;
    Spread m_length;
    Spread m_mark;
    std::uint32_t m_farFromMark = 0;
    std::uint32_t m_outside = 0;
    std::uint32_t m_firstOutside = 0; // bag number
    std::uint32_t m_lastOutside = 0;
    std::uint32_t m_throughProduct = 0;
    std::uint32_t m_withJoined = 0; // bags of one length with several products
    std::uint32_t m_scrap = 0;
    std::uint32_t m_phaseLost = 0;
};

// Returns how the machine followed its encoder.
[[nodiscard]] QJsonObject masterObject(const controller::PackingResult& result,
                                       const controller::ShaftOptions& shaft);
[[nodiscard]] store::CsvWriter bagRows();
void addBag(store::CsvWriter& csv, const controller::PackedBag& bag);
[[nodiscard]] QJsonObject bagObject(const controller::PackedBag& bag);

// Returns success when every bag was cut; otherwise the reason and the action.
[[nodiscard]] Outcome outcomeOf(const controller::PackingResult& result);

} // namespace campanel::cli
