// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/simulated_faults.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace campanel::panel {

namespace {

struct ReadyMade {
    const char* name;
    const char* note;
    const char* sometimes; // rules of campanel-controller; null: the fault is off or on
    const char* often;
};

constexpr auto lineStart = "line start"; // with a speed

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
    ReadyMade{QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Line runs"),
              QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults",
                                "The shaft with the encoder. 100 %: %1, the active program at its rate."),
              lineStart, lineStart},
    ReadyMade{QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Wheel slips"),
              QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults",
                                "The encoder turns 5 % less than the line travels."),
              nullptr, "line slip 0.05"},
    ReadyMade{QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Counts lost"),
              QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults",
                                "The encoder loses 50 counts in each revolution."),
              nullptr, "line lose 50"},
    ReadyMade{QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Wires swapped"),
              QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults",
                                "A and B of the encoder: the counts go backward."),
              nullptr, "line swap on"},
    ReadyMade{
        QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "Encoder signal disturbed"),
        QT_TRANSLATE_NOOP("campanel::panel::SimulatedFaults", "A and B change at once at 2 % of the edges."),
        nullptr, "line noise on"},
};

constexpr qsizetype faultCount = static_cast<qsizetype>(faults.size());
constexpr qsizetype lineCount = 5; // the last ones need an encoder
constexpr qsizetype lineRow = faultCount - lineCount;
// The line runs at these shares of the program's speed, by level; a controller does not accept the last one.
constexpr std::array lineShares{0.0, 0.5, 1.0, 1.2};
constexpr double usualMmPerS = 250; // without a program that follows a master

} // namespace

SimulatedFaults::SimulatedFaults(Controller& controller, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_wanted(faultCount, Off)
{
    setLevels(m_wanted);
    connect(controller.masterSetting(), &MasterSetting::changed, this, &SimulatedFaults::showRows);
    const link::Link& link = controller.link();
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
    const QString text = SimulatedFaults::tr(faults[static_cast<std::size_t>(fault)].note);
    return isLine() ? text.arg(Format().measure(mmPerS, 0, QStringLiteral("mm/s"))) : text;
}

bool LineFaultRow::isLine() const
{
    return fault == lineRow;
}

bool LineFaultRow::isSwitch() const
{
    return !faults[static_cast<std::size_t>(fault)].sometimes;
}

// Returns the speed of the line that the active program has at its rate.
double SimulatedFaults::programMmPerS() const
{
    constexpr double secondsPerMin = 60;
    const auto& program = m_controller.program();
    if (!program)
        return usualMmPerS;
    if (program->recipe.isCutter() && program->bagLengthMm * program->rateBagsPerMin > 0)
        return program->bagLengthMm * program->rateBagsPerMin / secondsPerMin;
    const profile::CamMaster* cam = profile::camMaster(program->recipe.program);
    return cam ? std::abs(cam->masterRateRevPerMin) / secondsPerMin *
                     m_controller.masterSetting()->revolutionMm()
               : usualMmPerS;
}

QStringList SimulatedFaults::rules(const QList<Level>& levels) const
{
    QStringList rules;
    for (qsizetype row = 0; row < std::min(faultCount, levels.size()); ++row) {
        const ReadyMade& fault = faults[static_cast<std::size_t>(row)];
        if (levels[row] == Off)
            continue;
        rules << QString::fromLatin1(levels[row] == Sometimes ? fault.sometimes : fault.often);
        if (row == lineRow)
            rules.last() += u' ' + QString::number(lineShares[levels[row]] * m_lineMmPerS, 'f', 1);
    }
    return rules;
}

void SimulatedFaults::setLevel(int row, int level)
{
    if (!m_controller.accessCheck().require(panel::Level::Technician) || row < 0 || row >= m_rows.count() ||
        level < Off || level > (m_rows.row(row).isLine() ? Beyond : Often) ||
        (level == Sometimes && m_rows.row(row).isSwitch()))
        return;
    m_wanted[row] = static_cast<Level>(level);
    if (row == lineRow)
        m_lineMmPerS = programMmPerS();
    send();
}

void SimulatedFaults::clear()
{
    if (!m_controller.accessCheck().require(panel::Level::Technician))
        return;
    m_wanted.fill(Off);
    send();
}

void SimulatedFaults::send()
{
    if (m_sent)
        return; // the answer continues
    m_sent = m_wanted;
    m_controller.link().simulateFaults(rules(m_wanted));
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
    showRows();
}

void SimulatedFaults::showRows()
{
    const bool hasEncoder = m_controller.masterSetting()->hasInput();
    QList<LineFaultRow> rows;
    for (const Level level : m_levels.first(hasEncoder ? faultCount : lineRow))
        rows << LineFaultRow{static_cast<int>(rows.size()), level, programMmPerS()};
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
