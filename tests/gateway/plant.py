# SPDX-License-Identifier: Apache-2.0
"""A plant on this computer for the commands beside this file: mosquitto, a simulated machine that makes bags, its panel and its gateway."""

import os
import socket
import subprocess
import tempfile
import time

NODE = "packer"


def free_port():
    """Returns a port of 127.0.0.1 that nobody uses."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return str(probe.getsockname()[1])


class Plant:
    """Starts the broker; the others on demand. Everything ends with the context."""

    def __init__(self, binaries):
        self.binaries = binaries
        self.port = free_port()
        self.processes = []

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory()
        self.environment = os.environ | {
            "QT_QPA_PLATFORM": "offscreen", "LC_ALL": "C.UTF-8", "HOME": self.path(""), "RUNTIME_DIRECTORY": self.path(""),
            "XDG_CONFIG_HOME": self.path(""), "XDG_DATA_HOME": self.path(""), "XDG_STATE_HOME": self.path(""),
            "PATH": "/usr/sbin:" + os.environ["PATH"]}
        broker = self.write("mosquitto.conf", f"user root\nallow_anonymous true\nlistener {self.port} 127.0.0.1\n")
        self.config = self.write("campanel.toml", f'[gateway]\nhost = "127.0.0.1"\nport = {self.port}\ngroup = "Hall"\nnode = "{NODE}"\n')
        os.mkdir(self.path("campanel"))
        self.write("campanel/campanel.conf", "[General]\ngloves=false\n")  # the first start is over: the panel opens Run
        self.start("mosquitto", "-c", broker, stderr=subprocess.DEVNULL)
        time.sleep(1)
        return self

    def __exit__(self, *_):
        for process in reversed(self.processes):
            process.terminate()
            process.wait()
        self.folder.cleanup()

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as out:
            out.write(text)
        return self.path(name)

    def program(self, name):
        return os.path.join(self.binaries, name)

    def start(self, *command, **more):
        process = subprocess.Popen(command, env=self.environment | more.pop("env", {}), **more)
        self.processes.append(process)
        return process

    def subscribe(self, file):
        """Writes topic and payload in hex, a line each, into the open file."""
        self.start("mosquitto_sub", "-h", "127.0.0.1", "-p", self.port, "-t", "spBv1.0/#", "-F", "%t %x", stdout=file)

    def start_machine(self):
        """A controller that makes 200 bags a minute."""
        self.start(self.program("campanel-controller"), "--link", self.path("line"), "--state", self.path(""), stdout=subprocess.DEVNULL)
        time.sleep(1)
        for command in (["download", "--bag-length-mm", "250", "--rate", "200"], ["start"]):
            self.control(*command)

    def control(self, *command):
        """Runs campanelctl on the machine's line, and returns what it prints."""
        return subprocess.check_output([self.program("campanelctl"), *command, "--port", self.path("line")], env=self.environment, text=True)

    def start_panel(self, *options, **more):
        return self.start(self.program("campanel"), "--port", self.path("line"), *options, **{"stderr": subprocess.DEVNULL} | more)

    def start_gateway(self):
        return self.start(self.program("campanel-gateway"), "--config", self.config, "--state", self.path(""), stderr=subprocess.DEVNULL)
