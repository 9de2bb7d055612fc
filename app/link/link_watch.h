// SPDX-License-Identifier: Apache-2.0
// Reports the line's record while it is watched: the figures once a second, the frames ten times. Lives in
// the link thread; costs nothing while nobody watches.
#pragma once

#include "app/link/link_values.h"

#include <QObject>
#include <QTimer>

#include <memory>

namespace campanel::link {

class LinkWatch : public QObject {
    Q_OBJECT

public:
    LinkWatch(std::shared_ptr<modbus::LinkRecord> record, QObject* parent);

    void watchFigures(bool isWatched);
    void resetFigures();
    void watchFrames(bool isWatched);

signals:
    void figuresReported(const campanel::link::FiguresReport& report);
    void framesRecorded(const QList<campanel::modbus::FrameRecord>& frames);

private:
    void reportFigures();
    void reportFrames();

    std::shared_ptr<modbus::LinkRecord> m_record;
    QTimer m_figuresTimer;
    QTimer m_framesTimer;
    std::uint64_t m_lastFrame = 0;
};

} // namespace campanel::link
