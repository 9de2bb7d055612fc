// SPDX-License-Identifier: Apache-2.0
// Every metric that a machine publishes on the plant's network, one row each. The panel's values, the
// gateway's messages and docs/metrics.md follow from the rows. Names and states are those of PackML
// (ANSI/ISA-TR88.00.02) where it has one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace campanel::plant {

// The data types; the numbers are those of Sparkplug B. UInt32 is none of them: the specification has it in
// int_value, widespread decoders look for it in long_value.
enum class MetricType : std::uint8_t { Int32 = 3, Int64 = 4, Double = 10, Boolean = 11, String = 12 };

// The part that knows the value: the panel sends it over the local socket, or the gateway has it itself.
enum class MetricOwner : std::uint8_t { Panel, Gateway };

// The alias of a metric: it stands for the name in all messages after the first. An alias never changes and
// is never used again.
enum class Metric : std::uint16_t {
    UnitModeCurrent = 1,
    StateCurrent = 2,
    MachSpeed = 3,
    CurMachSpeed = 4,
    ProdProcessedCount = 5,
    ProdDefectiveCount = 6,
    StateCurrentTime = 7,
    StateCumulativeTime = 8,
    Alarm = 9,
    RecipeName = 10,
    RecipeVersion = 11,
    RecipeCrc = 12,
    RecipeGeneration = 13,
    BagDeviationMean = 14,
    BagDeviationScatter = 15,
    FilmSaved = 16,
    LinkQuality = 17,
    PanelPresent = 18,
    ValuesDropped = 19,
    Instance = 20,
    StopReason = 21,
    OrderName = 22,
    OrderLot = 23,
    OrderState = 24,
    OrderQuantity = 25,
    OrderGood = 26,
    OrderRejected = 27,
    OrderEmpty = 28,
};

struct MetricRow {
    Metric metric{};
    std::string_view name;
    MetricType type = MetricType::Int32;
    std::string_view unit = {};   // empty: none
    double deadBand = 0;          // a smaller change is not sent; 0: every change is
    std::string_view source = {}; // where the value comes from
    std::string_view text = {};   // what it means
    MetricOwner owner = MetricOwner::Panel;
};

