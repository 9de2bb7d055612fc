// SPDX-License-Identifier: Apache-2.0
#include "app/machine/machine.h"

#include "app/machine/engine_instances.h"

namespace campanel::machine {

Machine::Machine(QObject* parent)
    : QObject(parent)
{
}

Machine* Machine::create(QQmlEngine* qmlEngine, QJSEngine*)
{
    return attachedInstance<Machine>(qmlEngine);
}

void Machine::start() {}
void Machine::stop() {}
void Machine::stopNow() {}
void Machine::home() {}
void Machine::resetFault() {}
void Machine::dismissMessage() {}

} // namespace campanel::machine
