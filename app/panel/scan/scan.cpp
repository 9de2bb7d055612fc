// SPDX-License-Identifier: Apache-2.0
#include "app/panel/scan/scan.h"

#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/library/recipes.h"
#include "app/panel/settings/settings.h"

#include <QCoreApplication>
#include <QKeyEvent>

#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::panel {

Scan::Scan(const Parts& parts, const QString& folder, QObject* parent)
    : QObject(parent)
    , m_parts(parts)
    , m_film(parts.controller, parts.recipes, folder, this)
{
    m_timer.setSingleShot(true);
    m_timer.callOnTimeout(this, [this] { carryOut(m_reader.expire(m_parts.controller.now())); });
    connect(&parts.settings, &Settings::changed, this, &Scan::updateSettings);
    LanguageNotifier::follow(this, [this] {
        dismissNotice(); // it is in the previous language
        updateSettings();
    });
    updateSettings();
    QCoreApplication::instance()->installEventFilter(this);
}

void Scan::updateSettings()
{
    const SettingValues& values = m_parts.settings.values();
    const ScannerKeys keys{values.text("scanner.prefix"), values.text("scanner.suffix") == u"tab",
                           std::chrono::milliseconds(values.whole("scanner.key_time_ms"))};
    if (keys == m_keys)
        return;
    m_keys = keys;
    m_reader.setKeys(keys);
    release(static_cast<int>(m_held.size()));
    emit settingsChanged();
}

QString Scan::prefixProblem(const QString& prefix) const
{
    return isValid("scanner.prefix", prefix.trimmed())
               ? QString()
               : tr("The prefix is not possible. Enter up to 8 letters, digits or signs of ASCII without "
                    "spaces.");
}

void Scan::setPrefix(const QString& prefix)
{
    if (prefixProblem(prefix).isEmpty())
        m_parts.settings.set("scanner.prefix", prefix.trimmed());
}

bool Scan::eventFilter(QObject* watched, QEvent* event)
{
    // A window passes its keys on to items, as events of their own.
    if (m_isReleasing || !watched->isWindowType())
        return QObject::eventFilter(watched, event);
    if (event->type() == QEvent::KeyPress) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        return (isEnabled() && takeKey(watched, key)) || isPressOfBurst(watched, key);
    }
    if (event->type() == QEvent::KeyRelease)
        return m_takenKeys.remove(static_cast<QKeyEvent*>(event)->key());
    return QObject::eventFilter(watched, event);
}

// Returns true when the window must not get the key.
bool Scan::takeKey(QObject* window, const QKeyEvent& event)
{
    const CodeReader::Step step = m_reader.press(
        {event.key(), event.text(), event.isAutoRepeat(), event.modifiers()}, m_parts.controller.now());
    release(step.released);
    if (step.isBegun)
        m_held.clear();
    if (step.isHeld)
        m_held.push_back({window, std::unique_ptr<QEvent>(event.clone())});
    else if (step.isTaken)
        m_takenKeys.insert(event.key());
    CodeReader::Step rest = step;
    rest.released = 0;
    carryOut(rest);
    return step.isTaken;
}

// Returns true for a key that would press or leave a button within a burst of typing: a scanner without a
// prefix sends such keys, a hand does not.
bool Scan::isPressOfBurst(QObject* window, const QKeyEvent& event)
{
    const auto now = m_parts.controller.now();
    const bool isSoon = m_typedAt && now - *m_typedAt <= m_keys.maxKeyTime;
    if (!event.text().isEmpty() && event.text()[0].isPrint())
        m_typedAt = now;
    const auto* focused = window->property("activeFocusItem").value<QObject*>();
    if (!isSoon || !focused)
        return false;
    bool isTaken = false;
    switch (event.key()) {
    case Qt::Key_Space:
    case Qt::Key_Return:
    case Qt::Key_Enter:
        isTaken = focused->inherits("QQuickAbstractButton");
        break;
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
        isTaken = !focused->inherits("QQuickTextInput");
        break;
    default:
        break;
    }
    if (isTaken)
        m_takenKeys.insert(event.key());
    return isTaken;
}

