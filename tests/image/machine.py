# SPDX-License-Identifier: Apache-2.0
"""A virtual computer that boots an image of packaging/image: its screen, taps, a USB serial adapter, a shell for tests, power cuts. Needs
QEMU 7.1 or later; without KVM a boot takes one to three minutes."""

import gzip
import json
import os
import random
import re
import select
import socket
import subprocess
import sys
import tempfile
import time

COMPUTERS = {
    "amd64": {"tty": "ttyS0",
              "command": ["qemu-system-x86_64", "-M", "q35", "-vga", "none", "-global", "ICH9-LPC.noreboot=false"], "processor": "max", "screen": "virtio-vga",
              "uefi": ("/usr/share/OVMF/OVMF_CODE_4M.fd", "/usr/share/OVMF/OVMF_VARS_4M.fd")},
    "arm64": {"tty": "ttyAMA0",
              "command": ["qemu-system-aarch64", "-M", "virt"], "processor": "cortex-a72", "screen": "virtio-gpu-pci",
              "uefi": ("/usr/share/AAVMF/AAVMF_CODE.fd", "/usr/share/AAVMF/AAVMF_VARS.fd")},
}
SHELL_UNIT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "test-shell@.service")
DATA_PARTITION = 4


def partitions(image):
    return json.loads(subprocess.run(["sfdisk", "-J", image], check=True, capture_output=True).stdout)["partitiontable"]["partitions"]


def partition(image, number):
    """The first byte and the size in bytes of a partition."""
    table = partitions(image)
    return table[number - 1]["start"] * 512, table[number - 1]["size"] * 512


def archive(entries):
    """(path, mode with the kind of the file, bytes) of each file in cpio's form "newc", which the kernel unpacks beside its initrd."""
    data = b""
    for number, (path, mode, content) in enumerate(entries + [("TRAILER!!!", 0, b"")], 1):
        name = path.encode() + b"\0"
        fields = (number, mode, 0, 0, 1, 0, len(content), 0, 0, 0, 0, len(name), 0)
        for piece in (b"070701" + b"".join(b"%08x" % field for field in fields) + name, content):
            data += piece + b"\0" * (-len(piece) % 4)
    return data


def put_files(image, tty, files=()):
    """Lets the first system of a copy of an image put files over itself at the first boot: a root shell on a serial line, which the image itself
    has not, and (path, mode, bytes) of more."""
    units = "etc/systemd/system/"
    with open(SHELL_UNIT, "rb") as file:
        entries = [(units + "test-shell@.service", 0o100644, file.read())]
    entries.append((units + f"sysinit.target.wants/test-shell@{tty}.service", 0o120777, b"../test-shell@.service"))
    entries += [(path, 0o100000 | mode, content) for path, mode, content in files]
    folders = {"/".join(path.split("/")[:depth]) for path, _, _ in entries for depth in range(1, path.count("/") + 1)}
    entries = [(folder, 0o40755, b"") for folder in sorted(folders)] + entries
    scripts = "scripts/local-bottom/"  # of initramfs-tools
    script = f'#!/bin/sh\n[ -e "$rootmnt/{units}test-shell@.service" ] || (cd "$rootmnt" && cpio -i </test-files)\n'
    more = archive([("test-files", 0o100644, archive(entries)), (scripts + "test_files", 0o100755, script.encode()),
                    (scripts + "ORDER", 0o100644, f'/{scripts}campanel "$@"\n/{scripts}test_files "$@"\n'.encode())])
    boot, place = f"{image}@@{partition(image, 1)[0]}", "::/loader/entries/campanel-a.conf"
    text = subprocess.run(["mtype", "-i", boot, place], check=True, capture_output=True).stdout
    with tempfile.TemporaryDirectory() as folder:
        for target, content in (("::/test-files", gzip.compress(more)), (place, text.replace(b"options ", b"initrd /test-files\noptions "))):
            with open(os.path.join(folder, "file"), "wb") as file:
                file.write(content)
            subprocess.run(["mcopy", "-o", "-i", boot, os.path.join(folder, "file"), target], check=True)


