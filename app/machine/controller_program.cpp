// SPDX-License-Identifier: Apache-2.0
#include "app/machine/controller_program.h"

#include "app/program/program_image.h"

#include <QLoggingCategory>

#include <cmath>
#include <numbers>

namespace campanel::machine {

namespace {

Q_LOGGING_CATEGORY(motionLog, "campanel.motion")

// Angle of the knife's shaft at a master angle, 0 at the index mark.
double knifeDegAt(const profile::RotaryCutter& cutter, double masterDeg)
{
    const double positionMm = cutter.motion.at(masterDeg / 360 * cutter.cycle.cycleTimeS).positionMm;
    return positionMm / cutter.machine.knifeRadiusMm * 180 / std::numbers::pi;
}

} // namespace

std::shared_ptr<const ControllerProgram> readProgram(const link::ActiveProgram& active,
                                                     const modbus::Identity& identity)
{
    if (active.isEmpty())
        return nullptr;
    auto program = std::make_shared<ControllerProgram>();
    program->generation = active.generation;
    program->crc = active.crc;
    program->registers = active.header;
    program->header = modbus::decodeBankHeader(active.header);
    program->cycleSeconds = static_cast<double>(program->header.cycleTicks) / identity.timerClockHz;
    program->rateBagsPerMin = 60 / program->cycleSeconds;
    const auto recipe =
        program::decodeProgram(active.header, program::withController(profile::Machine(), identity));
    if (!recipe) {
        qCWarning(motionLog) << "active program:"
                             << QString::fromStdString(program::describe(recipe.error()));
        return program;
    }
    program->recipe = *recipe;
    program->pulsesPerMm = profile::pulsesPerMm(recipe->machine);
    const auto cutter = profile::solve(recipe->program, recipe->machine);
    if (!cutter) {
        qCWarning(motionLog) << "active program:"
                             << QString::fromStdString(profile::describe(cutter.error()));
        return program;
    }
    program->syncStartDeg = knifeDegAt(*cutter, program->header.syncStartDeg);
    program->syncEndDeg = knifeDegAt(*cutter, program->header.syncEndDeg);
    program->cutDeg = knifeDegAt(*cutter, program->header.cutAngleDeg);
    program->curves = std::make_shared<const profile::Curves>(profile::sampleCurves(*cutter, curvePoints));
    return program;
}

} // namespace campanel::machine
