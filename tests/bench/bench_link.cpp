// SPDX-License-Identifier: Apache-2.0
// Status exchanges and table downloads with the real controller program and the time of real wires.
#include "bench_report.h"

#include "app/panel/words/connection_sentences.h"
#include "app/program/program_image.h"
#include "modbus/download/download.h"
#include "modbus/line/wire_time.h"
#include "tests/support/controller_process.h"

#include <chrono>
#include <stdexcept>

namespace campanel::bench {
namespace {

using Clock = std::chrono::steady_clock;
using namespace Qt::StringLiterals;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

template <typename T, typename E> T valueOrThrow(tl::expected<T, E> outcome)
{
    if (!outcome)
        throw std::runtime_error(panel::ConnectionSentences::error(outcome.error()).toStdString());
    return std::move(*outcome);
}

// About 257 rows, the table of the other figures.
std::vector<std::uint16_t> bank()
{
    program::Recipe recipe;
    recipe.cutter().slicesPerRamp = 127;
    auto built = program::buildProgram(recipe);
    if (!built)
        throw std::runtime_error("the program to be downloaded cannot be built");
    return built->registers;
}

void openAt(modbus::RtuClient& client)
{
    if (const auto opened = client.open(); !opened)
        throw std::runtime_error(describe(opened.error()));
}

double provenStatusPerSecond(modbus::RtuClient& client)
{
    std::uint16_t heartbeat = 0;
    for (int i = 0; i < 5; ++i)
        static_cast<void>(valueOrThrow(client.exchangeStatus(++heartbeat, 0)));
    int count = 0;
    const auto start = Clock::now();
    while (Clock::now() - start < statusTime) {
        static_cast<void>(valueOrThrow(client.exchangeStatus(++heartbeat, 0)));
        ++count;
    }
    return count / secondsSince(start);
}

// Begin, blocks, seal and apply.
double downloadSeconds(modbus::RtuClient& client, const std::vector<std::uint16_t>& image)
{
    using Phase = modbus::Download::Phase;
    const modbus::Identity identity = valueOrThrow(client.identify());
    modbus::Download download(image, identity, {});
    // The panel polls the status continuously; a download has the last one.
    static_cast<void>(valueOrThrow(download.noteStatus(valueOrThrow(client.exchangeStatus(1, 0)))));
    const auto start = Clock::now();
    while (!download.ended() && download.phase() != Phase::AwaitActive)
        static_cast<void>(valueOrThrow(download.advance(client)));
    return secondsSince(start);
}

void measureAt(std::uint32_t baud, double statusFloor, Figures& figures)
{
    const test::ControllerProcess controller({u"--baud"_s, QString::number(baud)});
    modbus::LinkSettings settings;
    settings.port = controller.port().toStdString();
    settings.line.baud = baud;
    modbus::RtuClient client(settings);
    openAt(client);
    static_cast<void>(valueOrThrow(client.identify())); // from then on with the permit

    const std::string at = " at " + std::to_string(baud);
    const double wireStatus =
        1.0 / std::chrono::duration<double>(modbus::pairTime(settings.line, modbus::statusFrames)).count();
    const double status = provenStatusPerSecond(client);
    figures.push_back(
        {"status exchanges" + at, status, 0.95 * wireStatus, "/s", "95 % of the wire's limit", false});
    figures.push_back({"status exchanges" + at, status, statusFloor, "/s", "the least wanted", false});

    const std::vector<std::uint16_t> image = bank();
    const double wireDownload =
        std::chrono::duration<double>(modbus::downloadTime(settings.line, static_cast<int>(image.size())))
            .count();
    figures.push_back({"download of " + std::to_string(image.size()) + " registers" + at,
                       downloadSeconds(client, image), wireDownload / 0.95, "s", "wire's limit / 0.95",
                       true});
}

} // namespace

Figures measureLink()
{
    Figures figures;
    measureAt(115200, 50, figures);
    measureAt(9600, 8, figures);
    return figures;
}

} // namespace campanel::bench
