// SPDX-License-Identifier: Apache-2.0
// Prints the register table.
#include "modbus/map/register_document.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <vector>

namespace campanel::modbus {

std::string hexAddress(unsigned address)
{
    std::ostringstream out;
    out << "0x" << std::hex << std::uppercase << std::setw(4) << std::setfill('0') << address;
    return out.str();
}

std::string_view typeName(RegisterType type)
{
    switch (type) {
    case RegisterType::U16:
        return "u16";
    case RegisterType::I16:
        return "i16";
    case RegisterType::U32:
        return "u32";
    case RegisterType::I32:
        return "i32";
    case RegisterType::Text:
        return "text";
    case RegisterType::Block:
        return "block";
    }
    return "";
}

namespace {

// Converts "status.active_crc" to STATUS_ACTIVE_CRC, "StopAtCycleEnd" to STOP_AT_CYCLE_END.
std::string upperSnake(std::string_view name)
{
    std::string result;
    bool afterLower = false;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isupper(byte) != 0 && afterLower)
            result += '_';
        result += c == '.' ? '_' : static_cast<char>(std::toupper(byte));
        afterLower = std::islower(byte) != 0 || std::isdigit(byte) != 0;
    }
    return result;
}

// Converts "DriveAlarm" to drive-alarm, as on a command line.
std::string lowerKebab(std::string_view name)
{
    std::string result = upperSnake(name);
    std::ranges::transform(result, result.begin(), [](unsigned char c) {
        return c == '_' ? '-' : static_cast<char>(std::tolower(c));
    });
    return result;
}

// A register group: the part of its registers' names before the dot.
struct Group {
    std::string_view name;
    unsigned base = 0;
    unsigned count = 0;
};

std::vector<Group> groups()
{
    std::vector<Group> result;
    for (const RegisterInfo& row : registers()) {
        const std::string_view name = row.name.substr(0, row.name.find('.'));
        if (result.empty() || result.back().name != name)
            result.push_back({name, row.address, 0});
        result.back().count = static_cast<unsigned>(row.address) + row.count - result.back().base;
    }
    return result;
}

// Returns true when the limits are narrower than the register.
bool isNarrower(const RegisterInfo& row)
{
    if (row.type == RegisterType::I16)
        return true;
    const double most = row.count == 2 ? 4294967295.0 : 65535.0;
    return row.minimum > 0 || std::llround(row.maximum / row.scale) < std::llround(most);
}

// Prints X macros, so that the core has no list of its own: groups with base and count; limits in raw units
// of every parameter and of other registers that are narrower than their type.
void printLists(std::ostream& out)
{
    out << "\n/* GROUP(name, base, registers); CTL_GROUP_name is the number of registers. */\n#define "
           "CTL_GROUPS(GROUP)";
    for (const Group& group : groups())
        out << " \\\n    GROUP(" << upperSnake(group.name) << ", " << hexAddress(group.base) << "u, "
            << group.count << "u)";
    out << "\n\n/* NEWER(address, registers, minor): registers that came with this minor version. */\n"
           "#define CTL_NEWER(NEWER)";
    for (const RegisterInfo& row : registers()) {
        if (row.minor != 0)
            out << " \\\n    NEWER(" << hexAddress(row.address) << "u, " << row.count << "u, " << row.minor
                << "u)";
    }
    out << "\n";
    for (const Group& group : groups())
        out << "#define CTL_GROUP_" << upperSnake(group.name) << ' ' << group.count << "u\n";
    out << "\n/* LIMIT(register, words, 0 for one signed; min, max and default are CTL_MIN_..., ...) */\n"
           "#define CTL_LIMITS(LIMIT)";
    for (const RegisterInfo& row : registers()) {
        if (row.access != Access::ReadWrite || row.type == RegisterType::Block ||
            (!isMachineData(row) && !isNarrower(row)))
            continue;
        const unsigned words = row.type == RegisterType::I16 ? 0 : row.count;
        out << " \\\n    LIMIT(" << upperSnake(row.name) << ", " << words << "u)";
    }
    out << "\n/* CONTACT(name, bit, register): the inputs that are contacts; the kind of contact, then its "
           "filter. */\n"
           "#define CTL_CONTACTS(CONTACT)";
    for (const InputRow& row : inputRows) {
        if (row.source == InputSource::Contact)
            out << " \\\n    CONTACT(\"" << lowerKebab(row.value.name) << "\", " << row.value.value
                << "u, CTL_REG_" << upperSnake(contactName(row)) << "_CONTACT"
                << ")";
    }
    out << "\n";
}

