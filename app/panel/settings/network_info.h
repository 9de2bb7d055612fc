// SPDX-License-Identifier: Apache-2.0
// `NetworkInfo` in QML: the clock and the addresses of this computer, read-only. They are set by
// `SystemClock` and `SystemNetwork`.
#pragma once

#include <QDateTime>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

#include <functional>

namespace campanel::panel {

class NetworkInfo : public QObject {
    Q_OBJECT
    QML_ELEMENT
    // The clock, "22 November 2026 14:07:31", and the time zone, "Europe/Berlin (UTC+01:00)".
    Q_PROPERTY(QString clockText READ clockText NOTIFY changed FINAL)
    Q_PROPERTY(QString zoneText READ zoneText NOTIFY changed FINAL)
    // A line for each active interface: "eth0: 192.168.1.20, fe80::1".
    Q_PROPERTY(QStringList networks READ networks NOTIFY changed FINAL)

public:
    explicit NetworkInfo(QObject* parent = nullptr);

    [[nodiscard]] QString clockText() const;
    [[nodiscard]] QString zoneText() const;
    [[nodiscard]] QStringList networks() const { return m_networks; }

    // Fixed values for reproducible captures; they apply to all instances created afterwards.
    struct Fixed {
        QDateTime now;
        QStringList networks;
    };
    static void fix(const Fixed& facts);

signals:
    void changed();

private:
    void refresh();

    QDateTime m_now;
    QStringList m_networks;
    QTimer m_timer;
};

} // namespace campanel::panel
