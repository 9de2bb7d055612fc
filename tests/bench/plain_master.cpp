// SPDX-License-Identifier: Apache-2.0
#include "master.h"

#include <modbus/modbus.h>

#include <cerrno>
#include <stdexcept>

namespace campanel::bench {
namespace {

class PlainMaster : public Master {
public:
    PlainMaster(const std::string& port, std::uint32_t baud)
        : m_context(modbus_new_rtu(port.c_str(), static_cast<int>(baud), 'N', 8, 1), &modbus_free)
    {
        if (!m_context || modbus_set_slave(m_context.get(), 1) != 0 || modbus_connect(m_context.get()) != 0)
            fail();
    }
    ~PlainMaster() override { modbus_close(m_context.get()); }
    PlainMaster(const PlainMaster&) = delete;
    PlainMaster& operator=(const PlainMaster&) = delete;

    std::vector<std::uint16_t> writeAndRead(std::uint16_t writeAddress,
                                            std::span<const std::uint16_t> written, std::uint16_t readAddress,
                                            std::uint16_t count) override
    {
        std::vector<std::uint16_t> registers(count);
        if (modbus_write_and_read_registers(m_context.get(), writeAddress, static_cast<int>(written.size()),
                                            written.data(), readAddress, count, registers.data()) != count)
            fail();
        return registers;
    }
    std::vector<std::uint16_t> read(std::uint16_t address, std::uint16_t count) override
    {
        std::vector<std::uint16_t> registers(count);
        if (modbus_read_registers(m_context.get(), address, count, registers.data()) != count)
            fail();
        return registers;
    }

private:
    [[noreturn]] static void fail()
    {
        throw std::runtime_error(std::string("libmodbus: ") + modbus_strerror(errno));
    }

    std::unique_ptr<modbus_t, void (*)(modbus_t*)> m_context;
};

} // namespace

std::unique_ptr<Master> plainMaster(const std::string& port, std::uint32_t baud)
{
    return std::make_unique<PlainMaster>(port, baud);
}

} // namespace campanel::bench