void printCHeader(std::ostream& out)
{
    out << "/* SPDX-License-Identifier: Apache-2.0 */\n"
           "/* Generated from the register table in modbus/; do not edit. */\n"
           "#ifndef CTL_REGISTERS_H\n#define CTL_REGISTERS_H\n\n";
    const auto define = [&out](const std::string& name, const std::string& value) {
        out << "#define CTL_" << name << ' ' << value << "\n";
    };
    define("DEVICE_TYPE", hexAddress(deviceType) + "u");
    define("MAP_MAJOR", std::to_string(mapMajor) + "u");
    define("MAP_MINOR", std::to_string(mapMinor) + "u");
    define("ACTIVE_BANK_BASE", hexAddress(activeBankBase) + "u");
    define("STAGED_BANK_BASE", hexAddress(stagedBankBase) + "u");
    define("BANK_HEADER_REGISTERS", std::to_string(bankHeaderRegisters) + "u");
    define("ROW_REGISTERS", std::to_string(rowRegisters) + "u");
    define("ROW_CAPACITY", std::to_string(rowCapacity) + "u");
    define("CAM_POINT_REGISTERS", std::to_string(camPointRegisters) + "u");
    define("CAM_POINT_CAPACITY", std::to_string(camPointCapacity) + "u");
    define("KNOT_REGISTERS", std::to_string(knotRegisters) + "u");
    define("KNOT_CAPACITY", std::to_string(knotCapacity) + "u");
    define("SEGMENT_REGISTERS", std::to_string(segmentRegisters) + "u");
    define("SEGMENT_CAPACITY", std::to_string(segmentCapacity) + "u");
    define("INTERVAL_REGISTERS", std::to_string(intervalRegisters) + "u");
    define("INTERVAL_CAPACITY", std::to_string(intervalCapacity) + "u");
    define("STAGE_REGISTERS", std::to_string(stageRegisters) + "u");
    define("STAGE_COUNT", std::to_string(stageCount) + "u");
    define("BANK_REGISTERS", std::to_string(bankRegisters) + "u");
    define("BLOCK_REGISTERS", std::to_string(blockRegisters) + "u");
    define("READBACK_REGISTERS", std::to_string(readbackRegisters) + "u");
    define("BAG_RECORDS", std::to_string(bagRecords) + "u");
    define("EDGE_RECORDS", std::to_string(edgeRecords) + "u");
    define("JAM_BINS", std::to_string(jamBins) + "u");
    define("EYE_RECORDS", std::to_string(eyeRecords) + "u");
    define("VIEW_CUTS", std::to_string(viewCuts) + "u");
    define("VIEW_MARKS", std::to_string(viewMarks) + "u");
    define("VIEW_PRODUCTS", std::to_string(viewProducts) + "u");
    define("SWITCH_COUNT", std::to_string(switchCount) + "u");
    out << "\n/* Addresses, and of writable registers the limits in raw units. */\n";
    for (const RegisterInfo& row : registers()) {
        define("REG_" + upperSnake(row.name), hexAddress(row.address) + "u");
        if (row.access == Access::ReadWrite && row.type != RegisterType::Block) {
            const bool isSigned = row.type == RegisterType::I16 || row.type == RegisterType::I32;
            const auto raw = [&row, isSigned](double physical) {
                const std::string digits = std::to_string(std::llround(physical / row.scale));
                return isSigned ? '(' + digits + ')' : digits + 'u';
            };
            define("MIN_" + upperSnake(row.name), raw(row.minimum));
            define("MAX_" + upperSnake(row.name), raw(row.maximum));
            define("DEFAULT_" + upperSnake(row.name), raw(row.defaultValue));
        }
    }
    printLists(out);
    out << "\n/* Offsets in a bank. */\n";
    for (const RegisterInfo& row : bankFields())
        define("OFFSET_" + upperSnake(row.name), std::to_string(row.address) + "u");
    for (const EnumInfo& info : enumerations()) {
        out << "\n";
        for (const EnumValue& value : info.values)
            define(upperSnake(info.name) + "_" + upperSnake(value.name), std::to_string(value.value) + "u");
        define(upperSnake(info.name) + "_LAST", std::to_string(info.values.back().value) + "u");
    }
    out << "\n#endif\n";
}

// Prints "; only Press": the values whose bits are set.
void printCondition(std::ostream& out, std::string_view enumName, unsigned bits)
{
    std::string_view separator = "; only ";
    for (const EnumInfo& info : enumerations()) {
        if (info.name != enumName)
            continue;
        for (const EnumValue& value : info.values) {
            if ((bits & (1u << value.value)) == 0)
                continue;
            out << separator << value.name;
            separator = ", ";
        }
    }
}

