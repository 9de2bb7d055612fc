// SPDX-License-Identifier: Apache-2.0
// campanelctl start, stop, home, jog-bag, cut, take, save and output: commands to the controller.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/link_session.h"
#include "app/cli/report.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::cli {
namespace {

Outcome give(const Invocation& call, modbus::Command code, const char* done, std::uint16_t permit = 0,
             std::uint16_t minor = 0)
{
    auto session = LinkSession::open(call);
    if (!session)
        return tl::unexpected(session.error());
    if (session->identity().mapMinor < minor)
        return fail(ExitCode::Refused,
                    panel::ConnectionSentences::refused(code, modbus::Refusal::UnknownCommand));
    session->setPermit(permit);
    if (const Outcome given = session->command(code); !given)
        return given;
    return call.deliver(QByteArray(done) + '\n');
}

Outcome giveWithPermit(const Invocation& call, modbus::Command code, const char* done,
                       std::uint16_t minor = 0)
{
    const auto permit = permitOf(call);
    return permit ? give(call, code, done, *permit, minor) : tl::unexpected(permit.error());
}

// Within the 500 ms after which the controller switches the output off.
constexpr auto tryPeriod = 150ms;
constexpr double longestTryS = 60;
constexpr double msPerS = 1000;

QStringList outputNames()
{
    QStringList names;
    for (const modbus::EnumValue& output : modbus::outputRows)
        names << fromView(output.name);
    return names;
}

tl::expected<double, Failure> secondsOf(const Invocation& call)
{
    bool isNumber = false;
    const double seconds = call.value(u"seconds"_s).toDouble(&isNumber);
    if (!isNumber || !(seconds > 0) || seconds > longestTryS)
        return fail(ExitCode::Usage, u"--seconds takes a number above 0, up to 60."_s);
    return seconds;
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

Outcome runJogBag(const Invocation& call)
{
    return giveWithPermit(call, modbus::Command::JogBag, "Making one bag.", modbus::bagsByHandMapMinor);
}

Outcome runCut(const Invocation& call)
{
    return giveWithPermit(call, modbus::Command::SingleCut, "Cutting once.", modbus::bagsByHandMapMinor);
}

Outcome runTake(const Invocation& call)
{
    return give(call, modbus::Command::TakeBag, "The next bag will be rejected.", 0,
                modbus::bagsByHandMapMinor);
}

Outcome runAcknowledge(const Invocation& call)
{
    return give(call, modbus::Command::Acknowledge, "Acknowledged.");
}

Outcome runOutput(const Invocation& call)
{
    const QStringList names = call.arguments();
    const auto row = std::ranges::find_if(modbus::outputRows, [&names](const modbus::EnumValue& output) {
        return names.value(0).compare(fromView(output.name), Qt::CaseInsensitive) == 0;
    });
    if (names.size() != 1 || row == modbus::outputRows.end())
        return fail(ExitCode::Usage, u"Name one output: %1."_s.arg(outputNames().join(u", "_s)));
    const auto seconds = secondsOf(call);
    if (!seconds)
        return tl::unexpected(seconds.error());
    const auto permit = permitOf(call);
    if (!permit)
        return tl::unexpected(permit.error());
    auto session = LinkSession::open(call);
    if (!session)
        return tl::unexpected(session.error());
    const bool isLater = row->value >= static_cast<std::int64_t>(modbus::OutputBit::Ready);
    if (session->identity().mapMinor < modbus::tryOutputMapMinor ||
        (isLater && !session->identity().hasRegister("io.more_outputs")))
        return fail(ExitCode::Refused, panel::ConnectionSentences::refused(modbus::Command::TryOutput,
                                                                           modbus::Refusal::UnknownCommand));
    session->setPermit(*permit);
    const auto end =
        std::chrono::steady_clock::now() + std::chrono::milliseconds(std::llround(msPerS * *seconds));
    while (std::chrono::steady_clock::now() < end) {
        if (const Outcome on = session->command(modbus::Command::TryOutput, {row->value, 1, 0}); !on)
            return on;
        std::this_thread::sleep_until(std::min(end, std::chrono::steady_clock::now() + tryPeriod));
    }
    if (const Outcome off = session->command(modbus::Command::TryOutput, {row->value, 0, 0}); !off)
        return off;
    return call.deliver((fromView(row->name) + u" was on for %1 s.\n"_s.arg(*seconds)).toUtf8());
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