inline constexpr std::array metricTable{
    MetricRow{.metric = Metric::UnitModeCurrent,
              .name = "Status/UnitModeCurrent",
              .source = "`Controller.state`",
              .text = "PackML mode: 1 Production, 3 Manual while a person jogs the axis."},
    MetricRow{.metric = Metric::StateCurrent,
              .name = "Status/StateCurrent",
              .source = "`Controller.state`, `Controller.packing`",
              .text = "PackML state; see below."},
    MetricRow{.metric = Metric::MachSpeed,
              .name = "Status/MachSpeed",
              .type = MetricType::Double,
              .unit = "bags/min",
              .source = "`Controller.active.rateBagsPerMin`",
              .text = "Set rate of the active program."},
    MetricRow{.metric = Metric::CurMachSpeed,
              .name = "Status/CurMachSpeed",
              .type = MetricType::Double,
              .unit = "bags/min",
              .deadBand = 0.5,
              .source = "`Controller.live.rateBagsPerMin`",
              .text = "Present rate."},
    MetricRow{.metric = Metric::ProdProcessedCount,
              .name = "Admin/ProdProcessedCount",
              .type = MetricType::Int64,
              .unit = "bags",
              .source = "`Controller.bags.count`",
              .text = "Bags since the controller was switched on."},
    MetricRow{
        .metric = Metric::ProdDefectiveCount,
        .name = "Admin/ProdDefectiveCount",
        .type = MetricType::Int64,
        .unit = "bags",
        .source = "`PackingLine::bagRecorded`",
        .text =
            "Bags since the panel was started that were start-up scrap, of two programs, at jaws "
            "that stood or jammed, or outside the tolerance. Null until the controller has recorded a bag."},
    MetricRow{.metric = Metric::StateCurrentTime,
              .name = "Admin/StateCurrentTime",
              .unit = "s",
              .deadBand = 10,
              .source = "the panel's steady clock",
              .text = "Time in the present mode and state."},
    MetricRow{.metric = Metric::StateCumulativeTime,
              .name = "Admin/StateCumulativeTime",
              .unit = "s",
              .deadBand = 10,
              .source = "the panel's steady clock",
              .text =
                  "Time in the present mode and state since the panel was started, all periods together."},
    MetricRow{.metric = Metric::Alarm,
              .name = "Admin/Alarm",
              .type = MetricType::String,
              .source = "`Alarms.urgentCode`",
              .text = "Code of the most urgent active alarm, such as C-03; an empty text without one."},
    MetricRow{.metric = Metric::RecipeName,
              .name = "CamPanel/Recipe/Name",
              .type = MetricType::String,
              .source = "`Controller.active.name`",
              .text = "Name of the program that the controller has."},
    MetricRow{.metric = Metric::RecipeVersion,
              .name = "CamPanel/Recipe/Version",
              .type = MetricType::Int64,
              .source = "`Controller.active.version`",
              .text = "Version of its recipe."},
    MetricRow{.metric = Metric::RecipeCrc,
              .name = "CamPanel/Recipe/CRC-32",
              .type = MetricType::Int64,
              .source = "status block, `active_crc`",
              .text = "CRC-32 of the active program, computed by the controller."},
    MetricRow{.metric = Metric::RecipeGeneration,
              .name = "CamPanel/Recipe/Generation",
              .type = MetricType::Int64,
              .source = "status block, `generation`",
              .text = "Number of programs that the controller has activated."},
    MetricRow{.metric = Metric::BagDeviationMean,
              .name = "CamPanel/Bag/DeviationMean",
              .type = MetricType::Double,
              .unit = "mm",
              .deadBand = 0.01,
              .source = "`Controller.bags.meanDeviationMm`",
              .text = "Mean deviation of the last 60 bags from the set length."},
    MetricRow{.metric = Metric::BagDeviationScatter,
              .name = "CamPanel/Bag/DeviationScatter",
              .type = MetricType::Double,
              .unit = "mm",
              .deadBand = 0.01,
              .source = "`Controller.bags.scatterMm`",
              .text = "Standard deviation of the last 60 bags."},
    MetricRow{.metric = Metric::FilmSaved,
              .name = "CamPanel/Film/Saved",
              .type = MetricType::Double,
              .unit = "m",
              .deadBand = 0.1,
              .source = "`Controller.packing.filmSavedM`",
              .text = "Film that was not fed because no product came, since the controller was switched on."},
    MetricRow{.metric = Metric::LinkQuality,
              .name = "CamPanel/Link/Quality",
              .source = "`Controller.linkQuality`",
              .text =
                  "Line between panel and controller: 4 no failure, 3 below 1 %, 2 below 5 %, 1 more, 0 no "
                  "connection."},
    MetricRow{.metric = Metric::PanelPresent,
              .name = "CamPanel/Gateway/PanelPresent",
              .type = MetricType::Boolean,
              .source = "local socket",
              .text = "True while the panel answers; false at most 2 s after it has stopped.",
              .owner = MetricOwner::Gateway},
    MetricRow{.metric = Metric::ValuesDropped,
              .name = "CamPanel/Gateway/ValuesDropped",
              .type = MetricType::Int64,
              .source = "ring of the gateway",
              .text = "Oldest values dropped since the gateway was started, because the broker was away too "
                      "long.",
              .owner = MetricOwner::Gateway},
    MetricRow{.metric = Metric::Instance,
              .name = "CamPanel/Gateway/Instance",
              .type = MetricType::String,
              .source = "random number",
              .text = "Changes with each start of the gateway. Two gateways with the same node name find one "
                      "another by it.",
              .owner = MetricOwner::Gateway},
    MetricRow{.metric = Metric::StopReason,
              .name = "Admin/StopReason",
              .type = MetricType::String,
              .source = "`Stops.reason`",
              .text =
                  "Reason of the present stop: a key of the list of reasons, such as `material/film_change`, "
                  "the name of an own one, or the code of an alarm. An empty text while the machine "
                  "produces, and until a reason is known."},
    MetricRow{.metric = Metric::OrderName,
              .name = "CamPanel/Order/Name",
              .type = MetricType::String,
              .source = "`Orders.current`",
              .text =
                  "Text of the order that the controller counts, or of the last one. Null without one, as "
                  "all metrics of the order."},
    MetricRow{.metric = Metric::OrderLot,
              .name = "CamPanel/Order/Lot",
              .type = MetricType::String,
              .source = "`Orders.current`",
              .text = "Its lot."},
    MetricRow{.metric = Metric::OrderState,
              .name = "CamPanel/Order/State",
              .type = MetricType::String,
              .source = "`Orders.current`",
              .text = "One of `under_way`, `complete`, `ended`, `lost`."},
    MetricRow{.metric = Metric::OrderQuantity,
              .name = "CamPanel/Order/Quantity",
              .type = MetricType::Int64,
              .unit = "bags",
              .source = "`Orders.current`",
              .text = "Good bags to make."},
    MetricRow{.metric = Metric::OrderGood,
              .name = "CamPanel/Order/Good",
              .type = MetricType::Int64,
              .unit = "bags",
              .source = "`Orders.current`",
              .text = "Good bags."},
    MetricRow{.metric = Metric::OrderRejected,
              .name = "CamPanel/Order/Rejected",
              .type = MetricType::Int64,
              .unit = "bags",
              .source = "`Orders.current`",
              .text = "Rejected bags."},
    MetricRow{.metric = Metric::OrderEmpty,
              .name = "CamPanel/Order/Empty",
              .type = MetricType::Int64,
              .unit = "bags",
              .source = "`Orders.current`",
              .text = "Bags that were cut without a product."},
};

inline constexpr std::size_t metricCount = metricTable.size();

// Returns the place of a metric in the table.
[[nodiscard]] constexpr std::size_t metricIndex(Metric metric)
{
    return static_cast<std::size_t>(metric) - 1;
}

// Returns true when the aliases are 1, 2, 3 and so on, in the order of the table.
[[nodiscard]] constexpr bool areAliasesInOrder()
{
    for (std::size_t i = 0; i < metricCount; ++i) {
        if (metricIndex(metricTable[i].metric) != i)
            return false;
    }
    return true;
}
static_assert(areAliasesInOrder());

[[nodiscard]] constexpr const MetricRow& metricRow(Metric metric)
{
    return metricTable[metricIndex(metric)];
}

// The states of PackML that a machine can have, and the state of the controller that each one stands for.
struct PackmlState {
    int code = 0;
    std::string_view name;
    std::string_view controller;
};

inline constexpr std::array packmlStates{
    PackmlState{2, "Stopped", "Idle: no program, or not ready"},
    PackmlState{4, "Idle", "Ready"},
    PackmlState{5, "Suspended", "Running, and the film waits for a product"},
    PackmlState{6, "Execute", "Running; Jogging, with mode 3 Manual"},
    PackmlState{7, "Stopping", "Stopping"},
    PackmlState{9, "Aborted", "Fault"},
    PackmlState{15, "Resetting", "Homing"},
};

} // namespace campanel::plant
