// SPDX-License-Identifier: Apache-2.0
#include "plain_master.h"

#include "ctl_registers.h"

#include <cerrno>
#include <stdexcept>

namespace campanel::soak {

using std::chrono::milliseconds;

void PlainMaster::Closer::operator()(modbus_t* context) const
{
    modbus_close(context);
    modbus_free(context);
}

PlainMaster::PlainMaster(FaultyController& controller, const FaultClass& faults,
                         const MasterSettings& settings, modbus_error_recovery_mode recovery, Truth& truth,
                         Tally& tally, Watch& watch)
    : m_controller(controller)
    , m_faults(faults)
    , m_settings(settings)
    , m_recovery(recovery)
    , m_truth(truth)
    , m_tally(tally)
    , m_watch(watch)
    , m_random(settings.seed)
{
}

PlainMaster::~PlainMaster() = default;

std::uint32_t PlainMaster::pick(std::uint32_t bound)
{
    return static_cast<std::uint32_t>(m_random() % bound);
}

void PlainMaster::connect()
{
    constexpr milliseconds pause{50};
    constexpr milliseconds longestSearch{20'000};
    const auto begun = Clock::now();
    while (!m_context) {
        m_context.reset(modbus_new_rtu(m_controller.portNow().c_str(), static_cast<int>(m_settings.line.baud),
                                       'N', 8, m_settings.line.stopBits));
        modbus_set_slave(m_context.get(), 1);
        modbus_set_error_recovery(m_context.get(), m_recovery);
        modbus_set_response_timeout(
            m_context.get(), 0,
            static_cast<std::uint32_t>(std::chrono::microseconds(m_settings.statusTimeout()).count()));
        if (modbus_connect(m_context.get()) == 0)
            return;
        m_context.reset();
        if (Clock::now() > begun + longestSearch)
            throw std::runtime_error("the port did not come back");
        std::this_thread::sleep_for(pause);
    }
}

bool PlainMaster::read(std::uint16_t address, std::vector<std::uint16_t>& registers)
{
    connect();
    const auto count = static_cast<int>(registers.size());
    const auto begun = Clock::now();
    m_watch.begin("modbus_read_registers");
    const int got = modbus_read_registers(m_context.get(), address, count, registers.data());
    const int error = errno;
    m_watch.end();
    m_tally.longestCallMs = std::max(m_tally.longestCallMs,
                                     std::chrono::duration<double, std::milli>(Clock::now() - begun).count());
    ++m_tally.exchanges;
    const int restarts = m_controller.events().restarts;
    if (restarts != std::exchange(m_restarts, restarts))
        m_truth.restarted();
    if (got == count) {
        ++m_tally.believed;
        return true;
    }
    ++m_tally.errors[modbus_strerror(error)];
    if (error == EIO || error == EBADF || error == ECONNRESET || error == ENXIO || error == ENODEV)
        m_context.reset();
    return false;
}

void PlainMaster::readStatus()
{
    std::vector<std::uint16_t> registers(modbus::statusRegisters);
    const auto asked = Clock::now();
    if (!read(CTL_REG_STATUS_TAG, registers))
        return;
    if (const auto wrong = m_truth.checkStatus(modbus::decodeStatus(registers), asked, Clock::now());
        !wrong.empty())
        m_tally.find(m_tally.wrong, "status: " + wrong);
}

void PlainMaster::readRegisters(std::uint16_t address, std::uint16_t count)
{
    std::vector<std::uint16_t> registers(count);
    if (!read(address, registers))
        return;
    if (const auto wrong = m_truth.checkRegisters(address, registers); !wrong.empty())
        m_tally.find(m_tally.wrong, wrong);
}

void PlainMaster::oneStep()
{
    const std::uint32_t choice = pick(100);
    const auto bankSize = static_cast<std::uint32_t>(m_truth.activeImage().size());
    if (choice < 60)
        readStatus();
    else if (choice < 90) // as many registers as the status: the answers can be confused
        readRegisters(static_cast<std::uint16_t>(CTL_REG_ACTIVE + pick(bankSize)), modbus::statusRegisters);
    else
        readRegisters(CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT, 10);
}

void PlainMaster::run(std::uint64_t exchanges)
{
    constexpr int cleanReads = 20; // for the controller's clock in the truth
    m_truth.resetClock();
    m_restarts = m_controller.events().restarts;
    for (int i = 0; i < cleanReads; ++i)
        readStatus();
    const Tally clean = std::exchange(m_tally, {});
    if (clean.wrong != 0 || clean.believed != cleanReads)
        throw std::runtime_error("a clean line is not read well: " +
                                 (clean.findings.empty() ? std::string("errors") : clean.findings[0]));
    m_controller.setFaults(rulesFor(m_faults, m_settings, m_controller));
    while (m_tally.exchanges < exchanges)
        oneStep();
    m_tally.faults += m_controller.setFaults("clear");
}

} // namespace campanel::soak
