// SPDX-License-Identifier: Apache-2.0
// The reason for values outside the approved windows. A download of such a recipe needs one; it is kept with
// the program that it brought, also over a restart of the panel, until the controller has another program or
// a technician widens the windows.
#pragma once

#include "app/program/approved_windows.h"
#include "app/program/recipe.h"
#include "app/store/logs/audit_log.h"

#include <QList>
#include <QObject>
#include <QtQml/qqmlregistration.h>

#include <optional>
#include <vector>

namespace campanel::panel {

class Controller;

class WindowReason : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Editor.programDownload.windowReason is the only one")

    // The values outside their windows and what to do; empty: nobody has to give a reason.
    Q_PROPERTY(QString question READ question NOTIFY changed FINAL)
    // The values of the program in the controller that are outside their windows, by whom, since when and
    // why; empty: there are none.
    Q_PROPERTY(QString line READ line NOTIFY changed FINAL)
    // True while the controller has such a program and nobody has given a reason.
    Q_PROPERTY(bool unexplained READ isUnexplained NOTIFY changed FINAL)

public:
    static constexpr int maxLength = 120;

    // Keeps its reasons in a file of the folder. The controller must outlive the object.
    WindowReason(Controller& controller, const QString& folder, QObject* parent);

    // Returns why this is no reason; empty: it is one.
    [[nodiscard]] Q_INVOKABLE QString problem(const QString& text) const;
    // Gives the reason for the wanted values, for operators. A text with a problem changes nothing.
    Q_INVOKABLE void give(const QString& text);

    [[nodiscard]] QString question() const;
    [[nodiscard]] QString line() const;
    [[nodiscard]] bool isUnexplained() const;

    // Sets the recipe to download, null: none, and whether its program is the one in the controller.
    void setWanted(const program::Recipe* recipe);
    void setRunning(bool isRunning);
    // Returns true when the wanted recipe may not be downloaded without a reason.
    [[nodiscard]] bool isMissing() const { return !m_outside.empty() && m_reason.isEmpty(); }
    // Keeps the reason with the program that is about to be sent.
    void begin(quint32 crc);
    // Forgets the reasons of other programs once this one is active.
    void end(quint32 crc);

signals:
    void changed();
    // Emitted when a person gives a reason: what may be downloaded follows.
    void given();
    // Emitted for the audit trail.
    void noted(const campanel::store::AuditEntry& entry);

private:
    // A reason that was given.
    struct Given {
        quint32 crc = 0; // of the program
        qint64 sinceMs = 0;
        QString by; // empty: nobody was logged in
        QString reason;
        std::vector<program::Excess> values;
    };

    [[nodiscard]] const Given* givenForActive() const;
    void add(quint32 crc);
    void load();
    void keep() const;

    Controller& m_controller;
    QString m_path;
    QString m_recipeName;
    std::vector<program::Excess> m_outside; // of the wanted recipe
    QString m_reason;                       // for them; empty: not given
    QString m_by;
    bool m_isRunning = false; // the wanted recipe is the one in the controller
    QList<Given> m_given;     // of the active program, and of the one on its way
};

} // namespace campanel::panel
