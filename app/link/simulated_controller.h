// SPDX-License-Identifier: Apache-2.0
// Runs campanel-controller as a child process and says on which port it serves. When it ends unasked it is
// started again, with the line faults that it had.
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
        QString program; // empty: searched for
        QString stateDir;
        QStringList arguments; // how the line is paced
    };

    SimulatedController(Options options, QObject* parent);
    ~SimulatedController() override;

    void start();

    // Rules of line faults in place of those before. Ends in one faultsAnswered(); false, and none, while it
    // is not serving.
    [[nodiscard]] bool setFaults(const QStringList& rules);

    // Ends in one rulerRead(); false, and none, while it is not serving.
    [[nodiscard]] bool readRuler();

    // Where it is looked for: beside this program, in the tree it is installed to, on PATH.
    [[nodiscard]] static QStringList candidatePaths();

signals:
    // After its start, and when its port was unplugged and is back, perhaps under another name.
    void serving(const QString& port);
    void notFound(const QString& lookedFor);
    // It is started again a moment later. `lastWords` is what it wrote to its standard error.
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
        bool isAsked = false; // for, by setFaults()
    };
    QList<SentFaults> m_sentFaults; // and not yet answered
    QStringList m_faults;           // in force
    int m_rulersAsked = 0;          // and not yet answered
};

} // namespace campanel::link
