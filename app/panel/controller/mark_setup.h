// SPDX-License-Identifier: Apache-2.0
// The mark sensor's distance and the tolerance of the mark position, as stored in the controller. Read once
// per connection and program, and updated by every write.
#pragma once

#include "app/link/link_values.h"

#include <QObject>

#include <array>
#include <limits>
#include <optional>

namespace campanel::panel {

class Controller;

class MarkSetup : public QObject {
    Q_OBJECT

public:
    // `machine` must outlive the object.
    explicit MarkSetup(Controller& machine);

    // Return mm; NaN while unknown.
    [[nodiscard]] double sensorMm() const { return valueOf(m_entries[0]); } // mark sensor before the knife
    [[nodiscard]] double windowMm() const { return valueOf(m_entries[1]); } // in both directions

    // Requests the values that are uncertain and not already requested.
    void ask();
    // Clears all values, for another controller.
    void forget();
    // Requests all values again because others may have been written; the old ones stay until the answer.
    void doubt();

signals:
    void changed();

private:
    struct Entry {
        const char* name;
        std::optional<double> value{};
        bool isCertain = false;
        quint32 readId = 0;     // 0: not requested
        bool isMissing = false; // the controller does not have this register
    };

    [[nodiscard]] static double valueOf(const Entry& entry)
    {
        return entry.value.value_or(std::numeric_limits<double>::quiet_NaN());
    }
    void takeOutcome(const link::ParameterOutcome& outcome);

    Controller& m_machine;
    std::array<Entry, 2> m_entries{Entry{"parameter.mark_distance"}, Entry{"parameter.mark_window"}};
};

} // namespace campanel::panel
