// SPDX-License-Identifier: Apache-2.0
#include "app/shell/clock_state.h"

#include <QDir>
#include <QFile>

#include <sys/timex.h>

using namespace Qt::StringLiterals;

namespace campanel::shell {

bool isClockSynchronized()
{
    timex state{};
    return adjtimex(&state) != -1 && (state.status & STA_UNSYNC) == 0;
}

store::ClockState clockState(const std::function<bool()>& isSynchronized, const QString& rtcFolder)
{
    if (isSynchronized())
        return store::ClockState::Proven;
    const QDir clocks(rtcFolder);
    for (const QString& name : clocks.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile mark(clocks.filePath(name + u"/hctosys"_s));
        if (mark.open(QIODevice::ReadOnly) && mark.readAll().trimmed() == "1")
            return store::ClockState::Unproven;
    }
    return store::ClockState::NotSet;
}

} // namespace campanel::shell
