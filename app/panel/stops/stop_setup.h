// SPDX-License-Identifier: Apache-2.0
// `Stops.setup` in QML: the shifts, the working days, and the list of reasons.
// Everything is a setting that the level Service may change.
#pragma once

#include "app/panel/kit/row_model.h"
#include "app/panel/stops/reason_editor.h"

#include <QObject>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class Settings;

// The start of a shift, in minutes of the day, and between which values it can be moved.
struct ShiftStartRow {
    Q_GADGET
    Q_PROPERTY(QString text READ text)
    Q_PROPERTY(int minutes MEMBER minutes)
    Q_PROPERTY(int earliest MEMBER earliest)
    Q_PROPERTY(int latest MEMBER latest)

public:
    int number = 0;
    int minutes = 0;
    int earliest = 0;
    int latest = 0;

    [[nodiscard]] QString text() const
    {
        return QTime::fromMSecsSinceStartOfDay(minutes * 60'000).toString(QStringLiteral("HH:mm"));
    }
    bool operator==(const ShiftStartRow&) const = default;
};

class StopSetup : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The setup belongs to Stops")
    Q_PROPERTY(QString shiftsText READ shiftsText NOTIFY changed FINAL)
    Q_PROPERTY(QString daysText READ daysText NOTIFY changed FINAL)
    Q_PROPERTY(QString reasonsText READ reasonsText NOTIFY changed FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* starts READ starts CONSTANT FINAL)
    Q_PROPERTY(bool canAddStart READ canAddStart NOTIFY changed FINAL)
    // The names of the days, Monday first, and which of them are working days.
    Q_PROPERTY(QStringList dayNames READ dayNames NOTIFY changed FINAL)
    Q_PROPERTY(QList<int> workingDays READ workingDays NOTIFY changed FINAL)
    Q_PROPERTY(campanel::panel::ReasonEditor* reasons READ reasons CONSTANT FINAL)

public:
    // The settings must outlive the object.
    explicit StopSetup(Settings& settings);

    [[nodiscard]] QString shiftsText() const;
    [[nodiscard]] QString daysText() const;
    [[nodiscard]] QString reasonsText() const;
    [[nodiscard]] RowModel<ShiftStartRow, &ShiftStartRow::number>* starts() { return &m_starts; }
    [[nodiscard]] bool canAddStart() const;
    [[nodiscard]] QStringList dayNames() const;
    [[nodiscard]] QList<int> workingDays() const;
    [[nodiscard]] ReasonEditor* reasons() { return &m_reasons; }

    // Moves a start between its neighbors; does nothing beyond them.
    Q_INVOKABLE void moveStart(int row, int minutes);
    // Adds a start in the longest shift.
    Q_INVOKABLE void addStart();
    // Removes a start, but not the last one.
    Q_INVOKABLE void removeStart(int row);
    // Adds or removes a working day, 1: Monday. One of them stays.
    Q_INVOKABLE void toggleDay(int day);

signals:
    void changed();

private:
    void update();
    [[nodiscard]] QList<QTime> times() const;

    Settings& m_settings;
    RowModel<ShiftStartRow, &ShiftStartRow::number> m_starts{this};
    ReasonEditor m_reasons;
};

} // namespace campanel::panel
