// SPDX-License-Identifier: Apache-2.0
#include "modbus/map/jam_status.h"

#include "modbus/map/codec.h"

#include <cassert>

namespace campanel::modbus {
namespace {

constexpr double percentPerStep = 0.1;

std::optional<JamStatus::Jam> lastJam(const RegisterReader& reader)
{
    const auto source = static_cast<JamSource>(reader.u16("jam.source"));
    if (source == JamSource::None)
        return std::nullopt;
    return JamStatus::Jam{source, reader.physical("jam.angle"), reader.physical("jam.torque"),
                          reader.physical("jam.limit"), reader.physical("jam.run_on")};
}

std::vector<JamStatus::Part> learnedBand(std::span<const std::uint16_t> registers, double fromDeg,
                                         double toDeg)
{
    const auto expected = registers.subspan(registerNamed("jam.expected").address - jamAddress, jamBins);
    const auto width = registers.subspan(registerNamed("jam.width").address - jamAddress, jamBins);
    std::vector<JamStatus::Part> band;
    for (std::size_t part = 0; part < jamBins; ++part) {
        if (width[part] != 0)
            band.push_back({fromDeg + (toDeg - fromDeg) * (static_cast<double>(part) + 0.5) / jamBins,
                            static_cast<std::int16_t>(expected[part]) * percentPerStep,
                            width[part] * percentPerStep});
    }
    return band;
}

} // namespace

JamStatus decodeJam(std::span<const std::uint16_t> registers)
{
    assert(registers.size() == jamRegisters);
    const RegisterReader reader(registers, jamAddress);
    JamStatus status;
    const auto state = reader.u16("jam.state");
    if (state <= static_cast<std::uint16_t>(JamState::Armed))
        status.state = static_cast<JamState>(state);
    status.cyclesLeft = reader.u16("jam.cycles_left");
    if (reader.u16("jam.interval") != 0)
        status.intervalMs = reader.physical("jam.interval");
    status.jams = reader.u16("jam.number");
    status.last = lastJam(reader);
    status.residueNumber = reader.u32("jam.residue_number");
    if (status.residueNumber != 0)
        status.residuePercent = reader.physical("jam.residue");
    status.fromDeg = reader.physical("jam.band_from");
    status.toDeg = reader.physical("jam.band_to");
    status.band = learnedBand(registers, status.fromDeg, status.toDeg);
    return status;
}

} // namespace campanel::modbus
