// SPDX-License-Identifier: Apache-2.0
// The fault script of the simulated line: any text, and what is accepted then damages a minute of exchanges.
#include "fault_rules.h"
#include "faulty_line.h"
#include "tests/fuzz/fuzz_target.h"

#include <algorithm>
#include <string_view>

namespace campanel::fuzz {
namespace {

using namespace campanel::controller;

constexpr std::int64_t stepNs = 20'000'000;
constexpr int steps = 200;

void exchange(const FaultScript& script)
{
    static constexpr std::uint8_t question[]{1, 3, 1, 0, 0, 2, 0xC5, 0xF7};
    static constexpr std::uint8_t answer[]{1, 3, 4, 0, 0, 0, 0, 0xFA, 0x33};
    FaultyLine line({}, script, 0);
    std::int64_t nowNs = 0;
    std::size_t received = 0;
    for (int i = 0; i < steps; ++i) {
        line.fromPanel(question, nowNs);
        nowNs += stepNs;
        while (const auto arrival = line.takeArrival(nowNs))
            line.fromController(answer, arrival->frame, nowNs);
        received += line.takeForPanel(nowNs).size();
        while (line.takeEvent(nowNs)) {
        }
        const auto next = line.nextEventNs();
        require(!next || *next >= 0, "an event has a time");
    }
    require(received <= 20'000'000, "the panel does not receive without end");
}

} // namespace

void runTarget(std::span<const std::uint8_t> bytes)
{
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const auto script = parseFaultScript(text);
    if (!script) {
        require(script.error().starts_with("line "), "an error names its line");
        return;
    }
    exchange(*script);
}

std::vector<Bytes> targetSeeds()
{
    std::vector<Bytes> seeds{
        bytesOf("seed 7; timeout 110\nlate times=1.5 probability=0.05\nlost-answer every=20 limit=3 # three\n"
                "corrupt bits=3 from=1000 until=5000\nunplug when=answer time=400 port=/tmp/other\n")};
    for (int kind = 0; kind <= static_cast<int>(FaultKind::DeviceType); ++kind)
        seeds.push_back(bytesOf(std::string(faultWord(static_cast<FaultKind>(kind))) + " every=2 limit=9"));
    seeds.push_back(
        bytesOf("noise bytes=5 after=3 part=both; gap characters=5; trailing bytes=40 part=request"));
    seeds.push_back(
        bytesOf("busy answers=3; exception code=4; wrong-baud time=500 part=answer; clear; silence"));
    return seeds;
}

} // namespace campanel::fuzz
