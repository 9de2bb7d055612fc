#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Brings a machine's values into victoria-metrics (Debian's package), and proves that its history has no gap when the broker was away.

into_victoria_metrics.py BIN SECONDS, run by a Python that has mqtt-spb-wrapper and paho-mqtt, as foreign_decoders.py installs it. The bridge
below is also an example of how a historian is fed. A replayed value has the time when it was measured."""

import json
import os
import subprocess
import sys
import tempfile
import threading
import time
import urllib.parse
import urllib.request

import paho.mqtt.client as mqtt
from mqtt_spb_wrapper import SpbPayloadParser

import plant


class Bridge:
    """Writes every numeric sample as a line of the InfluxDB protocol: metric,node=... value=... time."""

    def __init__(self, url):
        self.url = url
        self.names = {}

    def take(self, topic, data):
        _, _, kind, node = topic.split("/")[:4]
        if kind not in ("NBIRTH", "NDATA"):
            return
        lines = []
        for metric in (SpbPayloadParser(data).payload or {}).get("metrics", []):
            alias = int(metric["alias"]) if "alias" in metric else None
            if "name" in metric:
                self.names[node, alias] = metric["name"]
            name, value = self.names.get((node, alias)), metric.get("value")
            if name and isinstance(value, (int, float)) and not isinstance(value, bool):
                lines.append(f"{name.replace(' ', '_')},node={node} value={value} {int(metric['timestamp']) * 1_000_000}")
        if lines:
            urllib.request.urlopen(self.url + "/write", data="\n".join(lines).encode()).close()


def history(url, name):
    """Returns the samples of a metric in the order of time."""
    match = urllib.parse.quote('{__name__="%s"}' % name)
    with urllib.request.urlopen(f"{url}/api/v1/export?match[]={match}") as answer:
        samples = [pair for line in answer for row in [json.loads(line)] for pair in zip(row["timestamps"], row["values"])]
    return [value for _, value in sorted(set(samples))]


def main():
    binaries, seconds = sys.argv[1], float(sys.argv[2])
    with tempfile.TemporaryDirectory() as storage, plant.Plant(binaries) as hall:
        port = plant.free_port()
        url = f"http://127.0.0.1:{port}"
        hall.start("victoria-metrics", f"-storageDataPath={storage}", f"-httpListenAddr=127.0.0.1:{port}", stderr=subprocess.DEVNULL)
        time.sleep(2)
        bridge = Bridge(url)
        client = mqtt.Client()
        client.on_connect = lambda one, *_: one.subscribe("spBv1.0/#")
        client.on_message = lambda _one, _data, message: bridge.take(message.topic, message.payload)
        client.reconnect_delay_set(0.05, 0.1)  # before the gateway, which waits half a second at least
        client.connect("127.0.0.1", int(hall.port))
        client.loop_start()
        hall.start_machine()
        hall.start_panel("--config", hall.config)
        hall.start_gateway()
        time.sleep(seconds / 2)
        broker = hall.processes[0]
        broker.kill()
        broker.wait()
        time.sleep(seconds / 4)
        hall.start("mosquitto", "-c", hall.path("mosquitto.conf"), stderr=subprocess.DEVNULL)
        time.sleep(max(seconds / 4, 12))
        client.loop_stop()
        urllib.request.urlopen(url + "/internal/force_flush").close()
        bags = history(url, "Admin/ProdProcessedCount_value")
    steps = [b - a for a, b in zip(bags, bags[1:])]
    print(f"{len(bags)} samples of the bag counter, {bags[0]:.0f} to {bags[-1]:.0f}, the broker away for {seconds / 4:.0f} s; largest step {max(steps):.0f}")
    assert bags and max(steps) <= 1 and min(steps) >= 0, steps


if __name__ == "__main__":
    main()
