// SPDX-License-Identifier: Apache-2.0
#include "app/store/recipes/recipe_library.h"

#include "app/store/database/clock_mark.h"
#include "app/store/recipes/program_json.h"
#include "app/store/recipes/recipe_json.h"

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
        auto recipe = fromJson(query.value(4).toByteArray(), {});
        if (!recipe)
            continue;
        recipe->name = query.value(5).toString().toStdString();
        recipe->version = query.value(1).toInt();
        versions << RecipeVersion{query.value(0).toLongLong(), recipe->version, query.value(2).toLongLong(),
                                  query.value(3).toString(),   *recipe,         query.value(6).toBool()};
    }
    return versions;
}

bool isSameProgram(const program::Recipe& left, const program::Recipe& right)
{
    return programJson(left) == programJson(right) && program::sameCodes(left, right);
}

} // namespace

RecipeLibrary::Result<QList<RecipeVersion>> RecipeLibrary::newest()
{
    auto query = m_database.execute(
        selectVersions +
        uR"(WHERE r.deleted = 0 AND v.version = (SELECT MAX(version) FROM recipe_version WHERE recipe = r.id)
            ORDER BY v.saved_ms DESC, r.id DESC)"_s);
    return query ? Result<QList<RecipeVersion>>(readVersions(*query)) : tl::unexpected(query.error());
}

RecipeLibrary::Result<QList<RecipeVersion>> RecipeLibrary::versions(qint64 recipeId)
{
    auto query =
        m_database.execute(selectVersions + u"WHERE v.recipe = ? ORDER BY v.version DESC"_s, {recipeId});
    return query ? Result<QList<RecipeVersion>>(readVersions(*query)) : tl::unexpected(query.error());
}

RecipeLibrary::Result<bool> RecipeLibrary::has(const program::Recipe& recipe)
{
    auto query =
        m_database.execute(selectVersions + u"WHERE r.deleted = 0 AND r.name = ? AND v.version = ?"_s,
                           {QString::fromStdString(recipe.name), recipe.version});
    if (!query)
        return tl::unexpected(query.error());
    const QList<RecipeVersion> found = readVersions(*query);
    return !found.isEmpty() && isSameProgram(found.first().recipe, recipe);
}

RecipeLibrary::Result<RecipeVersion> RecipeLibrary::save(const program::Recipe& recipe, const QString& by,
                                                         qint64 nowMs, bool isClockUnset)
{
    RecipeVersion saved{0, recipe.version, nowMs, by, recipe};
    const auto done = m_database.transaction([&]() -> Result<void> {
        const auto newest = newestRecordMs(m_database);
        if (!newest)
            return tl::unexpected(newest.error());
        saved.isClockDoubtful = isClockUnset || isTimeDoubtful(nowMs, *newest);
        const QString name = QString::fromStdString(recipe.name);
        // Updates the spelling of the name; a deleted recipe is restored.
        auto known = m_database.execute(
            u"INSERT INTO recipe (name) VALUES (?) ON CONFLICT (name) DO UPDATE SET name = excluded.name, "
            "deleted = 0 RETURNING id"_s,
            {name});
        if (!known || !known->next())
            return tl::unexpected(known ? StoreError{} : known.error());
        saved.recipeId = known->value(0).toLongLong();
        known->finish();
        const auto before = versions(saved.recipeId);
        if (!before)
            return tl::unexpected(before.error());
        if (!before->isEmpty()) {
            const RecipeVersion& top = before->first();
            if (recipe.version <= top.version && isSameProgram(top.recipe, recipe)) {
                saved = top;
                return {};
            }
            saved.version = std::max(recipe.version, top.version + 1);
            saved.recipe.version = saved.version;
        }
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
    const auto done = m_database.execute(u"UPDATE recipe SET name = ? WHERE id = ?"_s, {name, recipeId});
    return done ? Result<void>() : tl::unexpected(done.error());
}

RecipeLibrary::Result<void> RecipeLibrary::setDeleted(qint64 recipeId, bool isDeleted)
{
    const auto done =
        m_database.execute(u"UPDATE recipe SET deleted = ? WHERE id = ?"_s, {isDeleted ? 1 : 0, recipeId});
    return done ? Result<void>() : tl::unexpected(done.error());
}

RecipeLibrary::Result<QList<program::Recipe>> RecipeLibrary::machines()
{
    auto query = m_database.execute(u"SELECT json FROM machine_data"_s);
    if (!query)
        return tl::unexpected(query.error());
    QList<program::Recipe> machines;
    while (query->next()) {
        if (const auto recipe = fromJson(query->value(0).toByteArray(), {}))
            machines << *recipe;
    }
    return machines;
}

RecipeLibrary::Result<void> RecipeLibrary::saveMachine(const program::Recipe& recipe, const QString& by,
                                                       qint64 nowMs)
{
    const auto done = m_database.execute(
        u"INSERT INTO machine_data (kind, saved_ms, saved_by, json) VALUES (?, ?, ?, ?) ON CONFLICT (kind) "
        u"DO UPDATE "
        "SET saved_ms = excluded.saved_ms, saved_by = excluded.saved_by, json = excluded.json"_s,
        {kindKey(recipe), nowMs, by, toJson(recipe)});
    return done ? Result<void>() : tl::unexpected(done.error());
}

} // namespace campanel::store