void printRow(std::ostream& out, const RegisterInfo& row, const std::string& address)
{
    out << "| " << address << " | `" << row.name << "` | " << typeName(row.type);
    if (row.type == RegisterType::Text || row.type == RegisterType::Block)
        out << '[' << row.count << ']';
    out << " | " << (row.access == Access::ReadWrite ? "rw" : "r") << " | ";
    if (row.scale < 1.0 || row.scale > 1.0)
        out << row.scale << ' ';
    out << row.unit << " | ";
    if (row.access == Access::ReadWrite && row.maximum > row.minimum && row.maximum < 4e9)
        out << row.minimum << " .. " << row.maximum << " (" << row.defaultValue << ")";
    out << " | " << row.text;
    if (!row.enumName.empty())
        out << " (" << row.enumName << ")";
    printCondition(out, "ProgramKind", row.kinds);
    printCondition(out, "TableLayout", row.layouts);
    out << " |\n";
}

// Prints the rules that are not in the columns of the tables. The controller's core implements them,
// tests/controller proves them.
void printRules(std::ostream& out)
{
    out << "## Rules for a master\n\n"
           "**Frames.** A request reads at most 125 registers (function 3), writes at most 123 (16), or "
           "writes at most 121 and\n"
           "reads at most 125 (23). A write lies within one group: the registers whose names begin with the "
           "same word. Exceptions: 1 for\n"
           "another function; 2 for an address that is not in this table, is read-only, or leaves the group; "
           "3 for a count or a value outside\n"
           "its range. A refused write changes nothing. A broadcast (unit 0) is executed and never "
           "answered.\n\n"
           "**Triggers.** Writing `exchange.heartbeat` counts as a heartbeat if the value differs from the "
           "last one. Writing\n"
           "`command.counter` executes the command, `transfer.operation` a step of the transfer, "
           "`readback.tag` a read. A master writes\n"
           "a group in one frame. A parameter takes effect at once.\n\n"
           "**Commands.** A counter equal to `result.counter` is not executed again: after a lost response, "
           "read `result` first. The\n"
           "code and the arguments are in the same frame as the counter; a counter without its code is "
           "refused with\n"
           "CommandIncomplete. Start homes first if the axis has not been homed since power-up and the "
           "program needs it; a stop ends homing\n"
           "as well.\n\n"
           "**Outputs.** TryOutput switches one output on at standstill; homing's rules apply to it, without "
           "a "
           "program.\n\n"
           "**Order.** One at a time. A bag is on the way until the next cut, or until its jaws have opened; "
           "then "
           "it is rejected if it is\n"
           "taken by a person, not proven by its mark, double, off register, of a start or of a change of "
           "program, burned or "
           "jammed, else "
           "empty, else good. With\n"
           "Stop the run ends so that the bags that are left are just enough; what a bag on the way was not "
           "good "
           "for, another start makes up.\n\n"
           "**Permit.** While `parameter.permit_needed` is 1, Start, JogBag and SingleCut need every bit of "
           "`exchange.permit`, "
           "homing and jogging need Clean.\n"
           "The bits hold with the heartbeat of their frame, until `parameter.heartbeat_timeout` or another "
           "frame of the group; Start and\n"
           "Home are then refused with HeartbeatLost, else with the first bit that is missing. A permit lost "
           "while running does not end the run.\n\n"
           "**Jog.** One key at a time; both together count as none. The axis moves while the bit is set and "
           "the heartbeat advances. After\n"
           "200 ms without a heartbeat it ramps down, and moves again only after all keys were released.\n\n"
           "**Transfer.** Begin has kind, length in registers and map major version in `transfer.data`; "
           "Block has one block of "
        << blockRegisters
        << " registers,\nthe last block may be shorter; Seal checks the whole bank. Blocks may come in any "
           "order and may be repeated;\n"
           "`transfer_result.next_missing` is the block to continue with after an interruption. Begin with "
           "the same session, kind and length\n"
           "continues a transfer, any other Begin starts a new one. ApplyStaged needs the session and the "
           "CRC-32 of the sealed bytes.\n\n"
           "**Header.** `bank.kind` is the kind that Begin announced. A cycle takes at least 2 ms. The "
           "divisor is not 0, "
           "the remainder below it.\nPulses per motor revolution: 1 to 10 000 000. Knife radius or feed: "
           "above 0.\n\n"
           "| layout | kinds | rows | a row | rules |\n|---|---|---|---|---|\n"
           "| StepTable | RotaryCutter | 1 to "
        << rowCapacity
        << " | pulses u16, ticks u32 | pulses leave at even distances of at most 2^timer_bits - 1 ticks and "
           "at most at "
           "max_pulse_frequency; 0 pulses: a pause; ticks and pulses add up to cycle_ticks and cycle_pulses; "
           "cycle_pulses + remainder / divisor = K Z / N exactly |\n"
           "| CamPoints | PositionMove, SpeedMove, PointCam, SegmentCam | 2 to "
        << camPointCapacity
        << " | position i32 in 1/256 pulse from the first row, slope i32 in 1/256 pulse per interval | the "
           "first position "
           "is 0; the last one is advance + remainder / divisor, to 1/256 pulse; neither a step nor a slope "
           "is faster "
           "than max_pulse_frequency; up to "
        << knotCapacity << " knots of a point cam, or up to " << segmentCapacity
        << " segments of a segment cam follow; their registers are under TableLayout. Segments end in "
           "ascending "
           "order, the last one at 360 deg |\n"
           "| Intervals | PositionMove, SpeedMove | 1 to "
        << intervalCapacity
        << " | distance, first speed, last speed, acceleration, u32 each | speeds in 2^-fraction_bits of an "
           "accumulator's "
           "unit; the distance is long enough for its change of speed: 2 acceleration distance >= difference "
           "of the "
           "squares of the speeds; distances add up to advance |\n"
           "| PressStages | Press | "
        << stageCount
        << " | frequency u32 in Hz, end i32 in pulses, force u32 in N, time u32 in ms | approach, probe, "
           "press, hold, "
           "return; ends ascend; ramps take at most 1000 ms; the ends are the positions of the header, to "
           "one "
           "pulse |\n\n"
           "Rows keep the inputs of their kind, to one pulse and one tick: a position move's advance is its "
           "distance; a "
           "speed move goes as far\nas a cycle at one of its speeds at least, as a cycle at the other at "
           "most, and over its "
           "given distance; cam points of a move take\nits given time; a point cam advances by (last knot - "
           "first knot), a segment cam by the end of its last segment, times "
           "slave_scale in 60 s master_ratio master_scale / |master_rate|.\nSeal answers BadHeader or BadSum "
           "with the offset of "
           "the header register in\n`transfer_result.detail`, BadRow with the number of the row, from 0.\n\n";
}

