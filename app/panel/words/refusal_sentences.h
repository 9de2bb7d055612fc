// SPDX-License-Identifier: Apache-2.0
// Refusals and limits of a program as whole translated sentences: which limit, by how much, where, what to
// do.
#pragma once

#include "app/panel/kit/format.h"
#include "app/program/program_image.h"
#include "profile/cutter/limits.h"

#include <QCoreApplication>

namespace campanel::panel {

class RefusalSentences {
    Q_DECLARE_TR_FUNCTIONS(RefusalSentences)

public:
    [[nodiscard]] static QString refusal(const profile::Refusal& refusal);
    // Returns the refusal with its nearest possible values.
    [[nodiscard]] static QString withSuggestions(const profile::Refusal& refusal);
    // Returns the same for each exceeded limit, or the value that cannot be stored.
    [[nodiscard]] static QString program(const program::ProgramRefusal& refusal);
    // Returns the text of a button: "Rate 143.2 bags/min", "Widen the window".
    [[nodiscard]] static QString suggestion(const profile::Suggestion& suggestion);
    // Returns what other ratios do, and the rate that they make possible.
    [[nodiscard]] static QString rampsName(const profile::RampOffer& offer); // "Longer ramps"
    [[nodiscard]] static QString rampsRate(const profile::RampOffer& offer); // "291.0 bags/min"
    // Returns the fastest rate of this motion and what sets it, beside a limit of the machine.
    [[nodiscard]] static QString possible(const profile::FastestRate& fastest);
    [[nodiscard]] static QString withinLimits(const std::optional<profile::FastestRate>& fastest);
    [[nodiscard]] static QString closeToLimits(const std::optional<profile::FastestRate>& fastest);
    // Returns "60.0 mm", as exact as needed to differ from the value beside it in the sentence.
    [[nodiscard]] static QString valueWithUnit(profile::Field field, double value,
                                               std::optional<double> beside = {});
    // Returns an approved window, "55.0 to 70.0 bags/min", and a value outside its window,
    // "Rate 80.0 bags/min, approved 55.0 to 70.0 bags/min".
    [[nodiscard]] static QString window(profile::Field field, const program::ApprovedWindow& window);
    [[nodiscard]] static QString outside(const program::Excess& excess);

private:
    [[nodiscard]] static QString limitBroken(const profile::Refusal& refusal);
    [[nodiscard]] static QString limitBrokenAt(const profile::Refusal& refusal);
    [[nodiscard]] static QString axisLimitBrokenAt(profile::Limit limit, const QString& actual,
                                                   const QString& allowed, const QString& time);
    [[nodiscard]] static QString jaw(const profile::Refusal& refusal);
    [[nodiscard]] static QString numbers(const profile::Suggestion& suggestion);
    [[nodiscard]] static QString knot(const profile::Refusal& refusal);
};

} // namespace campanel::panel
