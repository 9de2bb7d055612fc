// SPDX-License-Identifier: Apache-2.0
#include "coder_prints.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace campanel::controller {
namespace {

constexpr std::size_t keptPulses = 32;

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

void CoderPrints::takeCut(const BagCut& cut, bool isPlaced)
{
    m_cutMm = cut.drawnMm;
    // The pulses of several products in one bag follow one another.
    for (std::size_t i = 0; i < cut.products.size(); ++i) {
        ++m_products;
        m_bagged.push_back(isPlaced && i == 0 ? std::optional(cut.drawnMm - m_placeMm) : std::nullopt);
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
