// SPDX-License-Identifier: Apache-2.0
// Every alarm there is: its id, how bad it is, and in words what it is, why, and what to do. Ids never change
// and are never used again: C controller fault, W controller warning, M packing machine, L link, P panel.
#pragma once

#include "app/link/link_values.h"
#include "app/store/database/store_error.h"

#include <QString>

#include <span>

namespace campanel::machine {

// Worst last. A notice is listed and logged and needs no acknowledgement.
enum class AlarmSeverity { None, Notice, Warning, Fault };

struct AlarmKind {
    const char* id = "";
    AlarmSeverity severity = AlarmSeverity::Warning;
    bool stopsMachine = false; // such a one cannot be shelved
    // English sources of the texts; see the functions below.
    const char* titleSource = "";
    const char* causeSource = "";
    const char* actionSource = "";

    [[nodiscard]] QString code() const { return QString::fromLatin1(id); }
    // In the language of the program: a few words; then one or two sentences each.
    [[nodiscard]] QString title() const;
    [[nodiscard]] QString cause() const;
    [[nodiscard]] QString action() const;
    // Cause and action.
    [[nodiscard]] QString sentence() const;
};

class AlarmCatalogue {
public:
    [[nodiscard]] static std::span<const AlarmKind> all();
    // Null when there is none: the log may hold one of a newer version.
    [[nodiscard]] static const AlarmKind* find(const QString& code);

    [[nodiscard]] static const AlarmKind& of(modbus::FaultBit bit);
    [[nodiscard]] static const AlarmKind& of(modbus::WarningBit bit);
    // Bits that this version does not know.
    [[nodiscard]] static const AlarmKind& unknownFault();
    [[nodiscard]] static const AlarmKind& unknownWarning();
    // Null while the state is no problem.
    [[nodiscard]] static const AlarmKind* of(link::LinkState state);
    [[nodiscard]] static const AlarmKind& simulatorMissing();
    [[nodiscard]] static const AlarmKind& of(store::StoreError::Kind kind);
    // The database was damaged, and its last good copy has taken its place or not.
    [[nodiscard]] static const AlarmKind& memoryDamaged(bool isFromCopy);
    [[nodiscard]] static const AlarmKind& recipeNotKept();
    [[nodiscard]] static const AlarmKind& settingsNotKept();
};

} // namespace campanel::machine
