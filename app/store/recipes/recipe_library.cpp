// SPDX-License-Identifier: Apache-2.0
#include "app/store/recipes/recipe_library.h"

#include "app/store/database/clock_mark.h"
#include "app/store/database/names.h"
#include "app/store/files/files.h"
#include "app/store/files/store_logging.h"
#include "app/store/recipes/program_json.h"
#include "app/store/recipes/recipe_json.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

QString kindKey(const program::Recipe& recipe)
{
    const std::string_view key = program::kindInfo(recipe.kind()).key;
    return QString::fromLatin1(key.data(), static_cast<qsizetype>(key.size()));
}

// The beginning of each question for versions; readVersions() reads its columns.
const QString selectVersions =
    uR"(SELECT v.recipe, v.version, v.saved_ms, v.saved_by, v.json, r.name, v.clock_doubtful
        FROM recipe_version v JOIN recipe r ON r.id = v.recipe )"_s;

QList<RecipeVersion> readVersions(QSqlQuery& query)
{
    QList<RecipeVersion> versions;
    while (query.next()) {
        const QString name = query.value(5).toString();
        auto recipe = fromJson(query.value(4).toByteArray(), name, Names::Repair);
        if (!recipe) {
            qCWarning(storeLog).noquote() << printable(u"Version %1 of a recipe cannot be read. %2"_s.arg(
                query.value(1).toString(), FileErrorText::describe(recipe.error())));
            continue;
        }
        recipe->name = name.toStdString();
        recipe->version = query.value(1).toInt();
        versions << RecipeVersion{query.value(0).toLongLong(), recipe->version, query.value(2).toLongLong(),
                                  query.value(3).toString(),   *recipe,         query.value(6).toBool()};
    }
    return versions;
}

bool isSameProgram(const program::Recipe& left, const program::Recipe& right)
{
    return programJson(left) == programJson(right) && program::sameCodes(left, right) &&
           left.trims == right.trims && left.windows == right.windows;
}

} // namespace

RecipeLibrary::Result<QList<RecipeVersion>> RecipeLibrary::newest()
{
    auto query = m_database.execute(
        selectVersions +
        uR"(WHERE r.deleted = 0 AND v.version = (SELECT MAX(version) FROM recipe_version WHERE recipe = r.id))"_s);
    if (!query)
        return tl::unexpected(query.error());
    QList<RecipeVersion> found = readVersions(*query);
    query->finish();
    if (const auto added = addOlder(found); !added)
        return tl::unexpected(added.error());
    std::ranges::sort(found, std::greater<>(),
                      [](const RecipeVersion& each) { return std::pair(each.savedMs, each.recipeId); });
    return found;
}

// Adds the newest version that can be read of each recipe whose newest one cannot.
RecipeLibrary::Result<void> RecipeLibrary::addOlder(QList<RecipeVersion>& found)
{
    auto all = m_database.execute(
        uR"(SELECT recipe, MAX(version) FROM recipe_version JOIN recipe ON recipe.id = recipe
            WHERE deleted = 0 GROUP BY recipe)"_s);
    if (!all)
        return tl::unexpected(all.error());
    QHash<qint64, int> newest;
    while (all->next())
        newest.insert(all->value(0).toLongLong(), all->value(1).toInt());
    all->finish();
    for (const RecipeVersion& each : found)
        newest.remove(each.recipeId);
    for (auto missing = newest.begin(); missing != newest.end(); ++missing) {
        const auto readable = versions(missing.key());
        if (!readable)
            return tl::unexpected(readable.error());
        if (readable->isEmpty())
            continue;
        found << readable->first();
        found.last().unreadableVersion = missing.value();
    }
    return {};
}

RecipeLibrary::Result<QStringList> RecipeLibrary::unreadable()
{
    const auto readable = newest();
    if (!readable)
        return tl::unexpected(readable.error());
    auto all = m_database.execute(u"SELECT id, name FROM recipe WHERE deleted = 0 ORDER BY name"_s);
    if (!all)
        return tl::unexpected(all.error());
    QStringList names;
    while (all->next()) {
        if (std::ranges::find(*readable, all->value(0).toLongLong(), &RecipeVersion::recipeId) ==
            readable->end())
            names << all->value(1).toString();
    }
    return names;
}

