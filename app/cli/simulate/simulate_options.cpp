// SPDX-License-Identifier: Apache-2.0
// The table of disturbances.
#include "app/cli/simulate/simulate_options.h"

#include "app/cli/invocation.h"
#include "app/cli/report.h"
#include "app/panel/words/refusal_sentences.h"
#include "app/panel/words/register_words.h"
#include "app/program/dead_time_estimate.h"
#include "modbus/map/codec.h"
#include "modbus/map/mark_edges.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

using controller::PackingJob;

constexpr double longestMm = 2000.0;
constexpr double maxBags = 1e8;
constexpr double maxDeadTimeMs = 20.0;
constexpr double maxSeed = 4294967295.0;

struct Disturbance {
    const char* name;
    const char* what;
    const char* unit;
    double minimum;
    double maximum;
    double& (*place)(controller::MachineOptions& machine);
};

using Machine = controller::MachineOptions;

constexpr Disturbance disturbances[] = {
    {"slip", "standard deviation of the film's slip from bag to bag", "MM", 0, 10,
     [](Machine& machine) -> double& { return machine.film.slipMm; }},
    {"stretch", "maximum slow stretch of the film", "SHARE", 0, 0.1,
     [](Machine& machine) -> double& { return machine.film.stretch; }},
    {"stretch-step", "sudden stretch of the film", "SHARE", -0.2, 0.2,
     [](Machine& machine) -> double& { return machine.film.stretchStep; }},
    {"stretch-step-after", "film length before the sudden stretch", "M", 0, 1e6,
     [](Machine& machine) -> double& { return machine.film.stretchStepM; }},
    {"slip-per-acceleration", "film behind its roll, for each m/s^2 of acceleration", "MM", 0, 1,
     [](Machine& machine) -> double& { return machine.film.slipPerAcceleration; }},
    {"sensor-delay-ms", "delay of mark sensor and product eye", "MS", 0, 50,
     [](Machine& machine) -> double& { return machine.sensors.delayMs; }},
    {"sensor-scatter-ms", "standard deviation of this delay from edge to edge", "MS", 0, 10,
     [](Machine& machine) -> double& { return machine.sensors.scatterMs; }},
    {"sensor-off-later-ms", "additional delay of the end of a mark or product", "MS", 0, 10,
     [](Machine& machine) -> double& { return machine.sensors.offLaterMs; }},
    {"mark-noise", "standard deviation of the mark sensor", "MM", 0, 10,
     [](Machine& machine) -> double& { return machine.film.markNoiseMm; }},
    {"marks-missing", "marks that the sensor misses", "SHARE", 0, 1,
     [](Machine& machine) -> double& { return machine.film.marksMissing; }},
    {"marks-false", "bags with an additional mark", "SHARE", 0, 1,
     [](Machine& machine) -> double& { return machine.film.marksFalse; }},
    {"mark-width", "width of the printed marks", "MM", 0.5, 100,
     [](Machine& machine) -> double& { return machine.film.markWidthMm; }},
    {"false-mark-width", "width of additional marks", "MM", 0.5, 100,
     [](Machine& machine) -> double& { return machine.film.falseWidthMm; }},
    {"print-at", "another print so far behind each mark; 0: none", "MM", 0, longestMm,
     [](Machine& machine) -> double& { return machine.film.printAtMm; }},
    {"print-width", "width of this print", "MM", 0.5, 100,
     [](Machine& machine) -> double& { return machine.film.printWidthMm; }},
    {"print-error", "print length minus bag length", "SHARE", -0.5, 0.5,
     [](Machine& machine) -> double& { return machine.film.printError; }},
    {"film-misplaced", "offset of the first cut from its mark", "MM", -longestMm, longestMm,
     [](Machine& machine) -> double& { return machine.film.misplacedMm; }},
    {"knife-off", "place of the second of several knives behind its own, along the film", "MM", -5, 5,
     [](Machine& machine) -> double& { return machine.knifeOffMm; }},
    {"master-ripple", "ripple of the speed of an encoder as the master", "SHARE", 0, 0.5,
     [](Machine& machine) -> double& { return machine.shaft.ripple; }},
    {"master-ripple-hz", "frequency of this ripple", "HZ", 0.01, 200,
     [](Machine& machine) -> double& { return machine.shaft.rippleHz; }},
    {"master-wave", "slow wave of the speed of an encoder as the master, over 10 s", "SHARE", 0, 0.5,
     [](Machine& machine) -> double& { return machine.shaft.wave; }},
    {"master-jitter", "maximum error of an edge of this encoder", "COUNTS", 0, 10,
     [](Machine& machine) -> double& { return machine.shaft.jitterCounts; }},
    {"product-length", "length of the products; 0: 0.6 of the bag", "MM", 0, longestMm,
     [](Machine& machine) -> double& { return machine.products.lengthMm; }},
    {"product-scatter", "standard deviation of the product positions", "MM", 0, longestMm,
     [](Machine& machine) -> double& { return machine.products.scatterMm; }},
    {"products-missing", "missing products", "SHARE", 0, 1,
     [](Machine& machine) -> double& { return machine.products.missing; }},
    {"products-misplaced", "products displaced by up to 0.45 of a bag length", "SHARE", 0, 1,
     [](Machine& machine) -> double& { return machine.products.misplaced; }},
    {"products-joined", "products that hang together with the next one", "SHARE", 0, 1,
     [](Machine& machine) -> double& { return machine.products.joined; }},
    {"jams", "cuts with something between the jaws", "SHARE", 0, 1,
     [](Machine& machine) -> double& { return machine.jaws.jams; }},
    {"jam-stiffness", "its force for each mm of the knife's way into it", "N", 0.1, 1000,
     [](Machine& machine) -> double& { return machine.jaws.stiffnessNPerMm; }},
    {"jam-touch", "shaft angle before the cut at which the knife touches it", "DEG", 0, 90,
     [](Machine& machine) -> double& { return machine.jaws.touchDegrees; }},
    {"seal-torque", "largest torque of a seal, a tenth of it from bag to bag", "NM", 0, 100,
     [](Machine& machine) -> double& { return machine.jaws.sealNm; }},
    {"friction-drift", "share by which the knife's friction rises and falls in ten minutes", "SHARE", 0, 1,
     [](Machine& machine) -> double& { return machine.drive.frictionDrift; }},
    {"torque-every-ms", "time between two reports of the drive's torque, each of one report ago; 0: none",
     "MS", 0, 100, [](Machine& machine) -> double& { return machine.report.everyMs; }},
    {"torque-step", "resolution of the reported torque, of the rated one", "PERCENT", 0.01, 10,
     [](Machine& machine) -> double& { return machine.report.stepPercent; }},
    {"torque-noise", "standard deviation of the reported torque", "PERCENT", 0, 20,
     [](Machine& machine) -> double& { return machine.report.noisePercent; }},
};

