// SPDX-License-Identifier: Apache-2.0
// The catalogue of alarms: id, severity, and texts for description, cause and action. Ids never change and
// are never reused: C controller fault, W controller warning, M packing machine, L link, P panel.
#pragma once

#include "app/link/link_values.h"
#include "app/store/database/store_error.h"

#include <QSet>
#include <QString>

#include <span>

namespace campanel::panel {

// The severities in ascending order. A notice is listed and logged but needs no acknowledgement.
enum class AlarmSeverity { None, Notice, Warning, Fault };

struct AlarmKind {
    const char* id = "";
    AlarmSeverity severity = AlarmSeverity::Warning;
    bool stopsMachine = false; // it ends a run, and cannot be shelved
    // The English sources of the texts; see the functions below.
    const char* titleSource = "";
    const char* causeSource = "";
    const char* actionSource = "";

    [[nodiscard]] QString code() const { return QString::fromLatin1(id); }
    // Returns the title in the language of the program, in a few words; the next two return one or two
    // sentences.
    [[nodiscard]] QString title() const;
    [[nodiscard]] QString cause() const;
    [[nodiscard]] QString action() const;
    // Returns cause and action.
    [[nodiscard]] QString sentence() const;
};

class AlarmCatalogue {
public:
    [[nodiscard]] static std::span<const AlarmKind> all();
    // Returns null when there is none: the log may hold an alarm of a newer version.
    [[nodiscard]] static const AlarmKind* find(const QString& code);

    [[nodiscard]] static const AlarmKind& of(modbus::FaultBit bit);
    [[nodiscard]] static const AlarmKind& of(modbus::WarningBit bit);
    // Returns the kinds of the bits that are set in a word of the status block.
    template <typename Bit> [[nodiscard]] static QSet<const AlarmKind*> ofBits(unsigned word)
    {
        QSet<const AlarmKind*> kinds;
        for (unsigned bit = 0; word >> bit != 0; ++bit) {
            if ((word >> bit & 1U) != 0)
                kinds.insert(&of(static_cast<Bit>(bit)));
        }
        return kinds;
    }
    // Returns the kind for bits that this version does not know.
    [[nodiscard]] static const AlarmKind& unknownFault();
    [[nodiscard]] static const AlarmKind& unknownWarning();
    // Returns null when the state is not a problem.
    [[nodiscard]] static const AlarmKind* of(link::LinkState state);
    [[nodiscard]] static const AlarmKind& simulatorMissing();
    [[nodiscard]] static const AlarmKind& of(store::StoreError::Kind kind);
    // Returns the alarm of a damaged database, replaced by its last good copy or not.
    [[nodiscard]] static const AlarmKind& memoryDamaged(bool isFromCopy);
    [[nodiscard]] static const AlarmKind& recipeNotKept();
    [[nodiscard]] static const AlarmKind& settingsNotKept();
    [[nodiscard]] static const AlarmKind& settingsDamaged();
    [[nodiscard]] static const AlarmKind& touchscreenMissing();
    [[nodiscard]] static const AlarmKind& markSensorDrifted();
};

} // namespace campanel::panel
