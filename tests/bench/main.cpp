// SPDX-License-Identifier: Apache-2.0
// campanel-bench: measures the figures of the README, as ratios against limits and peers in one run.
#include "bench_report.h"

#include "app/shell/qml_modules.h"

#include <QCommandLineParser>
#include <QGuiApplication>

#include <exception>
#include <iostream>

using namespace campanel::bench;
using namespace Qt::StringLiterals;

int main(int argc, char** argv)
{
    const QGuiApplication app(argc, argv);
    QCommandLineParser parser;
    parser.setApplicationDescription(
        u"Measures CamPanel against its limits; prints one table as Markdown."_s);
    parser.addHelpOption();
    parser.addPositionalArgument(
        u"part"_s,
        u"motion, programs, packing, plots, link, peers, start, idle, memory, records; all when none is named"_s,
        u"[part...]"_s);
    parser.process(app);

    const QStringList wanted = parser.positionalArguments();
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
        return 2;
    }
    std::cout << format(figures);
    return 0;
}
