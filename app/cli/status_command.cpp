// SPDX-License-Identifier: Apache-2.0
// campanelctl status: the decoded status block, the identity, and the recipe of the active program.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/link_session.h"
#include "app/cli/report.h"
#include "app/program/cam_advance.h"
#include "app/program/program_image.h"
#include "modbus/map/io_status.h"
#include "modbus/map/master_status.h"

#include <QJsonArray>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

QString nameOf(std::string_view enumeration, std::uint16_t value)
{
    return QString::fromStdString(modbus::enumName(enumeration, value));
}

QJsonArray bitNames(std::string_view enumName, std::uint32_t bits)
{
    QJsonArray names;
    constexpr std::uint32_t width = 16;
    for (std::uint16_t bit = 0; bit < width; ++bit) {
        if ((bits & (1u << bit)) != 0)
            names.append(nameOf(enumName, bit));
    }
    return names;
}

QJsonValue crcOrNull(const std::optional<std::uint32_t>& crc)
{
    if (!crc)
        return QJsonValue::Null;
    return crcText(*crc);
}

QJsonObject statusObject(const modbus::StatusBlock& status)
{
    const auto wide = [](auto value) { return static_cast<qint64>(value); };
    return {{u"state"_s,
             status.state ? nameOf("State", static_cast<std::uint16_t>(*status.state)) : QJsonValue()},
            {u"faults"_s, bitNames("FaultBit", status.faultBits)},
            {u"warnings"_s, bitNames("WarningBit", status.warningBits)},
            {u"program_kind"_s, nameOf("ProgramKind", static_cast<std::uint16_t>(status.programKind))},
            {u"staged_state"_s, status.stagedState
                                    ? nameOf("StagedState", static_cast<std::uint16_t>(*status.stagedState))
                                    : QJsonValue()},
            {u"generation"_s, wide(status.generation)},
            {u"active_crc32"_s, crcOrNull(status.activeCrc)},
            {u"saved_crc32"_s, crcOrNull(status.savedCrc)},
            {u"cycle_count"_s, wide(status.cycleCount)},
            {u"master_angle_deg"_s, orNull(status.masterAngleDeg)},
            {u"master_speed_percent"_s, status.masterSpeedPercent},
            {u"commanded_frequency_hz"_s, wide(status.commandedFrequencyHz)},
            {u"actual_frequency_hz"_s, wide(status.actualFrequencyHz)},
            {u"commanded_position_pulses"_s, wide(status.commandedPositionPulses)},
            {u"axis_position_pulses"_s, wide(status.axisPositionPulses)},
            {u"following_error_pulses"_s, wide(status.followingErrorPulses)},
            {u"knife_angle_deg"_s, orNull(status.knifeAngleDeg)},
            {u"bag_length_mm"_s, orNull(status.bagLengthMm)},
            {u"bag_deviation_mm"_s, orNull(status.bagDeviationMm)},
            {u"bag_count"_s, wide(status.bagCount)},
            {u"uptime_s"_s, wide(status.uptimeS)},
            {u"link"_s, QJsonObject{{u"crc_errors"_s, wide(status.linkCrcErrors)},
                                    {u"frame_errors"_s, wide(status.linkFrameErrors)},
                                    {u"exceptions"_s, wide(status.linkExceptions)},
                                    {u"requests"_s, wide(status.linkRequests)}}}};
}

QJsonObject pressObject(const modbus::PressStatus& press)
{
    return {{u"stage"_s,
             press.stage ? nameOf("PressStage", static_cast<std::uint16_t>(*press.stage)) : QJsonValue()},
            {u"force_n"_s, press.forceN},
            {u"last_stroke"_s,
             QJsonObject{{u"result"_s, nameOf("StrokeResult", static_cast<std::uint16_t>(press.result))},
                         {u"stop_error_pulses"_s, press.stopErrorPulses},
                         {u"stop_force_n"_s, press.stopForceN},
                         {u"peak_force_n"_s, press.peakForceN}}}};
}

QJsonArray keptPositions(const modbus::IoStatus& io)
{
    QJsonArray kept;
    for (const auto& [isKept, axis] :
         {std::pair(io.isAxisKept, u"axis"_s), std::pair(io.isFilmKept, u"film"_s),
          std::pair(io.isInfeedKept, u"infeed"_s)}) {
        if (isKept)
            kept << axis;
    }
    return kept;
}

