// SPDX-License-Identifier: Apache-2.0
// campanelctl start, stop, home and save: one command to the controller each.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/link_session.h"

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

Outcome give(const Invocation& call, modbus::Command code, const char* done, std::uint16_t permit = 0)
{
    auto session = LinkSession::open(call);
    if (!session)
        return tl::unexpected(session.error());
    session->setPermit(permit);
    if (const Outcome given = session->command(code); !given)
        return given;
    return call.deliver(QByteArray(done) + '\n');
}

Outcome giveWithPermit(const Invocation& call, modbus::Command code, const char* done)
{
    const auto permit = permitOf(call);
    return permit ? give(call, code, done, *permit) : tl::unexpected(permit.error());
}

} // namespace

Outcome runStart(const Invocation& call)
{
    return giveWithPermit(call, modbus::Command::Start, "Started.");
}

Outcome runStop(const Invocation& call)
{
    if (call.isSet(u"now"_s))
        return give(call, modbus::Command::StopNow, "Stopping now.");
    return give(call, modbus::Command::StopAtCycleEnd, "Stopping at the end of the cycle.");
}

Outcome runHome(const Invocation& call)
{
    return giveWithPermit(call, modbus::Command::Home, "Homing.");
}

Outcome runSave(const Invocation& call)
{
    auto session = LinkSession::open(call);
    if (!session)
        return tl::unexpected(session.error());
    const auto before = session->status();
    if (!before)
        return tl::unexpected(before.error());
    if (!before->activeCrc)
        return fail(ExitCode::Refused,
                    u"The controller has no active program to save. Download a program first."_s);
    if (const Outcome saved = session->command(modbus::Command::SaveToFlash, {0, 0, *before->activeCrc});
        !saved)
        return saved;
    const auto after = session->status();
    if (!after)
        return tl::unexpected(after.error());
    if (after->savedCrc != before->activeCrc)
        return fail(ExitCode::Refused, u"The saved program differs from the active program. Save again."_s);
    return call.deliver("Saved.\n");
}

} // namespace campanel::cli