class Picture:
    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        kind, width, height, _ = data.split(None, 3)[:3] + [None]
        if kind != b"P6":
            raise ValueError("no picture")
        self.width, self.height = int(width), int(height)
        self.pixels = data[-3 * self.width * self.height:]

    def at(self, x, y):
        """Red, green and blue."""
        start = 3 * (self.width * y + x)
        return self.pixels[start:start + 3]

    def page(self):
        """The pixels below the top bar and beside the command column: without clock and line."""
        row = 3 * self.width
        return b"".join(self.pixels[row * y:row * y + row * 7 // 8] for y in range(self.height // 10, self.height))

    def sample(self):
        """Every third pixel of every third row."""
        for y in range(0, self.height, 3):
            row = 3 * y * self.width
            for x in range(0, self.width, 3):
                at = row + 3 * x
                yield self.pixels[at:at + 3]

    def is_panel(self, size):
        """True for the size of the screen and many colors: a text console has few. A firmware's logo has many, and is mostly black."""
        sample = list(self.sample())
        black = sum(1 for pixel in sample if max(pixel) < 16)
        return (self.width, self.height) == size and black * 2 < len(sample) and len(set(sample)) >= 40

    def share(self, matches):
        """The share of pixels for which a function of red, green and blue is true."""
        sample = list(self.sample())
        return sum(1 for pixel in sample if matches(*pixel)) / len(sample)


class Machine:
    """A computer of COMPUTERS from power-on to its cut. `folder` gets the pictures and the log of the serial line. The disk is written, and so is
    the file with the firmware's variables, if there is one. `stick` is the disk of a stick that is not plugged in yet, `clock` the time at power-on
    of a computer whose clock does not run while it is off."""

    def __init__(self, computer, disk, folder, controller=None, size=(1024, 600), log=None, accel="tcg", variables=None, stick=None, clock=None):
        self.folder, self.size, self.seen = folder, size, b""
        os.makedirs(folder, exist_ok=True)
        if log:  # with every write and flush in a file
            open(log, "wb").close()
            drive = f"driver=blklogwrites,node-name=disk,file.driver=file,file.filename={disk},log.driver=file,log.filename={log}"
        else:
            drive = f"driver=raw,node-name=disk,file.driver=file,file.filename={disk}"
        qmp, tty = os.path.join(folder, "qmp"), os.path.join(folder, "tty")
        code, fresh = computer["uefi"]
        command = computer["command"] + [
                   "-cpu", computer["processor"] if accel == "tcg" else "host", "-accel", accel + (",thread=multi" if accel == "tcg" else ""),
                   "-smp", "2", "-m", "1024", "-nic", "none", "-display", "none", "-monitor", "none",
                   "-device", f"{computer['screen']},xres={size[0]},yres={size[1]}",
                   "-drive", f"if=pflash,format=raw,readonly=on,file={code}",
                   "-drive", f"if=pflash,format=raw,file={variables}" if variables else f"if=pflash,format=raw,snapshot=on,file={fresh}",
                   "-blockdev", drive, "-device", "virtio-blk-pci,drive=disk,bootindex=0",
                   "-device", "virtio-tablet-pci", "-device", "virtio-rng-pci", "-device", "qemu-xhci",
                   "-qmp", f"unix:{qmp},server=on,wait=off", "-serial", f"unix:{tty},server=on,wait=off"]
        if controller:
            command += ["-chardev", f"serial,id=line,path={os.path.realpath(controller)}", "-device", "usb-serial,chardev=line"]
        if clock:
            command += ["-rtc", f"base={clock}"]
        if stick:
            command += ["-blockdev", f"driver=raw,node-name=stick,file.driver=file,file.filename={stick}"]
        self.began = time.time()
        with open(os.path.join(folder, "qemu.log"), "w") as errors:
            self.process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stderr=errors)
        self.qmp, self.tty = self.connect(qmp), self.connect(tty)
        self.answers = self.qmp.makefile("rw")
        self.answers.readline()
        self.ask("qmp_capabilities")

    def connect(self, path):
        for _ in range(200):
            try:
                line = socket.socket(socket.AF_UNIX)
                line.connect(path)
                return line
            except OSError:
                time.sleep(0.05)
                if self.process.poll() is not None:
                    break
        with open(os.path.join(self.folder, "qemu.log")) as log:
            sys.exit("QEMU ended: " + log.read())

    def age(self):
        return time.time() - self.began

    def ask(self, name, **arguments):
        self.answers.write(json.dumps({"execute": name, "arguments": arguments}) + "\n")
        self.answers.flush()
        while True:
            answer = json.loads(self.answers.readline())
            if "error" in answer:
                raise RuntimeError(answer["error"]["desc"])
            if "return" in answer:
                return answer["return"]

    def plug_stick(self):
        self.ask("device_add", driver="usb-storage", drive="stick", id="stick", removable=True)

    def pull_stick(self):
        self.ask("device_del", id="stick")

    def picture(self, save_as=None):
        """What the screen shows; also as NAME.png in the folder."""
        path = os.path.abspath(os.path.join(self.folder, "screen.ppm"))
        self.ask("screendump", filename=path)
        if save_as:
            self.ask("screendump", filename=os.path.abspath(os.path.join(self.folder, save_as + ".png")), format="png")
        return Picture(path)

    def wait_for_panel(self, seconds):
        """The seconds from power-on until the screen shows the panel; None if it does not."""
        while self.age() < seconds:
            self.drain()
            try:
                if self.picture().is_panel(self.size):
                    return self.age()
            except (RuntimeError, ValueError):
                pass  # no screen yet
            time.sleep(1)
        return None

    def tap(self, x, y):
        """A tap at a pixel. QEMU 7.2 has no touchscreen, so it is the click of a tablet."""
        place = [{"type": "abs", "data": {"axis": axis, "value": round(value * 32767 / span)}} for axis, value, span in (("x", x, self.size[0]), ("y", y, self.size[1]))]
        self.ask("input-send-event", events=place)
        for down in (True, False):
            self.ask("input-send-event", events=[{"type": "btn", "data": {"button": "left", "down": down}}])
            time.sleep(0.12)

    def settle(self, seconds, before=None):
        """Waits until the page differs from `before` and has stayed for some seconds; returns whether it differs."""
        page = self.picture().page()
        changed, end = time.time(), time.time() + 120
        while time.time() < end and (page == before or time.time() < changed + seconds):
            self.drain(1)
            now = self.picture().page()
            if now != page:
                page, changed = now, time.time()
        return page != before

    def touch(self, x, y, seconds):
        """Taps, and waits until the page has changed and then stayed for some seconds; returns whether it has changed."""
        before = self.picture().page()
        self.tap(x, y)
        return self.settle(seconds, before)

    def drain(self, seconds=0.0):
        end = time.time() + seconds
        while select.select([self.tty], [], [], max(0.0, end - time.time()))[0]:
            data = self.tty.recv(65536)
            if not data:
                return
            self.seen += data
            with open(os.path.join(self.folder, "tty.log"), "ab") as log:
                log.write(data)

    def shell(self, command, seconds=120):
        """Runs a command in the test shell and returns what it printed."""
        mark = f"m{random.randrange(10**9)}"
        self.drain()
        start = len(self.seen)
        self.tty.sendall(f"{command}; echo {mark[:1]}''{mark[1:]} $?\n".encode())
        end = time.time() + seconds
        while time.time() < end:
            self.drain(0.2)
            text = self.seen[start:].decode(errors="replace").replace("\r", "")
            if re.search(re.escape(mark) + r" \d+\n", text):
                return text.split("\n", 1)[1].rsplit(mark, 1)[0].strip()
        raise TimeoutError(f"no answer to: {command}; {self.seen[start:]!r}")

    def wait_for(self, command, wanted, seconds=120):
        """Repeats a command until its output has this text; returns whether it came."""
        end = time.time() + seconds
        while time.time() < end:
            if wanted in self.shell(command):
                return True
            time.sleep(1)
        return False

    def cut(self):
        """Switches the power off without a warning."""
        self.process.kill()
        self.process.wait()