RecipeLibrary::Result<QHash<QString, qint64>> RecipeLibrary::downloads()
{
    constexpr int soughtRows = 20'000; // of the trail, which may have millions
    auto found = m_database.execute(uR"(SELECT what, object, after, sequence
            FROM (SELECT * FROM audit ORDER BY sequence DESC LIMIT ?)
            WHERE what IN ('program.download', 'recipe.rename') AND outcome = 'done' ORDER BY sequence)"_s,
                                    {soughtRows});
    if (!found)
        return tl::unexpected(found.error());
    QHash<QString, qint64> last;
    while (found->next()) {
        const QString name = nameKey(found->value(1).toString());
        if (found->value(0).toString() == u"program.download")
            last[name] = found->value(3).toLongLong();
        else if (const qint64 number = last.take(name))
            last[nameKey(found->value(2).toString())] = number;
    }
    return last;
}

RecipeLibrary::Result<QList<RecipeVersion>> RecipeLibrary::versions(qint64 recipeId)
{
    auto query =
        m_database.execute(selectVersions + u"WHERE v.recipe = ? ORDER BY v.version DESC"_s, {recipeId});
    return query ? Result<QList<RecipeVersion>>(readVersions(*query)) : tl::unexpected(query.error());
}

RecipeLibrary::Result<bool> RecipeLibrary::isEmpty()
{
    auto query = m_database.execute(u"SELECT 1 FROM recipe LIMIT 1"_s);
    return query ? Result<bool>(!query->next()) : tl::unexpected(query.error());
}

RecipeLibrary::Result<bool> RecipeLibrary::has(const program::Recipe& recipe)
{
    auto query =
        m_database.execute(selectVersions + u"WHERE r.deleted = 0 AND r.name_key = ? AND v.version = ?"_s,
                           {nameKey(QString::fromStdString(recipe.name)), recipe.version});
    if (!query)
        return tl::unexpected(query.error());
    const QList<RecipeVersion> found = readVersions(*query);
    return !found.isEmpty() && isSameProgram(found.first().recipe, recipe);
}

// Returns the recipe of this name, with its present spelling. A deleted recipe is restored.
RecipeLibrary::Result<qint64> RecipeLibrary::idOf(const program::Recipe& recipe)
{
    const QString name = keptName(QString::fromStdString(recipe.name));
    auto known = m_database.execute(u"SELECT id FROM recipe WHERE name_key = ?"_s, {nameKey(name)});
    if (!known)
        return tl::unexpected(known.error());
    if (!known->next()) {
        const auto added =
            m_database.execute(u"INSERT INTO recipe (name, name_key) VALUES (?, ?)"_s, {name, nameKey(name)});
        return added ? Result<qint64>(added->lastInsertId().toLongLong()) : tl::unexpected(added.error());
    }
    const qint64 id = known->value(0).toLongLong();
    known->finish();
    return m_database.execute(u"UPDATE recipe SET name = ?, deleted = 0 WHERE id = ?"_s, {name, id})
        .map([id](const auto&) { return id; });
}

// Returns the highest number of a version, also of one that cannot be read; 0: there is none. Earlier
// versions of the program gave numbers beyond the last one: no version can follow them.
RecipeLibrary::Result<int> RecipeLibrary::highestVersion(qint64 recipeId)
{
    auto found = m_database.execute(
        u"SELECT coalesce(max(version), 0) FROM recipe_version WHERE recipe = ?"_s, {recipeId});
    if (!found || !found->next())
        return tl::unexpected(found ? m_database.stepped(*found).error() : found.error());
    return found->value(0).toInt();
}

