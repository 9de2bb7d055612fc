// SPDX-License-Identifier: Apache-2.0
#include "app/cli/simulate/simulate_table.h"

#include "app/cli/invocation.h"
#include "app/cli/report.h"
#include "app/cli/simulate/simulate_figures.h"
#include "app/cli/simulate/simulate_options.h"
#include "profile/cutter/limits.h"
#include "profile/cutter/paper_lengths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

using profile::Field;

constexpr double slowRate = 60.0; // bags/min
constexpr double maxRate = 300.0;

struct TableColumn {
    const char* key;
    const char* heading; // in text
    int width;
    int decimals;
};
constexpr std::array measuredColumns{
    TableColumn{"set_length_mm", "length", 7, 1},
    TableColumn{"paper_deviation_mm", "paper", 7, 1},
    TableColumn{"rate_bags_per_min", "rate", 6, 0},
    TableColumn{"mean_mm", "mean", 9, 4},
    TableColumn{"standard_deviation_mm", "sd", 9, 4},
    TableColumn{"largest_mm", "largest", 9, 3},
    TableColumn{"share_within", "within", 9, 5},
    TableColumn{"bags_before_settled", "unsettled", 10, 0},
    TableColumn{"untracked_mean_mm", "untr. mean", 11, 3},
    TableColumn{"untracked_largest_mm", "largest", 9, 3},
    // The same with the gentlest ratios.
    TableColumn{"gentle_standard_deviation_mm", "gentle sd", 10, 4},
    TableColumn{"gentle_largest_mm", "largest", 9, 3},
    // Where the cuts of the own ratios lie on the print.
    TableColumn{"mark_error_rms_mm", "mark rms", 10, 4},
    TableColumn{"mark_error_largest_mm", "largest", 9, 3},
    TableColumn{"share_past_0.4_mm", "past 0.4", 10, 5},
};

tl::expected<std::vector<double>, Failure> lengthsOf(const Invocation& call)
{
    std::vector<double> lengths;
    if (!call.isSet(u"lengths"_s)) {
        std::ranges::transform(profile::paperLengths, std::back_inserter(lengths),
                               &profile::PaperLength::bagLengthMm);
        return lengths;
    }
    for (const QString& part : call.value(u"lengths"_s).split(u',')) {
        bool isNumber = false;
        lengths.push_back(part.trimmed().toDouble(&isNumber));
        if (!isNumber || !std::isfinite(lengths.back()))
            return fail(ExitCode::Usage,
                        u"--lengths takes numbers separated by commas such as 100,249.5, not \"%1\"."_s.arg(
                            call.value(u"lengths"_s)));
    }
    return lengths;
}

struct Measured {
    PackingFigures figures;
    controller::PackingResult result;
};

Measured measure(const Programs& programs, controller::PackingJob job, bool tracks, double toleranceMm)
{
    Measured measured{PackingFigures(toleranceMm), {}};
    // The last parameter overrides earlier ones.
    job.parameters.push_back(parameterOf(u"parameter.mark_tracking"_s, tracks ? 1 : 0).value());
    measured.result =
        runPacking(withPrograms(std::move(job), programs),
                   [&measured](const controller::PackedBag& bag) { measured.figures.add(bag); });
    return measured;
}

// One line of the table: a length at a rate. The own ratios of the recipe may not allow it.
struct Line {
    double lengthMm = 0;
    double rate = 0;
    std::optional<Programs> own;
    std::optional<Programs> gentle;
};

Outcome addLine(const Line& line, const controller::PackingJob& job, double toleranceMm, QJsonArray& rows)
{
    const auto paper =
        std::ranges::find(profile::paperLengths, line.lengthMm, &profile::PaperLength::bagLengthMm);
    QJsonObject row;
    for (const TableColumn& column : measuredColumns)
        row[QLatin1String(column.key)] = QJsonValue(); // not known
    row[u"set_length_mm"_s] = line.lengthMm;
    row[u"rate_bags_per_min"_s] = line.rate;
    if (paper != profile::paperLengths.end())
        row[u"paper_deviation_mm"_s] = paper->deviationMm;
    Outcome outcome;
    const auto measured = [&](const std::optional<Programs>& programs, bool tracks) {
        std::optional<Measured> found;
        if (!programs)
            return found;
        found = measure(*programs, job, tracks, toleranceMm);
        if (const Outcome ended = outcomeOf(found->result); !ended && outcome)
            outcome = fail(ended.error().code, u"%1 mm at %2 bags/min: "_s.arg(line.lengthMm).arg(line.rate) +
                                                   ended.error().sentence);
        return found;
    };
    if (const auto tracked = measured(line.own, true)) {
        const Spread& length = tracked->figures.lengthMm();
        row[u"mean_mm"_s] = orNull(length.mean());
        row[u"standard_deviation_mm"_s] = orNull(length.deviation());
        row[u"largest_mm"_s] = orNull(length.largest());
        row[u"share_within"_s] = orNull(tracked->figures.shareWithin());
        row[u"mark_error_rms_mm"_s] = orNull(tracked->figures.markMm().rms());
        row[u"mark_error_largest_mm"_s] = orNull(tracked->figures.markMm().largest());
        row[u"share_past_0.4_mm"_s] = orNull(tracked->figures.shareFarFromMark());
        row[u"bags_before_settled"_s] = static_cast<qint64>(tracked->result.bags - length.count());
    }
    if (const auto untracked = measured(line.own, false)) {
        row[u"untracked_mean_mm"_s] = orNull(untracked->figures.lengthMm().mean());
        row[u"untracked_largest_mm"_s] = orNull(untracked->figures.lengthMm().largest());
    }
    if (const auto gentle = measured(line.gentle, true)) {
        row[u"gentle_standard_deviation_mm"_s] = orNull(gentle->figures.lengthMm().deviation());
        row[u"gentle_largest_mm"_s] = orNull(gentle->figures.lengthMm().largest());
    }
    if (outcome)
        rows.append(row);
    return outcome;
}