// What the machine does not have is null.
QJsonObject ioObject(const modbus::IoStatus& io)
{
    return {{u"inputs"_s, io.inputs ? QJsonValue(bitNames("InputBit", *io.inputs)) : QJsonValue()},
            {u"outputs"_s, io.outputs ? QJsonValue(bitNames("OutputBit", *io.outputs)) : QJsonValue()},
            {u"torque_percent"_s, orNull(io.torquePercent)},
            {u"torque_angle_deg"_s, orNull(io.torqueAngleDeg)},
            {u"infeed_position_mm"_s, orNull(io.infeedPositionMm)},
            {u"infeed_following_error_mm"_s, orNull(io.infeedFollowingErrorMm)},
            {u"positions_kept"_s, keptPositions(io)}};
}

// Without an input for an encoder it is null.
QJsonValue masterValue(const modbus::MasterStatus& master)
{
    if (!master.isAvailable)
        return QJsonValue::Null;
    return QJsonObject{{u"state"_s, master.state
                                        ? nameOf("MasterState", static_cast<std::uint16_t>(*master.state))
                                        : QJsonValue()},
                       {u"counts"_s, master.counts},
                       {u"speed_mm_per_s"_s, master.speedMmPerS},
                       {u"angle_deg"_s, master.angleDeg},
                       {u"tracker_error_mm"_s, master.errorMm},
                       {u"lead_mm"_s, master.leadMm},
                       {u"lag_mm"_s, master.lagMm},
                       {u"held_mm"_s, master.heldMm},
                       {u"to_engaged_mm"_s, master.toEngagedMm},
                       {u"smoothing_ms"_s, master.smoothingMs},
                       {u"phase_deg"_s, master.phaseDeg},
                       {u"ripple_percent"_s, master.ripplePercent},
                       {u"input_errors"_s, master.inputErrors},
                       {u"index_error_counts"_s, master.indexErrorCounts},
                       {u"slip_mm"_s, master.slipMm},
                       {u"passed_m"_s, master.passedM}};
}

QJsonObject identityObject(const modbus::Identity& identity)
{
    return {{u"firmware"_s, QString::fromStdString(identity.firmwareVersion())},
            {u"register_map"_s, u"%1.%2"_s.arg(identity.mapMajor).arg(identity.mapMinor)},
            {u"unique_id"_s, QString::number(identity.uniqueId, 16).toUpper().rightJustified(16, u'0')},
            {u"row_capacity"_s, identity.rowCapacity},
            {u"timer_clock_hz"_s, static_cast<qint64>(identity.timerClockHz)},
            {u"timer_bits"_s, identity.timerBits},
            {u"max_pulse_frequency_hz"_s, static_cast<qint64>(identity.maxPulseFrequencyHz)}};
}

QJsonObject programObject(const program::Recipe& recipe)
{
    QJsonObject object{{u"name"_s, QString::fromStdString(recipe.name)}, {u"version"_s, recipe.version}};
    object[u"kind"_s] = fromView(program::kindInfo(recipe.kind()).key);
    for (const profile::Field field : program::kindInfo(recipe.kind()).programFields)
        object[fromView(profile::info(field).id)] = program::value(recipe, field);
    return object;
}

} // namespace

Outcome runStatus(const Invocation& call)
{
    auto session = LinkSession::open(call);
    if (!session)
        return tl::unexpected(session.error());
    const auto status = session->status();
    if (!status)
        return tl::unexpected(status.error());
    QJsonObject object = statusObject(*status);
    if (status->press)
        object[u"press"_s] = pressObject(*status->press);
    object[u"io"_s] = QJsonValue::Null; // of an older controller
    if (session->identity().mapMinor >= modbus::ioMapMinor) {
        const auto io = session->client().readProven(modbus::ioAddress,
                                                     modbus::ioRegisters(session->identity().mapMinor));
        if (!io)
            return fail(io.error());
        object[u"io"_s] = ioObject(modbus::decodeIo(*io));
    }
    object[u"master"_s] = QJsonValue::Null;
    if (session->identity().mapMinor >= modbus::masterMapMinor) {
        const auto master =
            session->client().readProven(modbus::masterStatusAddress, modbus::masterStatusRegisters);
        if (!master)
            return fail(master.error());
        object[u"master"_s] = masterValue(modbus::decodeMasterStatus(*master));
    }
    object[u"identity"_s] = identityObject(session->identity());
    object[u"program"_s] = QJsonValue::Null;
    if (status->activeCrc) {
        const auto active = session->activeProgram();
        if (!active)
            return tl::unexpected(active.error());
        if (*active) {
            const program::Recipe& recipe = (*active)->recipe;
            QJsonObject program = programObject(recipe);
            if (profile::camMaster(recipe.program) != nullptr)
                program[u"advance_mm_per_cycle"_s] = program::advanceMm((*active)->header, recipe);
            object[u"program"_s] = program;
        }
    }
    return call.deliver(formatted(object, call.format()));
}

} // namespace campanel::cli
