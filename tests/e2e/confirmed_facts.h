// SPDX-License-Identifier: Apache-2.0
// Prints what a panel in another process has confirmed, a line each: "recipe VERSION", "audit SEQUENCE",
// "begun CRC" when a download begins, "program GENERATION CRC" when it is active.
#pragma once

#include "app/panel/audit/audit_trail.h"
#include "app/panel/editor/editor.h"
#include "app/panel/library/recipes.h"

#include <QString>

#include <cstdio>

namespace campanel::test {

inline void say(const QString& line)
{
    std::printf("%s\n", qPrintable(line));
    std::fflush(stdout);
}

inline QString crcText(std::uint32_t crc)
{
    return QString::number(crc, 16).toUpper().rightJustified(8, u'0');
}

inline void sayConfirmed(panel::Recipes& recipes, panel::AuditTrail& trail, panel::Editor& editor)
{
    QObject::connect(&recipes, &panel::Recipes::noted, [](const store::AuditEntry& entry) {
        say(QStringLiteral("recipe ") + entry.readBack.section(u' ', 1));
    });
    QObject::connect(&trail, &panel::AuditTrail::appended, [](const store::AuditRow& row) {
        say(QStringLiteral("audit %1").arg(row.sequence));
        // "generation 7 · CRC-32 1A2B3C4D"
        const QString& readBack = row.entry.readBack;
        if (row.entry.what == u"program.download" && row.entry.outcome == u"done")
            say(QStringLiteral("program ") + readBack.section(u' ', 1, 1) + u' ' +
                readBack.section(u' ', -1));
    });
    QObject::connect(&editor, &panel::Editor::downloadBegun, [](const program::ProgramImage& image) {
        say(QStringLiteral("begun ") + crcText(image.crc));
    });
}

} // namespace campanel::test
