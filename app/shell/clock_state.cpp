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

bool isClockUnset(const std::function<bool()>& isSynchronized, const QString& rtcFolder)
{
    const QDir clocks(rtcFolder);
    for (const QString& name : clocks.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile mark(clocks.filePath(name + u"/hctosys"_s));
        if (mark.open(QIODevice::ReadOnly) && mark.readAll().trimmed() == "1")
            return false;
    }
    return !isSynchronized();
}

} // namespace campanel::shell
