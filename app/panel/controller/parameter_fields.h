// SPDX-License-Identifier: Apache-2.0
// A list of parameters that a technician sets, as stored in the controller: with label and range. Read when
// displayed, written with proof.
#pragma once

#include "app/panel/controller/parameter.h"
#include "app/panel/kit/value.h"

#include <QAbstractListModel>
#include <QtQml/qqmlregistration.h>

#include <optional>
#include <string_view>
#include <vector>

namespace campanel::panel {

class Controller;

class ParameterFields : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Lists of parameters belong to the object that displays them")
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
        NoteRole,    // range, or the reason for the suggestion
        ChoicesRole, // the texts of the values 0, 1 and so on; empty for a number
        ChoiceRole,  // the present one; -1 while unknown
        KnownRole,
        SuggestionRole, // a value other than the present one; empty when there is none
        MeasurableRole  // the machine can measure it
    };

    // Reads every value from the controller.
    void read();
    // The same for those that may have changed since they were read.
    Q_INVOKABLE void readIfUncertain();
    // Returns NaN while the value is unknown. `name` as in the register table.
    [[nodiscard]] double value(const char* name) const;
    // Writes a value; for technicians. Ends in one written().
    void write(const char* name, double value);

    Q_INVOKABLE void select(int row);
    Q_INVOKABLE void setChoice(int row, int choice);
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

protected:
    struct Field {
        Parameter* parameter = nullptr;
        const char* words = nullptr; // source text of the label
        bool hasChoices = false;     // a choice instead of a number
        std::optional<double> suggestion{};

        [[nodiscard]] const modbus::RegisterInfo& info() const { return parameter->info(); }
        [[nodiscard]] std::optional<double> value() const { return parameter->value(); }
    };

    // The controller must outlive the object.
    ParameterFields(Controller& controller, QObject* parent);

    [[nodiscard]] Controller& controller() const { return m_controller; }
    void setFields(std::vector<Field> fields);
    [[nodiscard]] Field& find(std::string_view name);
    void notifyChange();

    [[nodiscard]] virtual QString label(const Field& field) const = 0;
    // Returns the text below the label.
    [[nodiscard]] virtual QString note(const Field& field) const;
    [[nodiscard]] QString range(const Field& field) const;
    // Returns why this value cannot be together with the others; empty when it can.
    [[nodiscard]] virtual QString objection(const Field& /*field*/, double /*value*/) const { return {}; }
    [[nodiscard]] virtual bool isMeasurable(const Field& /*field*/) const { return false; }

private:
    [[nodiscard]] const Field* selected() const;
    void write(const Field& field, double value);
    void endWrite(const Field& field, const link::ParameterOutcome& outcome);
    [[nodiscard]] QString text(const Field& field, double value) const;
    [[nodiscard]] static QString unitOf(const Field& field);
    [[nodiscard]] QStringList choicesOf(const Field& field) const;
    void takeCommand(const link::CommandOutcome& outcome);
    void updateValue();

    Controller& m_controller;
    std::vector<Field> m_fields;
    Value m_value;
    int m_selected = -1;
    QString m_outcome;
    bool m_isFailed = false;
    bool m_isUnsaved = false;
};

} // namespace campanel::panel
