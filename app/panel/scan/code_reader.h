// SPDX-License-Identifier: Apache-2.0
// Recognizes the codes of a scanner among the keys of a keyboard: prefix, code and suffix, each key soon
// after the one before. It knows no window and no clock of its own. A code keeps its letters when Caps Lock
// is on, and the separators of a GS1 code (FNC1) as "|", which no GS1 code contains.
#pragma once

#include "app/link/link_values.h"

#include <QString>

#include <chrono>
#include <optional>

namespace campanel::panel {

// The keys that a scanner sends around a code.
struct ScannerKeys {
    QString prefix;         // printable characters; empty: no scanner
    bool endsByTab = false; // else by Enter
    std::chrono::milliseconds maxKeyTime{100};

    bool operator==(const ScannerKeys&) const = default;
};

class CodeReader {
public:
    struct Key {
        int key = 0; // Qt::Key
        QString text;
        bool isRepeat = false;
        std::optional<Qt::KeyboardModifiers> modifiers{}; // nullopt: not known
    };
    // The consequence of a key, or of the time.
    struct Step {
        int released = 0;     // held keys that were ordinary typing, the oldest first: deliver them
        bool isHeld = false;  // hold the key: it may begin a code
        bool isTaken = false; // do not deliver the key
        bool isBegun = false; // the prefix is complete: forget the held keys
        bool isHalf = false;  // a code was dropped
        std::optional<QString> code;
    };

    // Forgets what was read. Held keys must be delivered by the caller.
    void setKeys(const ScannerKeys& keys);

    [[nodiscard]] Step press(const Key& key, link::SteadyTime now);
    // Drops half a code and gives up a prefix when the time has passed.
    [[nodiscard]] Step expire(link::SteadyTime now);
    // Returns true while a code is read or the rest of a dropped one is awaited.
    [[nodiscard]] bool isReading() const { return m_state != State::Typing; }
    // Returns true while expire() has something to do later.
    [[nodiscard]] bool isWaiting() const { return isReading() || !m_held.isEmpty(); }

private:
    enum class State { Typing, Code, Dropping };

    void readPrefix(const Key& key, Step& step);
    void readCode(const Key& key, Step& step);
    void drop(Step& step);
    void finish(Step& step);
    [[nodiscard]] QString takeAltNumber();
    [[nodiscard]] bool isSuffix(const Key& key) const;

    ScannerKeys m_keys;
    State m_state = State::Typing;
    QString m_held; // the beginning of the prefix
    QString m_code;
    QString m_altNumber; // digits typed while Alt is held: the number of a character
    int m_letters = 0;   // of the code, and those whose case contradicts Shift
    int m_contradictions = 0;
    bool m_isCapsLockSent = false;                // by the scanner itself
    std::optional<link::SteadyTime> m_suffixAt{}; // end of the last code
    link::SteadyTime m_lastAt;
};

} // namespace campanel::panel
