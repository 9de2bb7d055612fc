// SPDX-License-Identifier: Apache-2.0
// Line faults as data: what goes wrong between panel and controller, how often, when. One rule a line; see
// controller/README.md for the language.
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
    DuplicateRequest, // the controller hears it twice
    DuplicateAnswer,
    Echo, // the panel hears its own request before the answer
    Truncate,
    Corrupt, // bits flipped, so that the CRC-16 is wrong
    Trailing,
    Gap, // silence within a frame
    Noise,
    WrongUnit, // this and the next two with a right CRC-16, as another device's answer
    WrongFunction,
    WrongCount,
    Exception, // instead of the answer: the request was carried out
    Busy,      // exception 6, not carried out, then it works again
    Silence,
    SecondMaster,
    WrongBaud,
    Unplug,
    Restart, // power-up from flash: what was in RAM is lost
    MapVersion,
    DeviceType,
};

// Which frame a fault of the line strikes.
enum class FaultPart : std::uint8_t { Answer, Request, Both };
// When a port is unplugged, or a second master speaks.
enum class FaultMoment : std::uint8_t { Idle, Request, Answer, Before, After };

struct FaultRule {
    FaultKind kind = FaultKind::Late;
    // How often: at each `every`-th exchange, or by chance; at most `limit` times, within a time since
    // loading.
    std::uint32_t every = 1; // 0: by chance
    double probability = 1.0;
    std::uint64_t limit = std::numeric_limits<std::uint64_t>::max();
    std::int64_t fromNs = 0;
    std::int64_t untilNs = std::numeric_limits<std::int64_t>::max();
    // What, each only for the kinds that take it.
    FaultPart part = FaultPart::Answer;
    FaultMoment when = FaultMoment::Idle;
    double times = 1.5;        // of the script's time-out
    double characters = 5.0;   // length of a gap
    std::uint32_t bits = 3;    // flipped
    std::uint32_t bytes = 3;   // of garbage or noise
    std::int64_t afterNs = 0;  // end of the answer to the noise
    std::uint32_t code = 2;    // of the exception
    std::uint32_t answers = 3; // that say busy
    std::int64_t timeNs = 500'000'000;
    std::string port;        // where the link to the port is when it comes back; empty: where it was
    std::uint16_t major = 0; // map version, device type
    std::uint16_t minor = 0;
    std::uint16_t type = 0;
};

struct FaultScript {
    std::vector<FaultRule> rules; // the first that strikes an exchange is the only one
    std::uint64_t seed = 1;
    std::int64_t timeoutNs = 100'000'000; // of the master; what Late counts in
};

// The word of the language.
[[nodiscard]] std::string_view faultWord(FaultKind kind);

// Lines or statements separated by ';'. Seed and time-out are those of `before` unless the text names others.
// The error names the line and says what is wrong.
[[nodiscard]] tl::expected<FaultScript, std::string> parseFaultScript(std::string_view text,
                                                                      const FaultScript& before = {});

} // namespace campanel::controller
