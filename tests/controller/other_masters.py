#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Reads identity and status, writes parameters and downloads a whole table with masters that this project did not write,
pymodbus and mbpoll, knowing nothing but REGISTERS.md. Usage: other_masters.py CONTROLLER REGISTERS.md"""
import inspect
import re
import struct
import subprocess
import sys
import tempfile
import zlib

from pymodbus.client import ModbusSerialClient

ROW = re.compile(r"^\| (0x[0-9A-F]{4}) \| `([a-z_.0-9]+)` \| ([a-z0-9]+)(?:\[(\d+)\])? \|")
FIELD = re.compile(r"^\| (\d+) \| `([a-z_.0-9]+)` \| ([a-z0-9]+)(?:\[(\d+)\])? \|")
VALUES = re.compile(r"^### (\w+)$")
VALUE = re.compile(r"^\| (\d+) \| (\w+) \|")
WIDTH = {"u16": 1, "i16": 1, "u32": 2, "i32": 2}


class Document:
    """REGISTERS.md as tables: register and bank field by name -> (address or offset, type), blocks by name -> address,
    words by enumeration and name -> value."""

    def __init__(self, path):
        self.registers, self.fields, self.blocks, self.words = {}, {}, {}, {}
        enumeration = None
        with open(path, encoding="utf-8") as document:
            for line in document:
                if row := ROW.match(line):
                    if row[3] in WIDTH:
                        self.registers[row[2]] = (int(row[1], 16), row[3])
                    else:
                        self.blocks[row[2]] = int(row[1], 16)
                elif row := FIELD.match(line):
                    self.fields[row[2]] = (int(row[1]), row[3])
                elif heading := VALUES.match(line):
                    enumeration = heading[1]
                elif (row := VALUE.match(line)) and enumeration:
                    self.words[enumeration, row[2]] = int(row[1])


def encode(value, kind):
    value &= (1 << 16 * WIDTH[kind]) - 1
    return [value] if WIDTH[kind] == 1 else [value >> 16, value & 0xFFFF]


def decode(words, kind):
    value = words[0] if WIDTH[kind] == 1 else words[0] << 16 | words[1]
    bits = 16 * WIDTH[kind]
    return value - (1 << bits) if kind[0] == "i" and value >> (bits - 1) else value


def group(registers, name):
    """The group's registers, its first address and its size."""
    members = {key: value for key, value in registers.items() if key.startswith(name + ".")}
    first = min(address for address, _ in members.values())
    end = max(address + WIDTH[kind] for address, kind in members.values())
    return members, first, end - first


class Pymodbus:
    """One connection; the name of the unit's argument differs between versions."""

    def __init__(self, port):
        self.client = ModbusSerialClient(port=port, baudrate=115200, timeout=2)
        assert self.client.connect(), "pymodbus cannot open " + port
        known = inspect.signature(self.client.read_holding_registers).parameters
        self.unit = {next(word for word in ("device_id", "slave", "unit") if word in known): 1}

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.client.close()

    def read(self, first, count):
        answer = self.client.read_holding_registers(first, count=count, **self.unit)
        assert not answer.isError(), answer
        return answer.registers

    def read_group(self, registers, name):
        members, first, count = group(registers, name)
        words = self.read(first, count)
        return {key: decode(words[address - first:], kind) for key, (address, kind) in members.items()}

    def write(self, first, words):
        """The exception's code, 0 when it was written."""
        answer = self.client.write_registers(first, words, **self.unit)
        return answer.exception_code if answer.isError() else 0

    def write_one(self, address, word):
        answer = self.client.write_register(address, word, **self.unit)
        assert not answer.isError(), answer


def read_with_pymodbus(port, registers, name):
    with Pymodbus(port) as master:
        return master.read_group(registers, name)


