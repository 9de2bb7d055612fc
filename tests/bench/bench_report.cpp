// SPDX-License-Identifier: Apache-2.0
// Quantiles and the printed table.
#include "bench_report.h"

#include <QFile>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace campanel::bench {
namespace {

std::string processorName()
{
    std::ifstream info("/proc/cpuinfo");
    std::string line;
    while (std::getline(info, line)) {
        if (line.starts_with("model name"))
            return line.substr(line.find(':') + 2);
    }
    return "unknown processor";
}

} // namespace

double quantile(std::vector<double> samples, double fraction)
{
    std::ranges::sort(samples);
    const double position = fraction * static_cast<double>(samples.size() - 1);
    return samples[static_cast<std::size_t>(std::ceil(position))];
}

double residentMb(std::int64_t processId)
{
    QFile status(QStringLiteral("/proc/%1/status").arg(processId));
    if (!status.open(QIODevice::ReadOnly))
        throw std::runtime_error("a started program ended before it was measured");
    static const QRegularExpression pattern(QStringLiteral("VmRSS:\\s+(\\d+) kB"));
    return pattern.match(QString::fromLatin1(status.readAll())).captured(1).toDouble() / 1024;
}

std::string format(const Figures& figures)
{
    std::ostringstream out;
    out << processorName() << ", " << std::thread::hardware_concurrency() << " threads\n\n"
        << "| figure | measured | limit | ratio | |\n|---|---:|---:|---:|---|\n"
        << std::fixed;
    for (const Figure& figure : figures) {
        const auto number = [&out](double value) -> std::ostream& {
            return out << std::setprecision(value < 10 ? 3 : value < 1000 ? 1 : 0) << value;
        };
        out << "| " << figure.what << " | ";
        number(figure.measured) << ' ' << figure.unit << " | "
                                << (figure.isPeer ? "" : (figure.atMost ? "<= " : ">= "));
        number(figure.limit) << ' ' << figure.unit << " (" << figure.limitText << ") | "
                             << std::setprecision(3) << figure.ratio() << " | "
                             << (figure.isPeer ? "peer" : (figure.holds() ? "ok" : "MISSED")) << " |\n";
    }
    return out.str();
}

} // namespace campanel::bench