// Parses "parameter.cut_clearance=8".
tl::expected<controller::ParameterValue, Failure> settingOf(const QString& text)
{
    const qsizetype sign = text.indexOf(u'=');
    bool isNumber = false;
    const double value = text.mid(sign + 1).trimmed().toDouble(&isNumber);
    if (sign < 1 || !isNumber || !std::isfinite(value))
        return fail(
            ExitCode::Usage,
            u"--set takes a parameter and its value such as parameter.cut_clearance=8, not \"%1\"."_s.arg(
                text));
    return parameterOf(text.left(sign).trimmed(), value);
}

bool learns(const Invocation& call)
{
    return call.value(u"sensor-compensation-ms"_s) == u"learned"_s;
}

tl::expected<std::vector<controller::ParameterValue>, Failure> parameterValues(const Invocation& call)
{
    std::vector<controller::ParameterValue> parameters;
    QStringList settings = call.values(u"set"_s);
    if (call.isSet(u"no-tracking"_s))
        settings << u"parameter.mark_tracking=0"_s;
    if (call.isSet(u"save-film"_s))
        settings << u"parameter.empty_bag=1"_s;
    const auto compensation = learns(call) ? tl::expected<double, Failure>(0.0)
                                           : numberOf(call, u"sensor-compensation-ms"_s, 0, 0, maxDeadTimeMs);
    if (!compensation)
        return tl::unexpected(compensation.error());
    if (*compensation > 0) {
        for (const char* name : {"mark_dead_time", "eye_dead_time", "eye_end_dead_time"})
            settings.prepend(u"parameter.%1=%2"_s.arg(QLatin1String(name), QString::number(*compensation)));
    }
    for (const QString& each : settings) {
        auto setting = settingOf(each);
        if (!setting)
            return tl::unexpected(setting.error());
        parameters.push_back(std::move(*setting));
    }
    return parameters;
}

