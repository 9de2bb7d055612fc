// SPDX-License-Identifier: Apache-2.0
// The segments of a cam in words: why they are refused, how they continue at the joints.
#pragma once

#include "profile/model/refusal.h"
#include "profile/segments/segment_cam.h"

#include <QCoreApplication>

namespace campanel::panel {

class SegmentSentences {
    Q_DECLARE_TR_FUNCTIONS(SegmentSentences)

public:
    // Returns the reason, the place and the nearest possible value; of a limit of the segments.
    [[nodiscard]] static QString refusal(const profile::Refusal& refusal);
    // Returns the first jump of valid segments, or that there is none.
    [[nodiscard]] static QString continuity(const profile::SegmentCamProgram& program);
    [[nodiscard]] static QString motionName(profile::SegmentMotion motion);

private:
    [[nodiscard]] static QString outOfRange(const profile::Refusal& refusal, const QString& actual,
                                            const QString& allowed);
};

} // namespace campanel::panel
