// SPDX-License-Identifier: Apache-2.0
#include "options.h"

#include "file_flash.h"

#include <charconv>
#include <cstring>
#include <fstream>
#include <getopt.h>
#include <iterator>
#include <optional>
#include <string_view>

namespace campanel::controller {
namespace {

constexpr const char* help =
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
  --speed FACTOR       simulated seconds per second, 0.01..1000 (1)
  --seed N             seed of the machine's disturbances (1)
  --film-slip MM       standard deviation of the film's slip per bag, 0..10 (0.03)
  --work-piece MM      where the work piece of a press begins, below the upper position, 0..1000 (75)
  --work-piece-scatter MM  standard deviation of that from stroke to stroke, 0..100 (0.2)
  --work-piece-missing P   share of the strokes that find none, 0..1 (0)
  --work-piece-stiffness N force per mm that the ram goes into it, 0..1000000 (200)
  --press-backlash MM  play between motor and ram, 0..10 (0.037)
  --press-lead-error R the ram goes 1 + R times as far as the motor says, -0.1..0.1 (0.00012)
  --press-screw-error MM   error to both sides within each turn of the screw, 0..1 (0.001)
  --press-drift MM     standard deviation of heat's move of the ram from stroke to stroke, 0..1 (0.005)
  --faults FILE        rules for what goes wrong on the line, one a line; see controller/README.md
  --fault-seed N       seed of the faults, unless the rules name one (1)
  --control            take a line of rules, separated by ';', from standard input at any time; it replaces all
                       rules, 'clear' removes them. Answered on standard output by 'ok N', N faults by the rules
                       before, or 'error' and a sentence; 'unplugged', 'port PATH', 'restarted' tell what happened
  --exit-with-parent   end when the process that started this one ends
  --help, --version
)";

tl::unexpected<Ending> wrong(const std::string& sentence)
{
    return tl::unexpected(Ending{2, "campanel-controller: " + sentence + "; see --help\n"});
}

// A number that takes the whole text and lies in [minimum, maximum].
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
    Speed,
    Seed,
    FilmSlip,
    WorkPiece,
    WorkPieceScatter,
    WorkPieceMissing,
    WorkPieceStiffness,
    PressBacklash,
    PressLeadError,
    PressScrewError,
    PressDrift,
    Faults,
    FaultSeed,
    Control,
    ExitWithParent,
    Help,
    Version
};

const option table[] = {{"link", required_argument, nullptr, Link},
                        {"unit", required_argument, nullptr, Unit},
                        {"baud", required_argument, nullptr, Baud},
                        {"parity", required_argument, nullptr, Parity},
                        {"stop-bits", required_argument, nullptr, StopBits},
                        {"no-pacing", no_argument, nullptr, NoPacing},
                        {"state", required_argument, nullptr, State},
                        {"speed", required_argument, nullptr, Speed},
                        {"seed", required_argument, nullptr, Seed},
                        {"film-slip", required_argument, nullptr, FilmSlip},
                        {"work-piece", required_argument, nullptr, WorkPiece},
                        {"work-piece-scatter", required_argument, nullptr, WorkPieceScatter},
                        {"work-piece-missing", required_argument, nullptr, WorkPieceMissing},
                        {"work-piece-stiffness", required_argument, nullptr, WorkPieceStiffness},
                        {"press-backlash", required_argument, nullptr, PressBacklash},
                        {"press-lead-error", required_argument, nullptr, PressLeadError},
                        {"press-screw-error", required_argument, nullptr, PressScrewError},
                        {"press-drift", required_argument, nullptr, PressDrift},
                        {"faults", required_argument, nullptr, Faults},
                        {"fault-seed", required_argument, nullptr, FaultSeed},
                        {"control", no_argument, nullptr, Control},
                        {"exit-with-parent", no_argument, nullptr, ExitWithParent},
                        {"help", no_argument, nullptr, Help},
                        {"version", no_argument, nullptr, Version},
                        {nullptr, 0, nullptr, 0}};

bool takePressOption(int code, std::string_view argument, PressOptions& press)
{
    switch (code) {
    case WorkPiece:
        return parseNumber(argument, 0.0, 1000.0, press.workPieceMm);
    case WorkPieceScatter:
        return parseNumber(argument, 0.0, 100.0, press.workPieceScatterMm);
    case WorkPieceMissing:
        return parseNumber(argument, 0.0, 1.0, press.missing);
    case WorkPieceStiffness:
        return parseNumber(argument, 0.0, 1e6, press.stiffnessNPerMm);
    case PressBacklash:
        return parseNumber(argument, 0.0, 10.0, press.backlashMm);
    case PressLeadError:
        return parseNumber(argument, -0.1, 0.1, press.leadError);
    case PressScrewError:
        return parseNumber(argument, 0.0, 1.0, press.screwErrorMm);
    default:
        return parseNumber(argument, 0.0, 1.0, press.driftMm);
    }
}

// Empty: done.
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

// False when the option's argument is outside its range.
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
    case Speed:
        return parseNumber(argument, 0.01, 1000.0, options.speed);
    case Seed:
        return parseNumber<std::uint64_t>(argument, 0, UINT64_MAX, options.machine.seed);
    case FilmSlip:
        return parseNumber(argument, 0.0, 10.0, options.machine.film.slipMm);
    case FaultSeed:
        return parseNumber<std::uint64_t>(argument, 0, UINT64_MAX, options.faults.seed);
    case Control:
        options.control = true;
        return true;
    case ExitWithParent:
        options.exitWithParent = true;
        return true;
    default:
        return takePressOption(code, argument, options.machine.press);
    }
}

} // namespace

tl::expected<Options, Ending> parseOptions(int argc, char** argv)
{
    Options options;
    options.stateDirectory = defaultStateDirectory();
    std::string faultFile; // read last: the seed may be named after it
    opterr = 0;
    for (;;) {
        int index = 0;
        const char* word = argv[optind];
        const int code = getopt_long(argc, argv, "", table, &index);
        if (code == -1)
            break;
        if (code == '?')
            return wrong("unknown or incomplete option " + std::string(word));
        if (code == Help)
            return tl::unexpected(Ending{0, help});
        if (code == Version)
            return tl::unexpected(Ending{0, "campanel-controller " CAMPANEL_VERSION "\n"});
        const char* argument = optarg != nullptr ? optarg : "";
        if (code == Faults)
            faultFile = argument;
        else if (!takeOption(code, argument, options))
            return wrong("--" + std::string(table[index].name) + " cannot be '" + argument + "'");
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
