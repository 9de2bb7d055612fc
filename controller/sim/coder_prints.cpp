// SPDX-License-Identifier: Apache-2.0
#include "coder_prints.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace campanel::controller {
namespace {

constexpr std::size_t keptPulses = 32;
constexpr double acrossMm = 10.0; // from a cut to the middle of a product

} // namespace

void CoderPrints::takePulse(double drawnMm)
{
    ++m_pulses;
    m_due.push_back(drawnMm);
    m_last.push_back(drawnMm);
    if (m_last.size() > keptPulses)
        m_last.pop_front();
    match();
}

// Returns where the pulse of a product belongs whose middle is so far before the cut.
std::optional<double> CoderPrints::placeOf(double behindMm, int placedLengths, double bagMm)
{
    const int length = static_cast<int>(std::floor(behindMm / bagMm));
    const double inLengthMm = behindMm - length * bagMm;
    const bool isFirst = m_length != length;
    m_length = length;
    if (!isFirst || length >= placedLengths || std::min(inLengthMm, bagMm - inLengthMm) < acrossMm)
        return std::nullopt;
    return m_cutMm - length * bagMm - m_placeMm;
}

void CoderPrints::takeCut(const BagCut& cut, int placedLengths, double bagMm)
{
    m_cutMm = cut.drawnMm;
    m_length.reset();
    for (const auto& product : cut.products) {
        ++m_products;
        const double middleMm = (product.leadMm + product.trailMm) / 2;
        m_bagged.push_back(placeOf(cut.drawnMm - middleMm, placedLengths, bagMm));
    }
    match();
}

// Pulses of products in front of the knife wait for their bags.
void CoderPrints::forgetUnseen()
{
    m_bagged.clear();
    m_due.clear();
    std::ranges::copy_if(m_last, std::back_inserter(m_due),
                         [this](double pulse) { return pulse + m_placeMm > m_cutMm + 1.0; });
}

// Products and pulses are in the same order.
void CoderPrints::match()
{
    while (!m_due.empty() && !m_bagged.empty()) {
        if (m_bagged.front()) {
            ++m_placed;
            m_farthestMm = std::max(m_farthestMm, std::abs(m_due.front() - *m_bagged.front()));
        }
        m_due.pop_front();
        m_bagged.pop_front();
    }
}

} // namespace campanel::controller
