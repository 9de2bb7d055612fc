// SPDX-License-Identifier: Apache-2.0
// The header of a program bank: fields of all banks, fields of a table layout, and the inputs of each kind of
// program at overlapping addresses.
#include "modbus/map/register_rows.h"

namespace campanel::modbus {
namespace {

using namespace rows;
using Layout = TableLayout;

constexpr RegisterInfo step(RegisterInfo row)
{
    return withLayout(row, Layout::StepTable);
}

constexpr RegisterInfo positionMove(RegisterInfo row)
{
    return withKind(ProgramKind::PositionMove, row);
}

constexpr RegisterInfo speedMove(RegisterInfo row)
{
    return withKind(ProgramKind::SpeedMove, row);
}

constexpr RegisterInfo pointCam(RegisterInfo row)
{
    return withKind(ProgramKind::PointCam, row);
}

constexpr RegisterInfo segmentCam(RegisterInfo row)
{
    return withKind(ProgramKind::SegmentCam, row);
}

// A register of every cam that follows a master.
constexpr RegisterInfo cam(RegisterInfo row)
{
    row.kinds = static_cast<std::uint16_t>(RegisterInfo::bitOf(ProgramKind::PointCam) |
                                           RegisterInfo::bitOf(ProgramKind::SegmentCam));
    return row;
}

constexpr RegisterInfo press(RegisterInfo row)
{
    return withKind(ProgramKind::Press, row);
}

constexpr std::array bankTable{
    ro16("bank.layout", 0, "layout of the rows", "TableLayout"),
    ro16("bank.kind", 1, "program kind", "ProgramKind"),
    ro16("bank.row_count", 2, "number of rows after the header"),
    ro32("bank.cycle_ticks", 3,
         "timer ticks of one cycle at full speed; sum of the ticks of a step table's rows", 1.0, "ticks"),
    step(ro32("bank.cycle_pulses", 5, "whole pulses of one cycle; sum of the pulses of the rows", 1.0,
              "pulses")),
    withLayout(roI32("bank.advance", 5, "whole pulses from start to end of a cycle", "pulses"),
               Layout::CamPoints, Layout::Intervals),
    ro32("bank.remainder", 7, "numerator of the fraction of a pulse that remains in each cycle", 1.0,
         "pulses"),
    ro32("bank.divisor", 9, "denominator of this fraction; 1: no fraction"),
    step(ro16("bank.carry_row", 11, "row that gets one more pulse when the remainder is a whole pulse")),
    withLayout(ro16("bank.end_behavior", 11, "behavior at the end of the table", "EndBehavior"),
               Layout::CamPoints, Layout::Intervals),
    step(ro16("bank.cut_angle", 12, "master angle at which the knife closes", {}, 0.01, "deg")),
    step(ro16("bank.sync_start", 13, "master angle at which knife and film start moving together", {}, 0.01,
              "deg")),
    step(ro16("bank.sync_end", 14, "master angle at which knife and film stop moving together", {}, 0.01,
              "deg")),
    withLayout(ro16("cam.master_ramp", 12,
                    "ramp time of the master from standstill to full speed; 0: no ramp", {}, 1.0, "ms"),
               Layout::CamPoints),
    withLayout(ro16("interval.fraction_bits", 12,
                    "unit of the speeds and accelerations of the rows: 2^-bits; 0 to 8"),
               Layout::Intervals),
    withLayout(ro16("cam.ramp_shape", 13, "shape of the master's ramp", "RampShape"), Layout::CamPoints),
    pointCam(withLayout(ro16("cam.knot_count", 14, "number of knots after the rows"), Layout::CamPoints)),
    segmentCam(
        withLayout(ro16("cam.segment_count", 14, "number of segments after the rows"), Layout::CamPoints)),
    cutter(ro32("program.knife_radius", 15, "knife-tip radius", 0.001, "mm")),
    cutter(ro16("program.knives", 17, "knives on the shaft")),
    cutter(ro32("program.pulses_per_motor_rev", 18, "pulses per motor revolution K", 1.0, "pulses")),
    cutter(ro16("program.gear_numerator", 20, "motor revolutions per knife revolution Z, numerator")),
    cutter(ro16("program.gear_denominator", 21, "Z, denominator")),
    cutter(ro16("program.pinned", 22,
                "the two given inputs: bit 0 bag length, 1 rate, 2 base speed, 3 film speed")),
    cutter(ro32("program.bag_length", 23, "bag length L: film fed per cycle", 0.001, "mm")),
    cutter(ro32("program.rate", 25, "bags per minute", 0.0001, "bags/min")),
    cutter(ro32("program.base_speed", 27, "v_a", 0.001, "mm/s")),
    cutter(ro32("program.film_speed", 29, "v_b", 0.001, "mm/s")),
    cutter(ro32("program.sync_ratio", 31, "v_b over film speed", 0.000001)),
    cutter(ro32("program.k1", 33, "T / t_a", 0.000001)),
    cutter(ro32("program.k2", 35, "T / t_b", 0.000001)),
    cutter(ro32("program.k3", 37, "T / t_c", 0.000001)),
    cutter(ro32("program.k4", 39, "T / t_d", 0.000001)),
    cutter(ro16("program.law", 41, "speed law", "Law")),
    cutter(ro32("program.law_parameter1", 42, "first parameter of the law, 0: none", 0.000001)),
    cutter(ro32("program.law_parameter2", 44, "second parameter of the law, 0: none", 0.000001)),
    cutter(ro16("program.ramp_slices", 46, "slices per ramp of the step table")),
    positionMove(roScaled32("position_move.distance", 15, "distance; negative: reverse", 0.001, "mm")),
    positionMove(ro16("position_move.duration", 17, "the given input", "MoveDuration")),
    positionMove(ro32("position_move.time", 18, "given time", 0.000001, "s")),
    positionMove(ro16("position_move.law", 20, "displacement law", "Law")),
    positionMove(ro32("position_move.law_parameter1", 21, "first parameter of the law, 0: none", 0.000001)),
    positionMove(ro32("position_move.law_parameter2", 23, "second parameter of the law, 0: none", 0.000001)),
    positionMove(ro16("position_move.cam_points", 25, "intervals of the cam table")),
    positionMove(ro32("position_move.feed", 26, "feed per motor revolution", 0.001, "mm")),
    positionMove(
        ro32("position_move.pulses_per_motor_rev", 28, "pulses per motor revolution K", 1.0, "pulses")),
    positionMove(ro32("position_move.inertia", 30, "inertia at the motor", 0.001, "kg cm^2")),
    positionMove(ro32("position_move.friction", 32, "friction at the motor", 0.001, "Nm")),
    speedMove(roScaled32("speed_move.start_speed", 15, "V0", 0.001, "mm/s")),
    speedMove(roScaled32("speed_move.end_speed", 17, "V1", 0.001, "mm/s")),
    speedMove(ro16("speed_move.duration", 19, "the given input", "MoveDuration")),
    speedMove(ro32("speed_move.time", 20, "given time", 0.000001, "s")),
    speedMove(roScaled32("speed_move.distance", 22, "given distance", 0.001, "mm")),
    speedMove(ro16("speed_move.law", 24, "speed law", "Law")),
    speedMove(ro32("speed_move.law_parameter1", 25, "first parameter of the law, 0: none", 0.000001)),
    speedMove(ro32("speed_move.law_parameter2", 27, "second parameter of the law, 0: none", 0.000001)),
    speedMove(ro16("speed_move.cam_points", 29, "intervals of the cam table")),
    speedMove(ro32("speed_move.feed", 30, "feed per motor revolution", 0.001, "mm")),
    speedMove(ro32("speed_move.pulses_per_motor_rev", 32, "pulses per motor revolution K", 1.0, "pulses")),
    speedMove(ro32("speed_move.inertia", 34, "inertia at the motor", 0.001, "kg cm^2")),
    speedMove(ro32("speed_move.friction", 36, "friction at the motor", 0.001, "Nm")),
    cam(roI16("cam.master_rate", 15, "speed of the master; negative: reverse", 0.1, "r/min")),
    pointCam(ro16("cam.ends", 16, "ends of the spline", "SplineEnds")),
    cam(ro32("cam.master_ratio", 17, "master revolutions per cam cycle", 0.001)),
    cam(ro32("cam.master_scale", 19, "scale of the cam over the master", 0.001)),
    cam(roScaled32("cam.slave_scale", 21, "scale of the cam over the slave", 0.001, {})),
    cam(roI16("cam.phase", 23, "start phase of the cam", 0.1, "deg")),
    cam(ro16("cam.cam_points", 24, "intervals of the cam table")),
    cam(ro32("cam.feed", 25, "feed per motor revolution", 0.001, "mm")),
    cam(ro32("cam.pulses_per_motor_rev", 27, "pulses per motor revolution K", 1.0, "pulses")),
    cam(ro32("cam.inertia", 29, "inertia at the motor", 0.001, "kg cm^2")),
    cam(ro32("cam.friction", 31, "friction at the motor", 0.001, "Nm")),
    press(ro32("press.approach_position", 15, "end of the approach", 0.001, "mm")),
    press(ro16("press.approach_speed", 17, "approach speed", {}, 0.1, "mm/s")),
    press(ro16("press.probe_speed", 18, "probe speed", {}, 0.1, "mm/s")),
    press(ro16("press.probe_force", 19, "contact force of the probe stage", {}, 1.0, "N")),
    press(ro32("press.probe_end", 20, "end of the probe stage", 0.001, "mm")),
    press(ro16("press.press_speed", 22, "press speed", {}, 0.1, "mm/s")),
    press(ro32("press.press_position", 23, "stop position", 0.001, "mm")),
    press(ro16("press.hold_time", 25, "hold time", {}, 0.01, "s")),
    press(ro16("press.return_speed", 26, "return speed", {}, 0.1, "mm/s")),
    press(ro16("press.max_force", 27, "maximum force; above it the stroke is aborted", {}, 1.0, "N")),
    press(ro16("press.position_tolerance", 28, "tolerance of the stop position, plus and minus", {}, 0.001,
               "mm")),
    press(ro16("press.min_stop_force", 29, "minimum force at the stop", {}, 1.0, "N")),
    press(ro16("press.max_stop_force", 30, "maximum force at the stop", {}, 1.0, "N")),
    press(ro32("press.feed", 31, "feed per motor revolution", 0.001, "mm")),
    press(ro32("press.pulses_per_motor_rev", 33, "pulses per motor revolution K", 1.0, "pulses")),
    press(ro32("press.max_acceleration", 35, "maximum acceleration of the ramps", 1.0, "mm/s^2")),
    ro16("program.recipe_version", 47, "version of the recipe"),
    RegisterInfo{"program.recipe_name",
                 48,
                 RegisterType::Text,
                 16,
                 Access::ReadOnly,
                 1.0,
                 {},
                 0,
                 0,
                 0,
                 {},
                 "name of the recipe"},
    block("bank.rows", bankHeaderRegisters, bankRegisters - bankHeaderRegisters, Access::ReadOnly,
          "bank.row_count rows in bank.layout"),
};

static_assert(isConsistent(bankTable));

} // namespace

std::span<const RegisterInfo> bankFields()
{
    return bankTable;
}

} // namespace campanel::modbus
