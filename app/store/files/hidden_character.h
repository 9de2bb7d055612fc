// SPDX-License-Identifier: Apache-2.0
// The characters that a reader does not see, or that change how others are seen.
#pragma once

#include <QChar>

namespace campanel::store {

// Returns true for a character of control, of format or of a line's end, and for half of a surrogate pair.
[[nodiscard]] inline bool hasHiddenCategory(char32_t character)
{
    switch (QChar::category(character)) {
    case QChar::Other_Control:
    case QChar::Other_Format:
    case QChar::Other_Surrogate:
    case QChar::Separator_Line:
    case QChar::Separator_Paragraph:
        return true;
    default:
        return false;
    }
}

} // namespace campanel::store