def read_with_mbpoll(port, registers, name):
    members, first, count = group(registers, name)
    command = ["mbpoll", "-m", "rtu", "-a", "1", "-b", "115200", "-P", "none", "-0", "-1", "-q", "-t", "4:hex",
               "-r", str(first), "-c", str(count), port]
    output = subprocess.run(command, check=True, capture_output=True, text=True, timeout=20).stdout
    words = {int(address): int(value, 16) for address, value in re.findall(r"\[(\d+)\]:\s+0x([0-9A-F]+)", output)}
    return {key: decode([words[address], words.get(address + 1, 0)], kind)
            for key, (address, kind) in members.items()}


def check(who, identity, status):
    print(who, identity, status, sep="\n  ")
    assert identity["identity.device_type"] == 0xCA3D
    assert identity["identity.map_major"] == 1
    assert identity["identity.timer_clock"] == 8_000_000
    assert identity["identity.timer_bits"] == 16
    assert identity["identity.max_pulse_frequency"] == 200_000
    assert status["status.state"] == 0, "Idle"
    assert status["status.fault"] == 0
    assert status["status.warning"] & 2, "NotHomed"
    assert status["status.generation"] == 0
    assert status["status.following_error"] == 0
    assert status["status.link_crc_errors"] == 0
    assert status["status.link_frame_errors"] == 0


def write_with_mbpoll(port, address, words):
    """True when it was written."""
    command = ["mbpoll", "-m", "rtu", "-a", "1", "-b", "115200", "-P", "none", "-0", "-q", "-t", "4",
               "-r", str(address), port, "--", *map(str, words)]
    return subprocess.run(command, capture_output=True, text=True, timeout=20).returncode == 0


def write_parameters(port, registers):
    """Each master writes, the other one reads."""
    ramp, ramp_kind = registers["parameter.ramp_time"]
    jog, jog_kind = registers["parameter.jog_frequency"]
    limit, limit_kind = registers["parameter.following_error_limit"]
    with Pymodbus(port) as master:
        master.write_one(ramp, 1250)
        assert master.write(limit, encode(70_000, limit_kind)) == 0
        assert master.write(jog, encode(20_001, jog_kind)) == 3, "beyond its range: illegal data value"
        assert master.write(registers["status.state"][0], [1]) == 2, "read only: illegal data address"
    parameters = read_with_mbpoll(port, registers, "parameter")
    assert parameters["parameter.ramp_time"] == 1250, parameters
    assert parameters["parameter.following_error_limit"] == 70_000, parameters
    assert write_with_mbpoll(port, ramp, encode(333, ramp_kind))
    assert write_with_mbpoll(port, jog, encode(19_999, jog_kind))
    assert not write_with_mbpoll(port, ramp, encode(49, ramp_kind)), "below its range"
    parameters = read_with_pymodbus(port, registers, "parameter")
    assert parameters["parameter.ramp_time"] == 333, parameters
    assert parameters["parameter.jog_frequency"] == 19_999, parameters
    print("parameters", parameters)


