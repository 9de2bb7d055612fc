// SPDX-License-Identifier: Apache-2.0
#include "app/panel/recipe/controller_program.h"

#include "app/program/cam_advance.h"
#include "app/program/program_image.h"

#include <QLoggingCategory>

#include <cmath>
#include <numbers>

namespace campanel::panel {

namespace {

Q_LOGGING_CATEGORY(motionLog, "campanel.motion")

} // namespace

double knifeDegAt(const profile::RotaryCutter& cutter, double masterDeg)
{
    const double positionMm = cutter.motion.at(masterDeg / 360 * cutter.cycle.cycleTimeS).positionMm;
    return positionMm / cutter.machine.knifeRadiusMm * 180 / std::numbers::pi;
}

std::shared_ptr<const ControllerProgram> readProgram(const link::ActiveProgram& active,
                                                     const modbus::Identity& identity)
{
    if (active.isEmpty())
        return nullptr;
    auto program = std::make_shared<ControllerProgram>();
    program->generation = active.generation;
    program->crc = active.crc;
    program->registers = active.header;
    program->list = active.list;
    const modbus::RegisterReader header(active.header, 0);
    program->kind = static_cast<modbus::ProgramKind>(header.u16("bank.kind"));
    program->layout = static_cast<modbus::TableLayout>(header.u16("bank.layout"));
    program->name = header.text("program.recipe_name");
    const auto recipe = program::decodeProgram(active.header, active.list,
                                               program::withController(profile::Machine(), identity));
    if (!recipe) {
        qCWarning(motionLog, "active program: unknown value %d (error %d)", recipe.error().code,
                  static_cast<int>(recipe.error().kind));
        return program;
    }
    program->recipe = *recipe;
    const auto solved = program::solveProgram(*recipe);
    if (!solved) {
        qCWarning(motionLog) << "active program:"
                             << QString::fromStdString(profile::describe(solved.error()));
        return program;
    }
    program->pulsesPerMm = solved->pulsesPerMm;
    program->advanceMm = program::advanceMm(active.header, *recipe);
    program->version = recipe->version;
    // The rows of a press are stages: the bank does not contain the duration of a stroke.
    const std::uint32_t ticks = header.u32("bank.cycle_ticks");
    program->cycleSeconds = ticks > 0 ? static_cast<double>(ticks) / identity.timerClockHz : solved->cycleS();
    program->rateBagsPerMin = ticks > 0 ? 60 / program->cycleSeconds : 0;
    if (solved->cutter) {
        program->bagLengthMm = solved->cutter->cycle.bagLengthMm;
        program->syncStartDeg = knifeDegAt(*solved->cutter, header.physical("bank.sync_start"));
        program->syncEndDeg = knifeDegAt(*solved->cutter, header.physical("bank.sync_end"));
        program->cutDeg = knifeDegAt(*solved->cutter, header.physical("bank.cut_angle"));
    }
    program->marksS = solved->marksS;
    program->curves = std::make_shared<const profile::Curves>(program::sampleCurves(*solved, curvePoints));
    return program;
}

} // namespace campanel::panel
