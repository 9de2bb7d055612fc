// SPDX-License-Identifier: Apache-2.0
// The keys with the reasons of a stop, in two levels of at most eight.
#pragma once

#include "app/panel/kit/row_model.h"
#include "app/panel/settings/stop_forms.h"
#include "app/panel/words/stop_words.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class Settings;

struct ReasonKeyRow {
    Q_GADGET
    Q_PROPERTY(QString reason READ key)
    Q_PROPERTY(QString text READ text)
    Q_PROPERTY(bool isPlanned READ isPlanned)
    Q_PROPERTY(bool opens MEMBER opens)

public:
    StopReason value;
    bool opens = false; // a group with reasons

    [[nodiscard]] QString key() const { return value.key(); }
    [[nodiscard]] QString text() const
    {
        return StopWords::reasonPart(value.name.isEmpty() ? value.group : value.name);
    }
    [[nodiscard]] bool isPlanned() const { return value.isPlanned; }
    bool operator==(const ReasonKeyRow&) const = default;
};

class ReasonKeys : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The keys belong to Stops")
    Q_PROPERTY(campanel::panel::RowModelBase* rows READ rows CONSTANT FINAL)
    // The words of the open group; empty: the groups are displayed.
    Q_PROPERTY(QString groupText READ groupText NOTIFY changed FINAL)

public:
    // The settings must outlive the object.
    ReasonKeys(Settings& settings, QObject* parent);

    [[nodiscard]] RowModel<ReasonKeyRow, &ReasonKeyRow::key>* rows() { return &m_rows; }
    [[nodiscard]] QString groupText() const { return StopWords::reasonPart(m_group); }
    [[nodiscard]] QString group() const { return m_group; }

    // Opens a group that has reasons; chooses another one.
    Q_INVOKABLE void touch(int row);
    Q_INVOKABLE void close();

signals:
    void changed();
    void chosen(const campanel::panel::StopReason& reason);

private:
    void update();

    Settings& m_settings;
    QString m_group;
    RowModel<ReasonKeyRow, &ReasonKeyRow::key> m_rows{this};
};

} // namespace campanel::panel
