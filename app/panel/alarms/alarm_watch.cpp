// SPDX-License-Identifier: Apache-2.0
#include "app/panel/alarms/alarm_watch.h"

#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/kit/format.h"
#include "app/panel/records/database_service.h"
#include "app/panel/settings/settings.h"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace campanel::panel {

using store::AlarmRow;

namespace {

constexpr int patienceMs = 3000;

// Returns true while a link is connecting, however long that takes.
bool isComing(link::LinkState state)
{
    return state == link::LinkState::Searching || state == link::LinkState::Connecting;
}

} // namespace

AlarmWatch::AlarmWatch(Controller& controller, Editor& editor, DatabaseService& records, Settings& settings,
                       QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_editor(editor)
    , m_settings(settings)
    , m_patience(this)
{
    m_patience.setSingleShot(true);
    m_patience.setInterval(patienceMs);
    connect(&m_patience, &QTimer::timeout, this, [this] {
        m_isPatienceOver = true;
        noteLink();
    });
    connect(&controller, &Controller::stateChanged, this, &AlarmWatch::noteController);
    connect(&controller, &Controller::connectionChanged, this, &AlarmWatch::noteLink);
    connect(&editor, &Editor::noticeChanged, this, &AlarmWatch::noteRecipe);
    connect(&records, &DatabaseService::errorReported, this, &AlarmWatch::noteTrouble);
    connect(&records.store(), &store::StoreThread::opened, this, &AlarmWatch::noteOpening);
}

void AlarmWatch::begin()
{
    if (!m_settings.notice().isEmpty())
        raiseEvent(AlarmCatalogue::settingsDamaged(), m_settings.notice());
    noteRecipe();
    noteController();
    noteLink();
}

void AlarmWatch::noteController()
{
    const auto& status = m_controller.status();
    if (!status) {
        setControllerAlarms({}, {}, AlarmRow::End::Unknown); // another controller
        return;
    }
    // Invisible alarms have not ended.
    if (!m_controller.isConnected())
        return;
    const QString bits = u"0x%1 0x%2"_s.arg(status->faultBits, 4, 16, QLatin1Char('0'))
                             .arg(status->warningBits, 4, 16, QLatin1Char('0'));
    setControllerAlarms(AlarmCatalogue::ofBits<modbus::FaultBit>(status->faultBits) +
                            AlarmCatalogue::ofBits<modbus::WarningBit>(status->warningBits),
                        bits, AlarmRow::End::Returned);
}

void AlarmWatch::setControllerAlarms(const Kinds& now, const QString& bits, AlarmRow::End end)
{
    const Kinds before = std::exchange(m_byController, now);
    for (const AlarmKind* kind : before - now)
        emit cleared(*kind, end);
    for (const AlarmKind& kind : AlarmCatalogue::all()) { // alarms of one status come in its order
        if (!now.contains(&kind) || before.contains(&kind))
            continue;
        const bool isUnknown =
            &kind == &AlarmCatalogue::unknownFault() || &kind == &AlarmCatalogue::unknownWarning();
        m_measures[&kind] = measured(kind);
        emit raised(kind, isUnknown ? bits : valuesOf(kind));
    }
}

FaultMeasure AlarmWatch::measured(const AlarmKind& kind) const
{
    if (&kind != &AlarmCatalogue::of(modbus::FaultBit::FollowingError))
        return {};
    return {std::abs(m_controller.live().followingErrorMm), m_controller.torque()->followingLimitMm()};
}

QString AlarmWatch::valuesOf(const AlarmKind& kind) const
{
    using modbus::FaultBit;
    const Format format;
    const LiveValues live = m_controller.live();
    if (&kind == &AlarmCatalogue::of(FaultBit::FollowingError)) {
        const auto limit = m_controller.parameter("parameter.following_error_limit").value();
        const QString pulses = format.grouped(std::abs(m_controller.status()->followingErrorPulses), 0);
        return limit ? tr("Axis: following error %1 pulses, limit %2 pulses")
                           .arg(pulses, format.grouped(*limit, 0))
                     : tr("Axis: following error %1 pulses").arg(pulses);
    }
    if (&kind == &AlarmCatalogue::of(FaultBit::ForceLimit))
        return tr("Ram: force %1 N, limit %2 N")
            .arg(format.number(live.forceN, 0), format.number(m_controller.active().maxStopForceN, 0));
    if (&kind == &AlarmCatalogue::of(FaultBit::TouchedTooEarly))
        return tr("Ram: contact at %1, approach ends at %2")
            .arg(format.measure(live.positionMm, 2, QStringLiteral("mm")),
                 format.measure(m_controller.active().approachPositionMm, 2, QStringLiteral("mm")));
    return {};
}

void AlarmWatch::noteLink()
{
    const link::LinkReport& report = m_controller.report();
    if (report.isScanning)
        return; // a scan of the link doctor uses the ports
    if (report.state == link::LinkState::Connected) {
        m_patience.stop();
        m_isPatienceOver = false;
        setLinkAlarm(nullptr);
        return;
    }
    if (isComing(report.state)) {
        if (!m_isPatienceOver) {
            if (!m_patience.isActive())
                m_patience.start();
            return;
        }
        // Keeps the link alarm until another state is certain; only a lost connection may become another
        // problem.
        if (m_link && m_link != AlarmCatalogue::of(link::LinkState::Lost))
            return;
    }
    const bool isSimulatorMissing = report.simulated && (report.simulator == link::SimulatorState::NotFound ||
                                                         report.simulator == link::SimulatorState::Ended);
    setLinkAlarm(isSimulatorMissing ? &AlarmCatalogue::simulatorMissing() : AlarmCatalogue::of(report.state));
}

void AlarmWatch::setLinkAlarm(const AlarmKind* kind)
{
    const AlarmKind* before = std::exchange(m_link, kind);
    if (before == kind)
        return;
    if (before)
        emit cleared(*before, AlarmRow::End::Returned);
    if (kind)
        emit raised(*kind, m_controller.connectionText());
}

void AlarmWatch::noteRecipe()
{
    if (!m_editor.notice().isEmpty())
        raiseEvent(AlarmCatalogue::recipeNotKept(), m_editor.notice());
}

void AlarmWatch::noteOpening(const store::StoreThread::Report& report)
{
    if (report.error)
        emit raised(AlarmCatalogue::of(report.error->kind), store::StoreErrorText::describe(*report.error));
    else if (report.opening.isReplaced())
        raiseEvent(AlarmCatalogue::memoryDamaged(report.opening.fromCopy), report.opening.damagedKeptAs);
}

void AlarmWatch::noteTrouble(const store::StoreError& error)
{
    if (error.kind == store::StoreError::Kind::Refused || error.kind == store::StoreError::Kind::LastVersion)
        return; // an answer to a request, not a problem
    const AlarmKind& kind = AlarmCatalogue::of(error.kind);
    m_store.insert(&kind);
    emit raised(kind, store::StoreErrorText::describe(error));
}

void AlarmWatch::noteStored()
{
    for (const AlarmKind* kind : std::exchange(m_store, {}))
        emit cleared(*kind, AlarmRow::End::Returned);
}

void AlarmWatch::noteSensorDrift(const std::optional<program::SensorDrift>& drift)
{
    const AlarmKind& kind = AlarmCatalogue::markSensorDrifted();
    if (!drift) {
        emit cleared(kind, AlarmRow::End::Returned);
        return;
    }
    const Format format;
    emit raised(kind, tr("Dead time of the mark sensor: entered %1 ms, learned %2 ms, margin ±%3 ms")
                          .arg(format.number(drift->enteredMs, 2), format.number(drift->learned.ms, 2),
                               format.number(drift->learned.marginMs, 2)));
}

void AlarmWatch::check()
{
    setLasting(m_areSettingsLost, !m_settings.areKept(), AlarmCatalogue::settingsNotKept());
    if (!m_countTouchscreens)
        return;
    const int touchscreens = m_countTouchscreens();
    m_touchscreens = std::max(m_touchscreens, touchscreens);
    setLasting(m_isTouchscreenMissing, touchscreens < m_touchscreens, AlarmCatalogue::touchscreenMissing());
}

void AlarmWatch::setLasting(bool& state, bool now, const AlarmKind& kind)
{
    if (std::exchange(state, now) == now)
        return;
    if (now)
        emit raised(kind, {});
    else
        emit cleared(kind, AlarmRow::End::Returned);
}

void AlarmWatch::raiseEvent(const AlarmKind& kind, const QString& detail)
{
    emit raised(kind, detail);
    emit cleared(kind, AlarmRow::End::Returned);
}

} // namespace campanel::panel
