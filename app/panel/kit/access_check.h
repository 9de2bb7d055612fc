// SPDX-License-Identifier: Apache-2.0
// The person at the panel and what that person may do. Every function that changes something asks this check
// itself, not only the screen. A refused person is asked to log in. Without PINs the check admits everybody.
#pragma once

#include <QObject>
#include <QString>

namespace campanel::panel {

// The levels. Viewer: nobody is logged in, and operators need a login too.
enum class Level { Viewer, Operator, Technician, Service };

class AccessCheck : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] Level level() const { return m_level; }
    // Returns the name; empty: nobody is logged in.
    [[nodiscard]] QString person() const { return m_person; }
    void setLevel(Level level, const QString& person = {})
    {
        m_level = level;
        m_person = person;
    }
    // Returns false and emits refused() when the level is too low.
    [[nodiscard]] bool require(Level needed)
    {
        if (m_level >= needed)
            return true;
        emit refused(needed);
        return false;
    }

signals:
    void refused(campanel::panel::Level needed);

private:
    Level m_level = Level::Service;
    QString m_person;
};

} // namespace campanel::panel
