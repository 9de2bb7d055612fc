// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/trim_words.h"

#include "app/panel/kit/format.h"

#include <cmath>

namespace campanel::panel {

using program::Trim;

namespace {

struct Words {
    const char* title;
    const char* less;
    const char* more;
    const char* lessBy;
    const char* moreBy;
};

constexpr std::array words{
    Words{QT_TRANSLATE_NOOP("TrimWords", "Cut"), QT_TRANSLATE_NOOP("TrimWords", "Earlier"),
          QT_TRANSLATE_NOOP("TrimWords", "Later"), QT_TRANSLATE_NOOP("TrimWords", "%1 earlier"),
          QT_TRANSLATE_NOOP("TrimWords", "%1 later")},
    Words{QT_TRANSLATE_NOOP("TrimWords", "Product"), QT_TRANSLATE_NOOP("TrimWords", "Back"),
          QT_TRANSLATE_NOOP("TrimWords", "Forward"), QT_TRANSLATE_NOOP("TrimWords", "%1 back"),
          QT_TRANSLATE_NOOP("TrimWords", "%1 forward")},
    Words{QT_TRANSLATE_NOOP("TrimWords", "Length"), QT_TRANSLATE_NOOP("TrimWords", "Shorter"),
          QT_TRANSLATE_NOOP("TrimWords", "Longer"), QT_TRANSLATE_NOOP("TrimWords", "%1 shorter"),
          QT_TRANSLATE_NOOP("TrimWords", "%1 longer")},
};
static_assert(words.size() == program::trimCount);

const Words& wordsOf(Trim trim)
{
    return words[static_cast<std::size_t>(trim)];
}

} // namespace

QString TrimWords::title(Trim trim)
{
    return tr(wordsOf(trim).title);
}

QString TrimWords::less(Trim trim)
{
    return tr(wordsOf(trim).less);
}

QString TrimWords::more(Trim trim)
{
    return tr(wordsOf(trim).more);
}

QString TrimWords::amount(Trim trim, double mm)
{
    const QString size = Format().compactMeasure(std::abs(mm), 1, 3, QStringLiteral("mm"));
    if (!(mm < 0 || mm > 0))
        return size;
    return tr(mm < 0 ? wordsOf(trim).lessBy : wordsOf(trim).moreBy).arg(size);
}

} // namespace campanel::panel
