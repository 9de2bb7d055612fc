// SPDX-License-Identifier: Apache-2.0
// The prints of a date coder: its pulses against the products that the cuts found in their bags. The machine
// counts both by itself; what the controller knows of products is not used.
#pragma once

#include "machine.h"

#include <cstdint>
#include <deque>
#include <optional>

namespace campanel::controller {

class CoderPrints {
public:
    // Each pulse is to come so much film before the cut behind its product.
    explicit CoderPrints(double placeMm)
        : m_placeMm(placeMm)
    {
    }

    void takePulse(double drawnMm);
    // The bag is cut behind lengths of `bagMm`. The prints of the last `placedLengths` of them must be in
    // their places; a product across two of them belongs to the one or the other, and the second one in a
    // length waits for the pulse of the first.
    void takeCut(const BagCut& cut, int placedLengths, double bagMm);

    // The products in bags without a pulse lay on the film before the controller could see them.
    void forgetUnseen();

    [[nodiscard]] std::uint32_t products() const { return m_products; }
    [[nodiscard]] std::uint32_t pulses() const { return m_pulses; }
    // Return the prints that had to be in their places, and the largest distance from one.
    [[nodiscard]] std::uint32_t placed() const { return m_placed; }
    [[nodiscard]] double farthestMm() const { return m_farthestMm; }
    // Return the pulses of products that are not cut yet, and the products in bags without their pulse.
    [[nodiscard]] std::size_t ahead() const { return m_due.size(); }
    [[nodiscard]] std::size_t waiting() const { return m_bagged.size(); }

private:
    void match();
    [[nodiscard]] std::optional<double> placeOf(double behindMm, int placedLengths, double bagMm);

    double m_placeMm;
    std::uint32_t m_products = 0;
    std::uint32_t m_pulses = 0;
    std::uint32_t m_placed = 0;
    double m_farthestMm = 0.0;
    std::deque<double> m_due;                   // pulses, film drawn
    std::deque<double> m_last;                  // the last pulses, matched or not
    double m_cutMm = 0.0;                       // the last cut
    std::optional<int> m_length;                // of the last product in its bag, counted from its end
    std::deque<std::optional<double>> m_bagged; // products in bags: the film where their pulse belongs
};

} // namespace campanel::controller
