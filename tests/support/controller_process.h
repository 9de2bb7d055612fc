// SPDX-License-Identifier: Apache-2.0
// The real campanel-controller as a child process. The name of its port is permanent, so that it can be
// killed and restarted with its flash.
#pragma once

#include <QProcess>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>

namespace campanel::test {

class ControllerProcess {
public:
    // Starts it with an empty state directory; throws std::runtime_error when it does not serve within ten
    // seconds.
    explicit ControllerProcess(QStringList arguments = {});
    ~ControllerProcess();
    ControllerProcess(const ControllerProcess&) = delete;
    ControllerProcess& operator=(const ControllerProcess&) = delete;

    // Returns the path, the same before and after a restart.
    [[nodiscard]] QString port() const { return m_folder.filePath(QStringLiteral("port")); }

    // Sends a line to its standard input; it needs the argument --control.
    void tell(const QByteArray& line);
    void kill();  // like a power cut
    void start(); // again, after kill()

private:
    QStringList m_arguments;
    QTemporaryDir m_folder;
    QProcess m_process;
};

} // namespace campanel::test
