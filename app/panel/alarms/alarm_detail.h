// SPDX-License-Identifier: Apache-2.0
// One occurrence of an alarm in detail; it is updated while the state changes.
#pragma once

#include "app/panel/alarms/alarm_book.h"

#include <QDate>
#include <QObject>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class AlarmDetail : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The detail belongs to Alarms")
    Q_PROPERTY(QString code READ code NOTIFY changed FINAL)
    Q_PROPERTY(QString title READ title NOTIFY changed FINAL)
    Q_PROPERTY(int severity READ severity NOTIFY changed FINAL) // Alarms.Severity
    Q_PROPERTY(QString severityText READ severityText NOTIFY changed FINAL)
    Q_PROPERTY(QString stateText READ stateText NOTIFY changed FINAL)
    Q_PROPERTY(QString cause READ cause NOTIFY changed FINAL)
    Q_PROPERTY(QString action READ action NOTIFY changed FINAL)
    // The additional text of the occurrence; empty when there is none.
    Q_PROPERTY(QString detail READ detail NOTIFY changed FINAL)
    Q_PROPERTY(QString raisedText READ raisedText NOTIFY changed FINAL)
    Q_PROPERTY(QString returnedText READ returnedText NOTIFY changed FINAL)
    Q_PROPERTY(QString acknowledgedText READ acknowledgedText NOTIFY changed FINAL)
    Q_PROPERTY(int times READ times NOTIFY changed FINAL)
    Q_PROPERTY(bool calls READ calls NOTIFY changed FINAL) // needs to be acknowledged
    Q_PROPERTY(bool shelvable READ shelvable NOTIFY changed FINAL)
    Q_PROPERTY(bool shelved READ shelved NOTIFY changed FINAL) // at present

public:
    using QObject::QObject;

    void show(const store::AlarmRow& row, const AlarmBook& book, const QDate& today);
    // Updates the occurrence after a change of the book.
    void update(const AlarmBook& book, const QDate& today);

    [[nodiscard]] const store::AlarmRow& row() const { return m_row; }
    [[nodiscard]] QString code() const { return m_row.code; }
    [[nodiscard]] QString title() const;
    [[nodiscard]] int severity() const;
    [[nodiscard]] QString severityText() const;
    [[nodiscard]] QString stateText() const;
    [[nodiscard]] QString cause() const;
    [[nodiscard]] QString action() const;
    [[nodiscard]] QString detail() const { return m_row.detail; }
    [[nodiscard]] QString raisedText() const;
    [[nodiscard]] QString returnedText() const;
    [[nodiscard]] QString acknowledgedText() const;
    [[nodiscard]] int times() const { return m_row.count; }
    [[nodiscard]] bool calls() const { return m_row.wantsAcknowledgement && m_row.acknowledgedMs == 0; }
    [[nodiscard]] bool shelvable() const;
    [[nodiscard]] bool shelved() const { return m_isShelved; }
    void noteAcknowledged(qint64 utcMs, const QString& by);

signals:
    void changed();

private:
    [[nodiscard]] const AlarmKind* kind() const { return AlarmCatalogue::find(m_row.code); }

    store::AlarmRow m_row;
    QDate m_today;
    bool m_isShelved = false;
};

} // namespace campanel::panel
