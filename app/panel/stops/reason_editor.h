// SPDX-License-Identifier: Apache-2.0
// The list of reasons as the level Service edits it: the groups, or the reasons of one group.
#pragma once

#include "app/panel/stops/reason_keys.h"

namespace campanel::panel {

class ReasonEditor : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The editor belongs to Stops")
    Q_PROPERTY(campanel::panel::RowModelBase* rows READ rows CONSTANT FINAL)
    // The words of the open group; empty: the groups are displayed.
    Q_PROPERTY(QString groupText READ groupText NOTIFY changed FINAL)
    Q_PROPERTY(bool canAdd READ canAdd NOTIFY changed FINAL)
    // True when the list differs from the standard one.
    Q_PROPERTY(bool isOwn READ isOwn NOTIFY changed FINAL)

public:
    // The settings must outlive the object.
    explicit ReasonEditor(Settings& settings);

    [[nodiscard]] RowModel<ReasonKeyRow, &ReasonKeyRow::key>* rows() { return &m_rows; }
    [[nodiscard]] QString groupText() const { return StopWords::reasonPart(m_group); }
    [[nodiscard]] bool canAdd() const { return m_rows.count() < maxReasons; }
    [[nodiscard]] bool isOwn() const;

    Q_INVOKABLE void openGroup(int row);
    Q_INVOKABLE void closeGroup();
    // Returns why the text cannot be the words of this row, or of a new one (-1); empty: it can.
    [[nodiscard]] Q_INVOKABLE QString problemOf(int row, const QString& text) const;
    Q_INVOKABLE void add(const QString& text);
    // Earlier stops keep their words.
    Q_INVOKABLE void rename(int row, const QString& text);
    Q_INVOKABLE void togglePlanned(int row);
    // Removes a reason, or a group with its reasons; the last group stays.
    Q_INVOKABLE void remove(int row);
    Q_INVOKABLE void restoreStandard();

signals:
    void changed();

private:
    void update();
    [[nodiscard]] QList<StopReason> all() const;
    void store(const QList<StopReason>& reasons);

    Settings& m_settings;
    QString m_group;
    RowModel<ReasonKeyRow, &ReasonKeyRow::key> m_rows{this};
};

} // namespace campanel::panel
