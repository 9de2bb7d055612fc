// SPDX-License-Identifier: Apache-2.0
#include "app/program/cam_advance.h"

#include "modbus/map/bank_header.h"
#include "profile/cam/point_cam_edit.h"
#include "profile/segments/segment_edit.h"

#include <cmath>

namespace campanel::program {
namespace {

constexpr double advanceStepsPerMm = 1e6; // grid of the advance in the table

template <typename P> constexpr bool isCam = std::is_base_of_v<profile::CamMaster, P>;

// Returns the value for a cam with a valid list, else 0.
template <typename Value> double ofValidCam(const profile::Program& program, Value value)
{
    const ListInfo* list = kindInfo(profile::kindOf(program)).list;
    if (list == nullptr || list->check(program))
        return 0;
    return std::visit(
        [&value]<typename P>(const P& cam) -> double {
            if constexpr (isCam<P>)
                return value(cam);
            else
                return 0;
        },
        program);
}

double inDirectionOf(double masterRateRevPerMin, double mm)
{
    return masterRateRevPerMin < 0 ? -mm : mm;
}

} // namespace

double advanceMm(const profile::Program& program)
{
    Recipe recipe;
    recipe.program = program;
    return ofValidCam(quantised(recipe).program, [](const auto& cam) {
        const double steps = std::round(netAdvanceMm(cam) * cam.slaveScale * advanceStepsPerMm);
        return steps == 0 ? 0 : inDirectionOf(cam.masterRateRevPerMin, steps / advanceStepsPerMm);
    });
}

double advanceMm(std::span<const std::uint16_t> registers, const Recipe& recipe)
{
    const profile::CamMaster* master = profile::camMaster(recipe.program);
    const modbus::RegisterReader header(registers, 0);
    const std::uint32_t divisor = header.u32("bank.divisor");
    if (master == nullptr || divisor == 0)
        return 0;
    const double pulses = header.physical("bank.advance") + header.physical("bank.remainder") / divisor;
    return pulses == 0 ? 0
                       : inDirectionOf(master->masterRateRevPerMin,
                                       pulses / profile::axisPulsesPerMm(recipe.machine));
}

double closingErrorMm(const profile::Program& program)
{
    return ofValidCam(program, [](const auto& cam) { return closingErrorMm(cam); });
}

bool isAdvanceConfirmed(const profile::Program& program)
{
    const double mm = advanceMm(program);
    return mm == 0 || std::abs(mm - confirmedAdvanceMm(program)) * advanceStepsPerMm < 1;
}

void confirmAdvance(profile::Program& program)
{
    setConfirmedAdvance(program, advanceMm(program));
}

double confirmedAdvanceMm(const profile::Program& program)
{
    const profile::CamMaster* master = profile::camMaster(program);
    return master != nullptr ? master->confirmedAdvanceMm : 0;
}

void setConfirmedAdvance(profile::Program& program, double advanceMm)
{
    std::visit(
        [advanceMm]<typename P>(P& cam) {
            if constexpr (isCam<P>)
                cam.confirmedAdvanceMm = advanceMm;
        },
        program);
}

void closeCam(profile::Program& program)
{
    std::visit(
        []<typename P>(P& cam) {
            if constexpr (isCam<P>)
                cam = closed(cam);
        },
        program);
}

} // namespace campanel::program
