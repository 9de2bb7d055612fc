// SPDX-License-Identifier: Apache-2.0
#include "app/panel/library/recipes.h"

#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/library/recipe_audit.h"
#include "app/panel/recipe/recipe_edit.h"
#include "app/panel/records/database_service.h"
#include "app/store/database/names.h"

#include <QDir>

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

namespace campanel::panel {

using program::Recipe;
using store::RecipeVersion;

Recipes::Recipes(Controller& controller, Editor& editor, DatabaseService& records, const QString& folder,
                 QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_editor(editor)
    , m_records(records)
    , m_wallClock([] { return QDateTime::currentDateTime(); })
    , m_files(
          QDir(folder).filePath(u"recipes"_s),
          [this](const store::RecipeOffer& offer) { return consequence(offer); }, this)
    , m_exports(QDir(folder).filePath(u"recipes"_s), this)
{
    connect(&records.store(), &store::StoreThread::opened, this, &Recipes::begin);
    connect(&editor, &Editor::applied, this, [this](const Recipe& recipe) {
        emit downloaded(recipe);
        keep(recipe, Origin::Editor, {});
    });
    connect(&editor, &Editor::recipeChanged, this, &Recipes::followEditor);
    connect(&controller, &Controller::programChanged, this, &Recipes::show);
    m_files.guardBy(controller.accessCheck());
    m_exports.guardBy(controller.accessCheck());
    connect(&m_files, &RecipeFiles::taken, this, &Recipes::import);
    m_editor.setNewestVersion([this](const std::string& name) {
        const RecipeVersion* known = named(QString::fromStdString(name));
        return known ? known->version : 0;
    });
    m_messageTimer.setSingleShot(true);
    m_messageTimer.setInterval(messageTime);
    m_messageTimer.callOnTimeout(this, &Recipes::dismissMessage);
    LanguageNotifier::follow(this, [this] {
        dismissMessage(); // it is in the previous language
        show();
    });
}

Recipes::~Recipes()
{
    m_editor.setNewestVersion([](const std::string&) { return 0; });
}

void Recipes::begin()
{
    reload();
    const Recipe open = m_editor.storedRecipe();
    work([open](store::RecipeLibrary& library) { return library.has(open); },
         [this, open](bool isKept) {
             work([](store::RecipeLibrary& library) { return library.isEmpty(); },
                  [this, open, isKept](bool isEmpty) {
                      checkOpenRecipe(open, isKept, isEmpty);
                      nameUnreadable();
                  });
         });
}

void Recipes::reload()
{
    if (std::exchange(m_isReading, true)) {
        m_isReadWanted = true;
        return;
    }
    work([](store::RecipeLibrary& library) { return library.machines(); },
         [this](const QList<store::MachineData>& machines) {
             m_machineData = machines;
             for (const store::MachineData& each : machines)
                 m_editor.setMachine(each.recipe.kind(), each.recipe.machine);
         });
    work([](store::RecipeLibrary& library) { return library.downloads(); },
         [this](const QHash<QString, qint64>& downloads) { m_downloads = downloads; });
    m_records.store().run(
        this, [](store::Database& database) { return store::RecipeLibrary(database).newest(); },
        [this](const tl::expected<Versions, store::StoreError>& newest) {
            m_isReading = false;
            if (std::exchange(m_isReadWanted, false))
                reload();
            if (!newest)
                return m_records.reportError(newest.error());
            m_all = *newest;
            m_unread.clear();
            m_shapes.clear();
            for (const RecipeVersion& each : m_all)
                m_shapes.insert(each.recipeId, shapeOf(each.recipe));
            m_isReady = true;
            if (!chosenRecipe()) {
                const RecipeVersion* open = named(m_editor.recipeName());
                m_chosenId = open ? open->recipeId : 0;
            }
            show();
            m_files.updateRows();
        });
}

void Recipes::keep(const Recipe& recipe, Origin origin, std::function<void(const RecipeVersion& kept)> done,
                   const QString& signer)
{
    const QString by = accessCheck().person();
    const qint64 nowMs = m_wallClock().toMSecsSinceEpoch();
    const store::ClockState clock = m_records.clockState();
    work(
        [recipe, origin, by, nowMs, clock](store::RecipeLibrary& library) {
            auto saved = library.save(recipe, by, nowMs, clock);
            if (const auto kept = library.saveMachine(recipe, by, nowMs, origin == Origin::Editor); !kept)
                saved = tl::unexpected(kept.error());
            return saved;
        },
        [this, recipe, done, signer](const RecipeVersion& saved) {
            RecipeVersion kept = saved;
            kept.recipe = recipe;
            kept.recipe.version = saved.version;
            const RecipeVersion* before = named(nameOf(recipe));
            for (const RecipeVersion& unread : std::as_const(m_unread))
                before = unread.recipeId == saved.recipeId ? &unread : before;
            if (!before || before->version != kept.version)
                emit noted(recipeSaved(before ? std::optional(*before) : std::nullopt, kept, signer));
            // For whoever asks before the list is read again.
            if (const auto at = std::ranges::find(m_all, kept.recipeId, &RecipeVersion::recipeId);
                at != m_all.end())
                *at = kept;
            else
                m_unread << kept;
            if (done)
                done(kept);
            reload();
        });
}

void Recipes::keepAndOpen(const Recipe& recipe, Origin origin,
                          std::function<QString(const Recipe& kept)> sentence)
{
    keep(recipe, origin, [this, sentence](const RecipeVersion& kept) {
        m_chosenId = kept.recipeId;
        m_editor.open(kept.recipe);
        say(sentence(kept.recipe));
    });
}

const RecipeVersion* Recipes::chosenRecipe() const
{
    const auto found = std::ranges::find(m_all, m_chosenId, &RecipeVersion::recipeId);
    return found == m_all.end() ? nullptr : &*found;
}

const RecipeVersion* Recipes::named(const QString& name) const
{
    const auto isNamed = [&name](const RecipeVersion& each) {
        return store::isSameName(nameOf(each.recipe), name);
    };
    const auto found = std::ranges::find_if(m_all, isNamed);
    return found == m_all.end() ? nullptr : &*found;
}

Recipe Recipes::onThisMachine(Recipe recipe) const
{
    const Recipe before = recipe;
    recipe.machine = m_editor.newRecipe(recipe.kind()).machine;
    if (!sameRecipe(before, recipe))
        program::followRatios(recipe);
    return recipe;
}

int Recipes::nextVersion() const
{
    return m_editor.recipe().version;
}

void Recipes::setWantedName(const QString& name)
{
    m_wantedName = name;
    emit wantedNameChanged();
}

QString Recipes::nameProblem() const
{
    const QString name = store::keptName(m_wantedName);
    if (name.isEmpty())
        return tr("Enter a name.");
    if (store::hiddenCharacter(m_wantedName))
        return tr("The name has characters that nobody can see. Enter the name again.");
    if (name.toStdString().size() > program::longestNameBytes)
        return tr("The name is too long. Enter at most %1 letters, or a third as many Chinese characters.")
            .arg(program::longestNameBytes);
    if (named(name))
        return tr("A recipe with this name already exists.");
    return {};
}

bool Recipes::chooseNamed(const QString& name)
{
    const RecipeVersion* found = named(name);
    if (found)
        chooseId(found->recipeId);
    return found != nullptr;
}

void Recipes::open()
{
    const RecipeVersion* chosen = chosenRecipe();
    if (m_controller.accessCheck().require(Level::Operator) && chosen) {
        m_editor.open(onThisMachine(chosen->recipe));
        dismissMessage();
    }
}

void Recipes::save()
{
    if (!m_controller.accessCheck().require(Level::Operator))
        return;
    keep(m_editor.recipe(), Origin::Editor,
         [this, before = m_editor.storedRecipe()](const RecipeVersion& kept) {
             // Unless another recipe has been opened since then.
             if (sameRecipe(m_editor.storedRecipe(), before))
                 m_editor.takeStored(kept.recipe);
             say(tr("Saved: %1, version %2.").arg(nameOf(kept.recipe), QString::number(kept.version)));
         });
}

void Recipes::create(int kind)
{
    if (!m_controller.accessCheck().require(Level::Technician) || !m_isReady || kind < 1 ||
        kind > static_cast<int>(program::kinds().size()) || !nameProblem().isEmpty())
        return;
    keepAndOpen(
        renamed(m_editor.newRecipe(static_cast<profile::ProgramKind>(kind))), Origin::Library,
        [](const Recipe& kept) {
            return tr("%1 was created with default values and opened. Set your values on the Motion page.")
                .arg(nameOf(kept));
        });
}

void Recipes::copy()
{
    const RecipeVersion* chosen = chosenRecipe();
    if (m_controller.accessCheck().require(Level::Technician) && chosen && nameProblem().isEmpty())
        keepAndOpen(renamed(onThisMachine(chosen->recipe)), Origin::Library, [](const Recipe& kept) {
            return tr("%1 was created as a copy and opened.").arg(nameOf(kept));
        });
}

void Recipes::saveAs()
{
    if (m_controller.accessCheck().require(Level::Technician) && nameProblem().isEmpty())
        keepAndOpen(renamed(m_editor.recipe()), Origin::Editor, [](const Recipe& kept) {
            return tr("Saved: %1, version %2.").arg(nameOf(kept), QString::number(kept.version));
        });
}

Recipe Recipes::renamed(Recipe recipe) const
{
    recipe.name = store::keptName(m_wantedName).toStdString();
    recipe.version = 1;
    return recipe;
}

void Recipes::rename()
{
    const RecipeVersion* chosen = chosenRecipe();
    if (!m_controller.accessCheck().require(Level::Technician) || !nameProblem().isEmpty())
        return;
    if (!chosen && m_editor.recipeVersion() == 0)
        return m_editor.setRecipeName(m_wantedName);
    if (!chosen)
        return;
    const QString before = nameOf(chosen->recipe);
    const QString name = store::keptName(m_wantedName);
    m_records.store().run(
        this,
        [id = chosen->recipeId, name](store::Database& database) {
            return store::RecipeLibrary(database).rename(id, name);
        },
        [this, before, name](const tl::expected<void, store::StoreError>& renamed) {
            if (!renamed && renamed.error().kind == store::StoreError::Kind::Refused)
                return say(tr("A deleted recipe has the name %1. Choose another name.").arg(name),
                           Lasts::UntilAnswered);
            if (!renamed)
                return m_records.reportError(renamed.error());
            if (nameOf(m_editor.storedRecipe()) == before) {
                Recipe stored = m_editor.storedRecipe();
                std::optional<Recipe> edited;
                if (m_editor.edited())
                    edited = m_editor.recipe();
                stored.name = name.toStdString();
                if (edited && nameOf(*edited) == before)
                    edited->name = stored.name;
                m_editor.open(stored, edited);
            }
            note(u"recipe.rename"_s, before, before, name);
            reload();
            say(tr("Renamed %1 to %2.").arg(before, name));
        });
}

void Recipes::remove()
{
    const RecipeVersion* chosen = chosenRecipe();
    if (!m_controller.accessCheck().require(Level::Technician) || !chosen)
        return;
    m_records.store().run(
        this,
        [id = chosen->recipeId](store::Database& database) {
            return store::RecipeLibrary(database).setDeleted(id, true);
        },
        [this, id = chosen->recipeId,
         name = chosenName()](const tl::expected<void, store::StoreError>& removed) {
            if (!removed) {
                m_records.reportError(removed.error());
                return;
            }
            note(u"recipe.delete"_s, name, {}, {});
            m_deletedName = name;
            say(tr("%1 was deleted; its versions are kept.").arg(name), Lasts::UntilAnswered);
            m_deletedId = id;
            emit messageChanged();
            reload();
        });
}

void Recipes::restore()
{
    if (!m_controller.accessCheck().require(Level::Technician))
        return;
    m_records.store().run(
        this,
        [id = m_deletedId](store::Database& database) {
            return store::RecipeLibrary(database).setDeleted(id, false);
        },
        [this](const tl::expected<void, store::StoreError>& restored) {
            if (!restored) {
                m_records.reportError(restored.error());
                return;
            }
            note(u"recipe.restore"_s, m_deletedName, {}, {});
            m_chosenId = m_deletedId;
            say(tr("%1 is in the list again.").arg(m_deletedName));
            reload();
        });
}

void Recipes::note(const QString& what, const QString& name, const QString& before, const QString& after)
{
    emit noted({.what = what, .object = name, .before = before, .after = after});
}

void Recipes::say(const QString& text, Lasts lasts)
{
    m_message = text;
    m_messageTimer.stop();
    if (lasts == Lasts::SomeSeconds)
        m_messageTimer.start();
    m_deletedId = 0;
    emit messageChanged();
}

void Recipes::dismissMessage()
{
    say({});
}

} // namespace campanel::panel
