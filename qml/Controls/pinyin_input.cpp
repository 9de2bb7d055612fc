// SPDX-License-Identifier: Apache-2.0
#include "pinyin_input.h"

#include <pinyinime.h>

#include <algorithm>
#include <array>

namespace campanel::controls {

namespace {

// Opens the decoder once, without a user dictionary: a panel has many users.
bool openDecoder()
{
    static const bool isOpen = ime_pinyin::im_open_decoder(CAMPANEL_PINYIN_DICTIONARY, "");
    return isOpen;
}

QString candidate(std::size_t number)
{
    std::array<ime_pinyin::char16, PinyinInput::maxLetters + 2> text{};
    if (!ime_pinyin::im_get_candidate(number, text.data(), text.size() - 1))
        return {};
    return QString::fromUtf16(reinterpret_cast<const char16_t*>(text.data()));
}

} // namespace

bool PinyinInput::available() const
{
    return openDecoder();
}

void PinyinInput::add(const QString& letter)
{
    if (letter.size() != 1 || letter[0] < u'a' || letter[0] > u'z' || m_letters.size() >= maxLetters ||
        !openDecoder())
        return;
    m_letters += letter[0].toLatin1();
    search();
}

void PinyinInput::erase()
{
    m_letters.chop(1);
    search();
}

// Commits a candidate; its number of characters equals its number of syllables.
void PinyinInput::choose(int number)
{
    if (number < 0 || number >= m_candidates.size())
        return;
    const QString text = m_candidates[number];
    const qsizetype syllables = std::min(text.size(), m_syllables.size());
    qsizetype letters = 0;
    for (const QString& syllable : m_syllables.first(syllables))
        letters += syllable.size();
    m_letters.remove(0, letters);
    search();
    emit committed(text);
}

void PinyinInput::clear()
{
    m_letters.clear();
    search();
}

// Restarts the search each time: the library's own selection and undo fail with assertions.
void PinyinInput::search()
{
    m_candidates.clear();
    m_syllables.clear();
    if (!m_letters.isEmpty()) {
        ime_pinyin::im_reset_search();
        const std::size_t found =
            ime_pinyin::im_search(m_letters.constData(), static_cast<std::size_t>(m_letters.size()));
        for (std::size_t i = 0; i < found && m_candidates.size() < maxCandidates; ++i)
            m_candidates << candidate(i);
        const ime_pinyin::uint16* starts = nullptr;
        const std::size_t syllables = ime_pinyin::im_get_spl_start_pos(starts);
        for (std::size_t i = 0; i < syllables; ++i)
            m_syllables << QString::fromLatin1(m_letters.mid(starts[i], starts[i + 1] - starts[i]));
        // Letters that are not a syllable yet.
        if (starts[syllables] < m_letters.size())
            m_syllables << QString::fromLatin1(m_letters.mid(starts[syllables]));
    }
    emit changed();
}

} // namespace campanel::controls
