// SPDX-License-Identifier: Apache-2.0
// The model: the film's place against its motor is a random walk (variance q per bag), seen with white noise
// (variance r). Prediction with the gain K of the steady Kalman filter is then the best there is:
//     P = (q + sqrt(q^2 + 4 q r)) / 2,  K = P / (P + r)
// (J. F. Muth, Optimal properties of exponentially weighted forecasts, 1960). The distances between marks,
// d_i = s_i + n_i - n_(i-1), are a moving average of the filter's own innovations, d_i = e_i - (1 - K)
// e_(i-1) with variance S = P + r; so K is the one that leaves the smallest sum of e^2 (maximum likelihood).
// From var d = q + 2 r and the covariance -r of neighbors the same K follows, but with twice its scatter at
// 100 bags. Backwards: q = K^2 S, r = (1 - K) S. With n distances K itself scatters by sqrt((1 - (1 - K)^2) /
// n) (G. E. P. Box, G. M. Jenkins, Time Series Analysis, 1970).
#include "app/panel/packing/gain_estimate.h"

#include <algorithm>
#include <cmath>

namespace campanel::panel {

namespace {

constexpr double minScatterMm = 0.002; // below the resolution of the registers no estimate is possible
constexpr double minPhaseGain = 0.1;
constexpr double maxPhaseGain = 0.6;
constexpr double minLengthGain = 0.02;
constexpr double maxLengthGain = 0.2;
constexpr double gainStep = 0.01;
constexpr int fewestBags = 50; // below, no margin means anything
constexpr double maxMarginShare = 0.1;
// The number of distances that lie along a straight line: the film's stretch changes slowly.
constexpr std::size_t longestRun = 100;
constexpr std::size_t shortestRun = 10;
constexpr double jumpMm = 1.5; // an error that the controller does not count as slip

// Returns the values without their mean and slope.
std::vector<double> withoutLine(const std::vector<double>& values)
{
    const double middle = (static_cast<double>(values.size()) - 1.0) / 2.0;
    double sum = 0.0;
    double moment = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double x = static_cast<double>(i) - middle;
        sum += values[i];
        moment += x * values[i];
        squares += x * x;
    }
    const double mean = sum / static_cast<double>(values.size());
    std::vector<double> result(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        result[i] = values[i] - mean - (static_cast<double>(i) - middle) * moment / squares;
    return result;
}

// Returns the sum of the squared prediction errors of a filter with this gain.
double unforeseen(const std::vector<double>& distances, double gain)
{
    double innovation = 0.0;
    double sum = 0.0;
    for (const double distance : distances) {
        innovation = distance + (1.0 - gain) * innovation;
        sum += innovation * innovation;
    }
    return sum;
}

} // namespace

// Adds a mark. The controller expects the next mark one filtered distance after the assumed position of this
// one. The assumed position is the expected one plus the phase gain's share of the error. So the measured
// distance is pitch + error - (1 - gain) * error before.
void GainEstimate::take(const MarkSample& mark, double phaseGain)
{
    if (m_before && m_before->marks == mark.marks && m_before->missing == mark.missing)
        return;
    const auto before = m_before;
    m_before = mark;
    const bool follows = before && mark.marks == before->marks + 1 && mark.missing == before->missing &&
                         std::abs(mark.errorMm) < jumpMm && std::abs(before->errorMm) < jumpMm &&
                         std::abs(mark.pitchMm - before->pitchMm) < jumpMm;
    if (!follows) {
        if (!m_runs.empty() && !m_runs.back().empty())
            m_runs.emplace_back();
        return;
    }
    if (m_runs.empty() || m_runs.back().size() == longestRun)
        m_runs.emplace_back();
    m_runs.back().push_back(before->pitchMm + mark.errorMm - (1.0 - phaseGain) * before->errorMm);
    while (bags() > maxBags || m_runs.size() > static_cast<std::size_t>(maxBags))
        m_runs.pop_front();
}

int GainEstimate::bags() const
{
    std::size_t bags = 0;
    for (const Run& run : m_runs)
        bags += run.size() >= shortestRun ? run.size() : 0;
    return static_cast<int>(bags);
}

std::optional<GainSuggestion> GainEstimate::suggestion() const
{
    if (bags() < fewestBags)
        return std::nullopt;
    std::vector<std::vector<double>> runs;
    for (const Run& run : m_runs) {
        if (run.size() >= shortestRun)
            runs.push_back(withoutLine(run));
    }
    double best = 0.0;
    double least = 0.0;
    for (double gain = gainStep; gain <= 1.0; gain += gainStep) {
        double sum = 0.0;
        for (const auto& run : runs)
            sum += unforeseen(run, gain);
        if (best == 0.0 || sum < least) {
            best = gain;
            least = sum;
        }
    }
    const double variance = least / bags();
    if (variance < minScatterMm * minScatterMm)
        return std::nullopt;
    GainSuggestion suggestion;
    suggestion.margin = std::sqrt((1.0 - (1.0 - best) * (1.0 - best)) / bags());
    if (bags() < minBags && suggestion.margin > maxMarginShare * best)
        return std::nullopt;
    suggestion.slipMm = best * std::sqrt(variance);
    suggestion.sensorMm = std::sqrt((1.0 - best) * variance);
    suggestion.phaseGain = std::clamp(best, minPhaseGain, maxPhaseGain);
    // The length gain with the best settling for it: T. R. Benedict, G. W. Bordner, 1962.
    const double length = suggestion.phaseGain * suggestion.phaseGain / (2.0 - suggestion.phaseGain);
    suggestion.lengthGain = std::clamp(length, minLengthGain, maxLengthGain);
    return suggestion;
}

} // namespace campanel::panel
