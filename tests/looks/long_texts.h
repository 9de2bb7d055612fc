// SPDX-License-Identifier: Apache-2.0
// A language for tests: English texts, two fifths longer and with accents, "[Bååg lééngth]", like the longest
// of the real languages. A text without brackets or accents has bypassed the translator.
#pragma once

#include <QTranslator>

namespace campanel::looks {

// Lengthens the text by two fifths (at least by the two brackets); placeholders, "%1", "%n", "%L2", stay.
[[nodiscard]] QString longText(const QString& text);

// The translator is installed during its lifetime.
class LongTexts : public QTranslator {
    Q_OBJECT

public:
    LongTexts();
    ~LongTexts() override;

    [[nodiscard]] bool isEmpty() const override { return false; }
    [[nodiscard]] QString translate(const char* context, const char* sourceText, const char* disambiguation,
                                    int n) const override;
};

} // namespace campanel::looks
