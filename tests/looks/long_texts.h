// SPDX-License-Identifier: Apache-2.0
// A language for tests only: every text in English, two fifths longer and with accents, "[Bååg lééngth]", as
// the longest of the real languages would be. A text without brackets or accents was never given to a
// translator.
#pragma once

#include <QTranslator>

namespace campanel::looks {

// Two fifths longer (at least by the two brackets); what stands for values, "%1", "%n", "%L2", stays.
[[nodiscard]] QString longText(const QString& text);

// Installed for as long as it lives.
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
