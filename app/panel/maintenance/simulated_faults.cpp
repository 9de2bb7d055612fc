// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/simulated_faults.h"

#include "app/panel/kit/language_notifier.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <utility>

namespace campanel::panel {

namespace {

struct ReadyMade {
    const char* name;
    const char* note;
    const char* sometimes; // rules of campanel-controller; null: the fault is off or on
    const char* often;
};

// About 80 exchanges pass per second at full speed: a probability of 0.001 means once in twelve seconds.
constexpr std::array faults{
    ReadyMade{QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Late responses"),
              QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults",
                                "Responses arrive 1.5 timeouts late, after the next request."),
              "late times=1.5 probability=0.01", "late times=1.5 probability=0.1"},
    ReadyMade{
        QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Lost frames"),
        QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Requests and responses that never arrive."),
        "lost-request probability=0.005; lost-answer probability=0.005",
        "lost-request probability=0.05; lost-answer probability=0.05"},
    ReadyMade{QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Corrupted responses"),
              QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Flipped bits and truncated responses."),
              "corrupt probability=0.01; truncate probability=0.005",
              "corrupt probability=0.1; truncate probability=0.05"},
    ReadyMade{QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Noise"),
              QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Random bytes after the responses."),
              "noise probability=0.01", "noise probability=0.1"},
    ReadyMade{QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "A second master"),
              QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults",
                                "Its valid responses arrive in place of the panel's."),
              "second-master probability=0.01", "second-master probability=0.1"},
    ReadyMade{
        QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Responses of other devices"),
        QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Wrong unit, wrong function, wrong length."),
        "wrong-unit probability=0.005; wrong-function probability=0.005; wrong-count probability=0.005",
        "wrong-unit probability=0.05; wrong-function probability=0.05; wrong-count probability=0.05"},
    ReadyMade{QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Busy controller"),
              QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults",
                                "The controller refuses three requests in a row."),
              "busy probability=0.005", "busy probability=0.05"},
    ReadyMade{QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Silence"),
              QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "No data passes for two seconds."),
              "silence time=2000 probability=0.001", "silence time=2000 probability=0.005"},
    ReadyMade{QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Unplugged adapter"),
              QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "The port disappears for two seconds."),
              "unplug when=answer time=2000 probability=0.001",
              "unplug when=answer time=2000 probability=0.005"},
    ReadyMade{QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Restarts of the controller"),
              QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults",
                                "Silence, then power-on with the saved program. The machine stops."),
              "restart time=1500 probability=0.001", "restart time=1500 probability=0.005"},
    ReadyMade{QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Another register map"),
              QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults",
                                "Takes effect when the panel reconnects, after another fault."),
              "map-version major=2 probability=0.5", "map-version major=2"},
    ReadyMade{QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Something under the jaws"),
              QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults",
                                "A packing machine with jam detection stops. Off: taken out."),
              nullptr, "jam on"},
};

constexpr qsizetype faultCount = static_cast<qsizetype>(faults.size());

} // namespace

SimulatedFaults::SimulatedFaults(link::Link& link, AccessCheck& accessCheck, QObject* parent)
    : QObject(parent)
    , m_link(link)
    , m_access(accessCheck)
    , m_wanted(faultCount, Off)
{
    setLevels(m_wanted);
    connect(&link, &link::Link::reported, this, &SimulatedFaults::takeReport);
    connect(&link, &link::Link::faultsSimulated, this, &SimulatedFaults::takeOutcome);
    LanguageNotifier::follow(this);
}

QString LineFaultRow::name() const
{
    return SimulatedFaults::tr(faults[static_cast<std::size_t>(fault)].name);
}

QString LineFaultRow::note() const
{
    return SimulatedFaults::tr(faults[static_cast<std::size_t>(fault)].note);
}

bool LineFaultRow::isSwitch() const
{
    return !faults[static_cast<std::size_t>(fault)].sometimes;
}

QStringList SimulatedFaults::rules(const QList<Level>& levels)
{
    QStringList rules;
    for (qsizetype row = 0; row < std::min(faultCount, levels.size()); ++row) {
        const ReadyMade& fault = faults[static_cast<std::size_t>(row)];
        if (levels[row] != Off)
            rules << QString::fromLatin1(levels[row] == Often ? fault.often : fault.sometimes);
    }
    return rules;
}

void SimulatedFaults::setLevel(int row, int level)
{
    if (!m_access.require(panel::Level::Technician) || row < 0 || row >= faultCount || level < Off ||
        level > Often || (level == Sometimes && m_rows.row(row).isSwitch()))
        return;
    m_wanted[row] = static_cast<Level>(level);
    send();
}

void SimulatedFaults::clear()
{
    if (!m_access.require(panel::Level::Technician))
        return;
    m_wanted.fill(Off);
    send();
}

void SimulatedFaults::send()
{
    if (m_sent)
        return; // the answer continues
    m_sent = m_wanted;
    m_link.simulateFaults(rules(m_wanted));
}

void SimulatedFaults::takeOutcome(const link::FaultsOutcome& outcome)
{
    if (!m_sent)
        return;
    const QList<Level> sent = *std::exchange(m_sent, std::nullopt);
    const bool isAccepted = outcome.end == link::FaultsEnd::Accepted;
    m_failure = isAccepted ? std::nullopt : std::optional(outcome);
    if (isAccepted)
        setLevels(sent);
    else
        m_wanted = m_levels;
    emit changed();
    if (m_wanted != m_levels)
        send();
}

// Clears the faults of a simulated controller that was restarted by another connection.
void SimulatedFaults::takeReport(const link::LinkReport& report)
{
    const bool isAnother = report.simulator == link::SimulatorState::Starting || !report.simulated;
    if (!isAnother || (activeCount() == 0 && !m_failure))
        return;
    m_failure.reset();
    m_wanted.fill(Off);
    setLevels(m_wanted);
    emit changed();
}

void SimulatedFaults::setLevels(const QList<Level>& levels)
{
    m_levels = levels;
    QList<LineFaultRow> rows;
    for (const Level level : levels)
        rows << LineFaultRow{static_cast<int>(rows.size()), level};
    m_rows.setRows(rows);
}

int SimulatedFaults::activeCount() const
{
    return static_cast<int>(faultCount - m_levels.count(Off));
}

QString SimulatedFaults::text() const
{
    if (activeCount() == 0)
        return tr("No faults: the connection works without errors.");
    QStringList names;
    for (qsizetype row = 0; row < faultCount; ++row) {
        if (m_levels[row] != Off)
            names << tr(faults[static_cast<std::size_t>(row)].name);
    }
    return tr("Active: %1").arg(names.join(tr(", ", "between names")));
}

QString SimulatedFaults::errorText() const
{
    if (!m_failure)
        return {};
    switch (m_failure->end) {
    case link::FaultsEnd::Refused:
        return tr("The simulated controller refused the fault: %1").arg(m_failure->detail);
    case link::FaultsEnd::NotSimulated:
        return tr("Faults are available for the simulated controller only.");
    case link::FaultsEnd::NotServing:
        return tr("The simulated controller is not running. Connect it, then try again.");
    case link::FaultsEnd::Accepted:
        break;
    }
    return {};
}

} // namespace campanel::panel