def step_table(document, rows):
    """A rotary cutter's bank: one knife, 10 000 pulses a cycle of one second, slow at the ends, fast in the middle."""
    weights = [1 + min(row, rows - 1 - row) for row in range(rows)]
    sums = [sum(weights[:row]) for row in range(rows + 1)]
    pulses = [10_000 * sums[row + 1] // sums[-1] - 10_000 * sums[row] // sums[-1] for row in range(rows)]
    ticks = 8_000_000 // rows
    header = {
        "bank.layout": document.words["TableLayout", "StepTable"],
        "bank.kind": document.words["ProgramKind", "RotaryCutter"],
        "bank.row_count": rows, "bank.cycle_ticks": ticks * rows, "bank.cycle_pulses": sum(pulses),
        "bank.remainder": 0, "bank.divisor": 1, "bank.carry_row": rows // 2,
        "bank.cut_angle": 18_000, "bank.sync_start": 14_400, "bank.sync_end": 21_600,
        "program.knife_radius": 60_000, "program.knives": 1, "program.pulses_per_motor_rev": 10_000,
        "program.gear_numerator": 1, "program.gear_denominator": 1, "program.bag_length": 250_000,
    }
    first_row = document.fields["bank.rows"][0]
    bank = [0] * first_row
    for name, value in header.items():
        offset, kind = document.fields[name]
        bank[offset:offset + WIDTH[kind]] = encode(value, kind)
    for count in pulses:
        bank += encode(count, "u16") + encode(ticks, "u32")
    return bank


def give_command(master, document, code, argument0=0, argument1=0, argument2=0):
    registers, words = document.registers, document.words
    counter = (master.read(registers["result.counter"][0], 1)[0] + 1) & 0xFFFF
    assert master.write(registers["command.counter"][0],
                        [counter, words["Command", code], argument0, argument1, *encode(argument2, "u32")]) == 0
    result = master.read_group(registers, "result")
    while result["result.status"] == words["CommandStatus", "Busy"]:
        result = master.read_group(registers, "result")
    assert result["result.counter"] == counter and result["result.code"] == words["Command", code], result
    assert result["result.status"] == words["CommandStatus", "Done"], result


def transfer(master, document, session, operation, block, data):
    registers, words = document.registers, document.words
    busy = words["TransferResult", "Busy"]
    result = {"transfer_result.result": busy}
    while result["transfer_result.result"] == busy:
        assert master.write(registers["transfer.session"][0],
                            [session, words["TransferOperation", operation], block, len(data), *data]) == 0
        result = master.read_group(registers, "transfer_result")
    assert result["transfer_result.session"] == session and result["transfer_result.block"] == block, result
    assert result["transfer_result.result"] == words["TransferResult", "Accepted"], result
    return result


def read_bank(master, base, count):
    words = []
    while len(words) < count:
        words += master.read(base + len(words), min(100, count - len(words)))
    return words


def download_table(port, document):
    """Begin, blocks, seal, read back, apply, save: all with functions 3 and 16 alone."""
    bank = step_table(document, 400)
    crc = zlib.crc32(struct.pack(f">{len(bank)}H", *bank))
    session = 77
    kind = document.words["ProgramKind", "RotaryCutter"]
    with Pymodbus(port) as master:
        identity = master.read_group(document.registers, "identity")
        size = identity["identity.block_registers"]
        transfer(master, document, session, "Begin", 0, [kind, len(bank), identity["identity.map_major"]])
        for block in range(0, (len(bank) + size - 1) // size):
            transfer(master, document, session, "Block", block, bank[size * block:size * (block + 1)])
        sealed = transfer(master, document, session, "Seal", 0, [])
        assert sealed["transfer_result.staged_crc"] == crc, (sealed, crc)
        assert read_bank(master, document.blocks["staged"], len(bank)) == bank
        give_command(master, document, "ApplyStaged", document.words["ApplyMode", "WhenStopped"], session, crc)
        assert read_bank(master, document.blocks["active"], len(bank)) == bank
        give_command(master, document, "SaveToFlash", argument2=crc)
        status = master.read_group(document.registers, "status")
    print(f"table of {len(bank)} registers, CRC-32 {crc:08X}", status)
    assert status["status.state"] == document.words["State", "Ready"]
    assert status["status.active_crc"] == crc and status["status.saved_crc"] == crc
    assert status["status.generation"] == 1


def main():
    controller, path = sys.argv[1:]
    document = Document(path)
    registers = document.registers
    assert len(registers) > 60 and len(document.fields) > 60, "the register document has no table"
    with tempfile.TemporaryDirectory() as state:
        with subprocess.Popen([controller, "--state", state], stdout=subprocess.PIPE, text=True) as process:
            try:
                port = process.stdout.readline().strip()
                for read in (read_with_pymodbus, read_with_mbpoll):
                    check(read.__name__, read(port, registers, "identity"), read(port, registers, "status"))
                write_parameters(port, registers)
                download_table(port, document)
            finally:
                process.terminate()


if __name__ == "__main__":
    main()
