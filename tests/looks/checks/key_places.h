// SPDX-License-Identifier: Apache-2.0
// Checks the places of keys: those of one page in all its states, and those beside a keypad, a sheet or a
// banner.
#pragma once

#include <QHash>
#include <QMap>
#include <QRectF>
#include <QStringList>

class QQuickItem;

namespace campanel::looks {

// Returns a fault for each key that something covers in part, of those with which a person goes on: Start,
// Stop, undo, redo, the next step, and the keys of a keypad, a sheet or a banner. They are covered wholly or
// not at all.
[[nodiscard]] QStringList checkCovered(QQuickItem& root);

// The places of the keys of one page in its states. A second tap on one spot must be the same key.
class KeyPlaces {
public:
    // Adds the page as it is now; a screen that is no state of a page is ignored.
    void add(const QString& screen, QQuickItem& root);
    // Returns a fault for each key that moves, and for each two keys that share a place, between two states.
    [[nodiscard]] QStringList faults() const;

private:
    struct State {
        QString screen;
        QHash<QString, QRectF> keys;
    };
    QMap<QString, QList<State>> m_pages;
};

} // namespace campanel::looks
