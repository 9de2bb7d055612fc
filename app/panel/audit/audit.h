// SPDX-License-Identifier: Apache-2.0
// `Audit` in QML: the view of the audit trail. The rows as a list, newest first, read page by page; one row
// in full; the check of the chain; the export to a file.
#pragma once

#include "app/store/logs/audit_log.h"

#include <QAbstractListModel>
#include <QDateTime>
#include <QStringList>
#include <QVariantList>
#include <QtQml/qqmlregistration.h>

#include <optional>

class QJSEngine;
class QQmlEngine;

namespace campanel::panel {

class AuditTrail;
class DatabaseService;
class ReportFiles;

class Audit : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    Q_PROPERTY(int count READ count NOTIFY changed FINAL)
    Q_PROPERTY(bool busy READ busy NOTIFY changed FINAL)
    // The filter: a name of `names` and a key of `areas`, empty for all.
    Q_PROPERTY(QString who READ who WRITE setWho NOTIFY changed FINAL)
    Q_PROPERTY(QString area READ area WRITE setArea NOTIFY changed FINAL)
    Q_PROPERTY(QString areaText READ areaText NOTIFY changed FINAL)
    Q_PROPERTY(QVariantList names READ names NOTIFY changed FINAL) // list of {key, text}
    Q_PROPERTY(QVariantList areas READ areas NOTIFY changed FINAL)
    // The selected row: pairs of {label, text}.
    Q_PROPERTY(QVariantList detail READ detail NOTIFY detailChanged FINAL)
    Q_PROPERTY(QString detailTitle READ detailTitle NOTIFY detailChanged FINAL)
    // The state of the chain as text: not checked, being checked, unbroken or broken.
    Q_PROPERTY(bool checking READ checking NOTIFY chainChanged FINAL)
    Q_PROPERTY(bool broken READ broken NOTIFY chainChanged FINAL)
    Q_PROPERTY(QString chainText READ chainText NOTIFY chainChanged FINAL)

public:
    enum Role { TimeRole = Qt::UserRole + 1, WhoRole, WhatRole, ObjectRole, ChangeRole, ProblemRole };

    // The maximum number of rows in a CSV file; the newest ones are exported.
    static constexpr int mostExported = 100'000;

    // All arguments must outlive the object.
    Audit(DatabaseService& records, AuditTrail& trail, ReportFiles& files, QObject* parent);

    static Audit* create(QQmlEngine* qmlEngine, QJSEngine* jsEngine);

    // Reads the newest rows and checks the chain; call it when the page opens.
    Q_INVOKABLE void open();
    // Reads the next page of older rows.
    Q_INVOKABLE void readMore();
    Q_INVOKABLE void select(int row);
    Q_INVOKABLE void check();
    // Reads the filtered rows and offers them to the report files.
    Q_INVOKABLE void exportCsv();

    [[nodiscard]] int count() const { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] bool busy() const { return m_isReading || m_isExporting; }
    [[nodiscard]] QString who() const { return m_filter.who.value_or(QString()); }
    void setWho(const QString& who);
    [[nodiscard]] QString area() const { return m_filter.area; }
    void setArea(const QString& area);
    [[nodiscard]] QString areaText() const;
    [[nodiscard]] QVariantList names() const;
    [[nodiscard]] QVariantList areas() const;
    [[nodiscard]] QVariantList detail() const;
    [[nodiscard]] QString detailTitle() const;
    [[nodiscard]] bool checking() const { return m_isChecking; }
    [[nodiscard]] bool broken() const;
    [[nodiscard]] QString chainText() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

signals:
    void changed();
    void detailChanged();
    void chainChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    using Rows = tl::expected<QList<store::AuditRow>, store::StoreError>;

    void setFilter(const store::AuditFilter& filter);
    void read();
    void takeRows(const Rows& rows);
    void takeAppended(const store::AuditRow& row);
    void checkNext(store::ChainCheck check);

    DatabaseService& m_records;
    ReportFiles& m_files;
    QList<store::AuditRow> m_rows; // newest first
    store::AuditFilter m_filter;
    QStringList m_names;
    bool m_isOpened = false;
    bool m_isReading = false;
    bool m_isReadAgain = false; // the filter changed during a read
    bool m_hasAll = false;
    bool m_isExporting = false;
    bool m_isChecking = false;
    std::optional<store::AuditRow> m_selected;
    std::optional<store::ChainCheck> m_check; // the last completed check
};

} // namespace campanel::panel