tl::expected<double, Failure> wholeOf(const Invocation& call, const QString& option, double otherwise,
                                      double minimum, double maximum)
{
    auto value = numberOf(call, option, otherwise, minimum, maximum);
    if (value && *value != std::floor(*value))
        return fail(ExitCode::Usage,
                    u"--%1 takes a whole number, not \"%2\"."_s.arg(option, call.value(option)));
    return value;
}

constexpr double maxCounts = 1e6;

// Reads what leads the machine.
Outcome readShaft(const Invocation& call, PackingJob& job)
{
    const QString master = call.isSet(u"master"_s) ? call.value(u"master"_s) : u"clock"_s;
    if (master != u"clock" && master != u"encoder" && master != u"wheel")
        return fail(ExitCode::Usage, u"--master takes clock, encoder or wheel, not \"%1\"."_s.arg(master));
    const auto counts = wholeOf(call, u"master-counts"_s, 10'000, 4, maxCounts);
    const auto stops = wholeOf(call, u"master-stops"_s, 0, 1, maxBags);
    if (!counts || !stops)
        return tl::unexpected(!counts ? counts.error() : stops.error());
    if (master == u"clock")
        return {};
    job.machine.shaft.counts = static_cast<std::uint32_t>(*counts);
    job.machine.shaft.drivesFilm = master == u"wheel";
    job.shaftStopEvery = static_cast<std::uint32_t>(*stops);
    return {};
}

} // namespace

QList<QCommandLineOption> simulateOptions()
{
    QList<QCommandLineOption> options{
        {u"bags"_s, u"Bags to cut (default 1000)."_s, u"COUNT"_s},
        {u"seed"_s, u"Seed of the random numbers (default 1); the same seed gives the same bags."_s,
         u"NUMBER"_s},
        {u"tolerance"_s, u"Allowed deviation of a bag's length (default 0.2)."_s, u"MM"_s},
        {u"go-on"_s, u"Start again after an alarm, as an operator would, until all bags are cut."_s},
        {u"with-bags"_s, u"With --format json: print the bags too."_s},
        {u"set"_s,
         u"Set a parameter of the controller, such as parameter.cut_clearance=8; may be repeated."_s,
         u"NAME=VALUE"_s},
        {u"no-tracking"_s, u"Switch mark tracking off: parameter.mark_tracking=0."_s},
        {u"save-film"_s, u"Make no bags without product: parameter.empty_bag=1."_s},
        {u"sensor-compensation-ms"_s,
         u"Dead time of mark sensor and product eye that the controller knows (0 to 20, default 0); \"learned\": that of the mark sensor is taken as soon as it is offered, those of the eye are measured (a taught part: --product-scatter 0; two speeds: --change-rate-every)."_s,
         u"MS"_s},
        {u"change-rate-every"_s,
         u"Change to half of the rate and back after so many bags, while the machine runs; an encoder then leads at half of the rate."_s,
         u"BAGS"_s},
        {u"power-cuts"_s,
         u"Bags in which the power is cut; in half of them somebody turns the knife's shaft and pulls film and infeed (0 to 1, default 0)."_s,
         u"SHARE"_s},
        {u"stops"_s,
         u"Bags in which an operator stops the machine at once, to start it again 1 to 5 s later (0 to 1, default 0)."_s,
         u"SHARE"_s},
        {u"master"_s,
         u"What the machine follows (clock, encoder, wheel; default clock): an encoder on the line's shaft, or on a wheel on film that somebody else drives, turns once in 250 mm of film; --rate is its speed."_s,
         u"KIND"_s},
        {u"master-counts"_s,
         u"Counts per revolution of an encoder as the master, after quadrature (4 to 1000000, default 10000)."_s,
         u"N"_s},
        {u"master-stops"_s,
         u"Stop the line's shaft in mid-bag and start it again, after each so many bags (default: never)."_s,
         u"BAGS"_s},
        {u"table"_s,
         u"Run the --lengths at 60 bags/min and at the maximum feasible rate up to 300, with and without tracking; print one table."_s},
        {u"lengths"_s, u"Bag lengths for --table, in mm (default: those of the paper's Table 2)."_s,
         u"L1,L2,..."_s}};
    const controller::MachineOptions defaults;
    for (const Disturbance& each : disturbances) {
        Machine machine = defaults;
        options << QCommandLineOption(QString::fromLatin1(each.name),
                                      u"Disturbance: %1 (%2 to %3, default %4)."_s.arg(
                                          QLatin1String(each.what), QString::number(each.minimum),
                                          QString::number(each.maximum),
                                          QString::number(each.place(machine))),
                                      QString::fromLatin1(each.unit));
    }
    return options;
}

