// SPDX-License-Identifier: Apache-2.0
// The numbers of a packing machine that a technician sets, as the controller holds them: in words, with
// range, and with a suggestion where there is one. Read when they are shown, written with proof.
#pragma once

#include "app/link/link_values.h"
#include "app/panel/packing/gain_estimate.h"

#include <QAbstractListModel>
#include <QSet>
#include <QtQml/qqmlregistration.h>

#include <optional>
#include <vector>

namespace campanel::machine {

class Machine;

class PackingFields : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The fields belong to the packing setup")
    // Of the selected one, for the keypad; 0 and empty while none is.
    Q_PROPERTY(QString label READ label NOTIFY changed FINAL)
    Q_PROPERTY(QString unit READ unit NOTIFY changed FINAL)
    Q_PROPERTY(QString valueText READ valueText NOTIFY changed FINAL)
    Q_PROPERTY(double minimum READ minimum NOTIFY changed FINAL)
    Q_PROPERTY(double maximum READ maximum NOTIFY changed FINAL)
    Q_PROPERTY(double defaultValue READ defaultValue NOTIFY changed FINAL)
    Q_PROPERTY(int decimals READ decimals NOTIFY changed FINAL)
    // What became of the last write; empty before there was one.
    Q_PROPERTY(QString outcomeText READ outcomeText NOTIFY changed FINAL)
    Q_PROPERTY(bool failed READ failed NOTIFY changed FINAL)
    // Values that were written since the controller last put them into its flash.
    Q_PROPERTY(bool unsaved READ unsaved NOTIFY changed FINAL)

public:
    enum Role {
        NameRole = Qt::UserRole + 1,
        ValueRole, // "--" while it is not known
        UnitRole,
        NoteRole,   // range, or why it is suggested
        SwitchRole, // on or off instead of a number
        OnRole,
        KnownRole,
        SuggestionRole // another value than now; empty when there is none
    };

    // The machine must outlive it.
    PackingFields(Machine& machine, QObject* parent);

    // Asks the controller for every value; does nothing while some are on their way.
    void read();
    void forget();
    // A parameter as this page calls it; empty for one that is not here. `name` as in the register table.
    [[nodiscard]] static QString words(const QString& name);
    void suggest(const std::optional<GainSuggestion>& gains, int bags);
    // NaN while it is not known. `name` as in the register table.
    [[nodiscard]] double value(const char* name) const;
    // For technicians. Ends in one written().
    void write(const char* name, double value);
    void retranslate();

    Q_INVOKABLE void select(int row);
    // The selected one; nothing outside its range.
    Q_INVOKABLE void writeSelected(double value);
    Q_INVOKABLE void setOn(int row, bool on);
    Q_INVOKABLE void takeSuggestion(int row);
    Q_INVOKABLE void save();
    // Why the value may not be written; empty when it may.
    [[nodiscard]] Q_INVOKABLE QString check(double value) const;

    [[nodiscard]] QString label() const;
    [[nodiscard]] QString unit() const;
    [[nodiscard]] QString valueText() const;
    [[nodiscard]] double minimum() const;
    [[nodiscard]] double maximum() const;
    [[nodiscard]] double defaultValue() const;
    [[nodiscard]] int decimals() const;
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
        const modbus::RegisterInfo* info = nullptr;
        const char* words = nullptr;
        bool isSwitch = false;
        std::optional<double> value;
        std::optional<double> suggestion;
    };

    [[nodiscard]] const Field* selected() const;
    [[nodiscard]] Field* find(const QString& name);
    [[nodiscard]] static QString text(const Field& field, double value);
    [[nodiscard]] static QString unitOf(const Field& field);
    [[nodiscard]] QString note(const Field& field) const;
    void takeOutcome(const link::ParameterOutcome& outcome);
    void takeCommand(const link::CommandOutcome& outcome);
    void tell();

    Machine& m_machine;
    std::vector<Field> m_fields;
    QSet<quint32> m_reads;  // under way
    QSet<quint32> m_writes; // under way
    int m_selected = -1;
    std::optional<GainSuggestion> m_gains;
    int m_bags = 0;
    QString m_outcome;
    bool m_isFailed = false;
    bool m_isUnsaved = false;
};

} // namespace campanel::machine
