#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests the update of a whole system in QEMU, with bundles made of the one that packaging/image made: one from a stick is installed by finger,
started and kept, and taken back again; one that does not open its window and one that hangs are left; one that is damaged and one of a stranger
are refused; and a power cut with lost writes at any moment leaves a whole system in the place that every boot starts. Prints one line per step;
ends with 1 when one has failed."""

import argparse
import hashlib
import os
import random
import re
import shutil
import subprocess
import sys
import time

from check_image import SETTINGS, Check
from machine import partition
from power_cuts import PowerCuts

HOME = "/var/lib/campanel-update"
STAGING = "/var/lib/campanel/update"
PLACES = {"a": 2, "b": 3}
UPDATE_S = 1800  # without KVM, beside other work
# What a finger does on a screen of 1024x600 in English, each touch with the seconds for which the page then stays: the message about the key on
# the card, language, controller, access, machine, download, finish; Settings, About, Update; the version on the stick; Update, the question.
FIRST_START = ((848, 107, 3), (816, 545, 4), (816, 545, 10), (816, 545, 4), (816, 545, 4), (446, 545, 15), (655, 545, 4))
OPEN_UPDATE = ((46, 550, 6), (250, 534, 6), (658, 545, 6))
CHOOSE_VERSION = (450, 162)
UPDATE, CONFIRM = (755, 545, 3), (705, 415, 1)


def run(*command, **more):
    return subprocess.run(command, check=True, **more)


def digest(path, start=0, size=None):
    """SHA-256 of a part of a file."""
    sha = hashlib.sha256()
    with open(path, "rb") as file:
        file.seek(start)
        left = os.path.getsize(path) - start if size is None else size
        while left > 0:
            piece = file.read(min(1 << 20, left))
            if not piece:
                break
            sha.update(piece)
            left -= len(piece)
    return sha.hexdigest()


class UpdateCheck(Check):
    def __init__(self, options):
        super().__init__(options)
        self.ctl = os.path.join(options.bin, "campanelctl")
        self.stick = self.path("stick.img")
        self.variables = self.path("variables.fd")
        self.systems = {}  # SHA-256 of a system to its version
        self.sizes = {}    # version to the bytes of its system

    # Bundles ------------------------------------------------------------------------------------------------------------------

    def sign(self, bundle, owner):
        secret, public = self.path(f"{owner}.secret"), self.path(f"{owner}.json")
        if not os.path.exists(secret):
            run(self.ctl, "recipe", "new-key", "--name", owner, "--key", secret, "-o", public)
        run(self.ctl, "package", "sign", bundle, "--key", secret, "-o", bundle + ".sig")

    def know(self, version, system):
        self.systems[digest(system)] = version
        self.sizes[version] = os.path.getsize(system)

    def make_bundle(self, version, change, owner="builder"):
        """A bundle of another version; `change` edits its system's files."""
        tree, content = self.path("tree"), self.path("content")
        for folder in (tree, content):
            shutil.rmtree(folder, ignore_errors=True)
        run("dpkg-deb", "--raw-extract", self.options.bundle, content)
        system = os.path.join(content, "system.img")
        run("unsquashfs", "-q", "-n", "-d", tree, system)
        os.remove(system)
        for path, pattern, text in ((os.path.join(tree, "usr/lib/os-release"), r"(?m)^IMAGE_VERSION=.*", f"IMAGE_VERSION={version}"),
                                    (os.path.join(content, "DEBIAN/control"), r"(?m)^Version: .*", f"Version: {version}")):
            with open(path) as file:
                old = file.read()
            with open(path, "w") as file:
                file.write(re.sub(pattern, text, old))
        change(tree)
        run("mksquashfs", tree, system, "-comp", "zstd", "-Xcompression-level", "1", "-noappend", "-no-progress", "-no-exports", "-xattrs", stdout=subprocess.DEVNULL)
        shutil.rmtree(tree)
        self.know(version, system)
        bundle = self.path(f"campanel-system_{version}_{self.options.architecture}.deb")
        run("dpkg-deb", "--root-owner-group", "-Znone", "--build", content, bundle, stdout=subprocess.DEVNULL)
        shutil.rmtree(content)
        self.sign(bundle, owner)
        return bundle

    def make_bundles(self):
        """Those of the test, and the stick with the first."""
        present = subprocess.check_output(["dpkg-deb", "--field", self.options.bundle, "Version"], text=True).strip()
        base = present.split("-")[0]
        self.versions = {"first": present, "next": f"{base}-30000101", "silent": f"{base}-30000102", "hanging": f"{base}-30000103"}
        content = self.path("content")
        run("dpkg-deb", "--raw-extract", self.options.bundle, content)
        self.know(present, os.path.join(content, "system.img"))
        shutil.rmtree(content)
        self.bundles = {"next": self.make_bundle(self.versions["next"], lambda tree: None)}

        def without_window(tree):
            path = os.path.join(tree, "usr/bin/campanel")
            os.remove(path)
            with open(path, "w") as file:
                file.write("#!/bin/sh\nexec sleep 1000\n")
            os.chmod(path, 0o755)
        self.bundles["silent"] = self.make_bundle(self.versions["silent"], without_window)

        # As a driver that never returns: nothing else runs, but for the computer's watchdog, which Linux has started by then.
        def hanging(tree):
            units = os.path.join(tree, "usr/lib/systemd/system")
            with open(os.path.join(units, "hanging.service"), "w") as file:
                file.write("[Service]\nExecStart=/bin/sh -c 'until [ -e /dev/watchdog ]; do sleep 1; done; sleep 5; "
                           "echo -1 >/proc/sys/kernel/sched_rt_runtime_us; "
                           "for core in 1 2 3 4; do chrt -f 99 sh -c \"while :; do :; done\" & done; wait'\n")
            os.makedirs(os.path.join(units, "multi-user.target.wants"), exist_ok=True)
            os.symlink("../hanging.service", os.path.join(units, "multi-user.target.wants/hanging.service"))
        if self.options.architecture == "amd64":  # QEMU's computer for arm64 has no watchdog
            self.bundles["hanging"] = self.make_bundle(self.versions["hanging"], hanging)
        for name, owner in (("damaged", "builder"), ("stranger", "stranger")):
            bundle = self.bundles[name] = self.path(name + ".deb")
            shutil.copyfile(self.bundles["next"], bundle)
            self.sign(bundle, owner)
        with open(self.bundles["damaged"], "r+b") as file:
            file.seek(100_000_000)
            file.write(b"another byte")
        self.fill_stick("next")

    def fill_stick(self, name):
        with open(self.stick, "wb") as file:
            file.truncate(700 << 20)
        run("mkfs.vfat", "-n", "UPDATE", self.stick, stdout=subprocess.DEVNULL)
        bundle = self.bundles[name]
        target = f"::/campanel-system_{self.versions.get(name, 'x')}_{self.options.architecture}.deb"
        run("mcopy", "-i", self.stick, bundle, target)
        run("mcopy", "-i", self.stick, bundle + ".sig", target + ".sig")

    # The computer ---------------------------------------------------------------------------------------------------------------

    def key_on_card(self, disk):
        boot = f"{disk}@@{partition(disk, 1)[0]}"
        folder = self.path("keys")
        os.makedirs(os.path.join(folder, "campanel/package-keys"), exist_ok=True)
        shutil.copyfile(self.path("builder.json"), os.path.join(folder, "campanel/package-keys/builder.json"))
        run("mcopy", "-s", "-i", boot, os.path.join(folder, "campanel"), "::/")

    def touch(self, machine, *touches):
        for x, y, seconds in touches:
            if not machine.touch(x, y, seconds):
                self.report(f"a touch of {x}, {y} changes the page", False)
                machine.picture(f"touched-{x}-{y}")

    def update_by_finger(self, machine):
        machine.shell(f"rm -f {HOME}/outcome")
        machine.plug_stick()
        machine.settle(10)
        self.touch(machine, *OPEN_UPDATE)
        end = time.time() + 600
        while time.time() < end:  # the panel reads the whole bundle
            machine.tap(*CHOOSE_VERSION)
            machine.drain(5)
            red, _, blue = machine.picture("versions").at(640, 560)
            if blue > red + 60:  # the key can be pressed
                break
        self.touch(machine, UPDATE)
        machine.picture("question")
        self.touch(machine, CONFIRM)
        if not self.report("a finger starts the update", machine.wait_for("systemctl is-active campanel-update", "activating", 600)):
            print(machine.shell("journalctl -b -u campanel-kiosk -o short-monotonic --no-pager | tail -n 30"), flush=True)
        machine.pull_stick()

    def request(self, machine, word="update"):
        """What the panel does when a technician has confirmed, after it has copied the files of the stick."""
        if word == "update":
            machine.plug_stick()
            if not machine.wait_for("ls /media/*/*.deb", "campanel-system", 120):
                self.report("the stick is there", False, machine.shell("ls /media; journalctl -b --no-pager | tail -n 20"))
                return
            copied = machine.shell(f"setpriv --reuid=campanel --regid=campanel --clear-groups sh -c 'mkdir -p {STAGING}; cp /media/*/*.deb {STAGING}/package.deb && "
                                   f"cp /media/*/*.sig {STAGING}/package.deb.sig && echo copied'", 600)
            self.report("the panel's user reads the stick", copied.endswith("copied"), copied if not copied.endswith("copied") else "")
            machine.pull_stick()
        machine.shell(f"rm -f {HOME}/outcome; setpriv --reuid=campanel --regid=campanel --clear-groups sh -c 'echo {word} >/run/campanel/update-request'; "
                      "systemctl start --no-block campanel-update")

    def outcome(self, machine):
        """Waits until the update has ended, over the boots of it; what it told."""
        end = time.time() + UPDATE_S
        while time.time() < end:
            try:
                told = machine.shell(f"cat {HOME}/outcome", 40)
            except TimeoutError:
                continue  # between two boots
            if '"result"' in told:
                return {key: value for key, value in re.findall(r'"(\w+)": "(.*)"', told)}
            time.sleep(3)
        return {}

    def state(self, machine):
        """The running version, and the place that every boot starts."""
        version = machine.shell("sed -n 's/^IMAGE_VERSION=//p' /usr/lib/os-release")
        every = machine.shell("mkdir -p /run/look; mount -t vfat -o ro /dev/disk/by-partlabel/campanel-boot /run/look; sed -n 's/^default campanel-\\(.\\).conf/\\1/p' "
                              "/run/look/loader/loader.conf; umount /run/look")
        return version, every

    def expect(self, step, machine, result, reason, version, place):
        told = self.outcome(machine)
        running, every = self.state(machine)
        good = (told.get("result"), told.get("reason"), running, every) == (result, reason, self.versions[version], place)
        return self.report(step, good, f"{told.get('result')} {told.get('reason')}, {running} runs, every boot starts {every}; {machine.age():.0f} s" +
                           ("" if good else "\n" + machine.shell("journalctl -b -u campanel-update -o cat --no-pager | tail -n 20")))

    def new_variables(self):
        shutil.copyfile(self.computer["uefi"][1], self.variables)

    def open(self, disk, **more):
        machine, seconds = self.start(disk, variables=self.variables, stick=self.stick, **more)
        self.report("opens the panel", seconds is not None, seconds and f"picture after {seconds:.0f} s")
        return machine

    def update(self):
        """The good one, with every write on record, and back again. The disk before it stays as `before.img`."""
        self.new_variables()
        disk = self.disk("update.img")
        self.key_on_card(disk)
        machine = self.open(disk)
        self.report("the key of the builder is taken", machine.wait_for("ls /etc/campanel/package-keys", "builder.json", 60))
        machine.settle(10)
        self.touch(machine, *FIRST_START)
        self.report("a finger goes through the first start", machine.wait_for(f"cat {SETTINGS}", "first_start=done", 60))
        self.report("the panel has its database", machine.wait_for("find /var/lib/campanel -size +0 -name 'campanel.sqlite'", "campanel.sqlite", 120))
        machine.shell("sync")
        machine.cut()
        run("cp", "--sparse=always", disk, self.path("before.img"))
        machine = self.open(disk, log=self.path("update.log"))
        try:
            self.update_by_finger(machine)
            if not self.expect("updates", machine, "done", "", "next", "b"):
                return
            machine.drain(5)
            machine.picture("updated")
        finally:
            machine.cut()
        machine = self.open(disk)
        try:
            self.report("every boot starts it", self.state(machine) == (self.versions["next"], "b"))
            self.request(machine, "back")
            self.expect("goes back", machine, "done", "", "first", "a")
            machine.picture("back")
        finally:
            machine.cut()
        os.remove(disk)

    def bad_ones(self):
        for name, result, reason in (("damaged", "refused", "signature"), ("stranger", "refused", "signature"), ("silent", "returned", "not-shown"),
                                     ("hanging", "returned", "not-shown")):
            if name not in self.bundles:
                continue
            self.fill_stick(name)
            self.new_variables()
            disk = self.path("bad.img")
            run("cp", "--sparse=always", self.path("before.img"), disk)
            machine = self.open(disk)
            try:
                self.request(machine)
                self.expect(f"a bundle that is {name}", machine, result, reason, "first", "a")
                if result == "returned":
                    self.report("the panel is there again", machine.wait_for("systemctl is-active campanel-kiosk", "active", 300))
                    machine.drain(5)
                    machine.picture("returned-" + name)
            finally:
                machine.cut()
            os.remove(disk)

    # Power cuts -----------------------------------------------------------------------------------------------------------------

    def whole_system(self, disk):
        """The place that every boot starts, and the version in it; the version is None when it is not whole."""
        start, size = partition(disk, 1)
        boot = self.path("cut-boot")
        run("dd", f"if={disk}", f"of={boot}", "bs=1M", "iflag=skip_bytes,count_bytes", f"skip={start}", f"count={size}", "status=none")
        text = subprocess.run(["mtype", "-i", boot, "::/loader/loader.conf"], capture_output=True, text=True).stdout
        found = re.search(r"(?m)^default campanel-([ab])\.conf$", text)
        place = found.group(1) if found else None
        version = None
        if place:
            start, _ = partition(disk, PLACES[place])
            for sha, candidate in self.systems.items():
                if digest(disk, start, self.sizes[candidate]) == sha:
                    version = candidate
            for file in ("linux", "initrd"):
                content = subprocess.run(["mtype", "-i", boot, f"::/{place}/{file}"], capture_output=True).stdout
                if hashlib.sha256(content).hexdigest() != self.boot_files[file]:
                    version = None
        os.remove(boot)
        return place, version

    def power_cuts(self):
        content = self.path("content")
        run("dpkg-deb", "--raw-extract", self.options.bundle, content)
        self.boot_files = {file: digest(os.path.join(content, "boot", file)) for file in ("linux", "initrd")}
        shutil.rmtree(content)
        cuts = PowerCuts(self.path("before.img"), self.path("update.log"), self.options.folder)
        print(f"campanel: image: {len(cuts.writes)} writes of the update, {cuts.flushes} flushes", flush=True)
        chance = random.Random(self.options.seed)
        booted = set(chance.sample(range(self.options.cuts), min(self.options.boots, self.options.cuts)))
        seen = {}
        for number in range(self.options.cuts):
            disk = self.path("cut.img")
            lost, unsure = cuts.make(disk, chance)
            place, version = self.whole_system(disk)
            damage = cuts.damage(disk)
            seen[(place, version)] = seen.get((place, version), 0) + 1
            self.report(f"power cut {number + 1}", version is not None and not damage,
                        f"every boot starts {place}, {version}; {lost} of {unsure} blocks since the last flush lost" + "".join("; " + found for found in damage))
            if number in booted:
                self.new_variables()
                machine = self.open(disk)
                try:
                    end = time.time() + UPDATE_S
                    while time.time() < end and "unfinished" in machine.shell(f"ls {HOME} || sleep 1", 300):
                        time.sleep(5)
                    running, every = self.state(machine)
                    self.report("ends in one of the two", running in self.versions.values() and self.versions["next" if every == "b" else "first"] == running, f"{running}, {every}")
                    machine.picture(f"cut-{number + 1}")
                finally:
                    machine.cut()
            os.remove(disk)
        print("campanel: image: " + ", ".join(f"{count} start {version} in {place}" for (place, version), count in sorted(seen.items(), key=str)), flush=True)

    def check(self):
        self.unpack()
        self.make_bundles()
        self.update()
        if not self.failed:
            self.power_cuts()
        self.bad_ones()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("image", help="an image of packaging/image, with its name: campanel-VERSION-ARCHITECTURE.img.zst; its bundle lies beside it")
    parser.add_argument("folder", help="gets pictures, logs and disks (12 GB)")
    parser.add_argument("--bin", default="build/ci/bin", help="where campanel-controller and campanelctl are")
    parser.add_argument("--cuts", type=int, default=30, help="how many power cuts")
    parser.add_argument("--boots", type=int, default=2, help="how many of them are booted")
    parser.add_argument("--seed", type=int, default=1, help="of what the cuts lose")
    parser.add_argument("--accel", default="tcg", help="what QEMU runs the processor by: tcg or kvm")
    options = parser.parse_args()
    name = re.fullmatch(r"campanel-(.*)-([a-z0-9]*)\.img\.zst", os.path.basename(options.image))
    if not name:
        parser.error(f"{options.image} has not the name of an image of packaging/image")
    options.architecture = name.group(2)
    options.bundle = os.path.join(os.path.dirname(options.image), f"campanel-system_{name.group(1)}_{name.group(2)}.deb")
    sys.exit(UpdateCheck(options).run())


if __name__ == "__main__":
    main()