tl::expected<double, Failure> numberOf(const Invocation& call, const QString& option, double otherwise,
                                       double minimum, double maximum)
{
    if (!call.isSet(option))
        return otherwise;
    bool isNumber = false;
    const double value = call.value(option).toDouble(&isNumber);
    if (!isNumber || !(value >= minimum && value <= maximum))
        return fail(ExitCode::Usage, u"--%1 takes a number from %2 to %3, not \"%4\"."_s.arg(
                                         option, QString::number(minimum, 'g', 10),
                                         QString::number(maximum, 'g', 10), call.value(option)));
    return value;
}

tl::expected<controller::PackingJob, Failure> jobOf(const Invocation& call)
{
    PackingJob job;
    const auto bags = wholeOf(call, u"bags"_s, job.bags, 1, maxBags);
    const auto seed = wholeOf(call, u"seed"_s, 1, 0, maxSeed);
    auto parameters = parameterValues(call);
    if (!bags || !seed || !parameters)
        return tl::unexpected(!bags ? bags.error() : !seed ? seed.error() : parameters.error());
    job.bags = static_cast<std::uint32_t>(*bags);
    job.machine.seed = static_cast<std::uint64_t>(*seed);
    job.parameters = std::move(*parameters);
    job.goOn = call.isSet(u"go-on"_s);
    const auto every = wholeOf(call, u"change-rate-every"_s, 0, 1, maxBags);
    if (!every)
        return tl::unexpected(every.error());
    job.changeEvery = static_cast<std::uint32_t>(*every);
    const auto stops = numberOf(call, u"stops"_s, 0, 0, 1);
    if (!stops)
        return tl::unexpected(stops.error());
    job.stopShare = *stops;
    const auto powerCuts = numberOf(call, u"power-cuts"_s, 0, 0, 1);
    if (!powerCuts)
        return tl::unexpected(powerCuts.error());
    job.powerCutShare = *powerCuts;
    const auto shaft = readShaft(call, job);
    if (!shaft)
        return tl::unexpected(shaft.error());
    if (learns(call))
        job.onMarks = [taker = DeadTimeTaker()](auto registers) mutable { return taker.take(registers); };
    for (const Disturbance& each : disturbances) {
        double& place = each.place(job.machine);
        const auto value = numberOf(call, QString::fromLatin1(each.name), place, each.minimum, each.maximum);
        if (!value)
            return tl::unexpected(value.error());
        place = *value;
    }
    return job;
}

