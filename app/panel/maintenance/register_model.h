// SPDX-License-Identifier: Apache-2.0
// The registers of the map as a list, filtered by group and name, each with its last reading. Registers of
// other kinds of program and blocks of plain data are not listed.
#pragma once

#include "app/link/link_values.h"

#include <QAbstractListModel>
#include <QList>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

struct RegisterRow {
    const modbus::RegisterInfo* info = nullptr;
    quint16 address = 0; // absolute
    QString group;       // "status"; the two banks are "active" and "staged"
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

    // Sets the active program.
    void setProgram(modbus::ProgramKind kind, modbus::TableLayout layout);
    // Sets the filter. Empty: all. Names match when they contain `name`, in any case.
    void setFilter(const QString& group, const QString& name);
    [[nodiscard]] QStringList groups() const;
    [[nodiscard]] int count() const { return static_cast<int>(m_shown.size()); }
    [[nodiscard]] const RegisterRow* rowAt(int row) const; // null outside
    [[nodiscard]] std::optional<modbus::NamedValue> valueAt(int row) const;

    // Returns the spans to read: rows without a gap between them form one span of at most readbackRegisters.
    [[nodiscard]] QList<modbus::RegisterSpan> spans(int first, int last) const;
    // Stores a reading; an empty one means that these registers cannot be read.
    void take(const link::ReadOutcome& outcome);
    // Clears the readings outside these rows, which would become old unnoticed.
    void keepOnly(int first, int last);
    void markOlderThan(link::SteadyTime time);

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

} // namespace campanel::panel
