// SPDX-License-Identifier: Apache-2.0
// Decodes payloads by sparkplug-payload, a program that is not ours: one in hex a line from stdin, one JSON a line to stdout.
const sparkplug = require("sparkplug-payload").get("spBv1.0");
const lines = require("readline").createInterface({ input: process.stdin });
const plain = (value) => (value !== null && typeof value === "object" && "low" in value ? Number(value.toString()) : value);
lines.on("line", (line) => {
    const payload = sparkplug.decodePayload(Buffer.from(line, "hex"));
    const metrics = payload.metrics.map((metric) => ({
        name: metric.name || null,
        alias: metric.alias === undefined ? null : Number(metric.alias),
        timestamp: Number(metric.timestamp),
        type: metric.type,
        value: metric.value === undefined ? null : plain(metric.value),
        isHistorical: metric.isHistorical === true,
        unit: metric.properties && metric.properties.engUnit ? metric.properties.engUnit.value : null,
    }));
    console.log(JSON.stringify({ seq: payload.seq === undefined ? null : Number(payload.seq), metrics }));
});
