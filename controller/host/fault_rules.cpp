// SPDX-License-Identifier: Apache-2.0
// The language of fault scripts: a word, then key=value pairs. Tables define the keys of each kind.
#include "fault_rules.h"

#include "ctl_registers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace campanel::controller {
namespace {

constexpr double nsPerMs = 1e6;

struct Kind {
    FaultKind kind;
    std::string_view word;
    std::string_view keys; // its own, besides the common ones
};

constexpr std::array kinds{
    Kind{FaultKind::Late, "late", "times part"},
    Kind{FaultKind::LostRequest, "lost-request", ""},
    Kind{FaultKind::LostAnswer, "lost-answer", ""},
    Kind{FaultKind::DuplicateRequest, "duplicate-request", ""},
    Kind{FaultKind::DuplicateAnswer, "duplicate-answer", ""},
    Kind{FaultKind::Echo, "echo", ""},
    Kind{FaultKind::Truncate, "truncate", "part"},
    Kind{FaultKind::Corrupt, "corrupt", "part bits"},
    Kind{FaultKind::Trailing, "trailing", "part bytes"},
    Kind{FaultKind::Gap, "gap", "part characters"},
    Kind{FaultKind::Noise, "noise", "part bytes after"},
    Kind{FaultKind::WrongUnit, "wrong-unit", ""},
    Kind{FaultKind::WrongFunction, "wrong-function", ""},
    Kind{FaultKind::WrongCount, "wrong-count", ""},
    Kind{FaultKind::Exception, "exception", "code"},
    Kind{FaultKind::Busy, "busy", "answers"},
    Kind{FaultKind::Silence, "silence", "time"},
    Kind{FaultKind::SecondMaster, "second-master", "when"},
    Kind{FaultKind::WrongBaud, "wrong-baud", "part time"},
    Kind{FaultKind::Unplug, "unplug", "when time port"},
    Kind{FaultKind::Restart, "restart", "time"},
    Kind{FaultKind::MapVersion, "map-version", "major minor"},
    Kind{FaultKind::DeviceType, "device-type", "type"},
};
constexpr std::string_view keysOfAll = "probability every limit from until";

template <typename Number>
bool takeNumber(std::string_view text, Number minimum, Number maximum, Number& result)
{
    Number value{};
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    if (parsed.ec != std::errc() || parsed.ptr != text.data() + text.size() || !(value >= minimum) ||
        !(value <= maximum))
        return false;
    result = value;
    return true;
}

bool takeMs(std::string_view text, std::int64_t& resultNs)
{
    double ms = 0;
    if (!takeNumber(text, 0.0, 1e9, ms))
        return false;
    resultNs = std::llround(ms * nsPerMs);
    return true;
}

template <typename Value, std::size_t count>
bool takeWord(std::string_view text, const std::array<std::pair<std::string_view, Value>, count>& words,
              Value& result)
{
    const auto found =
        std::ranges::find_if(words, [text](const auto& candidate) { return candidate.first == text; });
    if (found == words.end())
        return false;
    result = found->second;
    return true;
}

constexpr std::array parts{std::pair<std::string_view, FaultPart>{"answer", FaultPart::Answer},
                           std::pair<std::string_view, FaultPart>{"request", FaultPart::Request},
                           std::pair<std::string_view, FaultPart>{"both", FaultPart::Both}};
constexpr std::array unplugMoments{std::pair<std::string_view, FaultMoment>{"idle", FaultMoment::Idle},
                                   std::pair<std::string_view, FaultMoment>{"request", FaultMoment::Request},
                                   std::pair<std::string_view, FaultMoment>{"answer", FaultMoment::Answer}};
constexpr std::array masterMoments{std::pair<std::string_view, FaultMoment>{"before", FaultMoment::Before},
                                   std::pair<std::string_view, FaultMoment>{"after", FaultMoment::After}};

struct Key {
    std::string_view name;
    std::string_view range;
    bool (*take)(FaultRule& rule, std::string_view text);
};

const std::array keys{
    Key{"probability", "a number from 0 to 1",
        [](FaultRule& rule, std::string_view text) {
            rule.every = 0;
            return takeNumber(text, 0.0, 1.0, rule.probability);
        }},
    Key{"every", "a whole number from 1",
        [](FaultRule& rule, std::string_view text) {
            return takeNumber<std::uint32_t>(text, 1, UINT32_MAX, rule.every);
        }},
    Key{"limit", "a whole number",
        [](FaultRule& rule, std::string_view text) {
            return takeNumber<std::uint64_t>(text, 0, UINT64_MAX, rule.limit);
        }},
    Key{"from", "a time in ms",
        [](FaultRule& rule, std::string_view text) { return takeMs(text, rule.fromNs); }},
    Key{"until", "a time in ms",
        [](FaultRule& rule, std::string_view text) { return takeMs(text, rule.untilNs); }},
    Key{"part", "answer, request or both",
        [](FaultRule& rule, std::string_view text) { return takeWord(text, parts, rule.part); }},
    Key{"when", "idle, request or answer; before or after for a second master",
        [](FaultRule& rule, std::string_view text) {
            return rule.kind == FaultKind::Unplug ? takeWord(text, unplugMoments, rule.when)
                                                  : takeWord(text, masterMoments, rule.when);
        }},
    Key{"times", "a number from 0 to 1000",
        [](FaultRule& rule, std::string_view text) { return takeNumber(text, 0.0, 1000.0, rule.times); }},
    Key{"characters", "a number from 0 to 10000",
        [](FaultRule& rule, std::string_view text) {
            return takeNumber(text, 0.0, 10000.0, rule.characters);
        }},
    Key{"bits", "a whole number from 1 to 64",
        [](FaultRule& rule, std::string_view text) {
            return takeNumber<std::uint32_t>(text, 1, 64, rule.bits);
        }},
    Key{"bytes", "a whole number from 1 to 1000",
        [](FaultRule& rule, std::string_view text) {
            return takeNumber<std::uint32_t>(text, 1, 1000, rule.bytes);
        }},
    Key{"after", "a time in ms",
        [](FaultRule& rule, std::string_view text) { return takeMs(text, rule.afterNs); }},
    Key{"code", "a whole number from 1 to 255",
        [](FaultRule& rule, std::string_view text) {
            return takeNumber<std::uint32_t>(text, 1, 255, rule.code);
        }},
    Key{"answers", "a whole number from 1",
        [](FaultRule& rule, std::string_view text) {
            return takeNumber<std::uint32_t>(text, 1, UINT32_MAX, rule.answers);
        }},
    Key{"time", "a time in ms",
        [](FaultRule& rule, std::string_view text) { return takeMs(text, rule.timeNs); }},
    Key{"port", "a path",
        [](FaultRule& rule, std::string_view text) {
            rule.port = text;
            return !text.empty();
        }},
    Key{"major", "a whole number from 0 to 65535",
        [](FaultRule& rule, std::string_view text) {
            return takeNumber<std::uint16_t>(text, 0, UINT16_MAX, rule.major);
        }},
    Key{"minor", "a whole number from 0 to 65535",
        [](FaultRule& rule, std::string_view text) {
            return takeNumber<std::uint16_t>(text, 0, UINT16_MAX, rule.minor);
        }},
    Key{"type", "a whole number from 0 to 65535",
        [](FaultRule& rule, std::string_view text) {
            return takeNumber<std::uint16_t>(text, 0, UINT16_MAX, rule.type);
        }},
};

constexpr std::string_view blanks = " \t\r";

// Removes and returns the next word of the text; empty at its end.
std::string_view takeWordOff(std::string_view& text)
{
    const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    text.remove_prefix(end);
    return word;
}

bool isAmong(std::string_view list, std::string_view wanted)
{
    for (std::string_view word = takeWordOff(list); !word.empty(); word = takeWordOff(list)) {
        if (word == wanted)
            return true;
    }
    return false;
}

std::string quoted(std::string_view text)
{
    std::string result = "'";
    result.append(text).append("'");
    return result;
}

// Returns an error; empty: success.
std::optional<std::string> takePair(FaultRule& rule, const Kind& kind, std::string_view pair)
{
    const std::size_t equals = pair.find('=');
    const std::string_view name = pair.substr(0, equals);
    const auto key = std::ranges::find(keys, name, &Key::name);
    if (key == keys.end() || !(isAmong(kind.keys, name) || isAmong(keysOfAll, name))) {
        std::string sentence = quoted(kind.word);
        sentence.append(" does not take ").append(quoted(name)).append("; it takes ");
        return sentence.append(kind.keys).append(kind.keys.empty() ? "" : " ").append(keysOfAll);
    }
    if (equals == std::string_view::npos || !key->take(rule, pair.substr(equals + 1))) {
        std::string sentence = quoted(pair);
        return sentence.append(" is wrong: ").append(name).append(" is ").append(key->range);
    }
    return std::nullopt;
}

FaultRule defaultsOf(FaultKind kind)
{
    FaultRule rule;
    rule.kind = kind;
    rule.when = kind == FaultKind::SecondMaster ? FaultMoment::After : FaultMoment::Idle;
    if (kind == FaultKind::WrongBaud)
        rule.part = FaultPart::Both;
    rule.major = kind == FaultKind::MapVersion ? CTL_MAP_MAJOR + 1 : 0;
    return rule;
}

// Returns an error; empty: success.
std::optional<std::string> takeStatement(std::string_view statement, FaultScript& script)
{
    const std::string_view word = takeWordOff(statement);
    if (word.empty())
        return std::nullopt;
    if (word == "clear") {
        script.rules.clear();
        return std::nullopt;
    }
    if (word == "seed" || word == "timeout") {
        const std::string_view value = takeWordOff(statement);
        const bool taken = word == "seed" ? takeNumber<std::uint64_t>(value, 0, UINT64_MAX, script.seed)
                                          : takeMs(value, script.timeoutNs);
        if (taken && takeWordOff(statement).empty())
            return std::nullopt;
        return quoted(word).append(word == "seed" ? " takes one whole number" : " takes one time in ms");
    }
    const auto kind = std::ranges::find(kinds, word, &Kind::word);
    if (kind == kinds.end()) {
        std::string sentence = "there is no fault ";
        sentence.append(quoted(word)).append("; there are");
        for (const Kind& known : kinds)
            sentence.append(" ").append(known.word);
        return sentence;
    }
    FaultRule rule = defaultsOf(kind->kind);
    for (std::string_view pair = takeWordOff(statement); !pair.empty(); pair = takeWordOff(statement)) {
        if (auto sentence = takePair(rule, *kind, pair))
            return sentence;
    }
    script.rules.push_back(std::move(rule));
    return std::nullopt;
}

} // namespace

std::string_view faultWord(FaultKind kind)
{
    return std::ranges::find(kinds, kind, &Kind::kind)->word;
}

tl::expected<FaultScript, std::string> parseFaultScript(std::string_view text, const FaultScript& before)
{
    FaultScript script{{}, before.seed, before.timeoutNs};
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        line = line.substr(0, line.find('#'));
        while (!line.empty()) {
            const std::size_t cut = std::min(line.find(';'), line.size());
            if (const auto sentence = takeStatement(line.substr(0, cut), script)) {
                std::string error = "line ";
                return tl::unexpected(error.append(std::to_string(number)).append(": ").append(*sentence));
            }
            line.remove_prefix(std::min(cut + 1, line.size()));
        }
    }
    return script;
}

} // namespace campanel::controller
