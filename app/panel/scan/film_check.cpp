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
    connect(&machine, &Controller::programChanged, this, &FilmCheck::followProgram);
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
    return {static_cast<std::uint32_t>(root.value(u"program_crc"_s).toDouble()),
            root.value(u"code"_s).toString(), root.value(u"reason"_s).toString()};
}

// An unknown program, as after a lost line, clears nothing.
void FilmCheck::followProgram()
{
    const auto& program = m_machine.program();
    if (program && program->crc != m_reel.programCrc)
        setReel({program->crc, {}, {}});
    emit changed();
}

void FilmCheck::setReel(const Reel& reel)
{
    if (m_reel == reel)
        return;
    m_reel = reel;
    // Without the file a restart of the panel forgets the reel; the block of this run holds.
    (void)store::replaceBytes(
        m_path, QJsonDocument(QJsonObject{{u"program_crc"_s, static_cast<double>(reel.programCrc)},
                                          {u"code"_s, reel.code},
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

QString FilmCheck::blockedReason() const
{
    const QString needed = neededCode();
    const bool isWrong = !needed.isEmpty() && !m_reel.code.isEmpty() && m_reel.code != needed;
    if (!isWrong || !m_reel.reason.isEmpty())
        return {};
    const auto isFilmOf = [this](const store::RecipeVersion& each) {
        return QString::fromStdString(each.recipe.filmCode) == m_reel.code;
    };
    const bool isKnown = std::ranges::any_of(m_recipes.newest(), isFilmOf);
    return (isKnown
                ? tr("Wrong film reel: %1 was scanned, the recipe needs %2. Load and scan the right reel.")
                : tr("Unknown code %1: no recipe and no film reel has it. Load and scan the film reel %2."))
        .arg(m_reel.code, needed);
}

bool FilmCheck::check(const QString& code)
{
    const auto& program = m_machine.program();
    const bool isRight = code == neededCode();
    setReel({program ? program->crc : 0, code, {}});
    note(u"film.scan"_s, code, isRight ? u"done"_s : u"refused"_s);
    return isRight;
}

void FilmCheck::overrideCheck(const QString& reason)
{
    const QString text = reason.simplified();
    if (text.isEmpty() || blockedReason().isEmpty() || !m_machine.accessCheck().require(Level::Technician))
        return;
    setReel({m_reel.programCrc, m_reel.code, text});
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
