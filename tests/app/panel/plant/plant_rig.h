// SPDX-License-Identifier: Apache-2.0
// An AccessRig with the stops of the machine: all that the plant's network hears of.
#pragma once

#include "app/panel/orders/orders.h"
#include "app/panel/plant/plant_feed.h"
#include "app/panel/stops/stops.h"
#include "tests/app/panel/access_rig.h"

namespace campanel::test {

struct PlantRig : AccessRig {
    panel::Stops stops{machine, settings, records, nullptr};
    panel::Orders orders{machine, records, nullptr};
    panel::PlantSources sources{machine, alarms, stops, orders};

    PlantRig() { settle(); }
};

} // namespace campanel::test
