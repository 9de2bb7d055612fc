// SPDX-License-Identifier: Apache-2.0
// campanelctl measure: turns an axis slowly and counts its pulses, shows its direction, or finds the film per
// turn from a bag and a ruler.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/link_session.h"
#include "app/cli/report.h"
#include "app/panel/words/controller_sentences.h"
#include "modbus/map/codec.h"
#include "modbus/map/measure_status.h"

#include <array>
#include <chrono>
#include <cmath>
#include <thread>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::cli {
namespace {

using modbus::MeasuredAxis;
using modbus::MeasureState;

constexpr auto measurePause = 50ms; // the heartbeat goes on between two readings

struct MeasurableAxis {
    const char* name;
    const char* pulses; // parameter; null: in the recipe
    const char* reversed;
};

constexpr std::array measurableAxes{
    MeasurableAxis{"knife", nullptr, "signal.knife_reversed"},
    MeasurableAxis{"film", "parameter.film_pulses", "signal.film_reversed"},
    MeasurableAxis{"infeed", "parameter.flight_pulses", "signal.infeed_reversed"},
};

tl::expected<double, Failure> measuredParameter(LinkSession& session, const char* name)
{
    const modbus::RegisterInfo& info = *modbus::findRegister(name);
    const auto registers = session.client().readProven(info.address, info.count);
    if (!registers)
        return fail(registers.error());
    return modbus::RegisterReader(*registers, info.address).physical(name);
}

tl::expected<modbus::MeasureStatus, Failure> readMeasure(LinkSession& session)
{
    const auto registers = session.client().readProven(modbus::measureAddress, modbus::measureRegisters);
    if (!registers)
        return fail(registers.error());
    return modbus::decodeMeasure(*registers);
}

tl::expected<LinkSession, Failure> openMeasure(const Invocation& call)
{
    auto session = LinkSession::open(call);
    if (session && session->identity().mapMinor < modbus::measureMapMinor)
        return fail(ExitCode::Refused, panel::ConnectionSentences::refused(modbus::Command::Measure,
                                                                           modbus::Refusal::UnknownCommand));
    return session;
}

// Turns the axis until it has come to rest; the controller stops it by itself when this program ends.
tl::expected<modbus::MeasureStatus, Failure> turnAxis(LinkSession& session, std::uint16_t axis,
                                                      std::uint16_t turns)
{
    if (const Outcome begun = session.command(modbus::Command::Measure, {axis, turns, 0}); !begun)
        return tl::unexpected(begun.error());
    for (;;) {
        if (const auto alive = session.status(); !alive)
            return tl::unexpected(alive.error());
        const auto status = readMeasure(session);
        if (!status)
            return status;
        if (status->state == MeasureState::Done)
            return status;
        if (status->state == MeasureState::Ended)
            return fail(ExitCode::Refused, status->reason == modbus::Refusal::None
                                               ? u"The measurement was stopped. Nothing was changed."_s
                                               : panel::ControllerSentences::refusal(status->reason) +
                                                     u" Nothing was changed."_s);
        std::this_thread::sleep_for(measurePause);
    }
}

// Writes the value when it is to be taken, and returns the last words of the line.
tl::expected<QString, Failure> takeMeasured(const Invocation& call, LinkSession& session, const char* name,
                                            double value)
{
    if (!call.isSet(u"take"_s))
        return u", not written (--take)\n"_s;
    if (const auto written = session.client().writeParameter(*modbus::findRegister(name), value); !written)
        return fail(written.error());
    return u", written\n"_s;
}

Outcome measureTurns(const Invocation& call, LinkSession& session, std::uint16_t axis)
{
    const MeasurableAxis& each = measurableAxes[axis];
    const auto status = turnAxis(session, axis, modbus::measuredTurns);
    if (!status)
        return tl::unexpected(status.error());
    const QString counted = u"%1: %2 pulses per turn, mean of %3; the turns differ by %4"_s.arg(
        QLatin1StringView(each.name), QString::number(status->pulses, 'f', 2), QString::number(status->turns),
        QString::number(status->spread, 'f', 2));
    if (each.pulses == nullptr)
        return call.deliver(
            (counted + u"; per turn of the shaft, so divide by the gear for the recipe\n"_s).toUtf8());
    if (call.isSet(u"take"_s) && !status->areTurnsEven())
        return fail(ExitCode::Refused,
                    counted + u", which is too much. Check the index sensor. Nothing was changed."_s);
    const auto present = measuredParameter(session, each.pulses);
    if (!present)
        return tl::unexpected(present.error());
    const auto end = takeMeasured(call, session, each.pulses, std::round(status->pulses));
    if (!end)
        return tl::unexpected(end.error());
    return call.deliver((counted + u"; setting %1"_s.arg(QString::number(*present, 'f', 0)) + *end).toUtf8());
}

Outcome measureDirection(const Invocation& call, LinkSession& session, std::uint16_t axis)
{
    const MeasurableAxis& each = measurableAxes[axis];
    const auto present = measuredParameter(session, each.reversed);
    if (!present)
        return tl::unexpected(present.error());
    if (const auto status = turnAxis(session, axis, 0); !status)
        return tl::unexpected(status.error());
    return call.deliver(u"%1 has turned a quarter of a turn forward. If it went the other way: set %2 %3\n"_s
                            .arg(QLatin1StringView(each.name), QLatin1StringView(each.reversed),
                                 *present > 0 ? u"0"_s : u"1"_s)
                            .toUtf8());
}

Outcome measureFilm(const Invocation& call, LinkSession& session)
{
    bool isNumber = false;
    const double rulerMm = call.value(u"length"_s).toDouble(&isNumber);
    if (!isNumber || !(rulerMm > 0))
        return fail(ExitCode::Usage, u"Give the length of the last bag by the ruler with --length MM."_s);
    const auto status = readMeasure(session);
    const auto pulses = measuredParameter(session, "parameter.film_pulses");
    const auto feedMm = measuredParameter(session, "parameter.film_feed");
    for (const auto* each : {&pulses, &feedMm}) {
        if (!*each)
            return tl::unexpected(each->error());
    }
    if (!status)
        return tl::unexpected(status.error());
    if (!status->bagPulses)
        return fail(ExitCode::Refused,
                    u"The controller knows no bag yet. Cut two bags, then measure the second one."_s);
    const double setMm = *status->bagPulses / *pulses * *feedMm;
    if (std::abs(rulerMm / setMm - 1) > modbus::maxBagDeviation)
        return fail(ExitCode::Refused, u"Bag %1 is %2 mm long by the setting: %3 mm is another bag. Nothing "
                                       u"was changed. A setting that is "
                                       u"so far off is written with: set parameter.film_feed."_s.arg(
                                           QString::number(status->bag), QString::number(setMm, 'f', 1),
                                           call.value(u"length"_s)));
    const double newMm = *feedMm * rulerMm / setMm;
    const auto end = takeMeasured(call, session, "parameter.film_feed", newMm);
    if (!end)
        return tl::unexpected(end.error());
    return call.deliver(
        (u"film: %1 mm per turn by bag %2; setting %3 mm"_s.arg(
             QString::number(newMm, 'f', 3), QString::number(status->bag), QString::number(*feedMm, 'f', 3)) +
         *end)
            .toUtf8());
}

} // namespace

Outcome runMeasure(const Invocation& call)
{
    const QStringList arguments = call.arguments();
    const QString what = arguments.value(0);
    const bool isFilm = what == u"film" && arguments.size() == 1;
    std::uint16_t axis = 0;
    while (axis < measurableAxes.size() && arguments.value(1) != QLatin1StringView(measurableAxes[axis].name))
        ++axis;
    const bool isAxis =
        (what == u"turns" || what == u"direction") && arguments.size() == 2 && axis < measurableAxes.size();
    if (!isFilm && !isAxis)
        return fail(ExitCode::Usage,
                    u"Name what to measure: turns or direction of knife, film or infeed, or film."_s);
    const auto permit = permitOf(call);
    if (!permit)
        return tl::unexpected(permit.error());
    auto session = openMeasure(call);
    if (!session)
        return tl::unexpected(session.error());
    session->setPermit(*permit);
    if (isFilm)
        return measureFilm(call, *session);
    return what == u"turns" ? measureTurns(call, *session, axis) : measureDirection(call, *session, axis);
}

} // namespace campanel::cli
