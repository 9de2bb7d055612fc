// SPDX-License-Identifier: Apache-2.0
// campanelctl: finds the command, runs it, and converts its outcome to an exit code and one line on stderr.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/link_session.h"
#include "app/cli/simulate/simulate_options.h"
#include "app/store/files/files.h"

#include <QGuiApplication>
#include <QLocale>
#include <QLoggingCategory>

#include <algorithm>
#include <array>
#include <clocale>
#include <cstdio>
#include <memory>
#include <string_view>

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
         u"Prints the curves even if they exceed a limit of the machine, then exits with 1."_s,
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
        {u"map"_s,
         u"Print the maximum rate of a cutter for each bag length, and the limit that sets it."_s,
         u"A rate of 0: no rate is possible. PNG: the map as a picture."_s,
         recipe,
         {u"csv"_s, u"json"_s, u"png"_s},
         {{u"lengths"_s, u"Number of lengths (2 to 10000, default 200)."_s, u"COUNT"_s, u"200"_s},
          {u"from-mm"_s, u"Shortest bag."_s, u"NUMBER"_s},
          {u"to-mm"_s, u"Longest bag (default: all regimes)."_s, u"NUMBER"_s}},
         runMap},
        {u"laws"_s,
         u"Print the laws of motion with their peak values, strengths and weaknesses."_s,
         u"Cv, Ca, Cj: maximum speed, acceleration and jerk of a move over 1 in time 1. For a speed law they are one\nderivative lower: Cv is the maximum acceleration. G(1): travel of a speed law. cj is null or inf where\nthe acceleration jumps inside; laws with parameters are shown with their default values."_s,
         CommandInfo::Nothing,
         all,
         {{u"json"_s, u"Same as --format json."_s}, {u"csv"_s, u"Same as --format csv."_s}},
         runLaws},
        {u"compare"_s,
         u"Print the peaks of a move or a rotary cutter for each possible law."_s,
         {},
         recipe,
         {u"text"_s, u"json"_s},
         {},
         runCompare},
        {u"intervals"_s,
         u"Compile a recipe to few intervals of constant acceleration; fewer may be possible."_s,
         u"With --cam-mov: the pulse times of one interval, published, corrected and in theory."_s,
         recipe,
         all,
         {{u"speed-error-mm-per-s"_s, u"Allowed speed error (default 5)."_s, u"NUMBER"_s, u"5"_s},
          {u"published"_s, u"Rows for the generator of the paper, not corrected for its clock."_s},
          {u"cam-mov"_s, u"Pulses, first speed, last speed, acceleration, such as 10,50,800,40000."_s,
           u"D,V0,V1,A"_s}},
         runIntervals},
        {u"knots"_s,
         u"Check a point cam at the end of the cycle; print its knots as CSV."_s,
         {},
         recipe,
         all,
         {{u"repair"_s, u"Close the cam smoothly first."_s}},
         runKnots},
        {u"segments"_s,
         u"Check the joints of a segment cam; print its segments as CSV."_s,
         {},
         recipe,
         all,
         {{u"repair"_s, u"Make the segments continuous first."_s}},
         runSegments},
        {u"recipe"_s,
         u"Print a recipe file, or the default recipe of a kind, with the options applied; sign and verify one."_s,
         u"new-key --name NAME --key SECRET creates the key of a signer: the secret key in a new file, the public one\non standard output. sign RECIPE.json --key SECRET prints the signed recipe. verify SIGNED.json --keys FOLDER\nchecks it with the public keys in a folder."_s,
         recipe | CommandInfo::Signing,
         {u"json"_s},
         {{u"name"_s, u"Name of the recipe, or of the signer."_s, u"TEXT"_s},
          {u"key"_s, u"File of the secret key."_s, u"FILE"_s},
          {u"keys"_s, u"Folder of the public keys."_s, u"FOLDER"_s}},
         runRecipe},
        {u"simulate"_s,
         u"Cut bags on a simulated packing machine; print a summary, or a row for each bag as CSV."_s,
         u"The simulation runs the core of the real controller. Accuracy excludes the bags before tracking has settled\n(bags_before_settled). CSV: the bags on standard output, the summary on standard error. An alarm ends\nthe run with exit code 1 unless --go-on is given. A share of 0.01 is 1 %."_s,
         recipe, all, simulateOptions(), runSimulate},
        {u"download"_s,
         u"Transfer a recipe's table, compare CRC-32, apply, wait until it is active."_s,
         u"A running machine applies the new table at its next cycle."_s,
         recipe | link,
         all,
         {{u"when-stopped"_s, u"Apply only at standstill; refused while the machine moves."_s},
          {u"verify"_s, u"Read every register back before applying."_s},
          {u"save"_s, u"Save to the controller's flash afterwards."_s},
          {u"reason"_s, u"Why a value is outside its approved window."_s, u"TEXT"_s}},
         runDownload},
        {u"status"_s,
         u"Print the controller's status and the program that it executes."_s,
         {},
         link,
         all,
         {},
         runStatus},
        {u"versions"_s,
         u"Print the versions of software, program and recipe, and how long the disk lasts."_s,
         u"With --port the controller and its program, with --data what the panel has left there: the versions of panel\nand gateway that ran last, the open recipe, and the growth of its data. The rest is unknown."_s,
         link,
         all,
         {{u"data"_s, u"Folder of the panel's data, such as /var/lib/campanel/data/campanel/campanel."_s,
           u"FOLDER"_s}},
         runVersions},
        {u"start"_s, u"Start the machine."_s, {}, link, {}, {permitOption()}, runStart},
        {u"stop"_s,
         u"Stop the machine at the end of the cycle. This is not an emergency stop."_s,
         {},
         link,
         {},
         {{u"now"_s, u"Ramp down immediately."_s}},
         runStop},
        {u"home"_s, u"Search for the index mark."_s, {}, link, {}, {permitOption()}, runHome},
        {u"jog-bag"_s,
         u"Make one bag out of standstill, slowly."_s,
         u"It is start-up scrap. The machine must be homed, and stands in phase afterwards."_s,
         link,
         {},
         {permitOption()},
         runJogBag},
        {u"cut"_s,
         u"Cut once with the knife alone, while the film stands."_s,
         u"The bags on both sides are start-up scrap; without film since the last cut there is none."_s,
         link,
         {},
         {permitOption()},
         runCut},
        {u"take"_s,
         u"Reject the next bag of a run, for a check."_s,
         u"A cam switch must be set to reject bags."_s,
         link,
         {},
         {},
         runTake},
        {u"acknowledge"_s,
         u"Silence the horn and end the blinking of the light tower."_s,
         {},
         link,
         {},
         {},
         runAcknowledge},
        {u"save"_s, u"Save the active program to the controller's flash."_s, {}, link, {}, {}, runSave},
        {u"output"_s,
         u"Try an output at standstill: output Switch3 --seconds 2."_s,
         u"The controller switches the output off half a second after this command has ended, and with any motion."_s,
         link | CommandInfo::Names,
         {},
         {{u"seconds"_s, u"Duration, up to 60 (default 1)."_s, u"NUMBER"_s, u"1"_s}, permitOption()},
         runOutput},
        {u"measure"_s,
         u"Measure an axis at standstill: measure turns film, measure direction infeed, measure film --length 248.5."_s,
         u"turns      turns knife, film or infeed slowly past five index marks and counts the pulses\ndirection  moves the axis a quarter of a turn forward, to be watched\nfilm       corrects the film per turn by the last bag, whose length a ruler says\nKeep hands away. The axis stops when this command ends, at Stop, emergency stop, open door or drive alarm."_s,
         link | CommandInfo::Names,
         {},
         {{u"length"_s, u"Length of the last bag by the ruler, mm."_s, u"MM"_s},
          {u"take"_s, u"Write the measured value into the controller."_s},
          permitOption()},
         runMeasure},
        {u"order"_s,
         u"Start, read or end the order that the controller counts: order start --quantity 5000 --lot L17."_s,
         u"start   counts from the next bag on, before a run or in it; --quantity and --lot are needed\nstatus  prints the counts: good + rejected + empty + on_the_way = cut\nend     ends the order before its quantity; the run goes on\nlist    prints the orders of a panel's database or of a backup, newest first: order list FILE; writes nothing to it\nsign    prints the file by which the plant offers an order to a machine; needs --order, --machine and --key too\nverify  checks such a file with the public keys of --keys: order verify FILE"_s,
         link | CommandInfo::Names,
         all,
         {{u"quantity"_s, u"Good bags to make, up to 1000000."_s, u"NUMBER"_s},
          {u"lot"_s, u"Lot of the order."_s, u"TEXT"_s},
          {u"order"_s, u"The plant's number of the order, to sign."_s, u"TEXT"_s},
          {u"recipe"_s, u"Recipe of the order, to sign; without: any."_s, u"NAME"_s},
          {u"machine"_s, u"Name of the machine (gateway.node), to sign."_s, u"NAME"_s},
          {u"message-before"_s, u"Bags before the end, with the action message (default 20)."_s, u"NUMBER"_s,
           u"20"_s},
          {u"key"_s, u"File of the secret key, to sign."_s, u"FILE"_s},
          {u"keys"_s, u"Folder of the public keys, to verify."_s, u"FOLDER"_s},
          {u"action"_s, u"At the quantity: none, message or stop (default stop)."_s, u"ACTION"_s, u"stop"_s}},
         runOrder},
        {u"set"_s,
         u"Write a parameter of the controller and read it back: set parameter.ramp_time 800."_s,
         u"parameter.master_direction 1 reverses the master of a cam, also while the machine runs; hand.speed 60 lets the\nprogram run at 60 % of its rate, until the controller's power goes; hand.cut 0.5 puts its cuts 0.5 mm later."_s,
         link | CommandInfo::Names,
         {},
         {},
         runSet},
        {u"doctor"_s,
         u"Diagnose the connection; only reads, writes to no device."_s,
         u"With --scan and without --port every serial port of this computer is searched."_s,
         link,
         {u"text"_s, u"json"_s},
         {{u"scan"_s,
           u"Search baud rates, parities, stop bits and unit numbers until a controller responds."_s}},
         runDoctor},
        {u"link"_s,
         u"Exchange the status for some time; print the communication statistics."_s,
         u"wire_share: time of the frames on the wire at this baud rate / communication time."_s,
         link,
         all,
         {{u"seconds"_s, u"Duration (default 10)."_s, u"NUMBER"_s, u"10"_s},
          {u"exchanges"_s, u"Number of exchanges, instead of --seconds."_s, u"COUNT"_s}},
         runLink},
        {u"frames"_s,
         u"Exchange the status for some time; print every frame in words and bytes."_s,
         {},
         link,
         {},
         {{u"seconds"_s, u"Duration (default 5)."_s, u"NUMBER"_s, u"5"_s}},
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
        {u"fleet"_s,
         u"List the machines at the plant's broker, each with its recipe, version, CRC-32 and since when."_s,
         u"Asks the gateways of a group for all values. With --signed, machines whose table is none of the signed ones\nare named, and the command exits with 1. The times are those of the machines' clocks."_s,
         CommandInfo::Nothing,
         all,
         {{u"broker"_s, u"Broker, without TLS and password (default port 1883)."_s, u"HOST[:PORT]"_s},
          {u"config"_s,
           u"File with a section [gateway]: broker, TLS, password, group (default: that of this computer)."_s,
           u"FILE"_s},
          {u"group"_s, u"Sparkplug group of the machines (default CamPanel)."_s, u"GROUP"_s},
          {u"wait"_s, u"Seconds to wait for answers (default 3)."_s, u"NUMBER"_s, u"3"_s},
          {u"signed"_s, u"Signed recipe, or folder of signed recipes, to compare with."_s, u"PATH"_s},
          {u"keys"_s, u"Folder of the public keys."_s, u"FOLDER"_s}},
         runFleet},
        {u"audit"_s,
         u"Check an audit trail for altered or missing rows: audit verify FILE."_s,
         u"FILE is a panel's campanel.sqlite, a copy together with its .audit file, or a backup. The command only\nreads FILE. Exits with 1 if a row was altered or rows are missing, or if this cannot be ruled out."_s,
         CommandInfo::TrailFile,
         all,
         {},
         runAudit},
        {u"package"_s,
         u"Sign a package of CamPanel for the update from a stick, and check one."_s,
         u"The keys are those of recipe new-key. sign FILE.deb --key SECRET prints the signature; write it to\nFILE.deb.sig beside the package. verify FILE.deb --keys FOLDER reads the whole package. schema prints the schemas\nof the databases: versions with the same ones read each other's data."_s,
         CommandInfo::PackageFile,
         {u"json"_s},
         {{u"key"_s, u"File of the secret key."_s, u"FILE"_s},
          {u"keys"_s, u"Folder of the public keys."_s, u"FOLDER"_s}},
         runPackage},
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

// Returns the application: a picture needs fonts, but no screen.
std::unique_ptr<QCoreApplication> newApplication(int& argc, char** argv)
{
    const auto isPicture = [](const char* argument) { return std::string_view(argument).ends_with("png"); };
    if (argc < 2 || std::string_view(argv[1]) != "map" || std::none_of(argv + 2, argv + argc, isPicture))
        return std::make_unique<QCoreApplication>(argc, argv);
    qputenv("QT_QPA_PLATFORM", "minimal:enable_fonts");
    // Qt warns of an absent runtime folder, which a picture does not need.
    QLoggingCategory::setFilterRules(u"default.warning=false"_s);
    return std::make_unique<QGuiApplication>(argc, argv);
}

} // namespace

int main(int argc, char** argv)
{
    preferUtf8();
    QLocale::setDefault(QLocale(QLocale::English)); // the language of the sentences, with a decimal point
    const auto application = newApplication(argc, argv);
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
                           ? u"Name a command. campanelctl --help lists all commands."_s
                           : u"Unknown command \"%1\". campanelctl --help lists all commands."_s.arg(name)});
    Invocation call(*command);
    if (const Outcome parsed = call.parse(arguments); !parsed)
        return report(parsed.error());
    if (call.wantsHelp())
        return print(call.helpText());
    const Outcome outcome = command->run(call);
    return outcome ? static_cast<int>(ExitCode::Success) : report(outcome.error());
}