tl::expected<controller::ParameterValue, Failure> parameterOf(const QString& name, double value)
{
    const modbus::RegisterInfo* info = modbus::findRegister(name.toStdString());
    if (info == nullptr || !modbus::isMachineData(*info))
        return fail(ExitCode::Usage,
                    u"\"%1\" is not a parameter. campanelctl registers lists all parameters."_s.arg(name));
    controller::ParameterValue parameter;
    parameter.address = info->address;
    parameter.registers.resize(info->count);
    modbus::RegisterWriter writer(parameter.registers, info->address);
    if (const auto written = writer.physical(*info, value); !written)
        return fail(ExitCode::Usage, panel::RegisterWords::outOfRange(written.error()));
    return parameter;
}

tl::expected<program::ProgramImage, Failure> imageAt(program::Recipe recipe, double lengthMm, double rate)
{
    recipe.cutter().pinned = {profile::Field::BagLength, profile::Field::Rate};
    program::setValue(recipe, profile::Field::BagLength, lengthMm);
    program::setValue(recipe, profile::Field::Rate, rate);
    program::followRatios(recipe);
    auto image = program::buildProgram(recipe);
    if (!image)
        return fail(ExitCode::Refused, u"%1 mm at %2 bags/min: "_s.arg(lengthMm).arg(rate) +
                                           panel::RefusalSentences::program(image.error()));
    return std::move(*image);
}

tl::expected<Programs, Failure> programsOf(program::ProgramImage image, const PackingJob& job)
{
    Programs programs{std::move(image), {}};
    if (job.changeEvery == 0)
        return programs;
    const program::Recipe& recipe = programs.given.recipe;
    auto half = imageAt(recipe, program::value(recipe, profile::Field::BagLength),
                        program::value(recipe, profile::Field::Rate) / 2);
    if (!half)
        return tl::unexpected(half.error());
    programs.half = std::move(*half);
    return programs;
}

std::vector<controller::ParameterValue> DeadTimeTaker::take(std::span<const std::uint16_t> registers)
{
    for (const modbus::MarkEdge& edge : modbus::markEdges(registers, m_last)) {
        m_last = edge.number;
        m_takenMs = edge.deadMs;
        m_estimate.take(edge);
    }
    const auto offered = m_estimate.offered(m_takenMs);
    if (!offered)
        return {};
    return {parameterOf(u"parameter.mark_dead_time"_s, *offered).value()};
}

void DeadTimeTaker::see(std::span<const std::uint16_t> registers)
{
    for (const modbus::EyeEdge& edge : modbus::eyeEdges(registers, m_eye.last()))
        m_eye.take(edge);
}

PackingJob withPrograms(PackingJob job, const Programs& programs)
{
    const program::ProgramImage& image = programs.given;
    job.bank = image.registers;
    job.otherBank = programs.half.registers;
    job.timerClockHz = static_cast<std::uint32_t>(image.recipe.machine.timerClockHz);
    job.maxPulseHz = static_cast<std::uint32_t>(image.recipe.machine.maxPulseFrequencyHz);
    controller::ShaftOptions& shaft = job.machine.shaft;
    if (shaft.counts == 0)
        return job;
    // Both programs follow it.
    const double rate =
        program::value(image.recipe, profile::Field::Rate) / (job.otherBank.empty() ? 1.0 : 2.0);
    shaft.speedMmPerS = program::value(image.recipe, profile::Field::BagLength) * rate / 60.0;
    for (const auto& [name, value] :
         {std::pair{u"master.source"_s, 1.0}, std::pair{u"master.place"_s, shaft.drivesFilm ? 1.0 : 0.0},
          std::pair{u"master.counts"_s, static_cast<double>(shaft.counts)},
          std::pair{u"master.revolution"_s, shaft.revolutionMm}})
        job.parameters.insert(job.parameters.begin(), parameterOf(name, value).value());
    return job;
}

} // namespace campanel::cli
