// SPDX-License-Identifier: Apache-2.0
// Starting, finding the port, stopping.
#include "controller_process.h"

#include <stdexcept>

namespace campanel::test {

using namespace Qt::StringLiterals;

ControllerProcess::ControllerProcess(const QStringList& arguments)
{
    QStringList all = arguments;
    if (!all.contains(u"--state"_s))
        all << u"--state"_s << m_state.path();
    m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    m_process.start(QStringLiteral(CAMPANEL_CONTROLLER), all);
    while (!m_process.canReadLine()) {
        if (!m_process.waitForReadyRead(10000))
            throw std::runtime_error("campanel-controller printed no port: " + m_process.errorString().toStdString());
    }
    m_port = QString::fromLocal8Bit(m_process.readLine()).trimmed();
}

ControllerProcess::~ControllerProcess()
{
    m_process.terminate();
    if (!m_process.waitForFinished(5000)) {
        m_process.kill();
        m_process.waitForFinished();
    }
}

void ControllerProcess::killHard()
{
    m_process.kill();
    m_process.waitForFinished();
}

} // namespace campanel::test
