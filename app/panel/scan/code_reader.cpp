// SPDX-License-Identifier: Apache-2.0
#include "app/panel/scan/code_reader.h"

#include "app/program/recipe.h"
#include "app/store/recipes/recipe_json.h"

#include <algorithm>
#include <utility>

namespace campanel::panel {

namespace {

// The rest of a dropped code may come after a pause: so many key times without a key end it.
constexpr int quietKeyTimes = 10;

bool isModifier(int key)
{
    switch (key) {
    case Qt::Key_Shift:
    case Qt::Key_Control:
    case Qt::Key_Alt:
    case Qt::Key_AltGr:
    case Qt::Key_Meta:
    case Qt::Key_CapsLock:
    case Qt::Key_NumLock:
        return true;
    default:
        return false;
    }
}

// FNC1 within a GS1 code, as most keyboards send it: Ctrl+].
constexpr QChar groupSeparator(0x1d);
constexpr QChar shownSeparator(u'|');

// Returns the character, also of a scanner that is set to send FNC1 by a function key.
QString textOf(const CodeReader::Key& key)
{
    return key.key == Qt::Key_F8 ? QString(groupSeparator) : key.text;
}

bool hasCase(const QString& text)
{
    return text.size() == 1 && text[0].toUpper() != text[0].toLower();
}

// Returns true for a letter that is not what Shift alone makes of its key: Caps Lock is on.
bool contradictsShift(const CodeReader::Key& key)
{
    return key.modifiers && hasCase(key.text) &&
           key.text[0].isUpper() != key.modifiers->testFlag(Qt::ShiftModifier);
}

QString withOtherCase(QString text)
{
    for (QChar& letter : text)
        letter = letter.isUpper() ? letter.toLower() : letter.toUpper();
    return text;
}

bool isAnySuffix(const CodeReader::Key& key)
{
    return key.key == Qt::Key_Tab || key.key == Qt::Key_Return || key.key == Qt::Key_Enter ||
           key.text == u"\n" || key.text == u"\r";
}

} // namespace

void CodeReader::setKeys(const ScannerKeys& keys)
{
    m_keys = keys;
    m_state = State::Typing;
    m_held.clear();
    m_code.clear();
}

bool CodeReader::isSuffix(const Key& key) const
{
    return m_keys.endsByTab ? key.key == Qt::Key_Tab : key.key == Qt::Key_Return || key.key == Qt::Key_Enter;
}

CodeReader::Step CodeReader::press(const Key& key, link::SteadyTime now)
{
    if (m_keys.prefix.isEmpty())
        return {};
    Step step = expire(now);
    if (isModifier(key.key)) { // capitals
        step.isTaken = isReading();
        m_isCapsLockSent = m_isCapsLockSent || key.key == Qt::Key_CapsLock;
        return step;
    }
    // The second Return of a scanner that sends two: nobody has touched OK.
    const bool isSecondSuffix =
        !isReading() && m_suffixAt && now - *m_suffixAt <= m_keys.maxKeyTime && isAnySuffix(key);
    m_suffixAt = isSecondSuffix ? std::optional(now) : std::nullopt;
    if (isSecondSuffix) {
        step.isTaken = true;
        return step;
    }
    m_lastAt = now;
    switch (m_state) {
    case State::Typing:
        readPrefix(key, step);
        break;
    case State::Code:
        readCode(key, step);
        break;
    case State::Dropping:
        step.isTaken = true;
        if (isSuffix(key))
            m_state = State::Typing;
        break;
    }
    if (!isReading() && isSuffix(key) && step.isTaken)
        m_suffixAt = now;
    return step;
}

void CodeReader::readPrefix(const Key& key, Step& step)
{
    const bool canBegin = key.text.size() == 1 && !key.isRepeat;
    const bool fits = m_keys.prefix.startsWith(m_held + key.text);
    const QString text = !fits && contradictsShift(key) ? withOtherCase(key.text) : key.text;
    QString held = canBegin ? m_held + text : QString();
    while (!held.isEmpty() && !m_keys.prefix.startsWith(held))
        held.remove(0, 1); // "~~~A" has the prefix "~~" from its second character on
    step.isHeld = step.isTaken = !held.isEmpty();
    step.released += static_cast<int>(m_held.size() + (step.isHeld ? 1 : 0) - held.size());
    m_held = held;
    if (m_held != m_keys.prefix)
        return;
    m_held.clear();
    m_code.clear();
    m_altNumber.clear();
    m_letters = m_contradictions = 0;
    m_isCapsLockSent = false;
    m_state = State::Code;
    step.isHeld = false;
    step.isBegun = true;
}

void CodeReader::readCode(const Key& key, Step& step)
{
    step.isTaken = true;
    if (isSuffix(key))
        return finish(step);
    const bool isAlt = key.modifiers && key.modifiers->testFlag(Qt::AltModifier);
    if (isAlt && key.key >= Qt::Key_0 && key.key <= Qt::Key_9) {
        m_altNumber += QChar(u'0' + (key.key - Qt::Key_0));
        return;
    }
    const QString text = takeAltNumber() + textOf(key);
    m_code += text;
    m_letters += key.modifiers && hasCase(key.text) ? 1 : 0;
    m_contradictions += contradictsShift(key) ? 1 : 0;
    const auto isPossible = [](QChar letter) { return letter == u' ' || letter == groupSeparator; };
    const QString last =
        std::ranges::all_of(text, isPossible) ? QString() : QString(text).remove(groupSeparator);
    // A second prefix means that the end of the code before is missing.
    const bool isWrong = key.isRepeat || text.isEmpty() || !store::isScannable(last) ||
                         m_code.endsWith(m_keys.prefix) ||
                         static_cast<std::size_t>(m_code.toUtf8().size()) > program::maxCodeBytes;
    if (isWrong)
        drop(step);
}

QString CodeReader::takeAltNumber()
{
    const QString number = std::exchange(m_altNumber, QString());
    return number.isEmpty() ? QString() : QString(QChar(number.toUShort()));
}

void CodeReader::finish(Step& step)
{
    m_state = State::Typing;
    QString code = m_code.trimmed();
    while (code.startsWith(groupSeparator))
        code.remove(0, 1);
    while (code.endsWith(groupSeparator))
        code.chop(1);
    code = code.trimmed().replace(groupSeparator, shownSeparator);
    if (m_letters > 0 && m_contradictions == m_letters && !m_isCapsLockSent)
        code = withOtherCase(code);
    step.isHalf = code.isEmpty();
    if (!code.isEmpty())
        step.code = code;
}

void CodeReader::drop(Step& step)
{
    m_code.clear();
    m_state = State::Dropping;
    step.isHalf = true;
}

CodeReader::Step CodeReader::expire(link::SteadyTime now)
{
    Step step;
    const auto pause = now - m_lastAt;
    if (!isWaiting() || pause <= m_keys.maxKeyTime)
        return step;
    step.released = static_cast<int>(m_held.size());
    m_held.clear();
    if (m_state == State::Code)
        drop(step);
    if (m_state == State::Dropping && pause > quietKeyTimes * m_keys.maxKeyTime)
        m_state = State::Typing;
    return step;
}

} // namespace campanel::panel
