// SPDX-License-Identifier: Apache-2.0
// Eight hours of running in accelerated time: the real Run page with a status for every exchange of a line at
// 115200 baud, drawn once a second of that time, and a record of every frame. The resident memory must not
// grow.
#include "bench_report.h"

#include "app/shell/memory.h"
#include "modbus/line/rtu_line.h"
#include "tests/looks/test_window.h"

#include <QCoreApplication>

#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

namespace campanel::bench {
namespace {

using namespace std::chrono_literals;
using link::StatusBatch;

constexpr int statusPerS = 78;
constexpr int secondsPerHour = 3600;
constexpr int hours = 8;

// Records one exchange on the line; one in a hundred is lost.
void record(modbus::LinkRecord& line, int exchange, modbus::LinkFigures::WallTime at)
{
    constexpr std::array<std::uint8_t, 19> question{1, 23};
    constexpr std::array<std::uint8_t, 85> answer{1, 23, 80};
    constexpr int lostEvery = 100;
    line.figures.noteRequest(question.size(), false);
    line.frames.add(modbus::FrameVerdict::Sent, question, 0x0100, 40);
    if (exchange % lostEvery == 0) {
        line.figures.noteError(modbus::LinkErrorKind::NoAnswer, 60ms, at);
        return;
    }
    line.figures.noteReceived(answer.size());
    line.figures.noteAnswer(10ms + std::chrono::microseconds(exchange % 997), 11ms, 12ms, at);
    line.frames.add(modbus::FrameVerdict::Answer, answer, 0x0100, 40);
}

} // namespace

Figures measureMemory()
{
    shell::keepMemoryFlat();
    qputenv("QT_QPA_UPDATE_IDLE_TIME", "0");
    looks::TestWindow window({QStringLiteral("en"), QStringLiteral("light"), QSize(1024, 600)});
    if (!window.isReady())
        throw std::runtime_error("the panel's window cannot be loaded");
    link::StatusSample sample;
    const auto known = QObject::connect(&window.link(), &link::Link::statusReceived, &window.window(),
                                        [&](const StatusBatch& batch) {
                                            if (!batch.samples.isEmpty())
                                                sample = batch.samples.last();
                                        });
    window.link().show(looks::DemoLink::Situation::Fresh);
    window.link().show(looks::DemoLink::Situation::Running);
    QObject::disconnect(known);
    window.settle();

    constexpr double bagMm = 250;
    std::mt19937 random(1);
    std::normal_distribution<double> deviation(0, 0.03);
    modbus::LinkRecord line;
    modbus::LinkFigures::WallTime at{};
    double afterFirstHourMb = 0;
    for (int second = 0; second < hours * secondsPerHour; ++second) {
        StatusBatch batch;
        modbus::StatusBlock& status = sample.status;
        ++status.cycleCount;
        ++status.bagCount;
        status.bagDeviationMm = deviation(random);
        status.bagLengthMm = bagMm + *status.bagDeviationMm;
        for (int i = 0; i < statusPerS; ++i) {
            status.masterAngleDeg = 360.0 * i / statusPerS;
            status.actualFrequencyHz = static_cast<std::int32_t>(10'000 * std::abs(std::sin(i)));
            sample.receivedAt = window.link().now() + i * 12'820us;
            batch.samples.append(sample);
            record(line, second * statusPerS + i, at);
        }
        at += 1s;
        window.link().advance(1s);
        emit window.link().statusReceived(batch);
        window.settle();
        if (second == secondsPerHour)
            afterFirstHourMb = residentMb(QCoreApplication::applicationPid());
    }
    const double grownMb = residentMb(QCoreApplication::applicationPid()) - afterFirstHourMb;
    return {{"resident memory grown from hour 1 to hour " + std::to_string(hours), grownMb, 2, "MB", "flat",
             true}};
}

} // namespace campanel::bench