void printMarkdown(std::ostream& out)
{
    out << "# Register map " << mapMajor << '.' << mapMinor
        << "\n\n"
           "Generated from the register table (`modbus/map/register_map.cpp`, `modbus/map/protocol.cpp`); do "
           "not "
           "edit.\n\n"
           "Modbus RTU. Every register is a holding register: read with function 3, written with 6 or 16, "
           "both in one frame with 23.\n"
           "Addresses are those of the frame, counted from 0. Values of two registers have the high word "
           "first; text is UTF-8, two\n"
           "bytes a register, the first in the upper half, padded with zeros. Physical value = raw value x "
           "scale.\n\n";
    printRules(out);
    out << "## Registers\n\n"
           "| address | name | type | access | scale, unit | range (default) | meaning "
           "|\n|---|---|---|---|---|---|---|\n";
    out << std::setprecision(10);
    for (const RegisterInfo& row : registers())
        printRow(out, row, hexAddress(row.address));
    out << "\n## Layout of a program bank\n\nOffsets from the base of `active` ("
        << hexAddress(activeBankBase) << ") and `staged` (" << hexAddress(stagedBankBase)
        << "). The CRC-32 (polynomial 0xEDB88320,\nreflected, as in Ethernet and zlib) is computed over "
           "header and rows, every register "
           "high byte first.\n\n"
           "| offset | name | type | access | scale, unit | range (default) | meaning "
           "|\n|---|---|---|---|---|---|---|\n";
    for (const RegisterInfo& row : bankFields())
        printRow(out, row, std::to_string(row.address));
    out << "\n## Values\n";
    for (const EnumInfo& info : enumerations()) {
        const bool bits = info.name.ends_with("Bit");
        out << "\n### " << info.name << "\n\n| " << (bits ? "bit" : "value")
            << " | name | meaning |\n|---|---|---|\n";
        for (const EnumValue& value : info.values)
            out << "| " << value.value << " | " << value.name << " | " << meaning(value) << " |\n";
    }
}

} // namespace

std::string registersMarkdown()
{
    std::ostringstream out;
    printMarkdown(out);
    return out.str();
}

std::string registersCHeader()
{
    std::ostringstream out;
    printCHeader(out);
    return out.str();
}

} // namespace campanel::modbus
