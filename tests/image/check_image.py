#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests an image of packaging/image in QEMU: it opens the panel, a tap reaches it, the controller behind a USB adapter is connected, power cuts
with lost writes leave it whole, and without its data partition and on a small card the panel says so. Prints one line per step; ends with 1 when
one has failed."""

import argparse
import os
import random
import subprocess
import sys
import time

from machine import COMPUTERS, DATA_PARTITION, Machine, partition, partitions, put_files
from power_cuts import PowerCuts

PATIENCE_S = 900  # without KVM, beside other work
SETTINGS = "/var/lib/campanel/config/campanel/campanel.conf"
PI_FILES = {"linux", "cmdline.txt", "bcm2711-rpi-4-b.dtb", "bcm2711-rpi-400.dtb", "bcm2711-rpi-cm4-io.dtb"}
RECIPE = "/var/lib/campanel/data/campanel/campanel/recipe.json"
CONFIGURATION = "/etc/campanel/campanel.toml"
SETTINGS_ON_CARD = '[connection]\nport = "/dev/campanel-serial"\n[display]\ntheme = "dark"\n'


class Check:
    def __init__(self, options):
        self.options, self.failed = options, 0
        os.makedirs(options.folder, exist_ok=True)
        self.base = self.path("base.img")
        self.computer = COMPUTERS[options.image.rsplit("-", 1)[1].split(".")[0]]

    def path(self, name):
        return os.path.join(self.options.folder, name)

    def report(self, step, is_good, note=""):
        self.failed += not is_good
        print(f"campanel: image: {step}: {'ok' if is_good else 'FAILED'}{'; ' + note if note else ''}", flush=True)
        return is_good

    def start(self, disk, **more):
        """Boots it and waits for the panel; the machine, and the seconds or None."""
        machine = Machine(self.computer, disk, self.options.folder, controller=self.path("line"), accel=self.options.accel, **more)
        return machine, machine.wait_for_panel(PATIENCE_S)

    def disk(self, name):
        path = self.path(name)
        subprocess.run(["cp", "--sparse=always", self.base, path], check=True)
        return path

    @staticmethod
    def language_rows(machine):
        """The choice of the language is the first page of a new panel. Where each language is depends on the size of the screen in mm, so taps
        down the page find it: language to place."""
        rows = {}
        for y in range(170, 450, 30):
            machine.tap(440, y)
            time.sleep(2)
            language = machine.shell(f"sed -n 's/^language=//p' {SETTINGS}")
            if language:
                rows.setdefault(language, (440, y))
        return rows

    def unpack(self):
        subprocess.run(["zstd", "-q", "-d", "-f", self.options.image, "-o", self.base], check=True)
        put_files(self.base, self.computer["tty"])
        os.truncate(self.base, 2 << 30)  # a larger card

    def fill_card(self, disk, settings):
        """What a machine builder puts on the first partition."""
        boot = f"{disk}@@{partition(disk, 1)[0]}"
        folder = self.path("card")
        os.makedirs(os.path.join(folder, "campanel/recipes"), exist_ok=True)
        recipe = [os.path.join(self.options.bin, "campanelctl"), "recipe", "--name", "Rusk", "--bag-length-mm", "300", "--pulses-per-rev", "20000"]
        for name, text in (("campanel.toml", settings), ("hostname", "packer-7\n"), ("recipes/rusk.json", subprocess.check_output(recipe, text=True))):
            with open(os.path.join(folder, "campanel", name), "w") as file:
                file.write(text)
        subprocess.run(["mdeltree", "-i", boot, "::/campanel"], check=False, stderr=subprocess.DEVNULL)
        subprocess.run(["mcopy", "-s", "-i", boot, os.path.join(folder, "campanel"), "::/"], check=True)

    def made_ready(self, disk):
        """The second boot, with the settings corrected on the card, and of a computer whose clock has stood."""
        self.fill_card(disk, SETTINGS_ON_CARD)
        machine, seconds = self.start(disk, clock="2001-01-01")
        try:
            if self.report("opens the panel again", seconds is not None, seconds and f"picture after {seconds:.0f} s"):
                self.report("the corrected settings are taken", machine.wait_for(f"cat {CONFIGURATION}", 'theme = "dark"', 60) and
                            machine.shell("ls /var/lib/campanel-card") == "taken")
                self.report("the recipe is kept", machine.wait_for(f"grep -c Rusk {RECIPE}", "1"))
                first_line = float(machine.shell("journalctl -b -u campanel-kiosk -o short-unix --no-pager | head -n 1").split()[0])
                self.report("the time goes on", first_line > self.last_time, f"the kiosk began {first_line - self.last_time:.0f} s after the last known time")
                machine.picture("made-ready")
                self.another_version(machine)
                machine.shell("dd if=/dev/zero of=/run/campanel-data/fill bs=1M; sync", 300)
        finally:
            machine.cut()

    @staticmethod
    def tells(machine, pattern):
        """Whether the panel says it, in the language that it has."""
        return machine.wait_for(f"journalctl -b -u campanel-kiosk -o cat --no-pager | grep -qE '{pattern}' && echo told", "told", 300)

    def another_version(self, machine):
        """The data of a later panel: SQLite keeps the version of the tables in the bytes 60 to 63."""
        store = machine.shell("find /run/campanel-data -name campanel.sqlite")
        machine.shell("mkdir -p /run/systemd/system/campanel-kiosk.service.d; printf '[Service]\\nTimeoutStopSec=100\\n' "
                      ">/run/systemd/system/campanel-kiosk.service.d/slow.conf; systemctl daemon-reload")  # so that it closes the database
        machine.shell(f"systemctl stop campanel-kiosk; cp -p {store} /run/kept; printf '\\000\\001\\000\\000' | dd of={store} bs=1 seek=60 conv=notrunc; "
                      "systemctl start campanel-kiosk", 300)
        self.report("says that its data are of a newer version", self.tells(machine, "newer version|neueren Version|更新版本"))
        machine.drain(5)
        machine.picture("newer-data")
        machine.shell(f"systemctl stop campanel-kiosk; cp -p /run/kept {store}", 300)

    def full(self, disk):
        machine, seconds = self.start(disk)
        try:
            self.report("opens the panel on a full card", seconds is not None, seconds and f"picture after {seconds:.0f} s")
            self.report("the card is full", machine.shell("df --output=avail /run/campanel-data | tail -n 1") == "0")
            self.report("says so", self.tells(machine, "disk is full|Datenträger ist voll|磁盘已满"))
            machine.drain(5)
            machine.picture("full")
        finally:
            machine.cut()

    def pi_files(self):
        """QEMU starts no Raspberry Pi, so only the files are looked at by which it would start."""
        boot = f"{self.base}@@{partition(self.base, 1)[0]}"
        files = {name.removeprefix("::/").lower() for name in subprocess.check_output(["mdir", "-/", "-b", "-i", boot, "::/"], text=True).split()}
        needed = {"start4.elf", "fixup4.dat", "b/cmdline.txt"} | {f"a/{name}" for name in PI_FILES}
        for name, folder in (("config.txt", "a/"), ("tryboot.txt", "b/")):
            text = subprocess.run(["mtype", "-i", boot, f"::/{name}"], capture_output=True, text=True).stdout
            told = dict(line.replace("initramfs ", "initramfs=").split("=") for line in text.splitlines())
            self.report(f"{name} names its system", told.get("os_prefix") == folder, text if told.get("os_prefix") != folder else "")
            if folder == "a/":
                needed |= {folder + str(told.get("kernel")), folder + told.get("initramfs", "").split(" ")[0]}
        self.report("the files of a Raspberry Pi are there", needed <= files, " ".join(sorted(needed - files)))

    def boot(self):
        """The first boot: what it opens, what it is, and what is closed."""
        disk = self.disk("disk.img")
        self.fill_card(disk, SETTINGS_ON_CARD + "rate = = 3\n")
        machine, seconds = self.start(disk, log=self.path("writes.log"))
        try:
            if not self.report("opens the panel", seconds is not None, seconds and f"picture after {seconds:.0f} s"):
                print(machine.shell("systemctl --failed --no-legend; journalctl -b --no-pager | tail -n 40"))
                return
            machine.picture("first")
            self.report("kiosk", machine.wait_for("systemctl is-active campanel-kiosk", "active"), machine.shell("campanel-kiosk status"))
            self.report("no unit has failed", machine.shell("systemctl --failed --no-legend") == "", machine.shell("systemctl --failed --no-legend"))
            size = int(machine.shell("df --output=size -m /run/campanel-data | tail -n 1"))
            self.report("the data partition has the rest of the card", size > 600, f"{size} MB")
            mounts = machine.shell("grep -E ' (/|/run/campanel-base|/run/campanel-data) ' /proc/mounts")
            self.report("the system is read-only", " / overlay " in mounts and "/run/campanel-base squashfs ro" in mounts and "/run/campanel-data ext4 rw" in mounts)
            self.report("no login, no open port", machine.shell(
                "systemctl list-units --no-legend --all 'getty@*' 'serial-getty@*' | grep -c running; cut -d: -f2 /etc/shadow | grep -vc '^[!*]'; "
                "tail -qn +2 /proc/net/tcp /proc/net/tcp6 | awk '$4 == \"0A\"' | wc -l").split() == ["0", "0", "0"])
            self.report("the fonts' cache is used", "regenerating" not in machine.shell("fc-cache -v 2>&1"))
            self.report("connects to the controller behind a USB adapter",
                        machine.wait_for("journalctl -b -u campanel-kiosk -o cat --no-pager", 'connected to "/dev/campanel-serial"', 60))
            told = machine.shell("journalctl -b -u campanel-card -o cat --no-pager")
            self.report("what the builder put on the card is taken, broken settings are not", "taken: hostname" in told and "taken: recipes/rusk.json" in told
                        and "not taken: campanel.toml" in told and machine.shell("cat /etc/hostname /proc/sys/kernel/hostname").split() == ["packer-7", "packer-7"], told)
            self.report("its recipe is open, with its machine data", machine.wait_for(f"cat {RECIPE}", "Rusk") and "20000" in machine.shell(f"cat {RECIPE}"))
            time.sleep(10)
            machine.picture("card")
            rows = self.language_rows(machine)
            if not self.report("taps change the language", {"de", "zh_CN"} <= rows.keys(), " ".join(rows)):
                return
            machine.tap(*rows["zh_CN"])
            time.sleep(3)
            machine.picture("chinese")
            # So that the power goes in the middle of work.
            chance = random.Random(self.options.seed)
            end = time.time() + 20
            while time.time() < end:
                machine.tap(*chance.choice(list(rows.values())))
            seconds, memory, restarts = (machine.shell(command) for command in (
                "systemd-analyze | head -n 1", "systemctl show -P MemoryCurrent campanel-kiosk", "systemctl show -P NRestarts campanel-kiosk"))
            self.last_time = int(machine.shell("stat -c %Y /var/lib/systemd/timesync/clock"))
            print(f"campanel: image: {seconds}; the kiosk has {int(memory) >> 20} MB and was restarted {restarts} times", flush=True)
        finally:
            machine.cut()
        if not self.failed:
            self.made_ready(disk)
            self.full(disk)
        os.remove(disk)

    def boot_after_cut(self, disk):
        machine, seconds = self.start(disk)
        try:
            self.report("opens the panel after it", seconds is not None and machine.shell("cat /run/campanel-no-data").endswith("No such file or directory"),
                        seconds and f"picture after {seconds:.0f} s")
        finally:
            machine.cut()

    def power_cuts(self):
        """In the work of the first boot."""
        cuts = PowerCuts(self.base, self.path("writes.log"), self.options.folder)
        cuts.moments = cuts.later_half()
        print(f"campanel: image: {len(cuts.writes)} writes, {cuts.flushes} flushes")
        chance = random.Random(self.options.seed)
        for number in range(self.options.cuts):
            disk = self.path("cut.img")
            lost, unsure = cuts.make(disk, chance)
            damage = cuts.damage(disk)
            self.report(f"power cut {number + 1}", not damage, f"{lost} of {unsure} blocks since the last flush lost" + "".join("; " + found for found in damage))
            if number + 1 == self.options.cuts:
                self.boot_after_cut(disk)
            os.remove(disk)

    def power_cuts_of_partitions(self):
        """While the first boot makes the partitions; one disk of each state is booted."""
        cuts = PowerCuts(self.base, self.path("writes.log"), self.options.folder)
        cuts.moments = cuts.of_table()
        chance = random.Random(self.options.seed)
        seen = set()
        for number in range(self.options.cuts):
            disk = self.path("cut.img")
            lost, unsure = cuts.make(disk, chance)
            try:
                names = " ".join(part["name"].removeprefix("campanel-") for part in partitions(disk))
            except subprocess.CalledProcessError:
                names = "no table"
            damage = cuts.damage(disk, databases=False) if names == "boot a b data" else []
            self.report(f"power cut {number + 1} while partitions are made", names in ("boot a", "boot a b new", "boot a b data") and not damage,
                        f"{names}; {lost} of {unsure} blocks since the last flush lost" + "".join("; " + found for found in damage))
            if names not in seen:
                seen.add(names)
                self.boot_after_cut(disk)
            os.remove(disk)

    def without_data(self, name, lose, wanted):
        """`lose` takes the data partition away; `wanted` is a part of the reason that the panel tells."""
        disk = self.disk("no-data.img")
        lose(disk)
        machine, seconds = self.start(disk)
        try:
            self.report(f"opens the panel {name}", seconds is not None, seconds and f"picture after {seconds:.0f} s")
            reason = machine.shell("cat /run/campanel-no-data")
            self.report("says so", wanted in reason and self.tells(machine, "data cannot be used"), reason)
            machine.drain(5)
            machine.picture(name.replace(" ", "-"))
        finally:
            machine.cut()
        os.remove(disk)

    def overwrite_data(self, disk):
        machine, _ = self.start(disk)  # makes the partition
        machine.shell("sync")
        machine.cut()
        start, _ = partition(disk, DATA_PARTITION)
        with open(disk, "r+b") as file:
            file.seek(start)
            file.write(os.urandom(64 << 20))

    def check(self):
        self.unpack()
        if self.computer is COMPUTERS["arm64"]:
            self.pi_files()
        self.boot()
        if not self.failed:
            self.power_cuts_of_partitions()
            self.power_cuts()
            self.without_data("without its data", self.overwrite_data, "has lost its files")
            self.without_data("on a card that is too small", lambda disk: os.truncate(disk, 1_000_000_000), "smaller than 2 GB")

    def run(self):
        """Runs the check beside a simulated controller; the status of the program."""
        if os.path.lexists(self.path("line")):
            os.remove(self.path("line"))  # of a run that was killed
        controller = subprocess.Popen([os.path.join(self.options.bin, "campanel-controller"), "--link", self.path("line"), "--state", self.path("controller")],
                                      stdout=subprocess.DEVNULL)
        try:
            while not os.path.exists(self.path("line")):
                time.sleep(0.1)
                if controller.poll() is not None:
                    sys.exit("the simulated controller has ended")
            self.check()
        finally:
            controller.terminate()
        if not self.failed:
            for name in os.listdir(self.options.folder):
                if name.endswith((".img", ".deb", "writes.log", "update.log")):
                    os.remove(self.path(name))
        return 1 if self.failed else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("image", help="an image of packaging/image, with its name: campanel-VERSION-ARCHITECTURE.img.zst")
    parser.add_argument("folder", help="gets pictures, logs and disks (5 GB)")
    parser.add_argument("--bin", default="build/ci/bin", help="where campanel-controller is")
    parser.add_argument("--cuts", type=int, default=5, help="how many power cuts")
    parser.add_argument("--seed", type=int, default=1, help="of what the cuts lose and where the taps go")
    parser.add_argument("--accel", default="tcg", help="what QEMU runs the processor by: tcg or kvm")
    sys.exit(Check(parser.parse_args()).run())


if __name__ == "__main__":
    main()
