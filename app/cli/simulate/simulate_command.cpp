// SPDX-License-Identifier: Apache-2.0
// campanelctl simulate: a packing machine that cuts bags by a recipe, without a line, much faster than a real
// one.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/recipe_options.h"
#include "app/cli/report.h"
#include "app/cli/simulate/simulate_figures.h"
#include "app/cli/simulate/simulate_options.h"
#include "app/cli/simulate/simulate_table.h"
#include "app/store/files/files.h"

#include <cstdio>
#include <ctime>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

constexpr double usualToleranceMm = 0.2;
constexpr double maxToleranceMm = 100.0;

// The rows of the bags in the requested format.
class BagRows {
public:
    explicit BagRows(const Invocation& call)
        : m_csv(call.format() == u"csv")
        , m_json(call.format() == u"json" && call.isSet(u"with-bags"_s))
    {
    }

    void add(const controller::PackedBag& bag)
    {
        if (m_csv)
            addBag(m_rows, bag);
        if (m_json)
            m_list.append(bagObject(bag));
    }

    // Writes CSV with the bags alone, so that the next program can read it; the summary goes to another
    // place.
    [[nodiscard]] Outcome deliver(const Invocation& call, QJsonObject summary) const
    {
        if (m_csv) {
            std::fputs(qPrintable(store::printable(QString::fromUtf8(formatted(summary, u"text"_s)))),
                       stderr);
            return call.deliver(m_rows.bytes());
        }
        if (m_json)
            summary[u"bag_list"_s] = m_list;
        return call.deliver(formatted(summary, call.format()));
    }

private:
    bool m_csv;
    bool m_json;
    store::CsvWriter m_rows = bagRows();
    QJsonArray m_list;
};

double cpuS()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

Outcome checkCombination(const Invocation& call)
{
    const bool table = call.isSet(u"table"_s);
    if (!table && call.isSet(u"lengths"_s))
        return fail(ExitCode::Usage, u"--lengths requires --table."_s);
    for (const QString& option : {u"no-tracking"_s, u"with-bags"_s}) {
        if (table && call.isSet(option))
            return fail(ExitCode::Usage, u"--%1 cannot be combined with --table."_s.arg(option));
    }
    return {};
}

// Each edge of the eye that was measured, and whether the panel would offer its dead time.
QJsonObject eyeObject(const program::EyeDeadTime& eye)
{
    using Eye = program::EyeDeadTime;
    QJsonObject object;
    for (const auto& [edge, name] : {std::pair(Eye::Begin, u"begin"_s), std::pair(Eye::End, u"end"_s)}) {
        if (const auto found = eye.measured(edge))
            object[name] = QJsonObject{{u"dead_time_ms"_s, found->ms},
                                       {u"standard_deviation_ms"_s, found->marginMs},
                                       {u"offered"_s, found->marginMs <= Eye::maxMarginMs}};
    }
    return object;
}

Outcome simulateOne(const Invocation& call, const program::Recipe& recipe, controller::PackingJob job,
                    double toleranceMm)
{
    DeadTimeTaker taker;
    if (job.onMarks) {
        job.onMarks = [&taker](auto registers) { return taker.take(registers); };
        job.onEye = [&taker](auto registers) { taker.see(registers); };
    }
    auto image = program::buildProgram(recipe);
    if (!image)
        return fail(image.error());
    const auto programs = programsOf(std::move(*image), job);
    if (!programs)
        return tl::unexpected(programs.error());
    const program::Recipe& made = programs->given.recipe;
    PackingFigures figures(toleranceMm);
    BagRows rows(call);
    const double before = cpuS();
    const controller::PackingResult result =
        runPacking(withPrograms(job, *programs), [&figures, &rows](const controller::PackedBag& bag) {
            figures.add(bag);
            rows.add(bag);
        });
    const double spent = cpuS() - before;
    const Outcome ended = outcomeOf(result);
    QJsonObject summary = figures.object(result, spent);
    summary[u"name"_s] = QString::fromStdString(made.name);
    summary[u"set_length_mm"_s] = program::value(made, profile::Field::BagLength);
    summary[u"rate_bags_per_min"_s] = program::value(made, profile::Field::Rate);
    summary[u"seed"_s] = static_cast<qint64>(job.machine.seed);
    if (job.machine.shaft.counts != 0)
        summary[u"master"_s] = masterObject(result, job.machine.shaft);
    if (const auto found = taker.found())
        summary[u"learned"_s] = QJsonObject{{u"mark_dead_time_ms"_s, found->ms},
                                            {u"standard_deviation_ms"_s, found->marginMs},
                                            {u"slip_mm_per_m_per_s2"_s, found->slipMm},
                                            {u"ramps"_s, found->ramps}};
    if (const QJsonObject eye = eyeObject(taker.eye()); !eye.isEmpty())
        summary[u"eye"_s] = eye;
    summary[u"end"_s] = ended ? u"all bags cut"_s : ended.error().sentence.simplified();
    if (const Outcome delivered = rows.deliver(call, summary); !delivered)
        return delivered;
    return ended;
}

} // namespace

Outcome runSimulate(const Invocation& call)
{
    if (const Outcome checked = checkCombination(call); !checked)
        return checked;
    const auto recipe = recipeOf(call);
    if (!recipe)
        return tl::unexpected(recipe.error());
    if (!recipe->isCutter())
        return fail(ExitCode::Usage,
                    u"Bags are cut by a rotary cutter: name a recipe of kind rotary_cutter."_s);
    const auto job = jobOf(call);
    if (!job)
        return tl::unexpected(job.error());
    const auto tolerance = numberOf(call, u"tolerance"_s, usualToleranceMm, 0, maxToleranceMm);
    if (!tolerance)
        return tl::unexpected(tolerance.error());
    return call.isSet(u"table"_s) ? simulateTable(call, *recipe, *job, *tolerance)
                                  : simulateOne(call, *recipe, *job, *tolerance);
}

} // namespace campanel::cli
