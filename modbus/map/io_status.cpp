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

template <typename Bit> std::optional<bool> levelOf(const std::optional<std::uint16_t>& levels, Bit bit)
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
    return levelOf(outputs, bit);
}

IoStatus decodeIo(std::span<const std::uint16_t> registers)
{
    assert(registers.size() == ioRegisters);
    const RegisterReader reader(registers, ioAddress);
    const auto available = reader.u16("io.available");
    IoStatus status;
    if (hasPin(available, IoBit::Inputs))
        status.inputs = reader.u16("io.inputs");
    if (hasPin(available, IoBit::Outputs))
        status.outputs = reader.u16("io.outputs");
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
    status.isInfeedKept = hasPin(available, IoBit::InfeedKept);
    return status;
}

} // namespace campanel::modbus
