// SPDX-License-Identifier: Apache-2.0
#include "modbus/map/bank_header.h"

#include "modbus/map/codec.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace campanel::modbus {
namespace {

// The list behind the rows of a kind.
struct ListSize {
    ProgramKind kind = ProgramKind::None;
    std::string_view countRegister;
    std::uint16_t registers = 0; // of one entry
    std::uint16_t capacity = 0;
};

constexpr std::array lists{
    ListSize{ProgramKind::PointCam, "cam.knot_count", knotRegisters, knotCapacity},
    ListSize{ProgramKind::SegmentCam, "cam.segment_count", segmentRegisters, segmentCapacity}};

} // namespace

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

ListSpan listSpan(std::span<const std::uint16_t> header)
{
    const RegisterReader reader(header, 0);
    const auto kind = static_cast<ProgramKind>(reader.u16("bank.kind"));
    const auto list = std::ranges::find(lists, kind, &ListSize::kind);
    if (list == lists.end())
        return {};
    const unsigned rows = reader.u16("bank.row_count");
    const unsigned count = reader.u16(list->countRegister);
    if (rows > camPointCapacity || count > list->capacity)
        return {};
    return {static_cast<std::uint16_t>(bankHeaderRegisters + camPointRegisters * rows),
            static_cast<std::uint16_t>(list->registers * count)};
}

std::optional<std::uint16_t> bankLength(std::span<const std::uint16_t> header)
{
    const RegisterReader reader(header, 0);
    const unsigned rowLength = rowSize(static_cast<TableLayout>(reader.u16("bank.layout"))).registers;
    const unsigned length =
        bankHeaderRegisters + rowLength * reader.u16("bank.row_count") + listSpan(header).count;
    if (rowLength == 0 || length > bankRegisters)
        return std::nullopt;
    return static_cast<std::uint16_t>(length);
}

} // namespace campanel::modbus
