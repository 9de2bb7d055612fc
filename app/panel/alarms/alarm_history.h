// SPDX-License-Identifier: Apache-2.0
// The log of alarms as a list, the newest first, read page by page while somebody looks; what happens
// meanwhile shows at once.
#pragma once

#include "app/store/logs/alarm_log.h"

#include <QAbstractListModel>
#include <QDate>
#include <QtQml/qqmlregistration.h>

#include <functional>

namespace campanel::machine {

class Records;

class AlarmHistory : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The lists belong to Alarms")
    // Nothing is read or kept here before and after.
    Q_PROPERTY(bool watched READ watched WRITE setWatched NOTIFY changed FINAL)
    // The first page has not come yet.
    Q_PROPERTY(bool loading READ loading NOTIFY changed FINAL)
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)

public:
    // The records must outlive it.
    AlarmHistory(Records& records, QObject* parent);

    [[nodiscard]] bool watched() const { return m_isWatched; }
    void setWatched(bool isWatched);
    [[nodiscard]] bool loading() const { return m_isWatched && !m_isLoaded; }
    [[nodiscard]] int count() const { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] const QList<store::AlarmRow>& rows() const { return m_rows; }

    void setToday(std::function<QDate()> today) { m_today = std::move(today); }
    // This goes to the disk now, after whatever went before.
    void note(const store::AlarmChanges& changes);
    void retranslate();

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;
    [[nodiscard]] bool canFetchMore(const QModelIndex& parent) const override;
    void fetchMore(const QModelIndex& parent) override;

signals:
    void changed();
    void countChanged();

private:
    void read();
    void takePage(const QList<store::AlarmRow>& page);
    void apply(const store::AlarmChanges& changes);
    void applyRow(const store::AlarmRow& row);
    // The row of the first one with this id or an older one.
    [[nodiscard]] int rowFrom(qint64 id) const;

    Records& m_records;
    std::function<QDate()> m_today = &QDate::currentDate;
    QList<store::AlarmRow> m_rows;          // descending ids
    QList<store::AlarmChanges> m_meanwhile; // noted while a page is on its way, which may be without them
    quint32 m_round = 0;                    // a page of an earlier one comes too late
    bool m_isWatched = false;
    bool m_isLoaded = false;
    bool m_isReading = false;
    bool m_isAtEnd = false;
};

} // namespace campanel::machine
