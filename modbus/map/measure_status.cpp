// SPDX-License-Identifier: Apache-2.0
#include "modbus/map/measure_status.h"

#include "modbus/map/codec.h"

#include <cassert>

namespace campanel::modbus {

MeasureStatus decodeMeasure(std::span<const std::uint16_t> registers)
{
    assert(registers.size() == measureRegisters);
    const RegisterReader reader(registers, measureAddress);
    MeasureStatus status;
    status.state = static_cast<MeasureState>(reader.u16("measure.state"));
    status.axis = static_cast<MeasuredAxis>(reader.u16("measure.axis"));
    status.turns = reader.u16("measure.turns");
    status.reason = static_cast<Refusal>(reader.u16("measure.reason"));
    status.pulses = reader.physical("measure.pulses");
    status.spread = reader.physical("measure.spread");
    if (reader.u32("measure.bag_pulses") != 0)
        status.bagPulses = reader.physical("measure.bag_pulses");
    status.bag = reader.u32("measure.bag");
    return status;
}

} // namespace campanel::modbus