tl::expected<Programs, Failure> programsAt(const program::Recipe& recipe, double lengthMm, double rate,
                                           const controller::PackingJob& job)
{
    auto image = imageAt(recipe, lengthMm, rate);
    if (!image)
        return tl::unexpected(image.error());
    return programsOf(std::move(*image), job);
}

// Returns the highest whole rate of the table with these ratios.
double highestRate(const program::ProgramImage& image)
{
    const auto fastest = profile::fastestRate(image.cutter());
    return fastest ? std::floor(std::min(maxRate, fastest->rateBagsPerMin)) : slowRate;
}

// Adds the slow row, the fastest one of the recipe's ratios, and the fastest one of the gentlest ratios,
// where each is faster than the one before.
Outcome addRows(const program::Recipe& recipe, double lengthMm, const controller::PackingJob& job,
                double toleranceMm, QJsonArray& rows)
{
    const auto slow = imageAt(recipe, lengthMm, slowRate);
    if (!slow)
        return tl::unexpected(slow.error());
    program::Recipe gentle = recipe;
    gentle.cutter().ratioMode = profile::RatioMode::Gentle;
    const auto slowGentle = imageAt(gentle, lengthMm, slowRate);
    double last = 0;
    const double ownRate = highestRate(*slow);
    for (const double rate : {slowRate, ownRate, slowGentle ? highestRate(*slowGentle) : slowRate}) {
        if (rate <= last)
            continue;
        last = rate;
        Line line{lengthMm, rate, {}, {}};
        if (auto programs = programsAt(gentle, lengthMm, rate, job))
            line.gentle = std::move(*programs);
        if (rate <= ownRate) {
            auto programs = programsAt(recipe, lengthMm, rate, job);
            if (!programs)
                return tl::unexpected(programs.error());
            line.own = std::move(*programs);
        }
        if (const Outcome added = addLine(line, job, toleranceMm, rows); !added)
            return added;
    }
    return {};
}

QByteArray tableText(const QJsonArray& rows, const controller::PackingJob& job, double toleranceMm)
{
    QString text =
        u"mm; %1 bags per row, seed %2; within %3 mm; paper: deviation of its machine in Table 2\n"_s
            .arg(job.bags)
            .arg(job.machine.seed)
            .arg(toleranceMm);
    for (const TableColumn& column : measuredColumns)
        text += QString::fromLatin1(column.heading).rightJustified(column.width);
    for (const QJsonValue& row : rows) {
        text += u'\n';
        for (const TableColumn& column : measuredColumns) {
            const QJsonValue cell = row[QLatin1String(column.key)];
            text += (cell.isNull() ? u"--"_s : QString::number(cell.toDouble(), 'f', column.decimals))
                        .rightJustified(column.width);
        }
    }
    return (text + u'\n').toUtf8();
}

QByteArray tableCsv(const QJsonArray& rows)
{
    QStringList header;
    for (const TableColumn& column : measuredColumns)
        header << QString::fromLatin1(column.key);
    store::CsvWriter csv(header.join(u','), {});
    for (const QJsonValue& row : rows) {
        for (const TableColumn& column : measuredColumns)
            addCell(csv, row[QLatin1String(column.key)]);
        csv.endLine();
    }
    return csv.bytes();
}

} // namespace

Outcome simulateTable(const Invocation& call, const program::Recipe& recipe,
                      const controller::PackingJob& job, double toleranceMm)
{
    const auto lengths = lengthsOf(call);
    if (!lengths)
        return tl::unexpected(lengths.error());
    QJsonArray rows;
    Outcome outcome;
    for (const double lengthMm : *lengths) {
        if (const Outcome added = addRows(recipe, lengthMm, job, toleranceMm, rows); !added && outcome)
            outcome = added;
    }
    QByteArray text;
    if (call.format() == u"json")
        text = formatted(QJsonObject{{u"rows"_s, rows}}, call.format());
    else
        text = call.format() == u"csv" ? tableCsv(rows) : tableText(rows, job, toleranceMm);
    if (const Outcome delivered = call.deliver(text); !delivered)
        return delivered;
    return outcome;
}

} // namespace campanel::cli
