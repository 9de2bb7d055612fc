// SPDX-License-Identifier: Apache-2.0
// The registers at fixed addresses. Addresses and encodings are the contract: change them only with a new map
// version.
#include "modbus/map/register_map.h"

#include "modbus/map/register_rows.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <unordered_map>

namespace campanel::modbus {

const std::uint16_t mapMinor = 7;

namespace {

using namespace rows;
using namespace std::string_view_literals;

constexpr double max32 = 4294967295.0;

// The registers of one cam switch. A macro, because a name must be a literal.
#define CAMPANEL_CAM_SWITCH(number, address)                                                                 \
    rw16("parameter.switch" number "_mode", address, "cam switch " number ": mode", "SwitchMode", 0, 2, 0),  \
        rw16("parameter.switch" number "_on_angle", (address) + 1,                                           \
             "on angle in the cycle of a cutter's film or of a point cam's master", {}, 0, 359.99, 0, 0.01,  \
             "deg"),                                                                                         \
        rw16("parameter.switch" number "_off_angle", (address) + 2,                                          \
             "off angle; equal to the on angle: never on", {}, 0, 359.99, 0, 0.01, "deg"),                   \
        rw16("parameter.switch" number "_lead", (address) + 3, "switching lead at the present speed", {}, 0, \
             100, 0, 0.1, "ms"),                                                                             \
        rw16("parameter.switch" number "_every", (address) + 4, "on in every n-th cycle", {}, 1, 1000, 1)

// The registers of an input that is a contact, by its name in snake case.
#define CAMPANEL_CONTACT(minor, name, address)                                                               \
    since(minor,                                                                                             \
          rw16("parameter." name "_contact", address, "kind of contact of this input", "Contact", 0, 1, 0)), \
        since(minor, rw16("parameter." name "_filter", (address) + 1,                                        \
                          "time for which this input must have changed before it counts", {}, 0, 100, 0,     \
                          1.0, "ms"))

// The registers of an input that acts on a run, and of what a condition shows on the light tower.
#define CAMPANEL_SIGNAL_INPUT(name, address, filter)                                                         \
    since(6, rw16("signal." name "_contact", address, "kind of contact of this input", "Contact", 0, 1, 0)), \
        since(6, rw16("signal." name "_filter", (address) + 1,                                               \
                      "time for which this input must have changed before it counts", {}, 0, 100, filter,    \
                      1.0, "ms"))
#define CAMPANEL_INDEX_INPUT(name, address)                                                                  \
    since(7, rw16("signal." name "_contact", address, "kind of contact of this input", "IndexContact", 0, 2, \
                  2)),                                                                                       \
        since(7, rw16("signal." name "_filter", (address) + 1,                                               \
                      "time for which this input must have changed before it counts", {}, 0, 100, 0, 1.0,    \
                      "ms"))
#define CAMPANEL_SIGNAL(name, address, red, yellow, green)                                                   \
    since(6, rw16("signal." name "_red", address, "red light while this lasts", "SignalMode", 0, 4, red)),   \
        since(6, rw16("signal." name "_yellow", (address) + 1, "yellow light", "SignalMode", 0, 4, yellow)), \
        since(6, rw16("signal." name "_green", (address) + 2, "green light", "SignalMode", 0, 4, green)),    \
        since(6, rw16("signal." name "_horn", (address) + 3, "horn", "SignalMode", 0, 4, 0))

// The place of a knife, by its number behind the index mark.
#define CAMPANEL_KNIFE(number, address)                                                                      \
    since(6, rwI16("parameter.knife_" number, address,                                                       \
                   "film by which this knife of several cuts behind its place, as seen from the first one",  \
                   -5, 5, 0, 0.001, "mm"))

constexpr std::array registerTable{
    ro16("identity.device_type", 0x0000, "0xCA3D on every CamPanel controller"),
    ro16("identity.map_major", 0x0001,
         "register-map version; a panel of another major version refuses to work"),
    ro16("identity.map_minor", 0x0002, "a higher minor version only adds registers"),
    ro16("identity.firmware_major", 0x0003, "firmware version"),
    ro16("identity.firmware_minor", 0x0004, "firmware version"),
    ro16("identity.firmware_patch", 0x0005, "firmware version"),
    ro32("identity.unique_id_high", 0x0006, "unique id, upper half"),
    ro32("identity.unique_id_low", 0x0008, "unique id, lower half"),
    ro16("identity.program_kinds", 0x000A, "bit n set: program kind n can be executed", "ProgramKind"),
    ro16("identity.row_capacity", 0x000B, "maximum number of rows of a step table"),
    ro16("identity.bank_registers", 0x000C, "registers of a bank, header included"),
    ro16("identity.block_registers", 0x000D, "payload registers of one transfer block"),
    ro32("identity.timer_clock", 0x000E, "clock of the pulse timer", 1.0, "Hz"),
    ro16("identity.timer_bits", 0x0010, "width of the pulse timer"),
    ro32("identity.max_pulse_frequency", 0x0011, "maximum pulse frequency of the output stage", 1.0, "Hz"),
    ro16("identity.table_layouts", 0x0013, "bit n set: table layout n can be executed", "TableLayout"),
    ro32("clock.unix_time", 0x0060, "seconds since 1970-01-01 UTC, 0 until set", 1.0, "s"),

    rw16("parameter.heartbeat_timeout", 0x0080, "time without a panel heartbeat after which it is lost", {},
         200, 60000, 2000, 1.0, "ms"),
    rw16("parameter.heartbeat_lost_action", 0x0081, "action of a running machine after a lost heartbeat",
         "HeartbeatLostAction", 0, 1, 0),
    rw16("parameter.ramp_time", 0x0082, "ramp time between standstill and full speed", {}, 50, 10000, 800,
         1.0, "ms"),
    rw32("parameter.jog_frequency", 0x0083, "pulse frequency while jogging", 10, 20000, 1000, 1.0, "Hz"),
    rw32("parameter.home_frequency", 0x0085, "pulse frequency while homing", 10, 20000, 2000, 1.0, "Hz"),
    rw32("parameter.following_error_limit", 0x0087, "maximum following error; above it a fault", 10, 1000000,
         3000, 1.0, "pulses"),
    rw16("parameter.master_direction", 0x0089,
         "direction of the master of a point cam: 0 forward, 1 reverse; a running master ramps through zero",
         {}, 0, 1, 0),

    // Film, marks and products of a packing machine; see controller/core/packer/README.md.
    rw16("parameter.mark_tracking", 0x008A, "1: cuts follow the printed marks", {}, 0, 1, 1),
    rw32("parameter.mark_distance", 0x008B, "film length between mark sensor and knife", 10, 5000, 900, 0.001,
         "mm"),
    rw32("parameter.mark_offset", 0x008D, "film length from a mark to the cut behind it", 0, 2000, 0, 0.001,
         "mm"),
    rw16("parameter.mark_window", 0x008F, "maximum distance of a mark from its expected position", {}, 0.5,
         30, 6, 0.001, "mm"),
    rw16("parameter.mark_missing_limit", 0x0090, "consecutive missing marks that end the run", {}, 1, 100, 5),
    rw16("parameter.phase_gain", 0x0091, "share of the mark error that corrects the phase", {}, 0, 1, 0.25,
         0.001),
    rw16("parameter.length_gain", 0x0092, "share of the mark error that corrects the length between marks",
         {}, 0, 1, 0.1, 0.001),
    rw16("parameter.phase_limit", 0x0093, "maximum phase correction per bag", {}, 0.05, 20, 1, 0.001, "mm"),
    rw16("parameter.length_limit", 0x0094, "maximum length correction per bag", {}, 0, 10, 2, 0.01, "%"),
    rwI16("parameter.length_trim", 0x0095, "added to every bag while mark tracking is off", -5, 5, 0, 0.001,
          "mm"),
    rw16("parameter.anti_cut", 0x0096, "1: the knife stays open if a product is in its path", {}, 0, 1, 1),
    rw16("parameter.cut_clearance", 0x0097, "film length without products on both sides of a cut", {}, 0.5,
         60, 5, 0.001, "mm"),
    rw16("parameter.empty_bag", 0x0098, "1: film and knife wait one cycle for a missing product", {}, 0, 1,
         0),
    rw16("parameter.skip_limit", 0x0099, "consecutive skipped cuts that end the run", {}, 1, 100, 5),
    rw32("parameter.film_feed", 0x009A, "film per revolution of the film motor", 1, 2000, 150, 0.001, "mm"),
    rw32("parameter.film_pulses", 0x009C, "pulses per revolution of the film motor", 100, 1000000, 10000, 1.0,
         "pulses"),
    rw32("parameter.product_distance", 0x009E,
         "film length between knife and product infeed, to the nearest half bag", 50, 5000, 700, 0.001, "mm"),
    rw32("parameter.flight_pitch", 0x00A0, "distance of the products on the infeed", 20, 2000, 500, 0.001,
         "mm"),
    rw32("parameter.flight_pulses", 0x00A2, "pulses of the infeed motor per product", 100, 10000000, 20000,
         1.0, "pulses"),
    rw32("parameter.eye_distance", 0x00A4, "infeed distance between the product eye and the film", 20, 10000,
         1000, 0.001, "mm"),
    // A change of program while running; see controller/core/motion/README.md.
    rw32("parameter.knife_step", 0x00A6, "maximum speed step of the main axis", 10, 1000000, 2600, 1.0, "Hz"),
    rw32("parameter.film_step", 0x00A8, "maximum speed step of the film motor", 10, 1000000, 1300, 1.0, "Hz"),
    rw32("parameter.infeed_step", 0x00AA, "maximum speed step of the infeed motor", 10, 1000000, 800, 1.0,
         "Hz"),

    // Outputs that switch with the cycle; see controller/core/motion/README.md.
    CAMPANEL_CAM_SWITCH("1", 0x00AC),
    CAMPANEL_CAM_SWITCH("2", 0x00B1),
    CAMPANEL_CAM_SWITCH("3", 0x00B6),
    CAMPANEL_CAM_SWITCH("4", 0x00BB),
    CAMPANEL_CAM_SWITCH("5", 0x00C0),
    CAMPANEL_CAM_SWITCH("6", 0x00C5),
    CAMPANEL_CAM_SWITCH("7", 0x00CA),
    CAMPANEL_CAM_SWITCH("8", 0x00CF),
    rw16("parameter.drive_enable", 0x00D4, "mode of the output that enables the drives", "DriveEnable", 0, 2,
         1),
    since(5, rw16("parameter.permit_needed", 0x00D5, "1: a start needs every bit of exchange.permit", {}, 0,
                  1, 0)),
    CAMPANEL_CONTACT(5, "drive_alarm", 0x00D6),
    CAMPANEL_CONTACT(5, "emergency_stop", 0x00D8),
    CAMPANEL_CONTACT(5, "limit_forward", 0x00DA),
    CAMPANEL_CONTACT(5, "limit_reverse", 0x00DC),
    // Sensors that answer late; see controller/core/packer/README.md.
    since(6, rw16("parameter.mark_dead_time", 0x00DE, "time from a mark to the answer of its sensor", {}, 0,
                  20, 0, 0.001, "ms")),
    since(6, rw16("parameter.eye_dead_time", 0x00DF,
                  "time from the leading edge of a product to the answer of the product eye", {}, 0, 20, 0,
                  0.001, "ms")),
    since(6, rw16("parameter.eye_end_dead_time", 0x00E0,
                  "time from the trailing edge of a product to the answer of the product eye", {}, 0, 20, 0,
                  0.001, "ms")),
    since(6, rwI16("parameter.mark_end_later", 0x00E1,
                   "the end of a mark is answered later than its beginning by this time; both times together "
                   "are 0 to 20 ms",
                   -20, 20, 0, 0.001, "ms")),
    // These tell marks from other prints, and one product from two.
    since(6, rw16("parameter.mark_width_min", 0x00E2, "minimum width of a mark along the film, 0: any", {}, 0,
                  60, 0, 0.001, "mm")),
    since(6, rw16("parameter.mark_width_max", 0x00E3, "maximum width of a mark along the film, 0: any", {}, 0,
                  60, 0, 0.001, "mm")),
    since(6, rw16("parameter.mark_masking", 0x00E4,
                  "film length behind the beginning of a mark in which other prints are ignored, 0: none", {},
                  0, 2000, 0, 0.1, "mm")),
    since(6, rw16("parameter.product_length_max", 0x00E5,
                  "maximum length of one product, above it the products are joined, 0: not monitored", {}, 0,
                  2000, 0, 0.1, "mm")),
    // Hot jaws; see controller/core/motion/README.md.
    since(6, rw16("parameter.jaws_before", 0x00E6,
                  "shaft angle before the cut from which the jaws touch the film, 0: not known", {}, 0, 90, 0,
                  0.01, "deg")),
    since(6, rw16("parameter.jaws_behind", 0x00E7,
                  "shaft angle behind the cut up to which they touch it, 0: not known", {}, 0, 90, 0, 0.01,
                  "deg")),
    since(6,
          rw16("parameter.park_delay", 0x00E8, "time from a stop with closed jaws until the knife opens them",
               {}, 0, 10000, 0, 1.0, "ms")),
    since(6, rw16("parameter.jaws_closed_max", 0x00E9,
                  "time on standing film after which closed jaws spoil both bags", {}, 100, 60000, 1000, 1.0,
                  "ms")),
    // The places of knives that are not evenly spaced.
    CAMPANEL_KNIFE("2", 0x00EA),
    CAMPANEL_KNIFE("3", 0x00EB),
    CAMPANEL_KNIFE("4", 0x00EC),
    CAMPANEL_KNIFE("5", 0x00ED),
    CAMPANEL_KNIFE("6", 0x00EE),
    CAMPANEL_KNIFE("7", 0x00EF),
    CAMPANEL_KNIFE("8", 0x00F0),
    CAMPANEL_KNIFE("9", 0x00F1),
    CAMPANEL_KNIFE("10", 0x00F2),
    CAMPANEL_KNIFE("11", 0x00F3),
    CAMPANEL_KNIFE("12", 0x00F4),
    since(6,
          rw16("parameter.thread_up", 0x00F5,
               "1: after power-up and jog the film runs with the knife open until the cut can follow a mark",
               {}, 0, 1, 0)),
    // Jams; see controller/core/packer/README.md.
    since(6, rw16("parameter.jam_detection", 0x00F6, "1: something under the closing jaws stops the machine",
                  {}, 0, 1, 0)),
    since(6, rw16("parameter.jam_closing", 0x00F7,
                  "shaft angle before the cut from which the knife closes: there its torque is monitored", {},
                  1, 120, 45, 0.01, "deg")),
    since(6, rw16("parameter.jam_margin", 0x00F8,
                  "torque beyond the learned band, in relation to the rated torque, that is still none", {},
                  0.5, 100, 5, 0.1, "%")),
    since(6, rw16("parameter.jam_stop_time", 0x00F9,
                  "time from full speed to standstill of all axes after a jam", {}, 2, 2000, 50, 1.0, "ms")),
    since(6, rw16("parameter.jam_back", 0x00FA,
                  "shaft angle by which the knife goes back from where a jam was seen", {}, 5, 120, 30, 0.01,
                  "deg")),
    CAMPANEL_CONTACT(6, "torque_limit", 0x00FB),

    // Status block: the answer to the periodic FC23 exchange. 40 registers, so that 9600 baud still carries 8
    // a second.
    ro16("status.tag", 0x0100, "echo of exchange.tag"),
    ro16("status.heartbeat", 0x0101, "echo of exchange.heartbeat"),
    ro16("status.state", 0x0102, "state of the controller", "State"),
    ro16("status.fault", 0x0103, "fault bits", "FaultBit"),
    ro16("status.warning", 0x0104, "warning bits", "WarningBit"),
    ro16("status.program_kind", 0x0105, "kind of the active program", "ProgramKind"),
    ro16("status.staged_state", 0x0106, "state of the shadow bank", "StagedState"),
    ro32("status.generation", 0x0107, "number of programs that became active since first power-up"),
    ro32("status.active_crc", 0x0109, "CRC-32 of the active bank's bytes, 0: none"),
    ro32("status.saved_crc", 0x010B, "CRC-32 of the bank in the newest valid flash slot, 0: none"),
    ro32("status.cycle_count", 0x010D, "cycles completed since power-up; of a press all strokes"),
    ro16("status.master_angle", 0x010F, "position in the cycle", {}, 0.01, "deg"),
    ro16("status.master_speed", 0x0110, "speed in relation to the table; 100 % outside ramps", {}, 0.01, "%"),
    roI32("status.commanded_frequency", 0x0111, "pulse frequency sent to the drive", "Hz"),
    roI32("status.actual_frequency", 0x0113, "encoder speed in pulses", "Hz"),
    roI32("status.commanded_position", 0x0115, "pulses sent since homing, lower 32 bits", "pulses"),
    roI32("status.axis_position", 0x0117, "encoder position in pulses since homing, lower 32 bits", "pulses"),
    roI16("status.following_error", 0x0119, "commanded minus actual, saturating", 1.0, "pulses"),
    withKind(ProgramKind::RotaryCutter,
             ro16("status.knife_angle", 0x011A, "knife angle from the encoder, 0 at the index mark", {}, 0.01,
                  "deg")),
    withKind(
        ProgramKind::RotaryCutter,
        ro32("status.bag_length", 0x011B, "measured length of the last bag; 0: none measured", 0.001, "mm")),
    withKind(ProgramKind::RotaryCutter,
             roI16("status.bag_deviation", 0x011D, "last measured length minus set length, saturating", 0.001,
                   "mm")),
    withKind(ProgramKind::RotaryCutter, ro32("status.bag_count", 0x011E, "bags cut since power-up")),
    withKind(ProgramKind::Press, ro16("status.press_stage", 0x011A, "stage of the stroke", "PressStage")),
    withKind(ProgramKind::Press,
             ro16("status.press_force", 0x011B, "present force, saturating", {}, 1.0, "N")),
    withKind(ProgramKind::Press,
             roI16("status.stop_error", 0x011C, "last stroke: actual minus set stop position, saturating",
                   1.0, "pulses")),
    withKind(ProgramKind::Press,
             ro16("status.stop_force", 0x011D, "last stroke: force at the stop", {}, 1.0, "N")),
    withKind(ProgramKind::Press,
             ro16("status.stroke_result", 0x011E, "last stroke: outcome", "StrokeResult")),
    withKind(ProgramKind::Press,
             ro16("status.peak_force", 0x011F, "last stroke: maximum force", {}, 1.0, "N")),
    ro32("status.uptime", 0x0120, "time since power-up", 1.0, "s"),
    ro16("status.command_counter", 0x0122, "counter of the last command received"),
    ro16("status.link_crc_errors", 0x0123, "frames with a wrong CRC-16, wrapping"),
    ro16("status.link_frame_errors", 0x0124, "frames cut short, too long or with a line error, wrapping"),
    ro16("status.link_exceptions", 0x0125, "exception answers sent, wrapping"),
    ro16("status.link_requests", 0x0126, "requests answered, wrapping"),
    ro16("status.sample_time", 0x0127, "controller time of this block, wrapping", {}, 1.0, "ms"),

    // Film, marks and products; one proven reading. 0 while the program has no knife.
    cutter(ro16("packer.mark_state", 0x0140, "state of mark tracking", "MarkState")),
    cutter(
        roI16("packer.mark_error", 0x0141, "last cut: actual minus set position by its mark", 0.001, "mm")),
    cutter(ro32("packer.mark_pitch", 0x0142,
                "film length from mark to mark, measured by the film motor, filtered", 0.001, "mm")),
    cutter(roI16("packer.phase_correction", 0x0144, "phase correction of the next cut", 0.001, "mm")),
    cutter(roI16("packer.length_correction", 0x0145, "length correction of the next bag", 0.001, "mm")),
    cutter(roI16("packer.last_mark", 0x0146, "last mark: actual minus expected position", 0.001, "mm")),
    cutter(roI16("packer.film_following_error", 0x0147, "film motor: commanded minus actual", 0.001, "mm")),
    cutter(ro32("packer.marks", 0x0148, "marks followed since power-up")),
    cutter(ro32("packer.marks_missing", 0x014A, "missing marks")),
    cutter(ro32("packer.marks_false", 0x014C, "unexpected marks")),
    cutter(ro32("packer.products", 0x014E, "products placed on the film since power-up")),
    cutter(ro32("packer.cuts_skipped", 0x0150, "cuts skipped because of a product in the knife's path")),
    cutter(
        ro32("packer.empty_bags", 0x0152,
             "bags cut without a product (bit Empty); packer.film_saved has those that the film waited for")),
    cutter(ro32("packer.film_saved", 0x0154, "film saved by waiting for missing products", 0.001, "m")),
    cutter(ro16("packer.last_skip", 0x0156, "cause of the last skipped cut or bag", "SkipCause")),
    cutter(ro16("packer.skips_in_a_row", 0x0157, "consecutive skipped cuts")),
    cutter(ro32("packer.corrections_limited", 0x0158, "corrections reduced by a limit")),
    cutter(ro16("packer.film_angle", 0x015A, "position of the film in its cycle", {}, 0.01, "deg")),
    cutter(ro16("packer.knife_gate", 0x015B, "state of the knife against the film", "GateState")),
    cutter(ro16("packer.film_gate", 0x015C, "state of the film against the infeed", "GateState")),
    cutter(
        ro16("packer.teach_marks", 0x015D, "marks measured by TeachMarks; complete at the requested number")),
    cutter(ro32("packer.teach_pitch", 0x015E, "mean distance of these marks", 0.001, "mm")),
    cutter(ro16("packer.teach_scatter", 0x0160, "standard deviation of this distance", {}, 0.001, "mm")),
    cutter(ro16("packer.marks_wait", 0x0161, "marks between sensor and knife")),
    cutter(ro32("packer.bag_number", 0x0162,
                "bags recorded since power-up, equal to the number of the newest record")),
    cutter(block("packer.bags", 0x0164, 4 * bagRecords, Access::ReadOnly,
                 "the newest records, bag n at (n mod 8) x 4: deviation, mark error, distance to the "
                 "previous mark minus bag length (i16, 0.001 mm, saturating), BagBit")),
    cutter(ro32("packer.film_position", 0x0184,
                "position of the film motor, lower 32 bits; reference of the following registers", 0.001,
                "mm")),
    cutter(
        block("packer.cuts", 0x0186, viewCuts, Access::ReadOnly,
              "distances of the next cuts to the knife, i16, 0.1 mm; 0x8000: none. Bit 0 set: skipped cut")),
    cutter(block("packer.seen_marks", 0x018C, viewMarks, Access::ReadOnly,
                 "distances of the marks on the film, as above; bit 0 set: estimated, not seen")),
    cutter(block("packer.seen_products", 0x0198, 2 * viewProducts, Access::ReadOnly,
                 "products on the film: leading and trailing edge, as above")),
    since(6, cutter(ro16("packer.knife", 0x01A8,
                         "knife of the newest bag's cut, the first one behind the index mark is 1"))),
    since(6, cutter(ro16("packer.threading", 0x01A9, "1: the film is threaded up, the knife is open"))),

    // The pins, and what only some drives give. Read while somebody looks at it.
    ro16("io.available", 0x01B0,
         "which of the following values this machine has, and which positions survive a power cut", "IoBit"),
    ro16("io.inputs", 0x01B1, "present levels of the inputs", "InputBit"),
    ro16("io.outputs", 0x01B2, "present levels of the outputs", "OutputBit"),
    roI16("io.torque", 0x01B3, "torque reported by the drive of the axis, in relation to its rated torque",
          0.1, "%"),
    roScaled32("io.infeed_position", 0x01B4, "position of the infeed motor, lower 32 bits", 0.001, "mm"),
    roI16("io.infeed_following_error", 0x01B6, "infeed motor: commanded minus actual, saturating", 0.001,
          "mm"),
    ro16("io.torque_angle", 0x01B7, "position in the cycle of this torque", {}, 0.01, "deg"),
    since(6, ro16("io.more_outputs", 0x01B8, "present levels of the outputs from bit 16 of OutputBit on")),

    rw16("exchange.tag", 0x0200, "any value that differs from the last one; returned as status.tag"),
    rw16("exchange.heartbeat", 0x0201, "must advance; jog stops after 200 ms without a change"),
    rw16("exchange.jog", 0x0202, "pressed jog keys", "JogBit", 0, 3, 0),
    since(5,
          rw16("exchange.permit", 0x0203,
               "what the panel permits, in one frame with the heartbeat; any other write of the group takes "
               "it back",
               "PermitBit")),

    rw16("command.counter", 0x0220, "runs command.code (same frame); a repeated counter is ignored"),
    rw16("command.code", 0x0221, "the command", "Command", 0, static_cast<double>(lastCommand), 0),
    rw16("command.argument0", 0x0222, "see the command"),
    rw16("command.argument1", 0x0223, "see the command"),
    rw32("command.argument2", 0x0224, "see the command", 0, max32, 0),
    ro16("result.counter", 0x0230, "echo of command.counter"),
    ro16("result.code", 0x0231, "echo of command.code", "Command"),
    ro16("result.status", 0x0232, "outcome", "CommandStatus"),
    ro16("result.reason", 0x0233, "reason of a refusal", "Refusal"),

    rw16("transfer.session", 0x0240, "chosen by the panel at Begin; 0 is not allowed"),
    rw16("transfer.operation", 0x0241, "operation of this frame", "TransferOperation", 0, 3, 0),
    rw16("transfer.block", 0x0242, "block number, from 0"),
    rw16("transfer.length", 0x0243, "number of valid registers of data", {}, 0, blockRegisters, 0),
    block("transfer.data", 0x0244, blockRegisters, Access::ReadWrite, "payload"),
    ro16("transfer_result.session", 0x02C0, "session of the current transfer, 0: none"),
    ro16("transfer_result.operation", 0x02C1, "echo of transfer.operation", "TransferOperation"),
    ro16("transfer_result.block", 0x02C2, "echo of transfer.block"),
    ro16("transfer_result.result", 0x02C3, "outcome", "TransferResult"),
    ro16("transfer_result.detail", 0x02C4, "refused row or header register"),
    ro16("transfer_result.next_missing", 0x02C5,
         "lowest missing block; number of blocks if all were received"),
    ro32("transfer_result.staged_crc", 0x02C6, "CRC-32 of the sealed bytes, 0 until sealed"),

    // Proven reading: written and read in one FC23, so that the answer contains the question.
    rw16("readback.tag", 0x0300, "any value that differs from the last one"),
    rw16("readback.address", 0x0301, "first requested register"),
    rw16("readback.count", 0x0302, "number of requested registers", {}, 1, readbackRegisters, 1),
    ro16("readback_result.tag", 0x0310, "echo of readback.tag"),
    ro16("readback_result.address", 0x0311, "echo of readback.address"),
    ro16("readback_result.count", 0x0312, "echo of readback.count, 0: the range cannot be read"),
    block("readback_result.data", 0x0313, readbackRegisters, Access::ReadOnly,
          "the registers at the time of the request"),

    // The last measurement of an axis; see docs/commissioning.md.
    since(7, ro16("measure.state", 0x08E8, "state of the measurement", "MeasureState")),
    since(7, ro16("measure.axis", 0x08E9, "its axis", "MeasuredAxis")),
    since(7, ro16("measure.turns", 0x08EA, "turns counted")),
    since(7, ro16("measure.reason", 0x08EB, "why it ended; None: by a stop", "Refusal")),
    since(7, ro32("measure.pulses", 0x08EC, "mean pulses per turn, 0: none counted", 0.01, "pulses")),
    since(7,
          ro32("measure.spread", 0x08EE, "difference of the longest and the shortest turn", 0.01, "pulses")),
    since(7,
          cutter(ro32("measure.bag_pulses", 0x08F0,
                      "pulses of the film motor between the last two cuts, 0: not known", 0.01, "pulses"))),
    since(7, cutter(ro32("measure.bag", 0x08F2, "packer.bag_number of the bag that ended with them"))),

    // The panel reads these records of the mark sensor while the film runs.
    since(6,
          cutter(ro32("sensor.mark_number", 0x0A00,
                      "edges of the mark sensor since power-up, equal to the number of the newest record"))),
    since(6, cutter(block(
                 "sensor.marks", 0x0A02, 8 * edgeRecords, Access::ReadOnly,
                 "the newest edges, edge n at (n mod 12) x 8: film position (u32, 0.001 mm, lower 32 "
                 "bits), distance from the nearest expected mark (i16, 0.01 mm, saturating), film speed "
                 "(i16, 0.1 mm/s), film acceleration (i16, mm/s^2), MarkVerdict, dead time taken off "
                 "(u16, 0.001 ms), width (u16, 0.01 mm, saturating, 0: unknown)"))),
    // And these of the product eye.
    since(6,
          cutter(ro32("eye.edge_number", 0x0A64,
                      "edges of the product eye since power-up, equal to the number of the newest record"))),
    since(6,
          cutter(block("eye.edges", 0x0A66, 4 * eyeRecords, Access::ReadOnly,
                       "the newest edges, edge n at (n mod 6) x 4: place of the infeed in the product pitch "
                       "(u16, 1/65536), its speed (u16, 0.001 pitches per second, saturating), 1: a product "
                       "begins, 0: it ends, dead time taken off (u16, 0.001 ms)"))),

    // The torque of a packing machine's knife by its angle, and the jams. Angles are of the shaft, from the
    // cut, negative before it.
    since(6, cutter(ro16("jam.state", 0x0A80, "state of the monitoring", "JamState"))),
    since(6, cutter(ro16("jam.cycles_left", 0x0A81, "cycles at full speed until it is armed"))),
    since(6, cutter(ro16("jam.interval", 0x0A82,
                         "shortest time between two reports of the torque, 0: unknown", {}, 0.01, "ms"))),
    since(6, cutter(ro16("jam.number", 0x0A83, "jams since power-up"))),
    since(6, cutter(ro16("jam.source", 0x0A84, "what showed the last jam", "JamSource"))),
    since(6, cutter(roI16("jam.angle", 0x0A85, "angle of the last jam, when it was seen", 0.01, "deg"))),
    since(6, cutter(roI16("jam.torque", 0x0A86, "torque there, in relation to the rated torque", 0.1, "%"))),
    since(6, cutter(roI16("jam.limit", 0x0A87, "end of the band there", 0.1, "%"))),
    since(6, cutter(ro16("jam.run_on", 0x0A88, "angle from there to standstill", {}, 0.01, "deg"))),
    since(6, cutter(ro32("jam.residue_number", 0x0A89, "records of jam.residue since power-up"))),
    since(6, cutter(roI16("jam.residue", 0x0A8B,
                          "mean torque at the cut over the last 1000 bags, minus that of the first 20", 0.01,
                          "%"))),
    since(6, cutter(roI16("jam.band_from", 0x0A8C, "angle at which the band begins", 0.01, "deg"))),
    since(6, cutter(roI16("jam.band_to", 0x0A8D, "angle at which it ends", 0.01, "deg"))),
    since(6, cutter(block("jam.expected", 0x0A8E, jamBins, Access::ReadOnly,
                          "torque in equal parts of the band at full speed, i16, 0.1 %"))),
    since(6, cutter(block("jam.width", 0x0A8E + jamBins, jamBins, Access::ReadOnly,
                          "half of the band's width there, 0.1 %; 0: not learned"))),

    // An encoder that leads the line; see controller/core/master/README.md.
    since(6, rw16("master.source", 0x0B00, "what the cycles follow; moves and the press have no master",
                  "MasterSource", 0, 1, 0)),
    since(6, rw16("master.signal", 0x0B01, "what the input counts", "MasterSignal", 0, 1, 0)),
    since(6, rw16("master.reversed", 0x0B02, "1: the counts fall while the line runs forward", {}, 0, 1, 0)),
    since(6, rw16("master.lead", 0x0B03, "1: the axes are led by the speed times the delay", {}, 0, 1, 1)),
    since(6,
          rw32("master.counts", 0x0B04, "counts per revolution of the encoder, four per line with quadrature",
               4, 1000000, 10000, 1.0, "counts")),
    since(6, rw32("master.revolution", 0x0B06, "film per revolution of the encoder", 1, 10000, 250, 0.001,
                  "mm")),
    since(6, rw16("master.delay", 0x0B08,
                  "from a pulse of the controller to the movement of the axis, that of the drive for one", {},
                  0, 50, 0, 0.001, "ms")),
    since(6, rw16("master.smoothing", 0x0B09,
                  "time constant of the measured position, 0: 20 counts at the program's rate, 2 to 20 ms",
                  {}, 0, 50, 0, 0.001, "ms")),
    since(6,
          rw16("master.engage", 0x0B0A, "minimum stretch of the master in which the line engages, of a cycle",
               {}, 10, 400, 50, 1.0, "%")),
    since(6,
          rw16("master.speed_max", 0x0B0B,
               "maximum speed of the master, of the program's rate; a start is refused above it, a run ends "
               "at the end of its cycle, a quarter above it is a fault",
               {}, 100, 150, 110, 1.0, "%")),
    since(6, rw16("master.backward", 0x0B0C,
                  "1: a cam goes back with an encoder that goes back; 0: it waits, as a cutter always does",
                  {}, 0, 1, 1)),
    since(6, rw16("master.place", 0x0B0D, "where the encoder is", "MasterPlace", 0, 1, 0)),
    since(6, rw16("master.index_limit", 0x0B0E,
                  "counts by which the encoder's index mark may be off its place, 0: it has none", {}, 0,
                  1000, 0, 1.0, "counts")),
    since(6, rw16("master.slip_limit", 0x0B0F,
                  "film by which a mark may be off by a wheel on the film, 0: not watched", {}, 0, 50, 2,
                  0.01, "mm")),
    since(6, rwI16("master.phase", 0x0B10,
                   "shift of the line ahead of the master, of its cycle; superimposed while it runs", -180,
                   180, 0, 0.01, "deg")),
    since(6, ro16("master_status.available", 0x0B20, "1: the controller has an input for an encoder")),
    since(6, ro16("master_status.state", 0x0B21, "the line against the master", "MasterState")),
    since(6, roI32("master_status.counts", 0x0B22, "counts since power-up, lower 32 bits", "counts")),
    since(6, roScaled32("master_status.speed", 0x0B24, "measured speed of the film by the encoder", 0.001,
                        "mm/s")),
    since(6,
          ro16("master_status.angle", 0x0B26, "position of the encoder in its revolution", {}, 0.01, "deg")),
    since(6, roI16("master_status.error", 0x0B27, "last counts minus expected position, saturating", 0.001,
                   "mm")),
    since(6, roI16("master_status.lead", 0x0B28, "film by which the axes are led, saturating", 0.001, "mm")),
    since(6, roI16("master_status.held", 0x0B29,
                   "film by which the master stands behind the line, which waits for it, saturating", 0.001,
                   "mm")),
    since(6, roScaled32("master_status.to_engaged", 0x0B2A, "film until the line has engaged", 0.001, "mm")),
    since(6, ro16("master_status.smoothing", 0x0B2C, "time constant in use, 0: none", {}, 0.001, "ms")),
    since(6, roI16("master_status.phase", 0x0B2D, "present shift of the line by master.phase", 0.01, "deg")),
    since(6, ro16("master_status.ripple", 0x0B2E,
                  "half of the difference between maximum and minimum of the speed in the last second", {},
                  0.01, "%")),
    since(6, ro16("master_status.input_errors", 0x0B2F,
                  "changes of A and B at once since power-up, saturating", {}, 1.0, {})),
    since(6, roI16("master_status.index_error", 0x0B30,
                   "counts by which the last index mark was off its place, saturating", 1.0, "counts")),
    since(6, roI16("master_status.slip", 0x0B31,
                   "film between the last two marks, less that by the wheel, saturating", 0.001, "mm")),
    since(6,
          roI16("master_status.lag", 0x0B32,
                "film that had passed by the encoder when the knife came to its last cut, beyond that cut; "
                "saturating",
                0.001, "mm")),
    since(6, roScaled32("master_status.passed", 0x0B33,
                        "film by a wheel that has passed uncut since power-up", 0.001, "m")),

    // Written before OrderStart, which takes it over.
    since(6, block("order.lot", 0x0B36, orderLotRegisters, Access::ReadWrite,
                   "lot of the next order, UTF-8, the first byte high, filled up with zeros")),
    // The order under way, and what its bags were. good + rejected + empty + on_the_way = cut.
    since(6, cutter(ro16("order_status.state", 0x0B50, "state of the order", "OrderState"))),
    since(6, cutter(ro16("order_status.number", 0x0B51, "its number, 0: none since first power-up"))),
    since(6, cutter(ro16("order_status.action", 0x0B52, "what happens at the quantity", "OrderAction"))),
    since(6, cutter(ro16("order_status.kept", 0x0B53, "1: the order survives a power cut"))),
    since(6, cutter(ro32("order_status.quantity", 0x0B54, "good bags to make"))),
    since(6, cutter(ro32("order_status.good", 0x0B56, "good bags"))),
    since(6, cutter(ro32("order_status.rejected", 0x0B58, "bags that the reject output takes, not empty"))),
    since(6, cutter(ro32("order_status.empty", 0x0B5A, "bags cut without a product, otherwise good"))),
    since(6, cutter(ro32("order_status.cut", 0x0B5C, "bags cut"))),
    since(6, cutter(ro16("order_status.on_the_way", 0x0B5E, "bags cut that may still be rejected"))),
    since(6, cutter(block("order_status.lot", 0x0B5F, orderLotRegisters, Access::ReadOnly,
                          "lot of the order, as order.lot"))),

    // The operator's hand. The speed is 100 % at each power-up; the trims are saved with the program and kept
    // over a power cut where the board can, and become those of the next one with a program of another name.
    since(6, rw16("hand.speed", 0x0B80,
                  "speed of a cutter or a cam that follows the clock, of its program's rate", {}, 20, 100,
                  100, 1.0, "%")),
    since(6,
          rwI16("hand.cut", 0x0B81, "the cut lies so much later on the print, without marks to the product",
                -10, 10, 0, 0.001, "mm")),
    since(6, rwI16("hand.product", 0x0B82, "the product lies so much farther forward in its bag", -20, 20, 0,
                   0.001, "mm")),
    since(6, rwI16("hand.length", 0x0B83, "added to every bag while mark tracking is off", -5, 5, 0, 0.001,
                   "mm")),
    since(6, rwI16("hand.next_cut", 0x0B84, "hand.cut of the next program of another name", -10, 10, 0, 0.001,
                   "mm")),
    since(6, rwI16("hand.next_product", 0x0B85, "hand.product of the next program of another name", -20, 20,
                   0, 0.001, "mm")),
    since(6, rwI16("hand.next_length", 0x0B86, "hand.length of the next program of another name", -5, 5, 0,
                   0.001, "mm")),

    // The machine around the knife; see controller/core/signal/README.md.
    CAMPANEL_SIGNAL_INPUT("start_button", 0x0BA0, 20),
    CAMPANEL_SIGNAL_INPUT("stop_button", 0x0BA2, 20),
    CAMPANEL_SIGNAL_INPUT("door", 0x0BA4, 20),
    CAMPANEL_SIGNAL_INPUT("next_machine", 0x0BA6, 100),
    CAMPANEL_SIGNAL_INPUT("coder", 0x0BA8, 100),
    CAMPANEL_SIGNAL("fault", 0x0BAA, 3, 0, 0),
    CAMPANEL_SIGNAL("warning", 0x0BAE, 0, 1, 0),
    CAMPANEL_SIGNAL("waiting", 0x0BB2, 0, 0, 2),
    CAMPANEL_SIGNAL("running", 0x0BB6, 0, 0, 1),
    CAMPANEL_SIGNAL("ready", 0x0BBA, 0, 0, 0),
    CAMPANEL_SIGNAL("order", 0x0BBE, 0, 2, 0),
    CAMPANEL_SIGNAL_INPUT("bag_button", 0x0BC2, 20),
    since(6, rwI16("signal.coder_place", 0x0BC4,
                   "film from the date coder's pulse to the cut behind its product; negative: after the cut",
                   -500, 3000, 0, 0.1, "mm")),
    since(6,
          rw16("signal.coder_pulse", 0x0BC5, "length of the date coder's pulse", {}, 1, 1000, 20, 1.0, "ms")),
    CAMPANEL_INDEX_INPUT("film_index", 0x0BC6),
    CAMPANEL_INDEX_INPUT("infeed_index", 0x0BC8),
    // Motors that are wired or mounted the other way round; taken over at standstill.
    since(7,
          rw16("signal.knife_reversed", 0x0BCA, "1: forward is the other way of the main axis", {}, 0, 1, 0)),
    since(7,
          rw16("signal.film_reversed", 0x0BCB, "1: forward is the other way of the film motor", {}, 0, 1, 0)),
    since(7, rw16("signal.infeed_reversed", 0x0BCC, "1: forward is the other way of the infeed motor", {}, 0,
                  1, 0)),
    since(6,
          ro16("signal_status.presses", 0x0BD0, "presses of the Start and one-bag buttons since power-up")),
    since(6, ro16("signal_status.refusal", 0x0BD1, "why the last one started nothing", "Refusal")),

    block("active", activeBankBase, bankRegisters, Access::ReadOnly, "the active bank; layout below"),
    block("staged", stagedBankBase, bankRegisters, Access::ReadOnly, "the shadow bank; layout below"),
};

#undef CAMPANEL_CAM_SWITCH
#undef CAMPANEL_INDEX_INPUT
#undef CAMPANEL_KNIFE
#undef CAMPANEL_SIGNAL
#undef CAMPANEL_SIGNAL_INPUT

static_assert(isConsistent(registerTable));

} // namespace

std::span<const RegisterInfo> registers()
{
    return registerTable;
}

bool isMachineData(const RegisterInfo& row)
{
    static constexpr std::array machineDataGroups{"parameter."sv, "master."sv, "signal."sv};
    return row.access == Access::ReadWrite &&
           std::ranges::any_of(machineDataGroups,
                               [&row](std::string_view group) { return row.name.starts_with(group); });
}

bool isWrittenAlone(const RegisterInfo& row)
{
    return isMachineData(row) || (row.access == Access::ReadWrite && row.name.starts_with("hand."));
}

std::string contactName(const InputRow& row)
{
    std::string name;
    for (const char c : row.value.name) {
        const auto letter = static_cast<unsigned char>(c);
        if (std::isupper(letter) != 0 && !name.empty())
            name += '_';
        name += static_cast<char>(std::tolower(letter));
    }
    const std::string ofSignal = "signal." + name;
    return findRegister(ofSignal + "_contact") != nullptr ? ofSignal : "parameter." + name;
}

const RegisterInfo* findRegister(std::string_view name)
{
    // A hash table, because every status block is read by names, about eighty a second.
    static const std::unordered_map<std::string_view, const RegisterInfo*> byName = [] {
        std::unordered_map<std::string_view, const RegisterInfo*> index;
        for (const std::span<const RegisterInfo> rows : {registers(), bankFields()}) {
            for (const RegisterInfo& row : rows)
                index.emplace(row.name, &row);
        }
        return index;
    }();
    const auto found = byName.find(name);
    return found == byName.end() ? nullptr : found->second;
}

} // namespace campanel::modbus
