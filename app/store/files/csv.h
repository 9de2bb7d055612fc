// SPDX-License-Identifier: Apache-2.0
// Formats a text as a field of a CSV line (RFC 4180). All CSV files of CamPanel separate fields by commas and
// end every line with a line feed alone.
#pragma once

#include <QString>

namespace campanel::store {

// Adds quotation marks when they are necessary.
[[nodiscard]] inline QString csvField(const QString& text)
{
    if (!text.contains(u',') && !text.contains(u'"') && !text.contains(u'\n') && !text.contains(u'\r'))
        return text;
    QString doubled = text;
    return u'"' + doubled.replace(u'"', QStringLiteral("\"\"")) + u'"';
}

} // namespace campanel::store
