// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/mark_setup.h"

#include "app/panel/controller/controller.h"

#include <algorithm>

namespace campanel::panel {

MarkSetup::MarkSetup(Controller& machine)
    : m_machine(machine)
{
    connect(&machine, &Controller::parameterEnded, this, &MarkSetup::takeOutcome);
}

void MarkSetup::ask()
{
    for (Entry& entry : m_entries) {
        if (!entry.isCertain && !entry.isMissing && entry.readId == 0)
            entry.readId = m_machine.readParameter(entry.name);
    }
}

void MarkSetup::forget()
{
    for (Entry& entry : m_entries)
        entry = Entry{entry.name};
    emit changed();
}

void MarkSetup::doubt()
{
    for (Entry& entry : m_entries) {
        entry.isCertain = entry.isMissing = false;
        entry.readId = 0;
    }
}

// Uses also the readings and writes of others: the value is proven by reading in any case.
void MarkSetup::takeOutcome(const link::ParameterOutcome& outcome)
{
    const auto entry = std::ranges::find_if(
        m_entries, [&outcome](const Entry& candidate) { return candidate.name == outcome.name; });
    if (entry == m_entries.end())
        return;
    const bool isOwn = outcome.id == entry->readId;
    if (isOwn)
        entry->readId = 0;
    if (outcome.end == link::ParameterEnd::Done && outcome.value) {
        entry->value = outcome.value;
        entry->isCertain = true;
        emit changed();
    } else if (isOwn) {
        entry->isMissing = outcome.end == link::ParameterEnd::Refused;
    } else if (outcome.end == link::ParameterEnd::OutcomeUnknown) {
        entry->isCertain = false; // possibly written
    }
}

} // namespace campanel::panel
