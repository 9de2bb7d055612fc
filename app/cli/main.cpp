// SPDX-License-Identifier: Apache-2.0
// campanelctl: finds the command, runs it, and converts its outcome to an exit code and one line on stderr.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/simulate_options.h"
#include "app/store/files/files.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <clocale>
#include <cstdio>

using namespace Qt::StringLiterals;
using namespace campanel::cli;

namespace {

std::vector<CommandInfo> commandTable()
{
    constexpr unsigned recipe = CommandInfo::Recipe;
    constexpr unsigned link = CommandInfo::Link;
    const QStringList all{u"text"_s, u"csv"_s, u"json"_s};
    return {
        {u"profile"_s,
         u"Solve a recipe; print its numbers, or its curves as CSV or JSON."_s,
         u"Prints the curves also when a limit of the machine is broken, and then exits with 1."_s,
         recipe,
         all,
         {{u"points"_s, u"Points of the curves (2 to 100000, default 1000)."_s, u"COUNT"_s, u"1000"_s}},
         runProfile},
        {u"table"_s,
         u"Build the table of a recipe; print its figures and rows."_s,
         {},
         recipe,
         all,
         {},
         runTable},
        {u"laws"_s,
         u"Print the laws of motion with their peak values, strengths and weaknesses."_s,
         u"Cv, Ca, Cj: largest speed, acceleration and jerk of a move over 1 in time 1. As a speed law they "
         u"are one\n"
         "derivative lower: Cv is the largest acceleration. G(1): travel of a speed law. cj is null or inf "
         "where\n"
         "the acceleration jumps inside; laws with parameters are shown with the default ones."_s,
         CommandInfo::Nothing,
         all,
         {{u"json"_s, u"Same as --format json."_s}, {u"csv"_s, u"Same as --format csv."_s}},
         runLaws},
        {u"compare"_s,
         u"Print the peaks of a move by every law that it can use."_s,
         {},
         recipe,
         {u"text"_s, u"json"_s},
         {},
         runCompare},
        {u"intervals"_s,
         u"Compile a recipe to the fewest intervals of constant acceleration."_s,
         u"With --cam-mov: the pulse times of one interval, as published, corrected and in theory."_s,
         recipe,
         all,
         {{u"speed-error-mm-per-s"_s, u"Largest speed error allowed (default 5)."_s, u"NUMBER"_s, u"5"_s},
          {u"published"_s, u"Rows for the generator as the paper has it, not corrected for its clock."_s},
          {u"cam-mov"_s, u"Pulses, first speed, last speed, acceleration, such as 10,50,800,40000."_s,
           u"D,V0,V1,A"_s}},
         runIntervals},
        {u"knots"_s,
         u"Check where a point cam closes; print its knots as CSV."_s,
         {},
         recipe,
         all,
         {{u"repair"_s, u"Close the cam smoothly first."_s}},
         runKnots},
        {u"recipe"_s,
         u"Print a recipe file: the one named or a kind's default, with the options put in."_s,
         {},
         recipe,
         {u"json"_s},
         {{u"name"_s, u"Name of the recipe."_s, u"TEXT"_s}},
         runRecipe},
        {u"simulate"_s,
         u"Cut bags on a simulated packing machine; print a summary, or a row for each bag as CSV."_s,
         u"The controller is the real one's core. Figures of accuracy leave out the bags before tracking has "
         u"settled\n"
         "(bags_before_settled). CSV: the bags alone on standard output, the summary on standard error. An "
         "alarm "
         u"ends\n"
         "the run with exit code 1 unless --go-on is given. A share of 0.01 is 1 %."_s,
         recipe, all, simulateOptions(), runSimulate},
        {u"download"_s,
         u"Transfer a recipe's table, compare CRC-32, apply, wait until it is active."_s,
         u"A running machine takes the new table over at its next cycle."_s,
         recipe | link,
         all,
         {{u"when-stopped"_s, u"Apply only at standstill; refused while the machine moves."_s},
          {u"verify"_s, u"Read every register back before applying."_s},
          {u"save"_s, u"Save to the controller's flash afterwards."_s}},
         runDownload},
        {u"status"_s,
         u"Print the controller's status and the program that it executes."_s,
         {},
         link,
         all,
         {},
         runStatus},
        {u"start"_s, u"Start the machine."_s, {}, link, {}, {}, runStart},
        {u"stop"_s,
         u"Stop the machine at the end of the cycle. This is no emergency stop."_s,
         {},
         link,
         {},
         {{u"now"_s, u"Ramp down at once."_s}},
         runStop},
        {u"home"_s, u"Look for the index mark."_s, {}, link, {}, {}, runHome},
        {u"save"_s, u"Save the active program to the controller's flash."_s, {}, link, {}, {}, runSave},
        {u"set"_s,
         u"Write a parameter of the controller and read it back: set parameter.ramp_time 800."_s,
         u"parameter.master_direction 1 turns the master of a point cam round, also while it runs."_s,
         link | CommandInfo::Names,
         {},
         {},
         runSet},
        {u"doctor"_s,
         u"Find out why there is no connection; only reads, writes to no device."_s,
         u"With --scan and without --port every serial port of this computer is searched."_s,
         link,
         {u"text"_s, u"json"_s},
         {{u"scan"_s, u"Search baud rates, parities, stop bits and units until a controller answers."_s}},
         runDoctor},
        {u"link"_s,
         u"Exchange the status for a while; print the figures of the line."_s,
         u"wire_share: time that the frames need at this baud rate against the time that the exchanges took."_s,
         link,
         all,
         {{u"seconds"_s, u"How long (default 10)."_s, u"NUMBER"_s, u"10"_s},
          {u"exchanges"_s, u"So many exchanges instead."_s, u"COUNT"_s}},
         runLink},
        {u"frames"_s,
         u"Exchange the status for a while; print every frame in words and bytes as it passes."_s,
         {},
         link,
         {},
         {{u"seconds"_s, u"How long (default 5)."_s, u"NUMBER"_s, u"5"_s}},
         runFrames},
        {u"registers"_s,
         u"Print the register map, or read registers."_s,
         u"Fields of a program bank, such as program.bag_length, are read from the active bank."_s,
         link | CommandInfo::Names,
         {u"text"_s, u"csv"_s, u"json"_s, u"markdown"_s},
         {{u"read"_s, u"Read the registers NAME... from the controller."_s},
          {u"json"_s, u"Same as --format json."_s},
          {u"markdown"_s, u"Same as --format markdown."_s}},
         runRegisters},
        {u"audit"_s,
         u"Check whether an audit trail is unbroken: audit verify FILE."_s,
         u"FILE is a panel's campanel.sqlite, a copy of it together with its .audit file, or a backup. "
         u"Nothing is\n"
         "written to it. Exits with 1 when a row was altered or rows are missing, also when that cannot be "
         "ruled "
         "out."_s,
         CommandInfo::TrailFile,
         all,
         {},
         runAudit},
    };
}

int report(const Failure& failure)
{
    std::fprintf(stderr, "campanelctl: %s\n",
                 qPrintable(campanel::store::printable(failure.sentence.simplified())));
    return static_cast<int>(failure.code);
}

int print(const QString& text)
{
    const Outcome written = writeStandardOutput(text.toUtf8());
    return written ? static_cast<int>(ExitCode::Success) : report(written.error());
}

// Sets UTF-8: newer versions of Qt warn on standard error about other locales, although they replace them
// themselves.
void preferUtf8()
{
    const char* name = std::setlocale(LC_CTYPE, "");
    const QByteArray locale = QByteArray(name ? name : "C").toUpper();
    if (!locale.contains("UTF-8") && !locale.contains("UTF8"))
        qputenv("LC_ALL", "C.UTF-8");
}

} // namespace

int main(int argc, char** argv)
{
    preferUtf8();
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(u"campanelctl"_s);
    QCoreApplication::setApplicationVersion(QStringLiteral(CAMPANEL_VERSION));
    const QStringList arguments = QCoreApplication::arguments();
    const std::vector<CommandInfo> commands = commandTable();
    const QString name = arguments.value(1);
    if (name == u"--help" || name == u"-h" || name == u"help")
        return print(overviewText(commands));
    if (name == u"--version" || name == u"-v")
        return print(u"campanelctl "_s + QCoreApplication::applicationVersion() + u'\n');
    const auto command = std::ranges::find(commands, name, &CommandInfo::name);
    if (command == commands.end())
        return report({ExitCode::Usage,
                       name.isEmpty()
                           ? u"Name a command; campanelctl --help lists them."_s
                           : u"There is no command \"%1\"; campanelctl --help lists them."_s.arg(name)});
    Invocation call(*command);
    if (const Outcome parsed = call.parse(arguments); !parsed)
        return report(parsed.error());
    if (call.wantsHelp())
        return print(call.helpText());
    const Outcome outcome = command->run(call);
    return outcome ? static_cast<int>(ExitCode::Success) : report(outcome.error());
}
