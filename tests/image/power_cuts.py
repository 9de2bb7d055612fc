# SPDX-License-Identifier: Apache-2.0
"""Disks as a power cut may leave them, from what QEMU's blklogwrites has written of a run: everything up to a random moment, and of what was
written since the last flush each 4 KiB only by chance."""

import os
import random
import sqlite3
import struct
import subprocess

from machine import DATA_PARTITION, partition

FLUSH, FUA, DISCARD, MARK = 1, 2, 4, 8
BLOCK = 4096


def entries_of(log):
    """(place, length, flags, position of the data in the log) of each write and flush, in bytes."""
    entries, size = [], os.path.getsize(log)
    with open(log, "rb") as file:
        sector = struct.unpack("<QQQI", file.read(28))[3]
        at = sector
        while at + sector <= size:
            file.seek(at)
            place, length, flags, _ = struct.unpack("<QQQQ", file.read(32))
            entries.append((place * sector, length * sector, flags, at + sector))
            at += sector + (0 if flags & (DISCARD | MARK) else length * sector)
    return entries


class PowerCuts:
    """`base` is the disk before the run, `log` the log of it. The cuts come at any write, unless `moments` is set to some of `writes`."""

    def __init__(self, base, log, folder):
        self.base, self.log, self.folder = base, log, folder
        self.entries = entries_of(log)
        self.moments = self.writes = [i for i, (_, length, flags, _) in enumerate(self.entries) if length and not flags & (DISCARD | MARK)]
        self.flushes = sum(1 for entry in self.entries if entry[2] & FLUSH)

    def later_half(self):
        return self.writes[len(self.writes) // 2:]

    def of_table(self):
        """The writes up to the last one into the table of partitions."""
        last = max(i for i in self.writes if self.entries[i][0] < 1 << 20)
        return [i for i in self.writes if i <= last]

    def make(self, disk, chance):
        """Writes the disk after a cut; returns how many blocks were lost and how many were unsure."""
        subprocess.run(["cp", "--sparse=always", self.base, disk], check=True)
        moment = chance.choice(self.moments)
        last_flush = max((i for i in range(moment) if self.entries[i][2] & FLUSH), default=0)
        lost = unsure = 0
        with open(self.log, "rb") as source, open(disk, "r+b") as target:
            for i, (place, length, flags, data) in enumerate(self.entries[:moment + 1]):
                if flags & (DISCARD | MARK):
                    continue
                source.seek(data)
                for step in range(0, length, BLOCK):
                    piece = source.read(min(BLOCK, length - step))
                    if i > last_flush and not flags & FUA:
                        unsure += 1
                        if chance.random() < 0.5:
                            lost += 1
                            continue
                    target.seek(place + step)
                    target.write(piece)
        return lost, unsure

    def damage(self, disk, databases=True):
        """What the check at boot and SQLite find on such a disk; empty: it is whole. Repairs the file system as the boot does. `databases`: it
        has some already."""
        start, size = partition(disk, DATA_PARTITION)
        data = os.path.join(self.folder, "cut-data")
        subprocess.run(["dd", f"if={disk}", f"of={data}", "bs=1M", "iflag=skip_bytes,count_bytes", f"skip={start}", f"count={size}", "conv=sparse", "status=none"], check=True)
        os.truncate(data, size)
        found = []
        if subprocess.run(["e2fsck", "-f", "-p", data], capture_output=True).returncode >= 4:
            found.append("e2fsck -p cannot repair it")
        elif subprocess.run(["e2fsck", "-f", "-n", data], capture_output=True).returncode != 0:
            found.append("e2fsck finds more after the repair")
        if databases:
            found += self.broken_databases(data)
        os.remove(data)
        return found

    def broken_databases(self, data):
        files = os.path.join(self.folder, "cut-files")
        subprocess.run(["rm", "-rf", files], check=True)
        os.mkdir(files)
        subprocess.run(["debugfs", "-R", f"rdump /system/upper/var/lib/campanel {files}", data], capture_output=True, check=True)
        paths = [os.path.join(folder, name) for folder, _, names in os.walk(files) for name in names]
        databases = [path for path in paths if self.is_database(path)]  # all of them first: opening one removes its journal
        found = []
        for path in databases:
            try:
                with sqlite3.connect(path) as database:
                    answer = database.execute("pragma integrity_check").fetchone()[0]
            except sqlite3.Error as error:
                answer = str(error)
            if answer != "ok":
                found.append(f"{os.path.basename(path)}: {answer}")
        return found if databases else ["no database"]

    @staticmethod
    def is_database(path):
        with open(path, "rb") as file:
            return file.read(15) == b"SQLite format 3"
