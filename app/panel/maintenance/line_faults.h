// SPDX-License-Identifier: Apache-2.0
// `Service.lineFaults` in QML: what goes wrong, on purpose, on the line to the simulated controller. A list
// of ready-made faults in words, each off, sometimes or often. A level shown is one that the controller
// accepted.
#pragma once

#include "app/link/link.h"
#include "app/panel/kit/gate.h"

#include <QAbstractListModel>
#include <QList>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::machine {

class LineFaults : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The line faults belong to the Service")

    Q_PROPERTY(int activeCount READ activeCount NOTIFY changed FINAL)
    // What is active, in words.
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    // Why the last change was not made; empty when it was.
    Q_PROPERTY(QString errorText READ errorText NOTIFY changed FINAL)

public:
    enum Level { Off, Sometimes, Often };
    Q_ENUM(Level)
    enum Role { NameRole = Qt::UserRole + 1, NoteRole, LevelRole };

    // Both must outlive it. Changes are for technicians.
    LineFaults(link::Link& link, Gate& gate, QObject* parent);

    // At another level from the moment that the controller accepts it.
    Q_INVOKABLE void setLevel(int row, int level);
    Q_INVOKABLE void clear();
    void retranslate();

    [[nodiscard]] int activeCount() const;
    [[nodiscard]] QString text() const;
    [[nodiscard]] QString errorText() const;
    // Rules for campanel-controller of these levels, one for each row of the list.
    [[nodiscard]] static QStringList rules(const QList<Level>& levels);
    [[nodiscard]] QStringList rulesInForce() const { return rules(m_levels); }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

signals:
    void changed();

private:
    void send();
    void takeReport(const link::LinkReport& report);
    void takeOutcome(const link::FaultsOutcome& outcome);
    void setLevels(const QList<Level>& levels);

    link::Link& m_link;
    Gate& m_gate;
    QList<Level> m_levels; // in force
    QList<Level> m_wanted;
    std::optional<QList<Level>> m_sent; // not yet answered
    std::optional<link::FaultsOutcome> m_failure;
};

} // namespace campanel::machine
