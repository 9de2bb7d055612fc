// SPDX-License-Identifier: Apache-2.0
#include "infeed.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace campanel::controller {
namespace {

constexpr double usualLength = 0.6; // share of the bag length
constexpr double misplacedBy = 0.45;
constexpr double minGapMm = 5.0; // between two products
constexpr double shortestMm = 1.0;
constexpr double layShare = 0.5; // of a product, where the laying place is

} // namespace

Infeed::Infeed(const ProductOptions& options, std::uint64_t seed)
    : m_options(options)
    , m_random(seed ^ 0xD1B54A32D192ED03u)
{
}

void Infeed::load(double bagMm, double position)
{
    m_bagMm = bagMm;
    m_position = position;
    // Products on the infeed stay; the first new one starts before the eye.
    const double eye = m_options.eyeMm / m_options.pitchMm;
    m_next = std::max(m_next, static_cast<std::int64_t>(std::floor(position - layShare + eye)) + 1);
}

bool Infeed::hangsTogether()
{
    std::uniform_real_distribution<double> share(0.0, 1.0);
    return m_options.joined > 0.0 && share(m_random) < m_options.joined;
}

void Infeed::generate()
{
    std::uniform_real_distribution<double> share(0.0, 1.0);
    Product product;
    product.number = m_next++;
    const bool joined = hangsTogether();
    const double usualMm = m_options.lengthMm > 0.0 ? m_options.lengthMm : usualLength * m_bagMm;
    product.lengthMm = std::max(shortestMm, usualMm + m_options.lengthScatterMm * m_normal(m_random));
    product.behindMm = m_options.scatterMm * m_normal(m_random);
    const bool missing = share(m_random) < m_options.missing;
    const bool misplaced = share(m_random) < m_options.misplaced;
    const double where = 2.0 * share(m_random) - 1.0;
    if (misplaced)
        product.behindMm = where * misplacedBy * m_bagMm;
    if (joined) { // the next place is empty
        product.pieces = 2;
        product.behindMm += 0.5 * product.lengthMm;
        product.lengthMm *= 2.0;
        ++m_next;
    }
    if (missing)
        return;
    const double pitchMm = std::min(m_options.pitchMm, m_bagMm);
    if (m_last) { // one product pushes the other
        const double places = static_cast<double>(product.number - m_last->number);
        const double room = (m_last->lengthMm + product.lengthMm) / 2.0 + minGapMm;
        product.behindMm = std::max(product.behindMm, m_last->behindMm + room - places * pitchMm);
    }
    m_last = product;
    m_coming.push_back(product);
    const double middle = static_cast<double>(product.number) + layShare +
                          (product.behindMm - m_options.eyeMm) / m_options.pitchMm;
    const double half = 0.5 * product.lengthMm / m_options.pitchMm;
    const double noise = m_options.eyeNoiseMm / m_options.pitchMm;
    m_due.push_back({middle - half + noise * m_normal(m_random), true});
    m_due.push_back({middle + half + noise * m_normal(m_random), false});
}

void Infeed::passEye(double position)
{
    const double eye = m_options.eyeMm / m_options.pitchMm;
    while (static_cast<double>(m_next) + layShare - eye < position + 2.0)
        generate();
    while (!m_due.empty() && m_due.front().position <= position) {
        m_edges.push_back(m_due.front());
        m_due.pop_front();
    }
}

void Infeed::layOne(double drawnMm)
{
    const Product product = m_coming.front();
    m_coming.pop_front();
    const double wayMm = std::floor(m_options.layMm / m_bagMm) * m_bagMm + 0.5 * m_bagMm;
    const double middle = drawnMm + wayMm + product.behindMm + m_options.laySlipMm * m_normal(m_random);
    const double pieceMm = product.lengthMm / product.pieces;
    for (int i = 0; i < product.pieces; ++i) {
        const double leadMm = middle - 0.5 * product.lengthMm + i * pieceMm;
        m_laid.push_back({leadMm, leadMm + pieceMm});
    }
}

void Infeed::moveTo(double position, double drawnBeforeMm, double drawnMm)
{
    if (!(m_bagMm > 0.0))
        return;
    passEye(position);
    while (!m_coming.empty() && static_cast<double>(m_coming.front().number) + layShare <= position) {
        const double due = static_cast<double>(m_coming.front().number) + layShare;
        const double way = position - m_position;
        const double part = way > 0.0 ? std::clamp((due - m_position) / way, 0.0, 1.0) : 1.0;
        layOne(drawnBeforeMm + part * (drawnMm - drawnBeforeMm));
    }
    m_position = position;
}

std::optional<Infeed::Edge> Infeed::takeEdge()
{
    if (m_edges.empty())
        return std::nullopt;
    const Edge edge = m_edges.front();
    m_edges.pop_front();
    return edge;
}

Infeed::Cut Infeed::cut(double drawnMm)
{
    Cut result;
    for (const Laid& laid : m_laid)
        result.through = result.through || (laid.leadMm < drawnMm && drawnMm < laid.trailMm);
    const auto past = std::stable_partition(m_laid.begin(), m_laid.end(), [drawnMm](const Laid& laid) {
        return 0.5 * (laid.leadMm + laid.trailMm) >= drawnMm;
    });
    result.products.assign(past, m_laid.end());
    m_laid.erase(past, m_laid.end());
    return result;
}

} // namespace campanel::controller
