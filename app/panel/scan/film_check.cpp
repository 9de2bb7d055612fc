// SPDX-License-Identifier: Apache-2.0
#include "app/panel/scan/film_check.h"

#include "app/panel/controller/controller.h"
#include "app/panel/library/recipes.h"
#include "app/store/files/files.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

// Stands for a reel whose file cannot be read: no recipe needs this one, so that it has to be scanned.
constexpr auto unreadableReel = "?";

QString identityOf(const ControllerProgram& program)
{
    return u"%1 v%2 %3"_s.arg(QString::fromStdString(program.name), QString::number(program.version),
                              QString::number(program.crc, 16));
}

} // namespace

FilmCheck::FilmCheck(Controller& controller, Recipes& recipes, const QString& folder, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_recipes(recipes)
    , m_path(QDir(folder).filePath(u"film_reel.json"_s))
{
    load();
    connect(&controller, &Controller::programChanged, this, &FilmCheck::followProgram);
    connect(&recipes, &Recipes::listChanged, this, &FilmCheck::followProgram);
    connect(&recipes, &Recipes::downloaded, this, &FilmCheck::takeDownloaded);
    connect(&recipes, &Recipes::codesSet, this, &FilmCheck::takeCodes);
    connect(this, &FilmCheck::changed, &controller, &Controller::commandsChanged);
    controller.setStartInterlock([this] { return blockedReason(); });
}

FilmCheck::~FilmCheck()
{
    m_controller.setStartInterlock({});
}

void FilmCheck::load()
{
    const auto bytes = store::readBytes(m_path);
    if (!bytes && bytes.error().kind == store::FileError::Kind::NotFound)
        return;
    const QJsonObject root = bytes ? QJsonDocument::fromJson(*bytes).object() : QJsonObject();
    m_reel = {root.value(u"code"_s).toString(QString::fromLatin1(unreadableReel)),
              root.value(u"overridden_for"_s).toString(), root.value(u"reason"_s).toString()};
    m_demand = {root.value(u"program"_s).toString(), root.value(u"recipe"_s).toInteger(),
                root.value(u"needed"_s).toString()};
}

void FilmCheck::keep(const Reel& reel, const Demand& demand)
{
    if (m_reel == reel && m_demand == demand)
        return;
    m_reel = reel;
    m_demand = demand;
    // Without the file a restart of the panel forgets the reel; the block of this run holds.
    (void)store::replaceBytes(m_path, QJsonDocument(QJsonObject{{u"code"_s, reel.code},
                                                                {u"overridden_for"_s, reel.overriddenFor},
                                                                {u"reason"_s, reel.reason},
                                                                {u"program"_s, demand.program},
                                                                {u"recipe"_s, demand.recipeId},
                                                                {u"needed"_s, demand.code}})
                                          .toJson());
}

void FilmCheck::followProgram()
{
    const auto& program = m_controller.program();
    if (program && (identityOf(*program) != m_demand.program || m_demand.recipeId == 0)) {
        const store::RecipeVersion* known = m_recipes.named(QString::fromStdString(program->name));
        const bool isDownloaded =
            m_downloaded && m_downloaded->name == program->name && m_downloaded->version == program->version;
        if (known || isDownloaded)
            keep(m_reel,
                 {identityOf(*program), known ? known->recipeId : 0,
                  QString::fromStdString(isDownloaded ? m_downloaded->filmCode : known->recipe.filmCode)});
    }
    emit changed();
}

void FilmCheck::takeDownloaded(const program::Recipe& recipe)
{
    m_downloaded = recipe;
    m_demand.recipeId = 0;
    followProgram();
}

// The codes are no part of the program: new ones hold for the one that runs.
void FilmCheck::takeCodes(const store::RecipeVersion& recipe)
{
    if (recipe.recipeId != m_demand.recipeId)
        return;
    keep(m_reel, {m_demand.program, m_demand.recipeId, QString::fromStdString(recipe.recipe.filmCode)});
    emit changed();
}

QString FilmCheck::neededCode() const
{
    return m_controller.program() ? m_demand.code : QString();
}

bool FilmCheck::isReel(const QString& code) const
{
    return std::ranges::any_of(m_recipes.newest(), [wanted = code.toStdString()](const auto& each) {
        return !wanted.empty() && each.recipe.filmCode == wanted;
    });
}

QString FilmCheck::blockedReason() const
{
    const QString needed = neededCode();
    const bool isOverridden = !m_reel.reason.isEmpty() && m_reel.overriddenFor == needed;
    if (needed.isEmpty() || m_reel.code.isEmpty() || m_reel.code == needed || isOverridden)
        return {};
    return (isReel(m_reel.code)
                ? tr("Wrong film reel: %1 was scanned, the recipe needs %2. Load and scan the right reel.")
                : tr("Unknown code %1: no recipe and no film reel has it. Load and scan the film reel %2."))
        .arg(m_reel.code, needed);
}

bool FilmCheck::check(const QString& code)
{
    keep({code, {}, {}}, m_demand);
    emit changed();
    const bool isWrong = !blockedReason().isEmpty();
    note(u"film.scan"_s, code, isWrong ? u"refused"_s : u"done"_s);
    return !isWrong;
}

void FilmCheck::overrideCheck(const QString& reason)
{
    const QString text = reason.simplified();
    if (!m_controller.accessCheck().require(Level::Technician) || text.isEmpty() || blockedReason().isEmpty())
        return;
    keep({m_reel.code, neededCode(), text}, m_demand);
    emit changed();
    note(u"film.override"_s, u"%1: %2"_s.arg(m_reel.code, text), u"done"_s);
}

// The value before is the code of the needed reel.
void FilmCheck::note(const QString& what, const QString& after, const QString& outcome)
{
    const auto& program = m_controller.program();
    emit noted({.what = what,
                .object = QString::fromStdString(program ? program->name : std::string()),
                .before = neededCode(),
                .after = after,
                .outcome = outcome});
}

} // namespace campanel::panel
