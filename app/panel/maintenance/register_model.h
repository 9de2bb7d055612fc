// SPDX-License-Identifier: Apache-2.0
// The registers of the map as a list, filtered by group and name, each with what was last read of it. What is
// only for another kind of program than the active one is left out, and so are the blocks of plain data.
#pragma once

#include "app/link/link_values.h"

#include <QAbstractListModel>
#include <QList>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::machine {

struct RegisterRow {
    const modbus::RegisterInfo* info = nullptr;
    quint16 address = 0; // absolute
    QString group;       // "status"; of the two banks "active" and "staged"
    QString name;        // as in the register document

    bool operator==(const RegisterRow&) const = default;
};

class RegisterModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Registers belong to the inspector")
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)

public:
    enum Role {
        NameRole = Qt::UserRole + 1,
        NoteRole,
        ValueRole,
        RawRole,
        WritableRole,
        KnownRole,
        StaleRole
    };

    explicit RegisterModel(QObject* parent);

    // Of the active program.
    void setProgram(modbus::ProgramKind kind, modbus::TableLayout layout);
    // Empty: all. Names that contain `name`, in any case.
    void setFilter(const QString& group, const QString& name);
    [[nodiscard]] QStringList groups() const;
    [[nodiscard]] int count() const { return static_cast<int>(m_shown.size()); }
    [[nodiscard]] const RegisterRow* rowAt(int row) const; // null outside
    [[nodiscard]] std::optional<modbus::NamedValue> valueAt(int row) const;

    // Rows that follow one another without a gap are read as one, at most readbackRegisters long.
    [[nodiscard]] QList<modbus::RegisterSpan> spans(int first, int last) const;
    // What was read; an empty one: these cannot be read.
    void take(const link::ReadOutcome& outcome);
    // What is not between these rows is forgotten, it grows old unseen.
    void keepOnly(int first, int last);
    // What was read before that is shown as old.
    void markOlderThan(link::SteadyTime time);
    void retranslate();

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

signals:
    void countChanged();

private:
    struct Shown {
        RegisterRow row;
        std::optional<modbus::NamedValue> value;
        link::SteadyTime readAt{};
        bool isStale = false;
        bool isUnreadable = false;
    };

    void rebuild();
    [[nodiscard]] QList<RegisterRow> allRows() const;
    [[nodiscard]] QString note(const Shown& shown) const;

    modbus::ProgramKind m_kind = modbus::ProgramKind::None;
    modbus::TableLayout m_layout = modbus::TableLayout::None;
    QString m_group;
    QString m_name;
    QList<Shown> m_shown;
};

} // namespace campanel::machine
