// SPDX-License-Identifier: Apache-2.0
// Runs campanel-controller as a child process and says on which port it serves. When it ends unasked it is
// started again.
#pragma once

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

    // Where it is looked for: beside this program, in the tree it is installed to, on PATH.
    [[nodiscard]] static QStringList candidatePaths();

signals:
    void serving(const QString& port);
    void notFound(const QString& lookedFor);
    // It is started again a moment later. `lastWords` is what it wrote to its standard error.
    void ended(const QString& lastWords);

private:
    void readFirstLine();
    void processEnded();

    Options m_options;
    QProcess m_process;
    QTimer m_restart;
    bool m_isServing = false;
};

} // namespace campanel::link
