// SPDX-License-Identifier: Apache-2.0
// The lists of alarms that are active or need to be acknowledged, the most urgent first, and of shelved
// alarms.
#pragma once

#include "app/panel/alarms/alarm_book.h"

#include <QAbstractListModel>
#include <QDate>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class LiveAlarms : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The lists belong to Alarms")
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)

public:
    using QAbstractListModel::QAbstractListModel;

    // Updates the rows. Remaining occurrences keep their rows, so the scroll position stays.
    void setEntries(std::vector<AlarmEntry> entries, const QDate& today);
    [[nodiscard]] const std::vector<AlarmEntry>& entries() const { return m_entries; }
    [[nodiscard]] int count() const { return static_cast<int>(m_entries.size()); }
    void retranslate();

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

signals:
    void countChanged();

private:
    void place(const AlarmEntry& entry, int at);

    std::vector<AlarmEntry> m_entries;
    QDate m_today;
};

class ShelvedAlarms : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The lists belong to Alarms")
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)

public:
    // The roles; `until` and `by` are sentences.
    enum Role { CodeRole = Qt::UserRole + 1, TitleRole, UntilRole, ByRole };

    using QAbstractListModel::QAbstractListModel;

    void setShelves(const QList<store::AlarmShelf>& shelves, const QDate& today);
    [[nodiscard]] const QList<store::AlarmShelf>& shelves() const { return m_shelves; }
    [[nodiscard]] int count() const { return static_cast<int>(m_shelves.size()); }
    void retranslate();

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

signals:
    void countChanged();

private:
    QList<store::AlarmShelf> m_shelves;
    QDate m_today;
};

} // namespace campanel::panel
