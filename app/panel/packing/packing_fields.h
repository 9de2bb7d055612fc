// SPDX-License-Identifier: Apache-2.0
// The parameters of a packing machine that a technician sets, as stored in the controller: with label, range,
// and a suggestion where there is one. Read when displayed, written with proof.
#pragma once

#include "app/panel/controller/parameter.h"
#include "app/panel/kit/value.h"
#include "app/panel/packing/gain_estimate.h"

#include <QAbstractListModel>
#include <QtQml/qqmlregistration.h>

#include <optional>
#include <string_view>
#include <vector>

namespace campanel::panel {

class Controller;

class PackingFields : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The fields belong to the packing setup")
    // The selected field, for the keypad.
    Q_PROPERTY(campanel::panel::Value* value READ value CONSTANT FINAL)
    // The result of the last write; empty before the first.
    Q_PROPERTY(QString outcomeText READ outcomeText NOTIFY changed FINAL)
    Q_PROPERTY(bool failed READ failed NOTIFY changed FINAL)
    // True when written values are not in the controller's flash yet.
    Q_PROPERTY(bool unsaved READ unsaved NOTIFY changed FINAL)

public:
    enum Role {
        NameRole = Qt::UserRole + 1,
        ValueRole, // "--" while unknown
        UnitRole,
        NoteRole,   // range, or the reason for the suggestion
        SwitchRole, // on or off instead of a number
        OnRole,
        KnownRole,
        SuggestionRole // a value other than the present one; empty when there is none
    };

    // The machine must outlive the object.
    PackingFields(Controller& machine, QObject* parent);

    // Reads every value from the controller.
    void read();
    // Returns the label of a parameter; empty for one that is not in this list. `name` as in the register
    // table.
    [[nodiscard]] static QString words(const QString& name);
    void suggest(const std::optional<GainSuggestion>& gains, int bags);
    // Returns NaN while the value is unknown. `name` as in the register table.
    [[nodiscard]] double value(const char* name) const;
    // Writes a value; for technicians. Ends in one written().
    void write(const char* name, double value);
    void retranslate();

    Q_INVOKABLE void select(int row);
    Q_INVOKABLE void setOn(int row, bool on);
    Q_INVOKABLE void takeSuggestion(int row);
    Q_INVOKABLE void save();

    [[nodiscard]] Value* value() { return &m_value; }
    [[nodiscard]] QString outcomeText() const { return m_outcome; }
    [[nodiscard]] bool failed() const { return m_isFailed; }
    [[nodiscard]] bool unsaved() const { return m_isUnsaved; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

signals:
    void changed();
    void written(const QString& name, bool isDone, const QString& sentence);

private:
    struct Field {
        Parameter* parameter = nullptr;
        const char* words = nullptr;
        bool isSwitch = false;
        std::optional<double> suggestion;

        [[nodiscard]] const modbus::RegisterInfo& info() const { return parameter->info(); }
        [[nodiscard]] std::optional<double> value() const { return parameter->value(); }
    };

    [[nodiscard]] const Field* selected() const;
    [[nodiscard]] Field& find(std::string_view name);
    void write(const Field& field, double value);
    void endWrite(const Field& field, const link::ParameterOutcome& outcome);
    [[nodiscard]] static QString text(const Field& field, double value);
    [[nodiscard]] static QString unitOf(const Field& field);
    [[nodiscard]] QString note(const Field& field) const;
    void takeCommand(const link::CommandOutcome& outcome);
    void tell();
    void updateValue();

    Controller& m_machine;
    std::vector<Field> m_fields;
    Value m_value;
    int m_selected = -1;
    std::optional<GainSuggestion> m_gains;
    int m_bags = 0;
    QString m_outcome;
    bool m_isFailed = false;
    bool m_isUnsaved = false;
};

} // namespace campanel::panel
