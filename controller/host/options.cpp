// SPDX-License-Identifier: Apache-2.0
#include "options.h"

#include "ctl_registers.h"
#include "file_flash.h"
#include "input_pins.h"
#include "machine_options.h"

#include <charconv>
#include <cstring>
#include <fstream>
#include <getopt.h>
#include <iterator>
#include <optional>
#include <string_view>
#include <vector>

namespace campanel::controller {
namespace {

// The text around the machine's own options.
constexpr const char* helpBefore =
    R"(usage: campanel-controller [OPTION]...

Simulates the machine and its controller, and serves it over Modbus RTU on a pseudo-terminal. The first line
printed is that port's path. Ends on SIGTERM or SIGINT.

  --link PATH          make PATH a symbolic link to the port; removed at the end
  --unit N             Modbus unit, 1..247 (1)
  --baud N             line speed, 1200..921600 (115200): bytes take as long as on such a wire
  --parity N|E|O       parity (N)
  --stop-bits 1|2      stop bits (1)
  --no-pacing          bytes take no time
  --state DIR          where its flash is kept ($XDG_STATE_HOME/campanel)
  --map-minor N        answer as a controller of register map 1.N, 4 or later: registers since then do not exist
  --speed FACTOR       simulated seconds per second, 0.01..1000 (1)
  --seed N             seed of the machine's disturbances (1)
  --pins NAME,..       inputs that are on at power-up: )";

constexpr std::uint32_t usualMasterCounts = 10'000;

constexpr const char* helpAfter =
    R"(  --master-counts N    counts per revolution of the encoder on the line's shaft, which stands at first, 4..1000000;
                       0: none (10000)
  --positions-kept     the positions of axis, film and infeed survive a power cut, as with absolute encoders; the
                       shaft stands at its index mark at first
  --faults FILE        rules for what goes wrong on the line, one a line; see controller/README.md
  --fault-seed N       seed of the faults, unless the rules name one (1)
  --control            take a line of rules, separated by ';', from standard input at any time; it replaces all
                       rules, 'clear' removes them. Answered on standard output by 'ok N', N faults by the rules
                       before, or 'error' and a sentence; 'unplugged', 'port PATH', 'restarted' tell what
                       happened. 'measure' is answered by 'measured LENGTH DISTANCE': the last bag's length and
                       that of its cut behind its mark in mm, as a ruler shows it; 'measured none' before any.
                       'pin NAME on' and 'pin NAME off' set an input of --pins, answered by the same words.
                       'line start [MM_PER_S]' and 'line stop' move the line's shaft; 'line slip SHARE',
                       'line lose COUNTS' (per revolution), 'line swap on|off', 'line noise on|off' and 'line jump'
                       are faults of its encoder; answered by the same words
  --exit-with-parent   end when the process that started this one ends
  --help, --version
)";

tl::unexpected<Ending> wrong(const std::string& sentence)
{
    return tl::unexpected(Ending{2, "campanel-controller: " + sentence + "; see --help\n"});
}

// Parses a number that takes the whole text and is within [minimum, maximum].
template <typename Number>
bool parseNumber(std::string_view text, Number minimum, Number maximum, Number& result)
{
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), result);
    return parsed.ec == std::errc() && parsed.ptr == text.data() + text.size() && result >= minimum &&
           result <= maximum;
}

enum Code {
    Link = 1,
    Unit,
    Baud,
    Parity,
    StopBits,
    NoPacing,
    State,
    MapMinor,
    Speed,
    Seed,
    Pins,
    MasterCounts,
    PositionsKept,
    Faults,
    FaultSeed,
    Control,
    ExitWithParent,
    Help,
    Version,
    FirstOfMachine = 256 // the options of machineOptions(); below them is '?', the answer to an unknown one
};

const option ownOptions[] = {{"link", required_argument, nullptr, Link},
                             {"unit", required_argument, nullptr, Unit},
                             {"baud", required_argument, nullptr, Baud},
                             {"parity", required_argument, nullptr, Parity},
                             {"stop-bits", required_argument, nullptr, StopBits},
                             {"no-pacing", no_argument, nullptr, NoPacing},
                             {"state", required_argument, nullptr, State},
                             {"map-minor", required_argument, nullptr, MapMinor},
                             {"speed", required_argument, nullptr, Speed},
                             {"seed", required_argument, nullptr, Seed},
                             {"pins", required_argument, nullptr, Pins},
                             {"master-counts", required_argument, nullptr, MasterCounts},
                             {"positions-kept", no_argument, nullptr, PositionsKept},
                             {"faults", required_argument, nullptr, Faults},
                             {"fault-seed", required_argument, nullptr, FaultSeed},
                             {"control", no_argument, nullptr, Control},
                             {"exit-with-parent", no_argument, nullptr, ExitWithParent},
                             {"help", no_argument, nullptr, Help},
                             {"version", no_argument, nullptr, Version}};

