// SPDX-License-Identifier: Apache-2.0
// A controller with its machine on a bench, on simulated time: frames in, answers out, without a line.
#pragma once

#include "simulated_controller.h"
#include "support/bank_image.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace campanel::test {

using Bytes = std::vector<std::uint8_t>;
using Registers = std::vector<std::uint16_t>;

// A flash in memory that can lose its power after a number of written bytes (an erase counts as one).
class MemoryFlash final : public controller::FlashDevice {
public:
    bool read(std::uint32_t slot, std::uint32_t offset, std::span<std::uint8_t> bytes) override;
    bool erase(std::uint32_t slot) override;
    bool write(std::uint32_t slot, std::uint32_t offset, std::span<const std::uint8_t> bytes) override;

    bool keeps() const override { return hasRecords; }
    bool keep(std::uint32_t record, std::span<const std::uint8_t> bytes) override;
    std::size_t kept(std::uint32_t record, std::span<std::uint8_t> bytes) override;

    std::array<Bytes, 2> contents; // contents of each slot
    bool hasRecords = true;
    std::array<Bytes, CTL_KEPT_RECORDS> records;
    std::optional<std::size_t> bytesUntilPowerCut;
    std::size_t written = 0;
};

ctl_config benchConfig();
// Returns the frame with its CRC-16, computed bit by bit.
Bytes frame(Bytes content);
std::uint32_t crc32(const Registers& registers);

class Rig {
public:
    explicit Rig(const controller::MachineOptions& options = {}, MemoryFlash* flash = nullptr);

    // Returns the answer to a raw frame; empty when there is none.
    Bytes exchange(const Bytes& raw);
    // Returns the registers read; empty when refused.
    Registers read(std::uint16_t address, std::uint16_t count);
    // Returns 0 or the exception code.
    int write(std::uint16_t address, const Registers& values);
    Registers readWrite(std::uint16_t readAddress, std::uint16_t readCount, std::uint16_t writeAddress,
                        const Registers& values);

    std::uint16_t status(std::uint16_t address) { return read(address, 1).at(0); }
    std::uint32_t statusWide(std::uint16_t address);
    std::int32_t signedWide(std::uint16_t address) { return static_cast<std::int32_t>(statusWide(address)); }
    // Returns the refusal (CTL_REFUSAL_...), after Busy.
    std::uint16_t command(std::uint16_t code, std::uint16_t argument0 = 0, std::uint16_t argument1 = 0,
                          std::uint32_t argument2 = 0);
    // Returns the eight transfer result registers.
    Registers transfer(std::uint16_t session, std::uint16_t operation, std::uint16_t block,
                       const Registers& data);
    // Returns the result of the seal. The announced kind is that of the image unless `kind` is given.
    std::uint16_t download(const Registers& image, std::uint16_t session = 1,
                           std::optional<std::uint16_t> kind = {});
    std::uint16_t apply(const Registers& image, std::uint16_t mode, std::uint16_t session = 1);
    // Downloads and activates at standstill.
    void install(const Registers& image, std::uint16_t session = 1);
    void install(const BankImage& bank) { install(bank.registers()); }
    // Starts and homes until the table runs.
    void start();
    // Without a permit the frame is that of a panel that does not have the register.
    void heartbeat(std::uint16_t jog = 0, std::optional<std::uint16_t> permit = {});
    void setParameter(std::uint16_t address, std::uint16_t value);

    void run(std::uint64_t timeUs);
    // Returns false when the state is not reached within this simulated time.
    bool runUntilState(std::uint16_t state, std::uint64_t timeoutUs = 60'000'000);
    // Runs for this time; returns the largest change of the commanded speed between two slices, in pulses per
    // slice.
    std::int64_t maxJolt(std::uint64_t timeUs);

    [[nodiscard]] ctl_core& core() { return m_controller.core(); }
    [[nodiscard]] controller::SimulatedController& controller() { return m_controller; }
    // Returns the pulses sent since homing.
    [[nodiscard]] std::int64_t commanded() { return core().motion.commanded - core().motion.origin; }

private:
    MemoryFlash m_ownFlash;
    controller::SimulatedController m_controller;
    std::uint16_t m_counter = 0;
    std::uint16_t m_heartbeat = 0;
};

} // namespace campanel::test
