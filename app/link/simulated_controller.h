// SPDX-License-Identifier: Apache-2.0
// Runs campanel-controller as a child process and reports its port. An unexpected end leads to a restart with
// the same line faults.
#pragma once

#include "app/link/link_values.h"

#include <QObject>
#include <QProcess>
#include <QStringList>
#include <QTimer>

namespace campanel::link {

class SimulatedController : public QObject {
    Q_OBJECT

public:
    struct Options {
        QString program; // empty: searched
        QString stateDir;
        QStringList arguments; // pacing of the line, options of the machine
    };

    SimulatedController(Options options, QObject* parent);
    ~SimulatedController() override;

    void start();

    // Sets the rules of line faults and the statements about the machine, as "jam on" and "line start 250",
    // in place of the earlier ones. Ends in one faultsAnswered(). Returns false, without an answer, while the
    // controller is not serving.
    [[nodiscard]] bool setFaults(const QStringList& rules);

    // Measures the last bag. Ends in one rulerRead(). Returns false, without an answer, while the controller
    // is not serving.
    [[nodiscard]] bool measureSimulatedBag();

    // Returns the searched paths: beside this program, in the installation tree, on PATH.
    [[nodiscard]] static QStringList candidatePaths();

signals:
    // Emitted after the start, and when its port was unplugged and is back, possibly under another name.
    void serving(const QString& port);
    void notFound(const QString& searched);
    // Emitted before the restart a moment later. `lastWords` is its standard error output.
    void ended(const QString& lastWords);
    void faultsAnswered(const campanel::link::FaultsOutcome& outcome);
    void rulerRead(const campanel::link::RulerOutcome& outcome);

private:
    void readLines();
    void take(const QString& line);
    void takeAnswer(const QString& line);
    void takeMeasured(const QString& line);
    void sendFaults(const QStringList& rules, bool isAsked);
    void processEnded();

    Options m_options;
    QProcess m_process;
    QTimer m_restart;
    bool m_isServing = false;
    struct SentFaults {
        QStringList rules;
        bool isAsked = false; // requested by setFaults()
    };
    QList<SentFaults> m_sentFaults; // not answered yet
    QStringList m_faults;           // active
    QStringList m_ofMachine;        // statements about the machine, as sent last
    int m_rulersAsked = 0;          // not answered yet
};

} // namespace campanel::link
