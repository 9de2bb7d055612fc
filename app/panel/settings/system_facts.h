// SPDX-License-Identifier: Apache-2.0
// `SystemFacts` in QML: the clock and the network of this computer, to look at. They are set where the system
// is, not here.
#pragma once

#include <QDateTime>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

#include <functional>

namespace campanel::machine {

class SystemFacts : public QObject {
    Q_OBJECT
    QML_ELEMENT
    // "22 November 2026 14:07:31", "Europe/Berlin (UTC+01:00)".
    Q_PROPERTY(QString clockText READ clockText NOTIFY changed FINAL)
    Q_PROPERTY(QString zoneText READ zoneText NOTIFY changed FINAL)
    // A line for each interface that is up: "eth0: 192.168.1.20, fe80::1".
    Q_PROPERTY(QStringList networks READ networks NOTIFY changed FINAL)

public:
    explicit SystemFacts(QObject* parent = nullptr);

    [[nodiscard]] QString clockText() const;
    [[nodiscard]] QString zoneText() const;
    [[nodiscard]] QStringList networks() const { return m_networks; }

    // For captures, which must not depend on where they are made; of all that are made afterwards.
    struct Fixed {
        QDateTime now;
        QStringList networks;
    };
    static void fix(const Fixed& facts);

signals:
    void changed();

private:
    void look();

    QDateTime m_now;
    QStringList m_networks;
    QTimer m_timer;
};

} // namespace campanel::machine
