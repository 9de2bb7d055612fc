#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures what gateways cost a panel on the same computer: beside_a_panel.py BIN TEST SECONDS.

A panel shows a running machine for SECONDS: alone, with its own gateway, and while TEST (build/ci/tests/test_gateway) runs 49 others.
Prints the frame times and the requests of its line. A command, not a test: the numbers are those of the computer."""

import os
import re
import subprocess
import sys
import time

import plant

FRAME = re.compile(r"(?:Frame rendered|frame rendered).*? in (\d+)ms")


def percentile(values, share):
    return sorted(values)[min(len(values) - 1, int(share * len(values)))] if values else float("nan")


def requests(hall):
    """Returns the requests that the controller has counted; 16 bits."""
    rows = dict(line.split(",")[:2] for line in hall.control("status", "--format", "csv").splitlines() if "," in line)
    return int(rows["link.requests"])


def measure(binaries, seconds, has_gateway, others=None):
    with plant.Plant(binaries) as hall, open(hall.path("frames"), "w+", encoding="utf-8") as frames:
        hall.start_machine()
        before = requests(hall)
        options = ["--config", hall.config] if has_gateway else []
        panel = hall.start_panel(*options, stderr=frames, env={"QT_LOGGING_RULES": "qt.scenegraph.time.renderloop=true"})
        if has_gateway:
            hall.start_gateway()
        if others:
            hall.start(others, "test_gateway_and_broker", "fiftyMachinesAtOneBroker", stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                       env={"CAMPANEL_GATEWAYS": "49", "CAMPANEL_GATEWAY_SECONDS": str(int(seconds))})
        time.sleep(seconds)
        panel.terminate()
        panel.wait()
        count = (requests(hall) - before) % 65536
        frames.seek(0)
        times = [int(found) for found in FRAME.findall(frames.read())]
    return {"frames": len(times), "median ms": percentile(times, 0.5), "p99 ms": percentile(times, 0.99), "requests/s": round(count / seconds, 1)}


def main():
    binaries, test, seconds = sys.argv[1], os.path.abspath(sys.argv[2]), float(sys.argv[3])
    print("alone          ", measure(binaries, seconds, False), flush=True)
    print("its gateway    ", measure(binaries, seconds, True), flush=True)
    print("fifty gateways ", measure(binaries, seconds, True, test))


if __name__ == "__main__":
    main()
