// SPDX-License-Identifier: Apache-2.0
// A transparent item above others that reports each touch before it acts, and stops those that are refused.
// The others get every touch that is not refused.
#pragma once

#include <QQuickItem>
#include <QtQml/qqmlregistration.h>

namespace campanel::controls {

class TouchGate : public QQuickItem {
    Q_OBJECT
    QML_ELEMENT

public:
    explicit TouchGate(QQuickItem* parent = nullptr);

    // Stops the touch that touched() reports.
    Q_INVOKABLE void refuse() { m_isRefused = true; }
    // Returns false for null.
    Q_INVOKABLE bool isIn(QQuickItem* item, QQuickItem* ancestor) const;

signals:
    // `target` gets the touch unless refuse() is called; null: nothing gets it. A control is what has an
    // accessible name.
    void touched(QQuickItem* target, bool isControl);
    // Emitted when a touch has ended and acted.
    void lifted();

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void touchEvent(QTouchEvent* event) override;
    void itemChange(ItemChange change, const ItemChangeData& value) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] QQuickItem* targetAt(QQuickItem& below, const QPointF& scene) const;
    [[nodiscard]] bool stops(const QPointF& scene);

    bool m_isRefused = false;
};

} // namespace campanel::controls
