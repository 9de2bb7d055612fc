// SPDX-License-Identifier: Apache-2.0
// Printing of the register table.
#include "modbus/register_document.h"

#include <cctype>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

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

// "status.active_crc" -> STATUS_ACTIVE_CRC, "StopAtCycleEnd" -> STOP_AT_CYCLE_END
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
    define("INTERVAL_REGISTERS", std::to_string(intervalRegisters) + "u");
    define("INTERVAL_CAPACITY", std::to_string(intervalCapacity) + "u");
    define("STAGE_REGISTERS", std::to_string(stageRegisters) + "u");
    define("STAGE_COUNT", std::to_string(stageCount) + "u");
    define("BANK_REGISTERS", std::to_string(bankRegisters) + "u");
    define("BLOCK_REGISTERS", std::to_string(blockRegisters) + "u");
    define("READBACK_REGISTERS", std::to_string(readbackRegisters) + "u");
    define("BAG_RECORDS", std::to_string(bagRecords) + "u");
    define("VIEW_CUTS", std::to_string(viewCuts) + "u");
    define("VIEW_MARKS", std::to_string(viewMarks) + "u");
    define("VIEW_PRODUCTS", std::to_string(viewProducts) + "u");
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
    out << "\n/* Offsets in a bank. */\n";
    for (const RegisterInfo& row : bankFields())
        define("OFFSET_" + upperSnake(row.name), std::to_string(row.address) + "u");
    for (const EnumInfo& info : enumerations()) {
        out << "\n";
        for (const EnumValue& value : info.values)
            define(upperSnake(info.name) + "_" + upperSnake(value.name), std::to_string(value.value) + "u");
    }
    out << "\n#endif\n";
}

// "; only Press": the values whose bits are set.
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

void printMarkdown(std::ostream& out)
{
    out << "# Register map " << mapMajor << '.' << mapMinor
        << "\n\n"
           "Generated from the register table (`modbus/register_map.cpp`, `modbus/protocol.cpp`); do not "
           "edit.\n\n"
           "Modbus RTU. Every register is a holding register: read with function 3, written with 6 or 16, "
           "both in one frame with 23.\n"
           "Addresses are those of the frame, counted from 0. Values of two registers have the high word "
           "first; text is UTF-8, two\n"
           "bytes a register, the first in the upper half, padded with zeros. Physical value = raw value x "
           "scale.\n\n"
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
            out << "| " << value.value << " | " << value.name << " | " << value.text << " |\n";
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
