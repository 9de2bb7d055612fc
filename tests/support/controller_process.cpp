// SPDX-License-Identifier: Apache-2.0
// Starts the process, waits for the port, and kills it.
#include "tests/support/controller_process.h"
#include "tests/support/places.h"

#include <QFile>

#include <stdexcept>

namespace campanel::test {

using namespace Qt::StringLiterals;

ControllerProcess::ControllerProcess(QStringList arguments)
    : m_arguments(std::move(arguments))
{
    m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    // The same test with a controller of an older register map.
    if (const QString minor = qEnvironmentVariable("CAMPANEL_CONTROLLER_MAP_MINOR"); !minor.isEmpty())
        m_arguments << u"--map-minor"_s << minor;
    start();
}

ControllerProcess::~ControllerProcess()
{
    m_process.terminate();
    if (!m_process.waitForFinished(5000))
        kill();
}

void ControllerProcess::start()
{
    // Another program with the same contract: the firmware in QEMU.
    const QString other = qEnvironmentVariable("CAMPANEL_CONTROLLER");
    m_process.start(other.isEmpty() ? campanel::test::programPath("campanel-controller") : other,
                    QStringList{u"--link"_s, port(), u"--state"_s, m_folder.filePath(u"state"_s)} +
                        m_arguments);
    while (!m_process.canReadLine()) {
        if (!m_process.waitForReadyRead(10000))
            throw std::runtime_error("campanel-controller printed no port: " +
                                     m_process.errorString().toStdString());
    }
    m_process.readLine();
}

void ControllerProcess::tell(const QByteArray& line)
{
    m_process.write(line + '\n');
    m_process.waitForBytesWritten();
}

void ControllerProcess::kill()
{
    if (m_process.state() == QProcess::NotRunning)
        return;
    // The name is removed first, as with a pulled adapter: the system reuses the terminal's number, and the
    // name would then lead to the controller of another test.
    QFile::remove(port());
    m_process.kill();
    m_process.waitForFinished();
}

} // namespace campanel::test
