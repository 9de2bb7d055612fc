// SPDX-License-Identifier: Apache-2.0
#include "app/machine/engine_instances.h"

#include "app/machine/editor.h"
#include "app/machine/machine.h"
#include "app/machine/records.h"
#include "app/machine/service.h"
#include "app/machine/settings.h"

namespace campanel::machine {

void attachToEngine(QQmlEngine& engine, Machine& machine, Editor& editor, Records& records,
                    Service& service, Settings& settings)
{
    engine.setProperty(instanceKey<Machine>(), QVariant::fromValue(&machine));
    engine.setProperty(instanceKey<Editor>(), QVariant::fromValue(&editor));
    engine.setProperty(instanceKey<Records>(), QVariant::fromValue(&records));
    engine.setProperty(instanceKey<Service>(), QVariant::fromValue(&service));
    engine.setProperty(instanceKey<Settings>(), QVariant::fromValue(&settings));
}

} // namespace campanel::machine
