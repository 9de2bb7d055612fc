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

FilmCheck::FilmCheck(Controller& machine, Recipes& recipes, const QString& folder, QObject* parent)
    : QObject(parent)
    , m_machine(machine)
    , m_recipes(recipes)
    , m_path(QDir(folder).filePath(u"film_reel.json"_s))
    , m_reel(kept())
{
    connect(&machine, &Controller::programChanged, this, &FilmCheck::changed);
    connect(&recipes, &Recipes::listChanged, this, &FilmCheck::changed);
    connect(this, &FilmCheck::changed, &machine, &Controller::commandsChanged);
    machine.setStartInterlock([this] { return blockedReason(); });
}

FilmCheck::~FilmCheck()
{
    m_machine.setStartInterlock({});
}

FilmCheck::Reel FilmCheck::kept() const
{
    const auto bytes = store::readBytes(m_path);
    const QJsonObject root = bytes ? QJsonDocument::fromJson(*bytes).object() : QJsonObject();
    return {root.value(u"code"_s).toString(), root.value(u"overridden_for"_s).toString(),
            root.value(u"reason"_s).toString()};
}

void FilmCheck::setReel(const Reel& reel)
{
    if (m_reel == reel)
        return;
    m_reel = reel;
    // Without the file a restart of the panel forgets the reel; the block of this run holds.
    (void)store::replaceBytes(m_path, QJsonDocument(QJsonObject{{u"code"_s, reel.code},
                                                                {u"overridden_for"_s, reel.overriddenFor},
                                                                {u"reason"_s, reel.reason}})
                                          .toJson());
    emit changed();
}

QString FilmCheck::neededCode() const
{
    const auto& program = m_machine.program();
    if (!program)
        return {};
    for (const store::RecipeVersion& each : m_recipes.newest()) {
        if (each.recipe.name == program->name)
            return QString::fromStdString(each.recipe.filmCode);
    }
    return {};
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
    setReel({code, {}, {}});
    const bool isWrong = !blockedReason().isEmpty();
    note(u"film.scan"_s, code, isWrong ? u"refused"_s : u"done"_s);
    return !isWrong;
}

void FilmCheck::overrideCheck(const QString& reason)
{
    const QString text = reason.simplified();
    if (text.isEmpty() || blockedReason().isEmpty() || !m_machine.accessCheck().require(Level::Technician))
        return;
    setReel({m_reel.code, neededCode(), text});
    note(u"film.override"_s, u"%1: %2"_s.arg(m_reel.code, text), u"done"_s);
}

// The value before is the code of the needed reel.
void FilmCheck::note(const QString& what, const QString& after, const QString& outcome)
{
    store::AuditEntry entry;
    entry.what = what;
    entry.object = QString::fromStdString(m_machine.program() ? m_machine.program()->name : std::string());
    entry.before = neededCode();
    entry.after = after;
    entry.outcome = outcome;
    emit noted(entry);
}

} // namespace campanel::panel
