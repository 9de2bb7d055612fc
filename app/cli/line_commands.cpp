// SPDX-License-Identifier: Apache-2.0
// campanelctl link and frames: the traffic on the line during status exchanges, as figures or frame by frame.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/link_session.h"
#include "app/cli/report.h"
#include "modbus/line/frame_text.h"

#include <chrono>
#include <optional>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

using Clock = std::chrono::steady_clock;

struct Limits {
    double seconds = 0;
    int exchanges = 0; // 0: any number
};

tl::expected<Limits, Failure> limitsOf(const Invocation& call, bool hasExchanges)
{
    constexpr double longestS = 86'400;
    Limits limits;
    bool isNumber = false;
    limits.seconds = call.value(u"seconds"_s).toDouble(&isNumber);
    if (!isNumber || !(limits.seconds > 0) || limits.seconds > longestS)
        return fail(ExitCode::Usage, u"--seconds takes a number above 0, up to 86400."_s);
    if (hasExchanges && call.isSet(u"exchanges"_s)) {
        limits.exchanges = call.value(u"exchanges"_s).toInt(&isNumber);
        if (!isNumber || limits.exchanges < 1)
            return fail(ExitCode::Usage, u"--exchanges takes a whole number above 0."_s);
        limits.seconds = longestS;
    }
    return limits;
}

// Performs exchanges until a limit is reached or the port is lost; calls `afterEach`.
template <typename AfterEach>
Outcome exchange(LinkSession& session, const Limits& limits, const AfterEach& afterEach)
{
    const auto end = Clock::now() + std::chrono::duration<double>(limits.seconds);
    for (int i = 0; Clock::now() < end && (limits.exchanges == 0 || i < limits.exchanges); ++i) {
        const auto status = session.exchangeOnce();
        if (const Outcome go = afterEach(); !go)
            return go;
        if (!status && modbus::portIsLost(status.error()))
            return fail(status.error());
    }
    return {};
}

QJsonValue milliseconds(const modbus::LatencyHistogram& latency, double share)
{
    if (latency.count() == 0)
        return QJsonValue::Null;
    return static_cast<double>(latency.percentile(share).count()) / 1000.0;
}

QJsonObject figuresObject(const modbus::LinkFigures& figures)
{
    const auto wide = [](auto value) { return static_cast<qint64>(value); };
    QJsonObject errors;
    for (std::size_t i = 0; i < modbus::countedErrors.size(); ++i)
        errors[fromView(modbus::errorId(modbus::countedErrors[i]))] = wide(figures.errors()[i]);
    QJsonObject object{{u"requests"_s, wide(figures.requests())},
                       {u"answers"_s, wide(figures.answers())},
                       {u"errors"_s, errors},
                       {u"retries"_s, wide(figures.retries())},
                       {u"drains"_s, wide(figures.drains())},
                       {u"bytes"_s, QJsonObject{{u"sent"_s, wide(figures.sentBytes())},
                                                {u"received"_s, wide(figures.receivedBytes())},
                                                {u"dropped"_s, wide(figures.droppedBytes())},
                                                {u"stray"_s, wide(figures.strayBytes())}}},
                       {u"latency_ms"_s, QJsonObject{{u"p50"_s, milliseconds(figures.latency(), 0.50)},
                                                     {u"p95"_s, milliseconds(figures.latency(), 0.95)},
                                                     {u"p99"_s, milliseconds(figures.latency(), 0.99)},
                                                     {u"max"_s, milliseconds(figures.latency(), 1.0)}}},
                       {u"wire_share"_s, orNull(figures.wireShare())},
                       {u"controller"_s, QJsonValue::Null}};
    if (const auto& controller = figures.controller())
        object[u"controller"_s] = QJsonObject{{u"requests"_s, wide(controller->requests)},
                                              {u"crc_errors"_s, wide(controller->crcErrors)},
                                              {u"frame_errors"_s, wide(controller->frameErrors)},
                                              {u"exceptions"_s, wide(controller->exceptions)}};
    return object;
}

} // namespace

Outcome runLink(const Invocation& call)
{
    const auto limits = limitsOf(call, true);
    if (!limits)
        return tl::unexpected(limits.error());
    auto session = LinkSession::open(call);
    if (!session)
        return tl::unexpected(session.error());
    const Outcome ended = exchange(*session, *limits, [] { return Outcome(); });
    QJsonObject object = figuresObject(session->client().record().figures);
    object[u"answer_allowance_ms"_s] = static_cast<qint64>(session->client().allowance().count());
    // Also after the loss of the port: the earlier figures are valid.
    if (const Outcome delivered = call.deliver(formatted(object, call.format())); !delivered)
        return delivered;
    return ended;
}

Outcome runFrames(const Invocation& call)
{
    const auto limits = limitsOf(call, false);
    if (!limits)
        return tl::unexpected(limits.error());
    auto session = LinkSession::open(call);
    if (!session)
        return tl::unexpected(session.error());
    std::uint64_t shown = 0;
    std::optional<Clock::time_point> start;
    return exchange(*session, *limits, [&]() -> Outcome {
        const auto frames = session->client().record().frames.since(shown);
        if (frames.empty())
            return {};
        if (!start)
            start = frames.front().at;
        shown = frames.back().number;
        return call.deliver(QByteArray::fromStdString(modbus::framesText(frames, start)));
    });
}

} // namespace campanel::cli
