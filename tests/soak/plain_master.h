// SPDX-License-Identifier: Apache-2.0
// A master as written from libmodbus's documentation: reads, checks the return value, and trusts it. It only
// reads, so that its results can be checked exactly.
#pragma once

#include "tests/soak/fault_classes.h"
#include "tests/soak/faulty_controller.h"
#include "tests/soak/panel_master.h"
#include "tests/soak/tally.h"
#include "tests/soak/truth.h"

#include <modbus/modbus.h>

#include <memory>
#include <random>

namespace campanel::soak {

class PlainMaster {
public:
    // The controller must be prepared; `truth` has its data. Recovery LINK is not suitable for a panel: it
    // does not return after an adapter is pulled.
    PlainMaster(FaultyController& controller, const FaultClass& faults, const MasterSettings& settings,
                modbus_error_recovery_mode recovery, Truth& truth, Tally& tally, Watch& watch);
    ~PlainMaster();

    void run(std::uint64_t exchanges);

private:
    struct Closer {
        void operator()(modbus_t* context) const;
    };

    void connect();
    void oneStep();
    // Returns false after an error.
    [[nodiscard]] bool read(std::uint16_t address, std::vector<std::uint16_t>& registers);
    void readStatus();
    void readRegisters(std::uint16_t address, std::uint16_t count);
    [[nodiscard]] std::uint32_t pick(std::uint32_t bound);

    FaultyController& m_controller;
    FaultClass m_faults;
    MasterSettings m_settings;
    modbus_error_recovery_mode m_recovery;
    Truth& m_truth;
    Tally& m_tally;
    Watch& m_watch;
    std::mt19937_64 m_random;
    std::unique_ptr<modbus_t, Closer> m_context;
    int m_restarts = 0;
};

} // namespace campanel::soak
