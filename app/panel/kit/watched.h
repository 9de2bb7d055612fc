// SPDX-License-Identifier: Apache-2.0
// The base of an object that is kept up to date only while a page shows it. Derived classes connect to
// watchedChanged() for what they do besides.
#pragma once

#include <QObject>
#include <QSet>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

#include <chrono>
#include <functional>

namespace campanel::panel {

class Watched : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The base of objects that are watched")
    // True while a page shows the object.
    Q_PROPERTY(bool watched READ watched WRITE setWatched NOTIFY watchedChanged FINAL)

public:
    [[nodiscard]] bool watched() const { return m_isWatched; }
    void setWatched(bool isWatched);
    // Says whether that page shows the object, where several pages do.
    Q_INVOKABLE void setWatchedBy(QObject* page, bool isWatching);

signals:
    void watchedChanged();

protected:
    using QObject::QObject;

    // Calls `update` at once when the object becomes watched, then periodically until it is not.
    void updateEvery(std::chrono::milliseconds period, const std::function<void()>& update);

private:
    QTimer m_timer;
    QSet<const QObject*> m_pages; // those that show the object
    bool m_isWatched = false;
};

} // namespace campanel::panel
