// SPDX-License-Identifier: Apache-2.0
#include "app/cli/simulate_table.h"

#include "app/cli/invocation.h"
#include "app/cli/report.h"
#include "app/cli/simulate_figures.h"
#include "app/cli/simulate_options.h"
#include "profile/cutter/limits.h"
#include "profile/cutter/paper_lengths.h"

#include <algorithm>
#include <array>
#include <cmath>

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

tl::expected<program::ProgramImage, Failure> imageAt(program::Recipe recipe, double lengthMm, double rate)
{
    recipe.cutter().pinned = {Field::BagLength, Field::Rate};
    program::setValue(recipe, Field::BagLength, lengthMm);
    program::setValue(recipe, Field::Rate, rate);
    auto image = program::buildProgram(recipe);
    if (!image)
        return fail(ExitCode::Refused, u"%1 mm at %2 bags/min: "_s.arg(lengthMm).arg(rate) +
                                           panel::RefusalSentences::program(image.error()));
    return std::move(*image);
}

struct Measured {
    PackingFigures figures;
    controller::PackingResult result;
};

Measured measure(const program::ProgramImage& image, controller::PackingJob job, bool tracks,
                 double toleranceMm)
{
    Measured measured{PackingFigures(toleranceMm), {}};
    // The last parameter overrides earlier ones.
    job.parameters.push_back(parameterOf(u"parameter.mark_tracking"_s, tracks ? 1 : 0).value());
    measured.result =
        runPacking(withProgram(std::move(job), image),
                   [&measured](const controller::PackedBag& bag) { measured.figures.add(bag); });
    return measured;
}

tl::expected<QJsonObject, Failure> measuredRow(const program::ProgramImage& image,
                                               const controller::PackingJob& job, double toleranceMm)
{
    const double lengthMm = program::value(image.recipe, Field::BagLength);
    const double rate = program::value(image.recipe, Field::Rate);
    const Measured tracked = measure(image, job, true, toleranceMm);
    const Measured untracked = measure(image, job, false, toleranceMm);
    for (const auto& each : {tracked.result, untracked.result}) {
        if (const Outcome ended = outcomeOf(each); !ended)
            return fail(ended.error().code,
                        u"%1 mm at %2 bags/min: "_s.arg(lengthMm).arg(rate) + ended.error().sentence);
    }
    const Spread& length = tracked.figures.lengthMm();
    const auto paper = std::ranges::find(profile::paperLengths, lengthMm, &profile::PaperLength::bagLengthMm);
    return QJsonObject{{u"set_length_mm"_s, lengthMm},
                       {u"paper_deviation_mm"_s,
                        paper == profile::paperLengths.end() ? QJsonValue() : QJsonValue(paper->deviationMm)},
                       {u"rate_bags_per_min"_s, rate},
                       {u"mean_mm"_s, orNull(length.mean())},
                       {u"standard_deviation_mm"_s, orNull(length.deviation())},
                       {u"largest_mm"_s, orNull(length.largest())},
                       {u"share_within"_s, orNull(tracked.figures.shareWithin())},
                       {u"bags_before_settled"_s, static_cast<qint64>(tracked.result.bags - length.count())},
                       {u"untracked_mean_mm"_s, orNull(untracked.figures.lengthMm().mean())},
                       {u"untracked_largest_mm"_s, orNull(untracked.figures.lengthMm().largest())}};
}

// Adds the slow row and, if the machine can be faster, the fast one.
Outcome addRows(const program::Recipe& recipe, double lengthMm, const controller::PackingJob& job,
                double toleranceMm, QJsonArray& rows)
{
    const auto slow = imageAt(recipe, lengthMm, slowRate);
    if (!slow)
        return tl::unexpected(slow.error());
    std::vector<program::ProgramImage> images{*slow};
    const auto fastest = profile::fastestRate(slow->cutter());
    const double rate = fastest ? std::floor(std::min(maxRate, fastest->rateBagsPerMin)) : slowRate;
    if (rate > slowRate) {
        auto fast = imageAt(recipe, lengthMm, rate);
        if (!fast)
            return tl::unexpected(fast.error());
        images.push_back(std::move(*fast));
    }
    for (const program::ProgramImage& image : images) {
        auto row = measuredRow(image, job, toleranceMm);
        if (!row)
            return tl::unexpected(row.error());
        rows.append(*row);
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
    QByteArrayList lines;
    QByteArrayList heads;
    for (const TableColumn& column : measuredColumns)
        heads << column.key;
    lines << heads.join(',');
    for (const QJsonValue& row : rows) {
        QByteArrayList cells;
        for (const TableColumn& column : measuredColumns) {
            const QJsonValue cell = row[QLatin1String(column.key)];
            cells << (cell.isNull() ? QByteArray() : number(cell.toDouble()));
        }
        lines << cells.join(',');
    }
    return lines.join('\n') + '\n';
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
