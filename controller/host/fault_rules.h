// SPDX-License-Identifier: Apache-2.0
// The rules of line faults between panel and controller as data: kind, frequency, time. One rule per line;
// see controller/README.md for the language.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace campanel::controller {

enum class FaultKind : std::uint8_t {
    Late,
    LostRequest,
    LostAnswer,
    DuplicateRequest, // the controller receives it twice
    DuplicateAnswer,
    Echo, // the panel receives its own request before the answer
    Truncate,
    Corrupt, // bits flipped, so that the CRC-16 is wrong
    Trailing,
    Gap, // silence within a frame
    Noise,
    WrongUnit, // this and the next two are answers of another device with a correct CRC-16
    WrongFunction,
    WrongCount,
    Exception, // instead of the answer: the request was executed
    Busy,      // exception 6, not executed, then normal operation
    Silence,
    SecondMaster,
    WrongBaud,
    Unplug,
    Restart, // power-up from flash: RAM contents are lost
    MapVersion,
    DeviceType,
};

// The frame that a fault of the line affects.
enum class FaultPart : std::uint8_t { Answer, Request, Both };
// The time of an unplugged port, or of a second master's request.
enum class FaultMoment : std::uint8_t { Idle, Request, Answer, Before, After };

struct FaultRule {
    FaultKind kind = FaultKind::Late;
    // The frequency: each `every`-th exchange, or by chance; at most `limit` times, within a time since
    // loading.
    std::uint32_t every = 1; // 0: by chance
    double probability = 1.0;
    std::uint64_t limit = std::numeric_limits<std::uint64_t>::max();
    std::int64_t fromNs = 0;
    std::int64_t untilNs = std::numeric_limits<std::int64_t>::max();
    // The details, each for certain kinds only.
    FaultPart part = FaultPart::Answer;
    FaultMoment when = FaultMoment::Idle;
    double times = 1.5;        // multiple of the script's time-out
    double characters = 5.0;   // length of a gap
    std::uint32_t bits = 3;    // number of flipped bits
    std::uint32_t bytes = 3;   // number of bytes of garbage or noise
    std::int64_t afterNs = 0;  // time from the end of the answer to the noise
    std::uint32_t code = 2;    // exception code
    std::uint32_t answers = 3; // number of busy answers
    std::int64_t timeNs = 500'000'000;
    std::string port;        // path of the link after the return; empty: unchanged
    std::uint16_t major = 0; // map version, device type
    std::uint16_t minor = 0;
    std::uint16_t type = 0;
};

struct FaultScript {
    std::vector<FaultRule> rules; // the first rule that matches an exchange is the only one
    std::uint64_t seed = 1;
    std::int64_t timeoutNs = 100'000'000; // the master's; the unit of Late
};

// Returns the keyword of the language.
[[nodiscard]] std::string_view faultWord(FaultKind kind);

// Parses lines or statements separated by ';'. Seed and time-out come from `before` unless the text sets
// them. The error names the line and says what is wrong.
[[nodiscard]] tl::expected<FaultScript, std::string> parseFaultScript(std::string_view text,
                                                                      const FaultScript& before = {});

} // namespace campanel::controller
