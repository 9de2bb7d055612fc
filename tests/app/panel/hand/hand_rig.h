// SPDX-License-Identifier: Apache-2.0
// An AccessRig with a controller that answers what is asked of its registers.
#pragma once

#include "tests/app/panel/access_rig.h"

#include <QList>

#include <map>
#include <string>

namespace campanel::test {

struct HandRig : AccessRig {
    std::map<std::string, double> registers{{"hand.speed", 100}, {"master.source", 0}};
    int mapMinor = modbus::mapMinor;

    void connectRunning()
    {
        link::LinkReport report;
        report.state = link::LinkState::Connected;
        report.identity = FakeLink::identity();
        report.identity->mapMinor = static_cast<std::uint16_t>(mapMinor);
        emit link.reported(report);
        link.activate(image(), now);
        become(modbus::State::Running);
    }
    void become(modbus::State state)
    {
        link.status.state = state;
        link.sendStatus(now);
        answer();
    }
    // Answers what was asked since, as the controller would, or ends it so.
    void answer(link::ParameterEnd end = link::ParameterEnd::Done)
    {
        for (; m_answered < link.parameters.size(); ++m_answered) {
            const link::ParameterRequest request = link.parameters[m_answered];
            if (request.value && end == link::ParameterEnd::Done)
                registers[request.name] = *request.value;
            const auto found = registers.find(request.name);
            emit link.parameterEnded(
                {request.id,
                 request.name,
                 request.value ? end : link::ParameterEnd::Done,
                 found != registers.end() ? found->second : modbus::findRegister(request.name)->defaultValue,
                 {}});
        }
    }
    // Returns the values written to the register, in their order.
    [[nodiscard]] QList<double> written(const std::string& name) const
    {
        QList<double> values;
        for (const link::ParameterRequest& request : link.parameters) {
            if (request.name == name && request.value)
                values << *request.value;
        }
        return values;
    }

private:
    qsizetype m_answered = 0;
};

} // namespace campanel::test
