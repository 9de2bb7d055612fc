// SPDX-License-Identifier: Apache-2.0
// campanel-bench: measures the figures of the README, as ratios against limits and peers in one run.
#include "bench_report.h"

#include "app/shell/qml_modules.h"

#include <QCommandLineParser>
#include <QGuiApplication>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

using namespace campanel::bench;
using namespace Qt::StringLiterals;

namespace {
constexpr int usageError = 2;

// Ends the program with what to do where Qt would abort: it calls a missing display fatal. Its other messages
// meanwhile only tell how it looked for one.
void reportMissingDisplay(QtMsgType type, const QMessageLogContext& /*context*/, const QString& /*message*/)
{
    if (type != QtFatalMsg)
        return;
    std::cerr << "campanel-bench: There is no display; run it without one: QT_QPA_PLATFORM=offscreen "
                 "build/bench/tests/campanel-bench\n";
    std::_Exit(usageError);
}
} // namespace

int main(int argc, char** argv)
{
    const QtMessageHandler usual = qInstallMessageHandler(reportMissingDisplay);
    const QGuiApplication app(argc, argv);
    qInstallMessageHandler(usual);
    QCommandLineParser parser;
    parser.setApplicationDescription(
        u"Measures CamPanel against its limits; prints one table as Markdown. Ends with 1 when a figure misses its limit."_s);
    parser.addHelpOption();
    parser.addPositionalArgument(
        u"part"_s,
        u"motion, programs, packing, plots, link, peers, start, idle, memory, records; all when none is named"_s,
        u"[part...]"_s);
    const QCommandLineOption markdown(
        u"markdown"_s, u"Writes the table into this file, usually docs/figures.md."_s, u"file"_s);
    const QCommandLineOption named(
        u"named"_s,
        u"A figure that is known to miss its limit, by the beginning of its name; may be repeated."_s,
        u"figure"_s);
    parser.addOptions({markdown, named});
    parser.process(app);

    const QStringList wanted = parser.positionalArguments();
    if (parser.isSet(markdown) && !wanted.isEmpty()) {
        std::cerr << "campanel-bench: the table of a file has all parts\n";
        return usageError;
    }
    const struct {
        QString name;
        Figures (*measure)();
    } parts[] = {{u"motion"_s, measureMotion},   {u"programs"_s, measurePrograms},
                 {u"packing"_s, measurePacking}, {u"plots"_s, measurePlots},
                 {u"link"_s, measureLink},       {u"peers"_s, measurePeers},
                 {u"start"_s, measureStart},     {u"idle"_s, measureIdle},
                 {u"memory"_s, measureMemory},   {u"records"_s, measureRecords}};

    Figures figures;
    try {
        for (const auto& part : parts) {
            if (wanted.isEmpty() || wanted.contains(part.name)) {
                for (const Figure& figure : part.measure())
                    figures.push_back(figure);
            }
        }
    } catch (const std::exception& problem) {
        std::cerr << "campanel-bench: " << problem.what() << '\n';
        return 1;
    }
    if (figures.empty()) {
        std::cerr << "campanel-bench: no such part; see --help\n";
        return usageError;
    }
    const std::string table = format(figures);
    std::cout << table;
    try {
        if (parser.isSet(markdown))
            replaceTable(parser.value(markdown).toStdString(), table);
    } catch (const std::exception& problem) {
        std::cerr << "campanel-bench: " << problem.what() << '\n';
        return 1;
    }
    std::vector<std::string> known;
    for (const QString& name : parser.values(named))
        known.push_back(name.toStdString());
    const Figures late = missed(figures, known);
    for (const Figure& figure : late)
        std::cerr << "campanel-bench: " << figure.what << " misses its limit\n";
    return late.empty() ? 0 : 1;
}
