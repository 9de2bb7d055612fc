// SPDX-License-Identifier: Apache-2.0
// What the person at the panel may do now. Everything that changes something asks the gate where it is done,
// not only where it is shown; who is turned away is asked to log in. Without PINs it admits everybody.
#pragma once

#include <QObject>

namespace campanel::machine {

// Viewer: nobody is logged in where operators log in too.
enum class Level { Viewer, Operator, Technician, Service };

class Gate : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] Level level() const { return m_level; }
    void setLevel(Level level) { m_level = level; }
    // False with a refused().
    [[nodiscard]] bool admits(Level needed)
    {
        if (m_level >= needed)
            return true;
        emit refused(needed);
        return false;
    }

signals:
    void refused(campanel::machine::Level needed);

private:
    Level m_level = Level::Service;
};

} // namespace campanel::machine
