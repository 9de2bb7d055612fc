// SPDX-License-Identifier: Apache-2.0
// The real campanel-controller as a child process: its port, and its death with the test.
#pragma once

#include <QProcess>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>

namespace campanel::test {

class ControllerProcess {
public:
    // Starts it with its own empty state directory unless `arguments` name one; throws std::runtime_error when it
    // does not print its port within ten seconds.
    explicit ControllerProcess(const QStringList& arguments = {});
    ~ControllerProcess();
    ControllerProcess(const ControllerProcess&) = delete;
    ControllerProcess& operator=(const ControllerProcess&) = delete;

    [[nodiscard]] QString port() const { return m_port; }
    [[nodiscard]] qint64 processId() const { return m_process.processId(); }
    void killHard(); // as a power cut

private:
    QTemporaryDir m_state;
    QProcess m_process;
    QString m_port;
};

} // namespace campanel::test