void Scan::carryOut(const CodeReader::Step& step)
{
    release(step.released);
    if (m_reader.isWaiting())
        m_timer.start(m_keys.maxKeyTime + std::chrono::milliseconds(1));
    if (step.isHalf)
        showNotice(tr("The code was not read completely. Scan again."));
    if (step.code)
        takeCode(*step.code);
}

// Delivers held keys: they were ordinary typing.
void Scan::release(int count)
{
    m_isReleasing = true;
    for (int i = 0; i < count && !m_held.empty(); ++i) {
        const HeldKey key = std::move(m_held.front());
        m_held.erase(m_held.begin());
        if (key.window)
            QCoreApplication::sendEvent(key.window, key.event.get());
    }
    m_isReleasing = false;
}

void Scan::beginEntry()
{
    ++m_entries;
}

void Scan::endEntry()
{
    --m_entries;
}

void Scan::takeCode(const QString& code)
{
    dismissNotice();
    m_lastCode = code;
    emit codeRead(code);
    if (m_entries > 0)
        return;
    const QString reason = refusal();
    if (!reason.isEmpty())
        return showNotice(reason);
    const auto found = m_parts.recipes.coded(code);
    if (found.size() == 1)
        return openRecipe(found.first().recipeId);
    if (found.isEmpty() && (m_film.isReel(code) || !m_film.neededCode().isEmpty()))
        return checkFilm(code);
    showNotice(
        found.isEmpty()
            ? tr("No recipe has the code %1. Enter the code with its recipe on the Recipes page.").arg(code)
            : tr("%1 and %2 have the same code %3. Give one of them another code.")
                  .arg(QString::fromStdString(found[0].recipe.name),
                       QString::fromStdString(found[1].recipe.name), code));
}

// Takes a code that is no recipe's for that of a film reel.
void Scan::checkFilm(const QString& code)
{
    if (!m_parts.controller.accessCheck().require(Level::Operator))
        return;
    if (!m_film.check(code))
        emit wrongFilmScanned();
    else if (code == m_film.neededCode())
        showNotice(tr("Film reel %1 is the right one for this recipe.").arg(code));
    else
        showNotice(tr("Film reel %1 is loaded. The next recipe is compared with it.").arg(code));
}

// Returns why no recipe can be opened now; empty: one can.
QString Scan::refusal() const
{
    if (m_isTyping)
        return tr("An entry is open. Confirm or cancel the entry, then scan again.");
    if (m_parts.settings.firstStart())
        return tr("Complete the first start, then scan again.");
    if (!m_parts.recipes.ready())
        return tr("The recipes are still being read. Scan again.");
    switch (m_parts.editor.programDownload()->state()) {
    case ProgramDownload::State::Transferring:
    case ProgramDownload::State::Sealing:
    case ProgramDownload::State::Armed:
        return tr("A download is running. Scan again when the download has ended.");
    default:
        return {};
    }
}

void Scan::openRecipe(qint64 recipeId)
{
    if (!m_parts.controller.accessCheck().require(Level::Operator))
        return;
    m_parts.recipes.chooseId(recipeId);
    if (m_parts.editor.edited())
        emit editsFound();
    else
        openScanned(false);
}

void Scan::openScanned(bool savesEdits)
{
    if (!m_parts.controller.accessCheck().require(Level::Operator))
        return;
    if (savesEdits)
        m_parts.recipes.save();
    m_parts.recipes.open();
    emit recipeOpened();
}

void Scan::showNotice(const QString& text)
{
    if (m_notice == text)
        return;
    m_notice = text;
    emit noticeChanged();
}

void Scan::dismissNotice()
{
    showNotice({});
}

} // namespace campanel::panel
