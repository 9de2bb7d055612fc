// SPDX-License-Identifier: Apache-2.0
#include "app/plant/metric_document.h"

#include "app/plant/metric_table.h"

#include <sstream>

namespace campanel::plant {

namespace {

const char* nameOf(MetricType type)
{
    switch (type) {
    case MetricType::Int32:
        return "Int32";
    case MetricType::Int64:
        return "Int64";
    case MetricType::Double:
        return "Double";
    case MetricType::Boolean:
        return "Boolean";
    case MetricType::String:
        break;
    }
    return "String";
}

constexpr const char* preface = R"(# Metrics

What `campanel-gateway` publishes, by MQTT Sparkplug B 3.0. This page is generated from `app/plant/metric_table.h` by
`campanel-generate-metrics`; a test holds it against the table. How the gateway behaves is in [plant.md](plant.md).

| topic | when |
|---|---|
| `spBv1.0/GROUP/NBIRTH/NODE` | after each connection and each rebirth: every metric below, with name, alias, type and unit |
| `spBv1.0/GROUP/NDATA/NODE` | changes, by alias alone |
| `spBv1.0/GROUP/NDEATH/NODE` | the gateway has ended or is cut off; its `bdSeq` is that of the NBIRTH |
| `spBv1.0/GROUP/NCMD/NODE` | received: only `Node Control/Rebirth` is answered |
| `campanel/GROUP/rebirth` | received: any message asks all machines of the group for an NBIRTH, as `campanelctl fleet` does |
| `campanel/GROUP/recipes/NAME` | received: a signed recipe that the plant offers, retained; an empty message withdraws it |

A value that is not known or not fresh is null. Values that were measured while the broker was away come later, as historical.
NBIRTH has two metrics more: `bdSeq` (Int64) and `Node Control/Rebirth` (Boolean), the only one that takes a value.

| alias | name | type | unit | dead band | source | meaning |
|---:|---|---|---|---:|---|---|
)";

constexpr const char* statesPreface = R"(
## States

| `Status/StateCurrent` | PackML | state of the controller |
|---:|---|---|
)";

} // namespace

std::string metricsMarkdown()
{
    std::ostringstream out;
    out << preface;
    for (const MetricRow& row : metricTable) {
        out << "| " << static_cast<int>(row.metric) << " | `" << row.name << "` | " << nameOf(row.type)
            << " | " << row.unit << " | ";
        if (row.deadBand > 0)
            out << row.deadBand;
        out << " | " << row.source << " | " << row.text << " |\n";
    }
    out << statesPreface;
    for (const PackmlState& state : packmlStates)
        out << "| " << state.code << " | " << state.name << " | " << state.controller << " |\n";
    return out.str();
}

} // namespace campanel::plant
