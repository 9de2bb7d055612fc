// SPDX-License-Identifier: Apache-2.0
#include "modbus/map/bank_header.h"

#include "modbus/map/codec.h"

namespace campanel::modbus {

RowSize rowSize(TableLayout layout)
{
    switch (layout) {
    case TableLayout::StepTable:
        return {rowRegisters, rowCapacity};
    case TableLayout::CamPoints:
        return {camPointRegisters, camPointCapacity};
    case TableLayout::Intervals:
        return {intervalRegisters, intervalCapacity};
    case TableLayout::PressStages:
        return {stageRegisters, stageCount};
    case TableLayout::None:
        break;
    }
    return {};
}

KnotSpan knotSpan(std::span<const std::uint16_t> header)
{
    const RegisterReader reader(header, 0);
    if (reader.u16("bank.kind") != static_cast<std::uint16_t>(ProgramKind::PointCam))
        return {};
    const unsigned rows = reader.u16("bank.row_count");
    const unsigned knots = reader.u16("cam.knot_count");
    if (rows > camPointCapacity || knots > knotCapacity)
        return {};
    return {static_cast<std::uint16_t>(bankHeaderRegisters + camPointRegisters * rows),
            static_cast<std::uint16_t>(knotRegisters * knots)};
}

std::optional<std::uint16_t> bankLength(std::span<const std::uint16_t> header)
{
    const RegisterReader reader(header, 0);
    const unsigned rowLength = rowSize(static_cast<TableLayout>(reader.u16("bank.layout"))).registers;
    const unsigned length =
        bankHeaderRegisters + rowLength * reader.u16("bank.row_count") + knotSpan(header).count;
    if (rowLength == 0 || length > bankRegisters)
        return std::nullopt;
    return static_cast<std::uint16_t>(length);
}

} // namespace campanel::modbus