RecipeLibrary::Result<RecipeVersion> RecipeLibrary::save(const program::Recipe& recipe, const QString& by,
                                                         qint64 nowMs, ClockState clock)
{
    RecipeVersion saved{0, recipe.version, nowMs, by, recipe};
    const auto done = m_database.transaction([&]() -> Result<void> {
        const auto newest = newestRecordMs(m_database);
        if (!newest)
            return tl::unexpected(newest.error());
        saved.isClockDoubtful = isTimeDoubtful(nowMs, *newest, clock);
        const auto id = idOf(recipe);
        if (!id)
            return tl::unexpected(id.error());
        saved.recipeId = *id;
        const auto before = versions(saved.recipeId);
        const auto top = highestVersion(saved.recipeId);
        if (!before || !top)
            return tl::unexpected(before ? top.error() : before.error());
        if (!before->isEmpty() && recipe.version <= before->first().version &&
            isSameProgram(before->first().recipe, recipe)) {
            saved = before->first();
            return {};
        }
        saved.version = *top > 0 ? std::max(recipe.version, *top + 1) : recipe.version;
        saved.recipe.version = saved.version;
        if (saved.version > program::maxVersion)
            return tl::unexpected(StoreError{StoreError::Kind::LastVersion, m_database.path(),
                                             QString::fromStdString(recipe.name)});
        const auto inserted = m_database.execute(
            u"INSERT INTO recipe_version (recipe, version, saved_ms, saved_by, kind, json, clock_doubtful) "
            "VALUES (?, ?, ?, ?, ?, ?, ?)"_s,
            {saved.recipeId, saved.version, nowMs, by, kindKey(recipe), toJson(saved.recipe),
             saved.isClockDoubtful});
        return inserted ? Result<void>() : tl::unexpected(inserted.error());
    });
    return done ? Result<RecipeVersion>(saved) : tl::unexpected(done.error());
}

RecipeLibrary::Result<void> RecipeLibrary::rename(qint64 recipeId, const QString& name)
{
    const auto done = m_database.execute(u"UPDATE recipe SET name = ?, name_key = ? WHERE id = ?"_s,
                                         {keptName(name), nameKey(name), recipeId});
    return done ? Result<void>() : tl::unexpected(done.error());
}

RecipeLibrary::Result<void> RecipeLibrary::setDeleted(qint64 recipeId, bool isDeleted)
{
    const auto done =
        m_database.execute(u"UPDATE recipe SET deleted = ? WHERE id = ?"_s, {isDeleted ? 1 : 0, recipeId});
    return done ? Result<void>() : tl::unexpected(done.error());
}

RecipeLibrary::Result<QList<MachineData>> RecipeLibrary::machines()
{
    auto query = m_database.execute(u"SELECT json FROM machine_data"_s);
    if (!query)
        return tl::unexpected(query.error());
    QList<MachineData> machines;
    QStringList known{QString()};
    while (query->next()) {
        if (const auto recipe = fromJson(query->value(0).toByteArray(), {}, Names::Repair)) {
            machines << MachineData{*recipe, {}};
            known << kindKey(*recipe);
        }
    }
    auto others = m_database.execute(
        selectVersions + u"WHERE v.kind NOT IN ('%1') ORDER BY v.saved_ms DESC"_s.arg(known.join(u"', '"_s)));
    if (!others)
        return tl::unexpected(others.error());
    for (const RecipeVersion& each : readVersions(*others)) {
        if (!known.contains(kindKey(each.recipe))) {
            machines << MachineData{each.recipe, QString::fromStdString(each.recipe.name)};
            known << kindKey(each.recipe);
        }
    }
    return machines;
}

RecipeLibrary::Result<void> RecipeLibrary::saveMachine(const program::Recipe& recipe, const QString& by,
                                                       qint64 nowMs, bool replaces)
{
    const auto done = m_database.execute(
        u"INSERT INTO machine_data (kind, saved_ms, saved_by, json) VALUES (?, ?, ?, ?) ON CONFLICT (kind) "
        u"DO "_s +
            (replaces ? u"UPDATE SET saved_ms = excluded.saved_ms, saved_by = excluded.saved_by, "
                        "json = excluded.json"_s
                      : u"NOTHING"_s),
        {kindKey(recipe), nowMs, by, toJson(recipe)});
    return done ? Result<void>() : tl::unexpected(done.error());
}

} // namespace campanel::store
