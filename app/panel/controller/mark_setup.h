// SPDX-License-Identifier: Apache-2.0
// Where the mark sensor is and how far from its place a mark still counts, as the controller keeps them: read
// once per connection and program, and taken from whatever is written meanwhile.
#pragma once

#include "app/link/link_values.h"

#include <QObject>

#include <array>
#include <limits>
#include <optional>

namespace campanel::machine {

class Machine;

class MarkSetup : public QObject {
    Q_OBJECT

public:
    // The machine must outlive it.
    explicit MarkSetup(Machine& machine);

    // mm; NaN while it is not known.
    [[nodiscard]] double sensorMm() const { return valueOf(m_entries[0]); } // mark sensor before the knife
    [[nodiscard]] double windowMm() const { return valueOf(m_entries[1]); } // to both sides

    // Asks for what is not certain and not being asked for.
    void ask();
    // Another controller: nothing is known of it.
    void forget();
    // Who knows what was written meanwhile: all is asked for anew, and is as it was until the answer.
    void doubt();

signals:
    void changed();

private:
    struct Entry {
        const char* name;
        std::optional<double> value{};
        bool isCertain = false;
        quint32 readId = 0;     // 0: not asked for
        bool isMissing = false; // the controller does not have it
    };

    [[nodiscard]] static double valueOf(const Entry& entry)
    {
        return entry.value.value_or(std::numeric_limits<double>::quiet_NaN());
    }
    void takeOutcome(const link::ParameterOutcome& outcome);

    Machine& m_machine;
    std::array<Entry, 2> m_entries{Entry{"parameter.mark_distance"}, Entry{"parameter.mark_window"}};
};

} // namespace campanel::machine
