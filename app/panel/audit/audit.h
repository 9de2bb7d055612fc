// SPDX-License-Identifier: Apache-2.0
// `Audit` in QML: the view of the audit trail: its log with a filter by user and area, one row in full, the
// check of the chain.
#pragma once

#include "app/panel/audit/audit_words.h"
#include "app/panel/kit/singleton.h"
#include "app/panel/records/paged_log.h"
#include "app/panel/words/alarm_words.h"
#include "app/store/logs/audit_log.h"

#include <QDateTime>
#include <QStringList>
#include <QVariantList>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

class AuditTrail;

struct AuditListRow {
    Q_GADGET
    Q_PROPERTY(QString time READ time)
    Q_PROPERTY(QString clockNote READ clockNote)
    Q_PROPERTY(QString who READ who)
    Q_PROPERTY(QString what READ what)
    Q_PROPERTY(QString object READ object)
    Q_PROPERTY(QString change READ change)
    Q_PROPERTY(QString problem READ problem)

public:
    store::AuditRow row;

    [[nodiscard]] qint64 sequence() const { return row.sequence; }
    [[nodiscard]] QString time() const { return AuditWords::time(row.entry.timeMs); }
    [[nodiscard]] QString clockNote() const { return AlarmWords::clockNote(row.entry.isClockDoubtful); }
    [[nodiscard]] QString who() const { return AuditWords::who(row.entry); }
    [[nodiscard]] QString what() const { return AuditWords::what(row.entry.what); }
    [[nodiscard]] QString object() const { return AuditWords::object(row.entry); }
    [[nodiscard]] QString change() const { return AuditWords::change(row.entry); }
    [[nodiscard]] QString problem() const
    {
        return row.entry.outcome == QStringLiteral("done") ? QString()
                                                           : AuditWords::outcome(row.entry.outcome);
    }
};

using AuditRows = RowModel<AuditListRow, &AuditListRow::sequence>;
using AuditPages = PagedLog<AuditRows, &AuditListRow::row>;

class Audit : public QObject, public Singleton<Audit> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    Q_PROPERTY(campanel::panel::PagedLogBase* log READ log CONSTANT FINAL)
    // In addition to the filter of the log: a name of `names` and a key of `areas`, empty for all.
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
    // All arguments must outlive the object.
    Audit(DatabaseService& records, AuditTrail& trail, QObject* parent);

    // Reads the newest rows and checks the chain; call it when the page opens.
    Q_INVOKABLE void open();
    Q_INVOKABLE void select(int row);
    Q_INVOKABLE void check();

    [[nodiscard]] AuditPages* log() { return &m_log; }
    [[nodiscard]] AuditRows* rows() { return m_log.rows(); }
    [[nodiscard]] QString who() const { return m_who; }
    void setWho(const QString& who);
    [[nodiscard]] QString area() const { return m_area; }
    void setArea(const QString& area);
    [[nodiscard]] QString areaText() const;
    [[nodiscard]] QVariantList names() const;
    [[nodiscard]] QVariantList areas() const;
    [[nodiscard]] QVariantList detail() const;
    [[nodiscard]] QString detailTitle() const;
    [[nodiscard]] bool checking() const { return m_isChecking; }
    [[nodiscard]] bool broken() const;
    [[nodiscard]] QString chainText() const;

signals:
    void changed();
    void detailChanged();
    void chainChanged();

private:
    void checkNext(store::ChainCheck check);

    DatabaseService& m_records;
    AuditPages m_log;
    QString m_who;
    QString m_area;
    QStringList m_names;
    bool m_isChecking = false;
    std::optional<store::AuditRow> m_selected;
    std::optional<store::ChainCheck> m_check; // the last completed check
};

} // namespace campanel::panel
