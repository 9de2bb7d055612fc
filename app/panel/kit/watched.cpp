// SPDX-License-Identifier: Apache-2.0
#include "app/panel/kit/watched.h"

#include <utility>

namespace campanel::panel {

void Watched::setWatched(bool isWatched)
{
    if (std::exchange(m_isWatched, isWatched) != isWatched)
        emit watchedChanged();
}

void Watched::setWatchedBy(QObject* page, bool isWatching)
{
    if (isWatching)
        m_pages.insert(page);
    else
        m_pages.remove(page);
    setWatched(!m_pages.isEmpty());
}

void Watched::updateEvery(std::chrono::milliseconds period, const std::function<void()>& update)
{
    m_timer.setInterval(period);
    m_timer.callOnTimeout(this, update);
    connect(this, &Watched::watchedChanged, this, [this, update] {
        if (!m_isWatched)
            return m_timer.stop();
        m_timer.start();
        update();
    });
}

} // namespace campanel::panel
