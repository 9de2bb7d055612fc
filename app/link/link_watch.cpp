// SPDX-License-Identifier: Apache-2.0
#include "app/link/link_watch.h"

using namespace std::chrono_literals;

namespace campanel::link {

LinkWatch::LinkWatch(std::shared_ptr<modbus::LinkRecord> record, QObject* parent)
    : QObject(parent)
    , m_record(std::move(record))
    , m_figuresTimer(this)
    , m_framesTimer(this)
{
    m_figuresTimer.setInterval(1s);
    m_framesTimer.setInterval(100ms);
    connect(&m_figuresTimer, &QTimer::timeout, this, &LinkWatch::reportFigures);
    connect(&m_framesTimer, &QTimer::timeout, this, &LinkWatch::reportFrames);
}

void LinkWatch::watchFigures(bool isWatched)
{
    if (!isWatched) {
        m_figuresTimer.stop();
        return;
    }
    m_figuresTimer.start();
    reportFigures();
}

void LinkWatch::resetFigures()
{
    m_record->figures = {};
    if (m_figuresTimer.isActive())
        reportFigures();
}

void LinkWatch::watchFrames(bool isWatched)
{
    if (!isWatched) {
        m_framesTimer.stop();
        return;
    }
    m_lastFrame = 0;
    m_framesTimer.start();
    reportFrames();
}

void LinkWatch::reportFigures()
{
    emit figuresReported({std::chrono::steady_clock::now(), m_record->figures, m_record->allowance});
}

void LinkWatch::reportFrames()
{
    const std::vector<modbus::FrameRecord> frames = m_record->frames.since(m_lastFrame);
    if (frames.empty())
        return;
    m_lastFrame = frames.back().number;
    emit framesRecorded(QList<modbus::FrameRecord>(frames.begin(), frames.end()));
}

} // namespace campanel::link
