// SPDX-License-Identifier: Apache-2.0
// campanelctl map: the fastest rate over the bag length, and the limit that sets it.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/recipe_options.h"
#include "app/cli/report.h"
#include "app/panel/words/recipe_words.h"
#include "app/plot/picture/regime_picture.h"
#include "profile/cutter/limits.h"
#include "profile/cutter/paper_lengths.h"

#include <QBuffer>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QPainter>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

constexpr int maxLengths = 10'000;
constexpr int pictureWidth = 1280; // px
constexpr int pictureHeight = 800;
constexpr int picturePadding = 24;
constexpr int pictureFont = 20;

using profile::RegimeMap;
using profile::RegimePoint;

QString limitOf(const RegimePoint& point)
{
    return fromView(profile::limitId(point.limit));
}

QByteArray mapCsv(const RegimeMap& map)
{
    using Csv = store::CsvWriter;
    store::CsvTable<RegimePoint> file(
        {{u"bag_length_mm"_s, [](Csv& csv, const RegimePoint& point) { csv.significant(point.bagLengthMm); }},
         {u"rate_bags_per_min"_s,
          [](Csv& csv, const RegimePoint& point) { csv.significant(point.rateBagsPerMin); }},
         {u"limited_by"_s, [](Csv& csv, const RegimePoint& point) { csv.text(limitOf(point)); }}});
    for (const RegimePoint& point : map.points)
        file.add(point);
    return file.bytes();
}

QJsonObject pointObject(const RegimePoint& point)
{
    return {{u"bag_length_mm"_s, point.bagLengthMm},
            {u"rate_bags_per_min"_s, point.rateBagsPerMin},
            {u"limited_by"_s, limitOf(point)}};
}

QJsonObject mapObject(const RegimeMap& map, const program::Recipe& recipe)
{
    const profile::CutterLengths& lengths = map.lengths;
    QJsonArray points;
    for (const RegimePoint& point : map.points)
        points.append(pointObject(point));
    QJsonArray paper;
    for (const profile::PaperLength& each : profile::paperLengths)
        paper.append(pointObject(profile::regimePoint(recipe.cutter(), recipe.machine, each.bagLengthMm)));
    QJsonObject object{{u"name"_s, QString::fromStdString(recipe.name)},
                       {u"equal_speed_length_mm"_s, lengths.equalSpeedMm},
                       {u"jaw_length_mm"_s, lengths.jawMm},
                       {u"jaw_length_with_margin_mm"_s, lengths.jawWithMarginMm},
                       {u"dwell_length_mm"_s, lengths.dwellMm},
                       {u"stroke_length_mm"_s, lengths.strokeMm},
                       {u"recipe"_s, QJsonValue::Null},
                       {u"points"_s, points},
                       {u"paper_lengths"_s, paper}};
    if (const auto cycle = profile::solveNumbers(recipe.cutter(), recipe.machine))
        object[u"recipe"_s] =
            QJsonObject{{u"bag_length_mm"_s, cycle->bagLengthMm},
                        {u"rate_bags_per_min"_s, cycle->rateBagsPerMin},
                        {u"seal_time_ms"_s, profile::sealTimeMs(*cycle, recipe.machine)},
                        {u"feasible"_s, profile::isFeasible(recipe.cutter(), recipe.machine)}};
    return object;
}

QByteArray mapPng(const RegimeMap& map, const program::Recipe& recipe)
{
    plot::RegimePicture picture;
    plot::RegimeContent& content = picture.content;
    content.map = std::make_shared<const RegimeMap>(map);
    for (const profile::Limit limit : map.limits)
        content.limitNames << panel::RecipeWords::limitName(limit);
    content.rateUnit = panel::RecipeWords::unit(profile::info(profile::Field::Rate).unit);
    content.refusedName = u"not possible"_s;
    content.marksName = u"reference lengths"_s;
    for (const profile::PaperLength& each : profile::paperLengths)
        content.marks << each.bagLengthMm;
    if (const auto cycle = profile::solveNumbers(recipe.cutter(), recipe.machine)) {
        content.dot = {cycle->bagLengthMm, cycle->rateBagsPerMin};
        content.shownRate = cycle->rateBagsPerMin;
    }
    picture.style.font.setPixelSize(pictureFont);
    picture.layOut(QSizeF(pictureWidth - 2 * picturePadding, pictureHeight - 2 * picturePadding));

    QImage image(pictureWidth, pictureHeight, QImage::Format_RGB32);
    image.fill(picture.style.surface);
    QPainter painter(&image);
    painter.translate(picturePadding, picturePadding);
    picture.paint(painter);
    painter.end();
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return buffer.data();
}

// Returns the lengths of the options, or those that show all regimes.
tl::expected<profile::LengthRange, Failure> rangeOf(const Invocation& call, const program::Recipe& recipe)
{
    const profile::FieldInfo& length = profile::info(profile::Field::BagLength);
    profile::LengthRange range = profile::regimeRange(recipe.cutter(), recipe.machine);
    const auto read = [&](const QString& option, double& value) {
        bool ok = true;
        if (call.isSet(option))
            value = call.value(option).toDouble(&ok);
        return ok && profile::inRange(profile::Field::BagLength, value);
    };
    if (!read(u"from-mm"_s, range.fromMm) || !read(u"to-mm"_s, range.toMm) || !(range.fromMm < range.toMm))
        return fail(ExitCode::Usage,
                    u"--from-mm and --to-mm take two rising bag lengths from %1 to %2 mm."_s.arg(length.min)
                        .arg(length.max));
    return range;
}

} // namespace

Outcome runMap(const Invocation& call)
{
    bool ok = false;
    const int count = call.value(u"lengths"_s).toInt(&ok);
    if (!ok || count < 2 || count > maxLengths)
        return fail(ExitCode::Usage, u"--lengths takes a whole number from 2 to %1."_s.arg(maxLengths));
    auto recipe = recipeOf(call);
    if (!recipe)
        return tl::unexpected(recipe.error());
    if (!recipe->isCutter())
        return fail(ExitCode::Usage, u"The map is of a rotary cutter: --kind rotary_cutter."_s);
    *recipe = program::quantised(*recipe); // like the table
    // Invalid ratios have no range of lengths; the map refuses them with the whole reason.
    if (const auto solved = profile::solve(recipe->cutter(), recipe->machine);
        !solved && solved.error().limit != profile::Limit::StrokeCannotClose)
        return fail(solved.error());
    const auto range = rangeOf(call, *recipe);
    if (!range)
        return tl::unexpected(range.error());
    const auto map =
        profile::regimeMap(recipe->cutter(), recipe->machine, *range, static_cast<std::size_t>(count));
    if (!map)
        return fail(map.error());
    if (call.format() == u"png")
        return call.deliverBytes(mapPng(*map, *recipe));
    return call.deliver(call.format() == u"csv" ? mapCsv(*map)
                                                : QJsonDocument(mapObject(*map, *recipe)).toJson());
}

} // namespace campanel::cli
