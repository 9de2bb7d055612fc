// SPDX-License-Identifier: Apache-2.0
// A slave on a pseudo-terminal that sends the contract's echoes and misbehaves as scripted, one entry per
// request. libmodbus's server side receives; the answers are built here so that they can be wrong.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace campanel::test {

enum class Fault {
    None,
    LostRequest,    // not executed, not answered
    LostAnswer,     // executed, not answered
    LateAnswer,     // executed; the answer comes just before that of the next request
    BadChecksum,    // executed, CRC-16 of the answer inverted
    Truncated,      // executed, the answer stops in the middle
    Exception2,     // not executed, exception 2
    Busy,           // not executed, exception 6
    Exception2Done, // executed, exception 2
    Restart,        // executed, not answered, then restart()
};

class ScriptedSlave {
public:
    explicit ScriptedSlave(int unit = 1);
    ~ScriptedSlave();
    ScriptedSlave(const ScriptedSlave&) = delete;
    ScriptedSlave& operator=(const ScriptedSlave&) = delete;

    [[nodiscard]] const std::string& port() const { return m_port; }
    // Sets the faults of the next requests, in order; afterwards None.
    void script(std::vector<Fault> faults);
    void setRegister(std::uint16_t address, std::uint16_t value);
    [[nodiscard]] std::uint16_t getRegister(std::uint16_t address);
    // Return how many commands were executed, how many requests arrived, and how many of them wrote.
    [[nodiscard]] int commandsExecuted() const { return m_commands; }
    [[nodiscard]] int requests() const { return m_requests; }
    [[nodiscard]] int writes() const { return m_writes; }
    // Closes both ends of the pseudo-terminal, like a pulled adapter.
    void unplug();
    // Clears the transfer session, as a restart of the controller does.
    void forgetTransfer();
    // Loses the contents of RAM; an older program, the sixth, comes from the flash.
    void restart();
    // Activates an armed change, as at the cycle boundary.
    void reachCycleBoundary();
    void refuseRow(std::uint16_t row);
    // Works in pieces: answers the next Begin or Seal Busy this many times, and the result of the next
    // SaveToFlash for this many requests.
    void setBusy(int requests) { m_busy = requests; }
    // Delays every answer by this time.
    void delayAnswers(std::chrono::milliseconds delay) { m_delayMs = static_cast<int>(delay.count()); }
    // Puts these bytes before and behind every answer, as a line without bias or a late driver does.
    void surround(std::vector<std::uint8_t> before, std::vector<std::uint8_t> behind);
    // Answers every request with this Modbus exception; 0: no longer.
    void setException(std::uint8_t code) { m_exception = code; }
    // Returns every request before its answer, like some adapters.
    void setEchoing(bool isEchoing) { m_isEchoing = isEchoing; }

private:
    using Bytes = std::vector<std::uint8_t>;

    void serve();
    void answer(const Bytes& request);
    [[nodiscard]] Bytes execute(const Bytes& request);
    void send(const Bytes& bytes);
    void write(std::uint16_t address, const std::uint8_t* data, std::uint16_t count);
    void runCommand();
    void runTransfer();
    void runReadback();
    void activateStaged();
    void loseTransfer();
    void powerUp();
    void put32(std::uint16_t address, std::uint32_t value);

    const int m_unit;
    std::string m_port;
    int m_master = -1;
    int m_keptSlave = -1;
    std::mutex m_mutex; // guards all members below up to the thread
    std::vector<std::uint16_t> m_registers;
    std::deque<Fault> m_faults;
    std::vector<bool> m_received;
    std::uint16_t m_announced = 0;
    std::uint16_t m_refusedRow = 0xFFFF;
    Bytes m_late;
    Bytes m_before;
    Bytes m_behind;
    std::atomic<int> m_busy = 0;
    std::atomic<int> m_commands = 0;
    std::atomic<int> m_requests = 0;
    std::atomic<int> m_writes = 0;
    std::atomic<int> m_delayMs = 0;
    std::atomic<std::uint8_t> m_exception = 0;
    std::atomic<bool> m_isEchoing = false;
    std::atomic<bool> m_stop = false;
    std::thread m_thread;
};

} // namespace campanel::test
