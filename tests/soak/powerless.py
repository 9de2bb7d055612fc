#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""campanel-faulty-board gives a board nothing of what the panel sent while the board had no power. The board is this script, too: it
stays without power until it is told. powerless.py CAMPANEL_FAULTY_BOARD, or as a board: powerless.py ... --state FOLDER"""
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import tty

REQUEST = bytes([1, 3, 0, 0, 0, 1, 0x84, 0x0A])
ANSWER = bytes([1, 3, 2, 0, 7, 0xF9, 0x86])
PATIENCE_S = 30


def wait_for(condition, what):
    end = time.monotonic() + PATIENCE_S
    while not condition():
        assert time.monotonic() < end, what
        time.sleep(0.005)


def be_board(folder):
    """Answers every request, and keeps how many bytes have come since power-up."""
    starts = len(list(folder.glob("start*")))
    (folder / f"start{starts}").touch()
    if starts > 0:
        wait_for((folder / "power").exists, "no power")
    master, slave = os.openpty()
    tty.setraw(slave)
    print(os.ttyname(slave), flush=True)
    came = 0
    while True:
        came += len(os.read(master, 512))
        (folder / f"came{starts}").write_text(str(came), encoding="ascii")
        if came % len(REQUEST) == 0:
            os.write(master, ANSWER)


def came(folder, start):
    file = folder / f"came{start}"
    return int("0" + file.read_text(encoding="ascii")) if file.exists() else 0


def try_relay(relay, folder):
    environment = os.environ | {"CAMPANEL_BOARD": os.path.abspath(__file__)}
    with subprocess.Popen([relay, "--control", "--exit-with-parent", "--no-pacing", "--state", folder], env=environment, text=True,
                          stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        try:
            port = os.open(process.stdout.readline().strip(), os.O_RDWR | os.O_NOCTTY)
            tty.setraw(port)
            os.write(port, REQUEST)
            assert os.read(port, 512) == ANSWER
            process.stdin.write("restart time=1 every=1 limit=1\n")
            process.stdin.flush()
            assert process.stdout.readline() == "ok 0\n"
            os.write(port, REQUEST)  # the board loses its power with it
            wait_for((folder / "start1").exists, "the board does not start again")
            os.write(port, REQUEST)  # nobody hears it
            (folder / "power").touch()
            assert process.stdout.readline() == "restarted\n"
            os.write(port, REQUEST)
            wait_for(lambda: came(folder, 1) >= len(REQUEST), "the board hears nothing behind its restart")
            assert os.read(port, 512) == ANSWER
            assert came(folder, 0) == len(REQUEST), f"{came(folder, 0)} bytes before the restart"
            assert came(folder, 1) == len(REQUEST), f"{came(folder, 1)} bytes behind it: a request came through without power"
        finally:
            process.terminate()


def main():
    if "--state" in sys.argv:
        be_board(pathlib.Path(sys.argv[sys.argv.index("--state") + 1]))
    else:
        with tempfile.TemporaryDirectory() as folder:
            try_relay(sys.argv[1], pathlib.Path(folder))


if __name__ == "__main__":
    main()
