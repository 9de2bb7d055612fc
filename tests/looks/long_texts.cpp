// SPDX-License-Identifier: Apache-2.0
// Longer texts with accents; see long_texts.h.
#include "tests/looks/long_texts.h"

#include <QCoreApplication>

namespace campanel::looks {
namespace {

const QString plainLetters = QStringLiteral("aeiouyAEIOUYcnszCNSZ");
const QString accentedLetters = QStringLiteral("åéîôüýÅÉÎÔÜÝçñšžÇÑŠŽ");
constexpr qsizetype vowels = 12; // first one of them

// Returns the length of a placeholder at this place: "%1", "%L12", "%n"; 0: none.
qsizetype valueAt(const QString& text, qsizetype at)
{
    if (text[at] != u'%')
        return 0;
    qsizetype end = at + 1;
    if (end < text.size() && text[end] == u'L')
        ++end;
    const qsizetype digits = end;
    while (end < text.size() && text[end].isDigit())
        ++end;
    if (end > digits)
        return end - at;
    return end < text.size() && text[end] == u'n' ? end + 1 - at : 0;
}

} // namespace

QString longText(const QString& text)
{
    constexpr qsizetype brackets = 2;
    qsizetype left = (2 * text.size() + 4) / 5 - brackets;
    QString longer = QStringLiteral("[");
    for (qsizetype i = 0; i < text.size(); ++i) {
        if (const qsizetype value = valueAt(text, i)) {
            longer += QStringView(text).mid(i, value);
            i += value - 1;
            continue;
        }
        const qsizetype letter = plainLetters.indexOf(text[i]);
        const QChar shown = letter < 0 ? text[i] : accentedLetters[letter];
        longer += shown;
        if (letter >= 0 && letter < vowels && left > 0) {
            longer += shown.toLower();
            --left;
        }
    }
    for (; left > 0; --left)
        longer += u'~';
    return longer + u']';
}

LongTexts::LongTexts()
{
    QCoreApplication::installTranslator(this);
}

LongTexts::~LongTexts()
{
    QCoreApplication::removeTranslator(this);
}

QString LongTexts::translate(const char*, const char* sourceText, const char*, int) const
{
    return longText(QString::fromUtf8(sourceText));
}

} // namespace campanel::looks
