#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares in QEMU the time from power to the panel's picture with that of the same image with an empty Qt window in the panel's place, by turns,
and the time from the panel's window to the connected controller; prints the chain of units that the panel waits for. Ends with 1 beyond a limit."""

import argparse
import os
import re
import statistics
import sys

from check_image import Check
from machine import put_files

EMPTY = """[Service]
Type=simple
WatchdogSec=0
ExecStart=
ExecStart=/etc/empty_window
Environment=QT_QPA_PLATFORM=eglfs QT_QPA_EGLFS_INTEGRATION=eglfs_kms QT_QUICK_BACKEND=software
"""
LIMIT = 1.3        # times the empty window's
CONNECTED_S = 2.0  # behind the panel's window


class BootCheck(Check):
    def put_empty_window(self, disk):
        with open(os.path.join(self.options.bin, "empty_window"), "rb") as file:
            window = file.read()
        put_files(disk, self.computer["tty"], [("etc/empty_window", 0o755, window),
                                               ("etc/systemd/system/campanel-kiosk.service.d/empty.conf", 0o644, EMPTY.encode())])

    def once(self, name, prepare):
        """One boot of a disk that has been booted once."""
        disk = self.path(name + ".img")
        if not os.path.exists(disk):
            self.disk(name + ".img")
            prepare(disk)
            self.once_more(name, disk)
        return self.once_more(name, disk)

    def once_more(self, name, disk):
        machine, seconds = self.start(disk)
        try:
            machine.picture(name)
            if seconds and name == "panel":
                self.chain = machine.shell("systemd-analyze critical-chain --no-pager campanel-kiosk.service")
                machine.wait_for("journalctl -b -u campanel-kiosk -o cat --no-pager", 'connected to "/dev/campanel-serial"', 60)
                self.log = machine.shell("journalctl -b -u campanel-kiosk -o short-monotonic --no-pager")
            machine.shell("sync")
        finally:
            machine.cut()
        return seconds

    def connected(self):
        """The guest's seconds from the ready panel to the connected controller; negative: it was connected before."""
        def at(text):
            found = re.search(r"\[ *([0-9.]+)\][^\n]*" + text, self.log)
            return float(found.group(1)) if found else None
        ready, connected = at("Started campanel-kiosk"), at('connected to "/dev/campanel-serial"')
        return None if ready is None or connected is None else connected - ready

    def check(self):
        self.unpack()
        times, behind = {"empty": [], "panel": []}, []
        for turn in range(self.options.turns):
            for name, prepare in (("empty", self.put_empty_window), ("panel", lambda disk: None)):
                seconds = self.once(name, prepare)
                if not self.report(f"{name}, boot {turn + 1}", seconds is not None, seconds and f"picture after {seconds:.1f} s"):
                    return
                times[name].append(seconds)
            behind.append(self.connected())
            if behind[-1] is None or behind[-1] > CONNECTED_S:
                print(self.log, flush=True)
        print(self.chain, flush=True)
        middle = {name: statistics.median(values) for name, values in times.items()}
        ratio = middle["panel"] / middle["empty"]
        self.report("time to the picture", ratio <= LIMIT, f"panel {middle['panel']:.1f} s, empty window {middle['empty']:.1f} s: {ratio:.2f}, limit {LIMIT}")
        late = max((value for value in behind if value is not None), default=None)
        self.report("connected behind the window", None not in behind and late <= CONNECTED_S,
                    ", ".join("unknown" if value is None else f"{value:.1f} s" for value in behind) + f"; limit {CONNECTED_S} s")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("image", help="an image of packaging/image, with its name: campanel-VERSION-ARCHITECTURE.img.zst")
    parser.add_argument("folder", help="gets pictures, logs and disks (6 GB)")
    parser.add_argument("--bin", default="build/ci/bin", help="where campanel-controller and empty_window are")
    parser.add_argument("--turns", type=int, default=3, help="how many boots of each")
    parser.add_argument("--accel", default="tcg", help="what QEMU runs the processor by: tcg or kvm")
    sys.exit(BootCheck(parser.parse_args()).run())


if __name__ == "__main__":
    main()
