#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints what a host sees of all machines at a broker: plant_view.py HOST PORT. Decoded by mqtt-spb-wrapper, a
program that is not ours; it and paho-mqtt come from PyPI."""

import sys
import time

import paho.mqtt.client as mqtt
from mqtt_spb_wrapper import SpbPayloadParser

SHOWN = ["Status/StateCurrent", "Status/CurMachSpeed", "Admin/ProdProcessedCount", "CamPanel/Recipe/Name", "Admin/Alarm"]


class Plant:
    """The last value of each metric of each node, by its name."""

    def __init__(self):
        self.nodes = {}
        self.names = {}

    def take(self, topic, data):
        words = topic.split("/")
        if len(words) != 4 or words[2] not in ("NBIRTH", "NDATA", "NDEATH"):
            return
        node = words[3]
        if words[2] == "NDEATH":
            self.nodes[node] = None
            return
        for metric in (SpbPayloadParser(data).payload or {}).get("metrics", []):
            alias = int(metric["alias"]) if "alias" in metric else None
            if "name" in metric:
                self.names[node, alias] = metric["name"]
            if not metric.get("isHistorical"):
                self.nodes[node] = self.nodes.get(node) or {}
                self.nodes[node][self.names.get((node, alias))] = metric.get("value")

    def text(self):
        lines = ["node".ljust(16) + "".join(name.split("/")[-1].ljust(20) for name in SHOWN)]
        for node, values in sorted(self.nodes.items()):
            row = "offline" if values is None else "".join(str(values.get(name)).ljust(20) for name in SHOWN)
            lines.append(node.ljust(16) + row)
        return "\n".join(lines)


def main():
    host, port = sys.argv[1], int(sys.argv[2])
    plant = Plant()
    client = mqtt.Client(client_id=f"view-{time.time_ns()}")
    client.on_connect = lambda client, *_: client.subscribe("spBv1.0/#")
    client.on_message = lambda _client, _data, message: plant.take(message.topic, message.payload)
    client.connect(host, port)
    client.loop_start()
    while True:
        time.sleep(1)
        print("\033[H\033[J" + plant.text(), flush=True)


if __name__ == "__main__":
    main()
