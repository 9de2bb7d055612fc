// SPDX-License-Identifier: Apache-2.0
// A real campanel-controller for a test, on a port whose name outlives it, so that it can be killed and
// started again.
#pragma once

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace campanel::tests {

class ControllerProcess {
public:
    explicit ControllerProcess(QStringList arguments = {})
        : m_arguments(std::move(arguments))
    {
    }
    ~ControllerProcess() { kill(); }
    ControllerProcess(const ControllerProcess&) = delete;
    ControllerProcess& operator=(const ControllerProcess&) = delete;

    [[nodiscard]] QString port() const { return m_folder.filePath(QStringLiteral("port")); }

    // True when it serves.
    [[nodiscard]] bool start()
    {
        m_process.start(QStringLiteral(CAMPANEL_CONTROLLER),
                        QStringList{QStringLiteral("--link"), port(), QStringLiteral("--state"),
                                    m_folder.filePath(QStringLiteral("state"))} +
                            m_arguments);
        return QTest::qWaitFor([this] { return m_process.canReadLine() || hasEnded(); }, startTimeoutMs) &&
               !hasEnded();
    }

    // As a power cut would.
    void kill()
    {
        if (m_process.state() == QProcess::NotRunning)
            return;
        m_process.kill();
        m_process.waitForFinished();
    }

private:
    static constexpr int startTimeoutMs = 5000;

    [[nodiscard]] bool hasEnded() const { return m_process.state() == QProcess::NotRunning; }

    QStringList m_arguments;
    QTemporaryDir m_folder;
    QProcess m_process;
};

} // namespace campanel::tests
