#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds campanel-gateway against two decoders that are not ours: mqtt-spb-wrapper (PyPI) and sparkplug-payload (npm).

foreign_decoders.py BIN FOLDER SECONDS: runs mosquitto, a simulated machine that makes bags, its panel and the gateway of the folder BIN, and
records for SECONDS what mosquitto_sub hears; a rebirth is asked for by mqtt-spb-wrapper's encoder. Both decoders must read the same from each
message, with the names, types and units of docs/metrics.md. FOLDER keeps the installed decoders. Exit code 77: they cannot be installed."""

import json
import os
import re
import shutil
import subprocess
import sys
import time
import venv

import plant

HERE = os.path.dirname(os.path.abspath(__file__))
PYTHON_PACKAGES = ["mqtt-spb-wrapper==2.1.2"]
NODE_PACKAGE = "sparkplug-payload@1.0.3"
BY_PYTHON = """
import json, sys
from mqtt_spb_wrapper import SpbPayloadParser
from mqtt_spb_wrapper.spb_protobuf import MetricDataType
for line in sys.stdin:
    payload = SpbPayloadParser(bytes.fromhex(line.strip())).payload
    metrics = [{"name": m.get("name"), "alias": int(m["alias"]) if "alias" in m else None, "timestamp": int(m["timestamp"]),
                "type": m.get("datatype"), "value": m.get("value"), "isHistorical": m.get("isHistorical", False),
                "isNull": m.get("isNull", False)} for m in payload.get("metrics", [])]
    print(json.dumps({"seq": int(payload["seq"]) if "seq" in payload else None, "metrics": metrics}))
"""
REBIRTH = """
from mqtt_spb_wrapper.spb_protobuf import getDdataPayload, addMetric, MetricDataType
import sys
payload = getDdataPayload()
addMetric(payload, "Node Control/Rebirth", None, MetricDataType.Boolean, True)
sys.stdout.write(payload.SerializeToString().hex())
"""
TYPES = {3: "Int32", 4: "Int64", 10: "Double", 11: "Boolean", 12: "String"}


def install(folder):
    """Returns the Python that has the decoder, and the folder of the Node modules."""
    if not shutil.which("npm") or not shutil.which("node"):
        print("npm and node are not installed")
        sys.exit(77)
    python = os.path.join(folder, "venv", "bin", "python")
    if not os.path.exists(python):
        venv.create(os.path.join(folder, "venv"), with_pip=True)
    steps = [[python, "-m", "pip", "install", "-q", *PYTHON_PACKAGES],
             ["npm", "install", "--silent", "--prefix", folder, NODE_PACKAGE]]
    for step in steps:
        if subprocess.run(step, stdout=subprocess.DEVNULL).returncode != 0:
            print("cannot be installed:", " ".join(step))
            sys.exit(77)
    return python, os.path.join(folder, "node_modules")


def metrics_of_document():
    """Returns alias -> (name, type, unit), from docs/metrics.md."""
    with open(os.path.join(HERE, "..", "..", "docs", "metrics.md"), encoding="utf-8") as file:
        rows = re.findall(r"^\| (\d+) \| `([^`]+)` \| (\w+) \| ([^|]*?) ?\|", file.read(), re.MULTILINE)
    return {int(alias): (name, kind, unit.strip() or None) for alias, name, kind, unit in rows}


def record(binaries, python, seconds):
    """Runs everything, and returns the messages as (type, hex)."""
    rebirth = bytes.fromhex(subprocess.check_output([python, "-c", REBIRTH], text=True))
    with plant.Plant(binaries) as hall, open(hall.path("heard"), "w+", encoding="utf-8") as heard:
        hall.subscribe(heard)
        hall.start_machine()
        hall.start_panel("--config", hall.config)
        gateway = hall.start_gateway()
        time.sleep(seconds)
        subprocess.run(["mosquitto_pub", "-h", "127.0.0.1", "-p", hall.port, "-t", f"spBv1.0/Hall/NCMD/{plant.NODE}", "-s"], input=rebirth, check=True)
        time.sleep(2)
        gateway.kill()
        time.sleep(1)
        heard.seek(0)
        lines = [line.split() for line in heard]
    return [(topic.split("/")[2], data) for topic, data in lines if not topic.split("/")[2].endswith("CMD")]


def decoded(command, messages, environment=None):
    text = "".join(data + "\n" for _, data in messages)
    out = subprocess.run(command, input=text, text=True, stdout=subprocess.PIPE, check=True, env=environment).stdout
    return [json.loads(line) for line in out.splitlines()]


def compare(messages, by_python, by_node):
    """Returns the number of values. Fails on the first difference."""
    table = metrics_of_document()
    values = 0
    assert len(messages) == len(by_python) == len(by_node)
    next_seq = None
    for (kind, _), one, other in zip(messages, by_python, by_node):
        assert one["seq"] == other["seq"] and len(one["metrics"]) == len(other["metrics"])
        if kind != "NDEATH":
            assert one["seq"] == (0 if kind == "NBIRTH" else next_seq), (kind, one["seq"], next_seq)
            next_seq = (one["seq"] + 1) % 256
        for a, b in zip(one["metrics"], other["metrics"]):
            for key in ("name", "alias", "timestamp", "isHistorical"):
                assert a[key] == b[key], (key, a, b)
            assert TYPES[a["type"]] == b["type"], (a, b)
            assert a["isNull"] == (b["value"] is None), (a, b)
            assert a["isNull"] or a["value"] == b["value"], (a, b)
            if a["alias"] is not None:
                name, kind_of_value, unit = table[a["alias"]]
                assert kind_of_value == b["type"], (a, b)
                assert kind != "NBIRTH" or (a["name"], b["unit"]) == (name, unit), (a, b)
            values += 1
        assert kind != "NBIRTH" or {m["alias"] for m in one["metrics"] if m["alias"]} == set(table)
    return values


def main():
    binaries, folder, seconds = sys.argv[1], sys.argv[2], float(sys.argv[3])
    os.makedirs(folder, exist_ok=True)
    python, modules = install(folder)
    messages = record(binaries, python, seconds)
    by_python = decoded([python, "-c", BY_PYTHON], messages)
    by_node = decoded(["node", os.path.join(HERE, "decode_by_node.js")], messages, os.environ | {"NODE_PATH": modules})
    values = compare(messages, by_python, by_node)
    kinds = [kind for kind, _ in messages]
    assert kinds.count("NBIRTH") == 2 and kinds.count("NDEATH") == 1 and kinds.count("NDATA") >= 2, kinds
    known = {m["alias"] for message in by_node for m in message["metrics"] if m["alias"] and m["value"] is not None}
    assert known >= {1, 2, 3, 4, 5, 7, 8, 9, 10, 11, 12, 13, 17, 18, 19, 20}, known  # what a machine that runs has
    print(f"{len(messages)} messages, {values} values: {PYTHON_PACKAGES[0]} and {NODE_PACKAGE} read the same; a rebirth encoded by the former was answered")


if __name__ == "__main__":
    main()
