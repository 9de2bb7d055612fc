// SPDX-License-Identifier: Apache-2.0
#include "app/link/simulated_controller.h"

#include "app/link/link_logging.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::link {

namespace {

constexpr auto restartDelay = 500ms;
constexpr int endTimeoutMs = 2000;
const auto programName = u"campanel-controller"_s;

// The statements about the machine among the rules of the line: how they begin, and what ends them.
struct MachineFault {
    QLatin1String beginning;
    QLatin1String end;
};

constexpr std::array machineFaults{
    MachineFault{"jam on"_L1, "jam off"_L1},
    MachineFault{"line start"_L1, "line stop"_L1},
    MachineFault{"line slip"_L1, "line slip 0"_L1},
    MachineFault{"line lose"_L1, "line lose 0"_L1},
    MachineFault{"line swap on"_L1, "line swap off"_L1},
    MachineFault{"line noise on"_L1, "line noise off"_L1},
};

const MachineFault* machineFaultOf(const QString& rule)
{
    const auto found = std::ranges::find_if(
        machineFaults, [&rule](const MachineFault& fault) { return rule.startsWith(fault.beginning); });
    return found == machineFaults.end() ? nullptr : &*found;
}

} // namespace

SimulatedController::SimulatedController(Options options, QObject* parent)
    : QObject(parent)
    , m_options(std::move(options))
    , m_process(this)
    , m_restart(this)
{
    m_restart.setSingleShot(true);
    m_restart.setInterval(restartDelay);
    connect(&m_restart, &QTimer::timeout, this, &SimulatedController::start);
    connect(&m_process, &QProcess::readyReadStandardOutput, this, &SimulatedController::readLines);
    connect(&m_process, &QProcess::finished, this, &SimulatedController::processEnded);
    connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart)
            processEnded();
    });
}

SimulatedController::~SimulatedController()
{
    m_process.disconnect(this);
    if (m_process.state() == QProcess::NotRunning)
        return;
    m_process.terminate();
    if (!m_process.waitForFinished(endTimeoutMs))
        m_process.kill();
    m_process.waitForFinished(endTimeoutMs);
}

QStringList SimulatedController::candidatePaths()
{
    const QDir here(QCoreApplication::applicationDirPath());
    return {here.filePath(programName), QDir::cleanPath(here.filePath(u"../bin/"_s + programName)),
            QDir::cleanPath(here.filePath(u"../libexec/campanel/"_s + programName)),
            QStandardPaths::findExecutable(programName)};
}

void SimulatedController::start()
{
    QString program = m_options.program;
    if (program.isEmpty()) {
        for (const QString& candidate : candidatePaths()) {
            if (QFileInfo(candidate).isExecutable()) {
                program = candidate;
                break;
            }
        }
    }
    if (program.isEmpty()) {
        emit notFound(candidatePaths().value(0));
        m_restart.start();
        return;
    }
    QStringList arguments{u"--exit-with-parent"_s, u"--control"_s};
    if (!m_options.stateDir.isEmpty())
        arguments << u"--state"_s << m_options.stateDir;
    m_isServing = false;
    m_ofMachine.clear();
    m_process.start(program, arguments + m_options.arguments);
}

void SimulatedController::readLines()
{
    while (m_process.canReadLine())
        take(QString::fromLocal8Bit(m_process.readLine()).trimmed());
}

void SimulatedController::take(const QString& line)
{
    const auto portWord = u"port "_s;
    const auto measuredWord = u"measured "_s;
    if (!m_isServing) {
        m_isServing = true;
        qCInfo(linkLog) << "simulated controller serves" << line;
        if (!m_faults.isEmpty())
            sendFaults(m_faults, false);
        emit serving(line);
    } else if (line.startsWith(portWord)) {
        emit serving(line.mid(portWord.size()));
    } else if (line.startsWith(measuredWord)) {
        takeMeasured(line.mid(measuredWord.size()));
    } else if (line.startsWith(u"ok"_s) || line.startsWith(u"error"_s)) {
        takeAnswer(line);
    } else {
        qCInfo(linkLog) << "simulated controller:" << line;
    }
}

void SimulatedController::takeAnswer(const QString& line)
{
    if (m_sentFaults.isEmpty())
        return;
    const SentFaults sent = m_sentFaults.takeFirst();
    const bool isAccepted = line.startsWith(u"ok"_s);
    if (isAccepted)
        m_faults = sent.rules;
    if (sent.isAsked)
        emit faultsAnswered({isAccepted ? FaultsEnd::Accepted : FaultsEnd::Refused,
                             isAccepted ? QString() : line.section(u' ', 1)});
}

// Parses "none", or length and distance of the cut behind its mark in mm; "?" for an unknown length.
void SimulatedController::takeMeasured(const QString& line)
{
    if (m_rulersAsked == 0)
        return;
    --m_rulersAsked;
    const QStringList words = line.split(u' ');
    if (words.size() == 2)
        emit rulerRead({RulerEnd::Read, words[0].toDouble(), words[1].toDouble()});
    else
        emit rulerRead({RulerEnd::NoBag});
}

bool SimulatedController::measureSimulatedBag()
{
    if (!m_isServing)
        return false;
    ++m_rulersAsked;
    m_process.write("measure\n");
    return true;
}

bool SimulatedController::setFaults(const QStringList& rules)
{
    if (m_isServing)
        sendFaults(rules, true);
    return m_isServing;
}

void SimulatedController::sendFaults(const QStringList& rules, bool isAsked)
{
    m_sentFaults << SentFaults{rules, isAsked};
    QStringList ofLine;
    QStringList ofMachine;
    for (const QString& rule : rules)
        (machineFaultOf(rule) ? ofMachine : ofLine) << rule;
    // Before the rules, so that the answer to them is the answer to both.
    const QStringList before = std::exchange(m_ofMachine, ofMachine);
    for (const QString& rule : before) {
        if (!ofMachine.contains(rule))
            m_process.write(QByteArray(machineFaultOf(rule)->end.data()) + '\n');
    }
    for (const QString& rule : ofMachine) {
        if (!before.contains(rule))
            m_process.write(rule.toLatin1() + '\n');
    }
    const QString script = ofLine.isEmpty() ? u"clear"_s : ofLine.join(u"; "_s);
    m_process.write(script.toLocal8Bit() + '\n');
}

void SimulatedController::processEnded()
{
    const QString lastWords = m_process.error() == QProcess::FailedToStart
                                  ? m_process.errorString()
                                  : QString::fromLocal8Bit(m_process.readAllStandardError()).trimmed();
    qCWarning(linkLog) << "simulated controller has ended:" << lastWords;
    m_isServing = false;
    m_restart.start();
    emit ended(lastWords);
    for (const SentFaults& sent : std::exchange(m_sentFaults, {})) {
        if (sent.isAsked)
            emit faultsAnswered({FaultsEnd::NotServing, lastWords});
    }
    for (int left = std::exchange(m_rulersAsked, 0); left > 0; --left)
        emit rulerRead({RulerEnd::NotServing});
}

} // namespace campanel::link