// Returns the program's and the machine's options for getopt_long().
std::vector<option> allOptions()
{
    std::vector<option> all(std::begin(ownOptions), std::end(ownOptions));
    int code = FirstOfMachine;
    for (const MachineOption& option : machineOptions())
        all.push_back({option.name, required_argument, nullptr, code++});
    all.push_back({nullptr, 0, nullptr, 0});
    return all;
}

bool takeMachineOption(int code, std::string_view argument, MachineOptions& machine)
{
    const MachineOption& option = machineOptions()[static_cast<std::size_t>(code - FirstOfMachine)];
    return parseNumber(argument, option.minimum, option.maximum, option.member(machine));
}

// Returns an error; empty: success.
std::optional<std::string> readFaults(const std::filesystem::path& path, FaultScript& faults)
{
    std::ifstream file(path);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file)
        return "cannot read " + path.string();
    auto script = parseFaultScript(text, faults);
    if (!script)
        return path.string() + ", " + script.error();
    faults = std::move(*script);
    return std::nullopt;
}

// Returns false when the option's argument is outside its range.
bool takeOption(int code, std::string_view argument, Options& options)
{
    switch (code) {
    case Link:
        options.link = argument;
        return !argument.empty();
    case Unit:
        return parseNumber<std::uint8_t>(argument, 1, 247, options.unit);
    case Baud:
        return parseNumber<std::uint32_t>(argument, 1200, 921600, options.line.baud);
    case Parity:
        options.line.parity = argument.size() == 1 ? argument.front() : ' ';
        return std::strchr("NEO", options.line.parity) != nullptr;
    case StopBits:
        return parseNumber<std::uint32_t>(argument, 1, 2, options.line.stopBits);
    case NoPacing:
        options.line.paced = false;
        return true;
    case State:
        options.stateDirectory = argument;
        return !argument.empty();
    case MapMinor:
        return parseNumber<std::uint16_t>(argument, 4, CTL_MAP_MINOR, options.mapMinor);
    case Speed:
        return parseNumber(argument, 0.01, 1000.0, options.speed);
    case Seed:
        return parseNumber<std::uint64_t>(argument, 0, UINT64_MAX, options.machine.seed);
    case Pins:
        if (const auto pins = parsePins(argument)) {
            options.machine.inputs = *pins;
            return true;
        }
        return false;
    case MasterCounts:
        return parseNumber<std::uint32_t>(argument, 0, 1'000'000, options.machine.shaft.counts) &&
               (options.machine.shaft.counts == 0 || options.machine.shaft.counts >= 4);
    case PositionsKept:
        options.keepsPositions = true;
        options.machine.startAngleDegrees = 0; // where an encoder counts from
        return true;
    case FaultSeed:
        return parseNumber<std::uint64_t>(argument, 0, UINT64_MAX, options.faults.seed);
    case Control:
        options.control = true;
        return true;
    case ExitWithParent:
        options.exitWithParent = true;
        return true;
    default:
        return takeMachineOption(code, argument, options.machine);
    }
}

} // namespace

tl::expected<Options, Ending> parseOptions(int argc, char** argv)
{
    Options options;
    options.stateDirectory = defaultStateDirectory();
    options.machine.shaft.counts = usualMasterCounts;
    const std::vector<option> table = allOptions();
    std::string faultFile; // read last: the seed may follow it
    opterr = 0;
    for (;;) {
        int index = 0;
        const char* word = argv[optind];
        const int code = getopt_long(argc, argv, "", table.data(), &index);
        if (code == -1)
            break;
        if (code == '?')
            return wrong("unknown or incomplete option " + std::string(word));
        if (code == Help)
            return tl::unexpected(Ending{0, helpBefore + pinNames() + '\n' + machineHelp() + helpAfter});
        if (code == Version)
            return tl::unexpected(Ending{0, "campanel-controller " CAMPANEL_VERSION "\n"});
        const char* argument = optarg != nullptr ? optarg : "";
        if (code == Faults)
            faultFile = argument;
        else if (!takeOption(code, argument, options))
            return wrong("--" + std::string(table[static_cast<std::size_t>(index)].name) + " cannot be '" +
                         argument + "'");
    }
    if (optind < argc)
        return wrong("unexpected argument " + std::string(argv[optind]));
    if (!faultFile.empty()) {
        if (const auto sentence = readFaults(faultFile, options.faults))
            return wrong("--faults " + *sentence);
    }
    return options;
}

} // namespace campanel::controller
