// SPDX-License-Identifier: Apache-2.0
#include "app/link/link.h"

namespace campanel::link {

Link::Link(QObject* parent)
    : LinkEvents(parent)
{
    connect(this, &Link::commandEnded, this,
            [this](const CommandOutcome& outcome) { deliver(m_commands, outcome.id, outcome); });
    connect(this, &Link::parameterEnded, this,
            [this](const ParameterOutcome& outcome) { deliver(m_parameters, outcome.id, outcome); });
    connect(this, &Link::registersRead, this,
            [this](const ReadOutcome& outcome) { deliver(m_reads, outcome.request.id, outcome); });
}

void Link::request(CommandRequest request, const Reply<CommandOutcome>& reply)
{
    if (request.id == 0)
        request.id = nextId();
    if (reply.context)
        m_commands.insert(request.id, reply);
    sendCommand(request);
}

void Link::exchange(ParameterRequest request, const Reply<ParameterOutcome>& reply)
{
    if (request.id == 0)
        request.id = nextId();
    if (reply.context)
        m_parameters.insert(request.id, reply);
    sendParameter(request);
}

void Link::readRegisters(ReadRequest request, const Reply<ReadOutcome>& reply)
{
    if (request.id == 0)
        request.id = nextId();
    if (reply.context)
        m_reads.insert(request.id, reply);
    sendRead(request);
}

} // namespace campanel::link
