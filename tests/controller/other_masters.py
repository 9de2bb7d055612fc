#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Reads identity and status with two masters that this project did not write, pymodbus and mbpoll, knowing nothing but
REGISTERS.md. Usage: other_masters.py CONTROLLER REGISTERS.md"""
import inspect
import re
import subprocess
import sys
import tempfile

from pymodbus.client import ModbusSerialClient

ROW = re.compile(r"^\| (0x[0-9A-F]{4}) \| `([a-z_.0-9]+)` \| ([a-z0-9]+)(?:\[(\d+)\])? \|")
WIDTH = {"u16": 1, "i16": 1, "u32": 2, "i32": 2}


def read_document(path):
    """Name -> (address, type) of the single values in the document."""
    registers = {}
    with open(path, encoding="utf-8") as document:
        for line in document:
            row = ROW.match(line)
            if row and row[3] in WIDTH:
                registers[row[2]] = (int(row[1], 16), row[3])
    return registers


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


def read_with_pymodbus(port, registers, name):
    members, first, count = group(registers, name)
    client = ModbusSerialClient(port=port, baudrate=115200, timeout=2)
    assert client.connect(), "pymodbus cannot open " + port
    known = inspect.signature(client.read_holding_registers).parameters
    unit = next(word for word in ("device_id", "slave", "unit") if word in known)
    answer = client.read_holding_registers(first, count=count, **{unit: 1})
    client.close()
    assert not answer.isError(), answer
    return {key: decode(answer.registers[address - first:], kind) for key, (address, kind) in members.items()}


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


def main():
    controller, document = sys.argv[1:]
    registers = read_document(document)
    assert len(registers) > 60, "the register document has no table"
    with tempfile.TemporaryDirectory() as state:
        with subprocess.Popen([controller, "--state", state], stdout=subprocess.PIPE, text=True) as process:
            try:
                port = process.stdout.readline().strip()
                for read in (read_with_pymodbus, read_with_mbpoll):
                    check(read.__name__, read(port, registers, "identity"), read(port, registers, "status"))
            finally:
                process.terminate()


if __name__ == "__main__":
    main()
