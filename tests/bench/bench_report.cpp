// SPDX-License-Identifier: Apache-2.0
// Quantiles and the printed table.
#include "bench_report.h"

#include "tests/support/places.h"

#include <QFile>
#include <QProcess>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string_view>
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

// Returns the commit of the sources, with "-dirty" when they differ from it.
std::string commit()
{
    QProcess git;
    git.setWorkingDirectory(test::sourcePath("."));
    git.start(QStringLiteral("git"), {QStringLiteral("describe"), QStringLiteral("--always"),
                                      QStringLiteral("--exclude=*"), QStringLiteral("--dirty")});
    const bool isKnown =
        git.waitForFinished() && git.exitStatus() == QProcess::NormalExit && git.exitCode() == 0;
    return isKnown ? git.readAllStandardOutput().trimmed().toStdString() : "unknown";
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
    out << processorName() << ", " << std::thread::hardware_concurrency() << " threads, commit " << commit()
        << "\n\n"
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

void replaceTable(const std::string& path, const std::string& table)
{
    constexpr std::string_view begin = "<!-- campanel-bench: begin -->\n";
    constexpr std::string_view end = "<!-- campanel-bench: end -->\n";
    std::ifstream file(path);
    std::string text(std::istreambuf_iterator<char>(file), {});
    const std::size_t from = text.find(begin);
    const std::size_t to = text.find(end);
    if (from == std::string::npos || to == std::string::npos || to < from)
        throw std::runtime_error(path + " has no place for the table");
    text.replace(from + begin.size(), to - from - begin.size(), table);
    std::ofstream written(path, std::ios::trunc);
    written << text << std::flush;
    if (!written)
        throw std::runtime_error(path + " cannot be written");
}

Figures missed(const Figures& figures, const std::vector<std::string>& named)
{
    Figures result;
    for (const Figure& figure : figures) {
        const bool isNamed = std::ranges::any_of(
            named, [&](const std::string& name) { return figure.what.starts_with(name); });
        if (!figure.isPeer && !figure.holds() && !isNamed)
            result.push_back(figure);
    }
    return result;
}

} // namespace campanel::bench
