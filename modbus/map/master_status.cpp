// SPDX-License-Identifier: Apache-2.0
#include "modbus/map/master_status.h"

#include "modbus/map/codec.h"

#include <cassert>

namespace campanel::modbus {

MasterStatus decodeMasterStatus(std::span<const std::uint16_t> registers)
{
    assert(registers.size() == masterStatusRegisters);
    const RegisterReader reader(registers, masterStatusAddress);
    MasterStatus status;
    status.isAvailable = reader.u16("master_status.available") != 0;
    const auto state = reader.u16("master_status.state");
    if (state <= static_cast<std::uint16_t>(MasterState::Disengaging))
        status.state = static_cast<MasterState>(state);
    status.counts = reader.i32("master_status.counts");
    status.speedMmPerS = reader.physical("master_status.speed");
    status.angleDeg = reader.physical("master_status.angle");
    status.errorMm = reader.physical("master_status.error");
    status.leadMm = reader.physical("master_status.lead");
    status.heldMm = reader.physical("master_status.held");
    status.toEngagedMm = reader.physical("master_status.to_engaged");
    status.smoothingMs = reader.physical("master_status.smoothing");
    status.phaseDeg = reader.physical("master_status.phase");
    status.ripplePercent = reader.physical("master_status.ripple");
    status.inputErrors = reader.u16("master_status.input_errors");
    status.indexErrorCounts = reader.physical("master_status.index_error");
    status.slipMm = reader.physical("master_status.slip");
    status.lagMm = reader.physical("master_status.lag");
    status.passedM = reader.physical("master_status.passed");
    return status;
}

} // namespace campanel::modbus
