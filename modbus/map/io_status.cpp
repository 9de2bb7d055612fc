// SPDX-License-Identifier: Apache-2.0
#include "modbus/map/io_status.h"

#include "modbus/map/codec.h"
#include "modbus/map/register_map.h"

#include <cassert>

namespace campanel::modbus {
namespace {

template <typename Bit> bool hasPin(std::uint32_t levels, Bit bit)
{
    return (levels >> static_cast<unsigned>(bit) & 1u) != 0;
}

template <typename Bit, typename Levels>
std::optional<bool> levelOf(const std::optional<Levels>& levels, Bit bit)
{
    return levels ? std::optional(hasPin(*levels, bit)) : std::nullopt;
}

} // namespace

std::optional<bool> IoStatus::level(InputBit bit) const
{
    return levelOf(inputs, bit);
}

std::optional<bool> IoStatus::level(OutputBit bit) const
{
    return bit < OutputBit::Ready || hasAllOutputs ? levelOf(outputs, bit) : std::nullopt;
}

std::uint16_t ioRegisters(std::uint16_t minor)
{
    const RegisterInfo& more = registerNamed("io.more_outputs");
    const unsigned end = more.address + (more.minor <= minor ? 1u : 0u);
    return static_cast<std::uint16_t>(end - ioAddress);
}

IoStatus decodeIo(std::span<const std::uint16_t> registers)
{
    assert(registers.size() <= ioRegisters());
    const RegisterReader reader(registers, ioAddress);
    const auto available = reader.u16("io.available");
    IoStatus status;
    if (hasPin(available, IoBit::Inputs))
        status.inputs = reader.u16("io.inputs");
    if (hasPin(available, IoBit::Outputs))
        status.outputs = reader.u16("io.outputs");
    status.hasAllOutputs = status.outputs && registers.size() == ioRegisters();
    if (status.hasAllOutputs)
        *status.outputs |= std::uint32_t{reader.u16("io.more_outputs")} << 16u;
    if (hasPin(available, IoBit::Torque)) {
        status.torquePercent = reader.physical("io.torque");
        status.torqueAngleDeg = reader.physical("io.torque_angle");
    }
    if (hasPin(available, IoBit::Infeed)) {
        status.infeedPositionMm = reader.physical("io.infeed_position");
        status.infeedFollowingErrorMm = reader.physical("io.infeed_following_error");
    }
    status.isAxisKept = hasPin(available, IoBit::AxisKept);
    status.isFilmKept = hasPin(available, IoBit::FilmKept);
    status.canReverse = hasPin(available, IoBit::Reversal);
    status.isInfeedKept = hasPin(available, IoBit::InfeedKept);
    return status;
}

} // namespace campanel::modbus
