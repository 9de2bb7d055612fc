// SPDX-License-Identifier: Apache-2.0
// Observes the controller for the book of states: state, program, ideal rate, the machine's own reason of a
// stop, and the pieces with their faults.
#pragma once

#include "app/panel/recipe/controller_program.h"
#include "app/panel/stops/state_book.h"
#include "app/store/database/clock_mark.h"

#include <QObject>

#include <functional>
#include <memory>
#include <optional>

namespace campanel::panel {

class Controller;
class DatabaseService;
class Settings;

// The reason of a stop that waits for a product.
inline constexpr auto waitingReason = "waiting";

class MachineWatch : public QObject {
    Q_OBJECT

public:
    using WallClock = std::function<qint64()>; // milliseconds since 1970 UTC

    // The time that the film waits for a product before the machine counts as suspended.
    static constexpr std::chrono::seconds suspendedAfter{5};

    // All arguments must outlive the object.
    MachineWatch(Controller& controller, Settings& settings, DatabaseService& records, StateBook& book);

    void setWallClock(WallClock clock) { m_clock = std::move(clock); }
    // Sets the time of the newest record: an earlier time cannot be right.
    void setNewestRecord(qint64 utcMs) { m_newestMs = utcMs; }
    [[nodiscard]] StateBook::Now now() const;

signals:
    void observed();

private:
    void takeStatus();
    void takeBag(const modbus::BagRecord& bag);
    void takeSkippedCuts();
    void countPieces(const modbus::StatusBlock& status);
    [[nodiscard]] store::StateInterval::State stateOf(const modbus::StatusBlock& status);
    [[nodiscard]] double idealPerMin();

    Controller& m_controller;
    Settings& m_settings;
    DatabaseService& m_records;
    StateBook& m_book;
    WallClock m_clock;
    qint64 m_newestMs = 0;
    std::optional<link::SteadyTime> m_waitsSince; // the film
    std::optional<std::uint32_t> m_pieces;        // the controller's count
    std::optional<std::uint32_t> m_cutsSkipped;
    // The fastest rate, and the program and machine that it was computed for.
    std::shared_ptr<const ControllerProgram> m_program;
    std::optional<profile::Machine> m_machineData;
    double m_fastestPerMin = 0; // 0: unknown
};

} // namespace campanel::panel
