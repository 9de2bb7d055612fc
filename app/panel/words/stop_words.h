// SPDX-License-Identifier: Apache-2.0
// States, reasons of stops and durations as translated text.
#pragma once

#include "app/store/logs/stop_log.h"

#include <QCoreApplication>

namespace campanel::panel {

class StopWords {
    Q_DECLARE_TR_FUNCTIONS(StopWords)

public:
    [[nodiscard]] static QString state(store::StateInterval::State state);
    // Returns the words of a part of a reason: "Film change" for "film_change". Other texts stay.
    [[nodiscard]] static QString reasonPart(const QString& part);
    // Returns "Material · Film change", the title of an alarm with its code, or "No reason".
    [[nodiscard]] static QString reason(const QString& reason);
    // Returns "45 s", "12 min" or "1 h 05 min".
    [[nodiscard]] static QString duration(qint64 durationMs);
};

} // namespace campanel::panel
