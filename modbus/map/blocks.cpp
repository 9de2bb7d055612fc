// SPDX-License-Identifier: Apache-2.0
// Decodes the register blocks by the names of the register table.
#include "modbus/map/blocks.h"

#include "modbus/map/codec.h"

#include <algorithm>
#include <array>
#include <limits>

namespace campanel::modbus {
namespace {

template <typename E> constexpr std::uint16_t bit(E value)
{
    return static_cast<std::uint16_t>(1u << static_cast<std::uint16_t>(value));
}

// Returns the enumeration value, empty when this version does not know it.
template <typename E> std::optional<E> known(std::uint16_t raw, E last)
{
    if (raw > static_cast<std::uint16_t>(last))
        return std::nullopt;
    return static_cast<E>(raw);
}

std::optional<std::uint32_t> unlessZero(std::uint32_t value)
{
    return value == 0 ? std::nullopt : std::optional(value);
}

// Decodes the registers with a different meaning for each kind of program.
void decodeKind(const RegisterReader& reader, StatusBlock& status)
{
    if (status.programKind == ProgramKind::Press) {
        PressStatus press;
        press.stage = known(reader.u16("status.press_stage"), PressStage::Return);
        press.forceN = reader.u16("status.press_force");
        press.stopErrorPulses = static_cast<std::int16_t>(reader.u16("status.stop_error"));
        press.stopForceN = reader.u16("status.stop_force");
        press.result =
            known(reader.u16("status.stroke_result"), StrokeResult::Stopped).value_or(StrokeResult::None);
        press.peakForceN = reader.u16("status.peak_force");
        status.press = press;
        return;
    }
    if (status.programKind != ProgramKind::RotaryCutter && status.programKind != ProgramKind::None)
        return;
    if (!status.has(WarningBit::NotHomed))
        status.knifeAngleDeg = reader.physical("status.knife_angle");
    if (reader.u32("status.bag_length") != 0) {
        status.bagLengthMm = reader.physical("status.bag_length");
        status.bagDeviationMm = reader.physical("status.bag_deviation");
    }
    status.bagCount = reader.u32("status.bag_count");
}

} // namespace

std::string Identity::firmwareVersion() const
{
    return std::to_string(firmwareMajor) + '.' + std::to_string(firmwareMinor) + '.' +
           std::to_string(firmwarePatch);
}

bool Identity::supports(ProgramKind kind) const
{
    return kind <= lastProgramKind && (programKinds & bit(kind)) != 0;
}

bool Identity::supports(TableLayout layout) const
{
    return tableLayouts == 0 ||
           (layout <= TableLayout::PressStages && (tableLayouts >> static_cast<unsigned>(layout) & 1u) != 0);
}

bool Identity::hasRegister(std::string_view name) const
{
    return mapMinor >= registerNamed(name).minor;
}

bool StatusBlock::has(FaultBit which) const
{
    return (faultBits & bit(which)) != 0;
}

bool StatusBlock::has(WarningBit which) const
{
    return (warningBits & bit(which)) != 0;
}

Identity decodeIdentity(std::span<const std::uint16_t> registers)
{
    const RegisterReader reader(registers, identityAddress);
    Identity identity;
    identity.deviceType = reader.u16("identity.device_type");
    identity.mapMajor = reader.u16("identity.map_major");
    identity.mapMinor = reader.u16("identity.map_minor");
    identity.firmwareMajor = reader.u16("identity.firmware_major");
    identity.firmwareMinor = reader.u16("identity.firmware_minor");
    identity.firmwarePatch = reader.u16("identity.firmware_patch");
    identity.uniqueId = (static_cast<std::uint64_t>(reader.u32("identity.unique_id_high")) << 32) |
                        reader.u32("identity.unique_id_low");
    identity.programKinds = reader.u16("identity.program_kinds");
    identity.rowCapacity = reader.u16("identity.row_capacity");
    identity.bankRegisters = reader.u16("identity.bank_registers");
    identity.blockRegisters = reader.u16("identity.block_registers");
    identity.timerClockHz = reader.u32("identity.timer_clock");
    identity.timerBits = reader.u16("identity.timer_bits");
    identity.maxPulseFrequencyHz = reader.u32("identity.max_pulse_frequency");
    return identity;
}

std::optional<ImpossibleValue> impossibleValue(const Identity& identity)
{
    struct Row {
        ImpossibleValue read;
        std::uint32_t minimum;
        std::uint32_t maximum;
    };
    constexpr std::uint32_t largest = std::numeric_limits<std::uint32_t>::max();
    const std::array rows{
        Row{{"identity.row_capacity", identity.rowCapacity}, 1, largest},
        Row{{"identity.bank_registers", identity.bankRegisters}, bankHeaderRegisters, largest},
        Row{{"identity.block_registers", identity.blockRegisters}, 1, largest},
        Row{{"identity.timer_clock", identity.timerClockHz}, 1, largest},
        Row{{"identity.timer_bits", identity.timerBits}, 8, 32},
        Row{{"identity.max_pulse_frequency", identity.maxPulseFrequencyHz}, 1, largest},
    };
    const auto wrong = std::ranges::find_if(
        rows, [](const Row& row) { return row.read.value < row.minimum || row.read.value > row.maximum; });
    return wrong == rows.end() ? std::nullopt : std::optional(wrong->read);
}

StatusBlock decodeStatus(std::span<const std::uint16_t> registers)
{
    const RegisterReader reader(registers, statusAddress);
    StatusBlock status;
    status.tag = reader.u16("status.tag");
    status.heartbeat = reader.u16("status.heartbeat");
    status.state = known(reader.u16("status.state"), State::Fault);
    status.faultBits = reader.u16("status.fault");
    status.warningBits = reader.u16("status.warning");
    status.programKind =
        known(reader.u16("status.program_kind"), lastProgramKind).value_or(ProgramKind::None);
    status.stagedState = known(reader.u16("status.staged_state"), StagedState::Armed);
    status.generation = reader.u32("status.generation");
    status.activeCrc = unlessZero(reader.u32("status.active_crc"));
    status.savedCrc = unlessZero(reader.u32("status.saved_crc"));
    status.cycleCount = reader.u32("status.cycle_count");
    if (status.activeCrc)
        status.masterAngleDeg = reader.physical("status.master_angle");
    status.masterSpeedPercent = reader.physical("status.master_speed");
    status.commandedFrequencyHz = reader.i32("status.commanded_frequency");
    status.actualFrequencyHz = reader.i32("status.actual_frequency");
    status.commandedPositionPulses = reader.i32("status.commanded_position");
    status.axisPositionPulses = reader.i32("status.axis_position");
    status.followingErrorPulses = static_cast<std::int16_t>(reader.u16("status.following_error"));
    decodeKind(reader, status);
    status.uptimeS = reader.u32("status.uptime");
    status.commandCounter = reader.u16("status.command_counter");
    status.linkCrcErrors = reader.u16("status.link_crc_errors");
    status.linkFrameErrors = reader.u16("status.link_frame_errors");
    status.linkExceptions = reader.u16("status.link_exceptions");
    status.linkRequests = reader.u16("status.link_requests");
    status.sampleTimeMs = reader.u16("status.sample_time");
    return status;
}

CommandResult decodeCommandResult(std::span<const std::uint16_t> registers)
{
    const RegisterReader reader(registers, registerNamed("result.counter").address);
    CommandResult result;
    result.counter = reader.u16("result.counter");
    result.code = static_cast<Command>(reader.u16("result.code"));
    result.status = static_cast<CommandStatus>(reader.u16("result.status"));
    result.reason = static_cast<Refusal>(reader.u16("result.reason"));
    return result;
}

TransferAnswer decodeTransferAnswer(std::span<const std::uint16_t> registers)
{
    const RegisterReader reader(registers, registerNamed("transfer_result.session").address);
    TransferAnswer answer;
    answer.session = reader.u16("transfer_result.session");
    answer.operation = static_cast<TransferOperation>(reader.u16("transfer_result.operation"));
    answer.block = reader.u16("transfer_result.block");
    answer.result = static_cast<TransferResult>(reader.u16("transfer_result.result"));
    answer.detail = reader.u16("transfer_result.detail");
    answer.nextMissing = reader.u16("transfer_result.next_missing");
    answer.stagedCrc = reader.u32("transfer_result.staged_crc");
    return answer;
}

} // namespace campanel::modbus
