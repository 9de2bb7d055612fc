#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Cuts the power of the ARM7 firmware in QEMU at random moments of a save: behind it the old or the new program is there, whole.
power_cuts.py RUN_IN_QEMU CAMPANELCTL CTL_REGISTERS_H CUTS"""
import os
import pathlib
import re
import select
import signal
import struct
import subprocess
import sys
import tempfile
import time
import tty
import zlib
from random import Random

SEED = 11
PATIENCE_S = 60
POINT_REGISTERS = 4  # of a row of cam points
LONGEST_READ = 125
WRITE_ANSWER_BYTES = 8


def crc16(data):
    crc = 0xFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ 0xA001 if crc & 1 else crc >> 1
    return crc


class Registers:
    """Addresses by the generated header."""

    def __init__(self, header):
        self.text = pathlib.Path(header).read_text(encoding="utf-8")

    def __getitem__(self, name):
        return int(re.search(rf"^#define CTL_{name} (0x[0-9A-F]+|\d+)u?$", self.text, re.M)[1], 0)


class Powered:
    """The firmware while it has power. Its flash is in `state`."""

    def __init__(self, program, state):
        self.process = subprocess.Popen([program, "--exit-with-parent", "--state", state], stdout=subprocess.PIPE, text=True)
        self.port = self.process.stdout.readline().strip()
        self.line = -1

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.cut()

    def open(self):
        self.line = os.open(self.port, os.O_RDWR | os.O_NOCTTY)
        tty.setraw(self.line)

    def cut(self):
        """Like a pulled plug: QEMU dies at once with the process that started it."""
        if self.line >= 0:
            os.close(self.line)
            self.line = -1
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()

    def send(self, content):
        os.write(self.line, content + struct.pack("<H", crc16(content)))

    def take(self, size, patience_s):
        """Returns the answer of so many bytes; what has come when there is none."""
        answer = b""
        while len(answer) < size and select.select([self.line], [], [], patience_s)[0]:
            answer += os.read(self.line, 512)
        return answer

    def ask(self, content, size):
        """Asks again until the answer comes; only for questions that change nothing."""
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            self.send(content)
            answer = self.take(size, 1)
            if len(answer) == size and crc16(answer) == 0:
                return answer[3:-2]
        raise AssertionError("no answer")

    def read(self, address, count):
        return struct.unpack(f">{count}H", self.ask(bytes([1, 3]) + struct.pack(">HH", address, count), 5 + 2 * count))


class Bench:
    def __init__(self, run_in_qemu, ctl, header, folder):
        self.run_in_qemu, self.ctl, self.folder = run_in_qemu, ctl, folder
        self.registers = Registers(header)
        self.counter = 0

    def power(self):
        return Powered(self.run_in_qemu, self.folder)

    def download(self, machine, distance_mm, *options):
        run = subprocess.run([self.ctl, "download", "--kind", "position_move", "--distance-mm", str(distance_mm), "--port",
                              machine.port, *options], capture_output=True, text=True, check=False)
        assert run.returncode == 0, run.stderr
        machine.open()

    def wide(self, machine, name):
        high, low = machine.read(self.registers["REG_" + name], 2)
        return high << 16 | low

    def begin_save(self, machine, crc):
        counter = machine.read(self.registers["REG_RESULT_COUNTER"], 1)[0] % 0xFFFF + 1
        words = (counter, self.registers["COMMAND_SAVE_TO_FLASH"], 0, 0, crc >> 16, crc & 0xFFFF)
        machine.send(bytes([1, 16]) + struct.pack(">HHB6H", self.registers["REG_COMMAND_COUNTER"], 6, 12, *words))
        assert len(machine.take(WRITE_ANSWER_BYTES, PATIENCE_S)) == WRITE_ANSWER_BYTES

    def bank_crc(self, machine, length):
        """The CRC-32 of the active bank as it is read back, register by register."""
        words = []
        first = self.registers["REG_ACTIVE"]
        while len(words) < length:
            words += machine.read(first + len(words), min(LONGEST_READ, length - len(words)))
        return zlib.crc32(struct.pack(f">{length}H", *words))

    def saving_s(self, machine, crc):
        """The time that a save takes."""
        begun = time.monotonic()
        self.begin_save(machine, crc)
        while self.wide(machine, "STATUS_SAVED_CRC") != crc:
            assert time.monotonic() < begun + PATIENCE_S, "the save does not end"
        return time.monotonic() - begun


def cut_once(bench, random, distance_mm, longest_s):
    """Returns the CRC-32 of the program before the save and of the one saved."""
    with bench.power() as machine:
        bench.download(machine, distance_mm)
        old, new = bench.wide(machine, "STATUS_SAVED_CRC"), bench.wide(machine, "STATUS_ACTIVE_CRC")
        assert old != new
        bench.begin_save(machine, new)
        time.sleep(random.uniform(0, longest_s))
    return old, new


def look(bench, length):
    """Powers up; returns the CRC-32 of the program that is there, which is whole."""
    with bench.power() as machine:
        machine.open()
        saved, active = bench.wide(machine, "STATUS_SAVED_CRC"), bench.wide(machine, "STATUS_ACTIVE_CRC")
        assert saved == active, f"saved {saved:08X}, active {active:08X}"
        read = bench.bank_crc(machine, length)
        assert read == active, f"the bank has {read:08X}, the status says {active:08X}"
    return active


def main():
    run_in_qemu, ctl, header, cuts = sys.argv[1:]
    random = Random(SEED)
    outcomes = {"old": 0, "new": 0}
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(run_in_qemu, ctl, header, folder)
        with bench.power() as machine:
            bench.download(machine, 1000, "--save")
            old = bench.wide(machine, "STATUS_ACTIVE_CRC")
        with bench.power() as machine:
            bench.download(machine, 2000)
            other = bench.wide(machine, "STATUS_ACTIVE_CRC")
            rows = machine.read(bench.registers["REG_ACTIVE"] + bench.registers["OFFSET_BANK_ROW_COUNT"], 1)[0]
            length = bench.registers["OFFSET_BANK_ROWS"] + POINT_REGISTERS * rows
            longest_s = 1.2 * bench.saving_s(machine, other)
        distance_of = {old: 1000, other: 2000}
        for number in range(int(cuts)):
            saved = look(bench, length)
            wanted = next(distance for crc, distance in distance_of.items() if crc != saved)
            before, after = cut_once(bench, random, wanted, longest_s)
            found = look(bench, length)
            assert found in (before, after), f"cut {number}: {found:08X}, not {before:08X} or {after:08X}"
            outcomes["new" if found == after else "old"] += 1
    print(f"{cuts} cuts within {longest_s:.2f} s of a save, seed {SEED}: {outcomes['old']} times the old program, {outcomes['new']} the new")
    assert min(outcomes.values()) > 0, "the cuts do not lie about the end of the save"


if __name__ == "__main__":
    main()
