// SPDX-License-Identifier: Apache-2.0
#include "app/panel/scan/code_reader.h"

#include "app/program/recipe.h"
#include "app/store/recipes/recipe_json.h"

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
    return step;
}

void CodeReader::readPrefix(const Key& key, Step& step)
{
    const bool canBegin = key.text.size() == 1 && !key.isRepeat;
    QString held = canBegin ? m_held + key.text : QString();
    while (!held.isEmpty() && !m_keys.prefix.startsWith(held))
        held.remove(0, 1); // "~~~A" has the prefix "~~" from its second character on
    step.isHeld = step.isTaken = !held.isEmpty();
    step.released += static_cast<int>(m_held.size() + (step.isHeld ? 1 : 0) - held.size());
    m_held = held;
    if (m_held != m_keys.prefix)
        return;
    m_held.clear();
    m_code.clear();
    m_state = State::Code;
    step.isHeld = false;
    step.isBegun = true;
}

void CodeReader::readCode(const Key& key, Step& step)
{
    step.isTaken = true;
    if (isSuffix(key)) {
        m_state = State::Typing;
        const QString code = m_code.trimmed();
        step.isHalf = code.isEmpty();
        if (!code.isEmpty())
            step.code = code;
        return;
    }
    m_code += key.text;
    // A second prefix means that the end of the code before is missing.
    const bool isWrong = key.isRepeat || key.text.isEmpty() ||
                         (key.text != u" " && !store::isScannable(key.text)) ||
                         m_code.endsWith(m_keys.prefix) ||
                         static_cast<std::size_t>(m_code.toUtf8().size()) > program::maxCodeBytes;
    if (isWrong)
        drop(step);
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
