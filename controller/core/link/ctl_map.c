/* SPDX-License-Identifier: Apache-2.0 */
#include "link/ctl_map.h"

#include "base/ctl_limits.h"
#include "base/ctl_words.h"
#include "link/ctl_command.h"
#include "link/ctl_parts.h"
#include "link/ctl_status.h"

#include <string.h>

#define GROUP_NAME(name, base, count) GROUP_##name,
typedef enum { CTL_GROUPS(GROUP_NAME) GROUPS } group_name;

typedef struct {
    uint16_t base;
    uint16_t count;
} group_range;

#define GROUP_RANGE(name, base, count) {base, count},
static const group_range ranges[GROUPS] = {CTL_GROUPS(GROUP_RANGE)};

static group_name group_of(uint32_t address)
{
    uint32_t group = 0;
    while (group < GROUPS &&
           (address < ranges[group].base || address - ranges[group].base >= ranges[group].count))
        ++group;
    return (group_name)group;
}

/* Where the panel writes the group, NULL when it is read-only. */
static uint16_t* writable(ctl_core* core, group_name group)
{
    switch (group) {
    case GROUP_PARAMETER:
        return core->written.parameter;
    case GROUP_MASTER:
        return core->written.master;
    case GROUP_EXCHANGE:
        return core->written.exchange;
    case GROUP_COMMAND:
        return core->written.command;
    case GROUP_ORDER:
        return core->written.order;
    case GROUP_HAND:
        return core->written.hand;
    case GROUP_SIGNAL:
        return core->written.signal;
    case GROUP_TRANSFER:
        return core->written.transfer;
    case GROUP_READBACK:
        return core->written.readback;
    default:
        return NULL;
    }
}

static void zero(uint16_t* values, uint32_t count)
{
    memset(values, 0, count * sizeof values[0]);
}

/* The groups that are put together when they are read. */
typedef union {
    uint16_t identity[CTL_GROUP_IDENTITY];
    uint16_t clock[CTL_GROUP_CLOCK];
    uint16_t status[CTL_GROUP_STATUS];
    uint16_t packer[CTL_GROUP_PACKER];
    uint16_t io[CTL_GROUP_IO];
    uint16_t sensor[CTL_GROUP_SENSOR];
    uint16_t jam[CTL_GROUP_JAM];
    uint16_t eye[CTL_GROUP_EYE];
    uint16_t master_status[CTL_GROUP_MASTER_STATUS];
    uint16_t measure[CTL_GROUP_MEASURE];
    uint16_t order_status[CTL_GROUP_ORDER_STATUS];
    uint16_t transfer_result[CTL_GROUP_TRANSFER_RESULT];
} assembled_group;

_Static_assert(sizeof(assembled_group) == CTL_GROUP_PACKER * sizeof(uint16_t),
               "the packer's group is the largest");
_Static_assert(CTL_GROUP_READBACK_RESULT == 3u + CTL_READBACK_REGISTERS,
               "the values read back end the group");
_Static_assert(CTL_MAX_READBACK_COUNT == CTL_READBACK_REGISTERS, "all that may be asked for fits the answer");
_Static_assert(CTL_GROUP_ACTIVE == CTL_BANK_REGISTERS && CTL_GROUP_STAGED == CTL_BANK_REGISTERS,
               "a bank is read whole");
_Static_assert(CTL_GROUP_CLOCK == 2u, "the clock is one wide value");

/* Registers of a bank; behind its last row, where an older program may have left some, they read 0. */
static void read_bank(const ctl_bank* bank, uint32_t first, uint16_t* values, uint32_t count)
{
    const uint32_t length = ctl_bank_length(bank);
    const uint32_t end = length < CTL_BANK_STORAGE ? length : CTL_BANK_STORAGE;
    for (uint32_t i = 0; i < count; ++i)
        values[i] = first + i < end ? bank->registers[first + i] : (uint16_t)0;
}

/* Registers first..first+count of a group. */
static void read_group(ctl_core* core, group_name group, uint32_t first, uint16_t* values, uint32_t count)
{
    assembled_group assembled;
    uint16_t* const taken = assembled.packer;
    const uint16_t* source = taken;
    switch (group) {
    case GROUP_IDENTITY:
        ctl_identity(core, taken);
        break;
    case GROUP_CLOCK:
        ctl_put32(taken, ctl_unix_time(core));
        break;
    case GROUP_STATUS:
        ctl_status(core, taken);
        break;
    case GROUP_PACKER:
        ctl_packer_registers(&core->packer, taken);
        break;
    case GROUP_IO:
        ctl_io_registers(&core->io, &core->motion, taken);
        break;
    case GROUP_SENSOR:
        ctl_edges_registers(&core->packer.edges, taken);
        break;
    case GROUP_JAM:
        ctl_jam_registers(&core->packer.jam, ctl_packer_revolution(&core->packer), taken);
        break;
    case GROUP_EYE:
        ctl_eye_edges_registers(&core->packer.eye_edges, taken);
        break;
    case GROUP_MASTER_STATUS:
        ctl_master_registers(&core->master, taken);
        taken[CTL_REG_MASTER_STATUS_SLIP - CTL_REG_MASTER_STATUS_AVAILABLE] =
            ctl_saturated16(ctl_packer_um(&core->packer, core->packer.wheel.slip));
        break;
    case GROUP_MEASURE:
        ctl_measure_registers(&core->motion, taken);
        break;
    case GROUP_ORDER_STATUS:
        ctl_order_registers(&core->order, taken);
        break;
    case GROUP_SIGNAL_STATUS:
        taken[0] = core->actions.presses;
        taken[1] = core->actions.refusal;
        break;
    case GROUP_RESULT:
        source = core->command_result;
        break;
    case GROUP_TRANSFER_RESULT:
        ctl_transfer_result(&core->transfer, taken);
        break;
    case GROUP_READBACK_RESULT:
        source = core->written.readback_result;
        break;
    case GROUP_ACTIVE:
        if (!core->banks.has_active) {
            zero(values, count);
            return;
        }
        read_bank(ctl_active_bank(&core->banks), first, values, count);
        return;
    case GROUP_STAGED:
        ctl_transfer_read(&core->transfer, ctl_staged_bank(&core->banks), first, values, count);
        return;
    default:
        source = writable(core, group);
        break;
    }
    memcpy(values, &source[first], count * sizeof values[0]);
}

typedef struct {
    uint16_t address;
    uint16_t count;
    uint16_t minor;
} newer_registers;

#define NEWER_REGISTERS(address, count, minor) {address, count, minor},
static const newer_registers newer[] = {CTL_NEWER(NEWER_REGISTERS)};

/* The range has a register that came later than the minor version that this controller shows. */
static bool has_newer(const ctl_core* core, uint32_t address, uint32_t count)
{
    const uint16_t minor = core->board.config.map_minor;
    for (uint32_t i = 0; minor != 0 && i < sizeof newer / sizeof newer[0]; ++i) {
        if (newer[i].minor > minor && newer[i].address < address + count &&
            address < (uint32_t)newer[i].address + newer[i].count)
            return true;
    }
    return false;
}

uint8_t ctl_map_readable(const ctl_core* core, uint32_t address, uint32_t count)
{
    if (has_newer(core, address, count))
        return CTL_ILLEGAL_ADDRESS;
    for (uint32_t at = address; at < address + count;) {
        const group_name group = group_of(at);
        if (group == GROUPS)
            return CTL_ILLEGAL_ADDRESS;
        at = (uint32_t)ranges[group].base + ranges[group].count;
    }
    return 0;
}

uint8_t ctl_map_read(ctl_core* core, uint32_t address, uint16_t* values, uint32_t count)
{
    const uint8_t refused = ctl_map_readable(core, address, count);
    if (refused != 0)
        return refused;
    while (count != 0) {
        const group_name group = group_of(address);
        const uint32_t first = address - ranges[group].base;
        const uint32_t left = ranges[group].count - first;
        const uint32_t part = count < left ? count : left;
        read_group(core, group, first, values, part);
        values += part;
        address += part;
        count -= part;
    }
    return 0;
}

/* Reads the registers asked for into the answer; nothing when the range cannot be read. */
static void read_back(ctl_core* core)
{
    uint16_t* result = core->written.readback_result;
    const uint16_t* question = core->written.readback;
    uint16_t values[CTL_READBACK_REGISTERS];
    zero(values, CTL_READBACK_REGISTERS);
    const bool readable = ctl_map_read(core, question[1], values, question[2]) == 0;
    result[0] = question[0];
    result[1] = question[1];
    result[2] = readable ? question[2] : 0;
    memcpy(&result[3], values, sizeof values);
}

enum { PERMIT = CTL_REG_EXCHANGE_PERMIT - CTL_REG_EXCHANGE_TAG };

static bool covers(uint32_t address, uint32_t count, uint32_t wanted)
{
    return wanted >= address && wanted - address < count;
}

/* One register of each group sets off what the group is for; a frame that writes the group whole writes it
 * too. */
static void act(ctl_core* core, uint32_t address, uint32_t count)
{
    if (covers(address, count, CTL_REG_EXCHANGE_HEARTBEAT))
        ctl_heartbeat_receive(&core->heartbeat, &core->board, core->written.exchange[1]);
    core->heartbeat.permit = core->written.exchange[PERMIT];
    if (covers(address, count, CTL_REG_COMMAND_COUNTER))
        ctl_command(core, covers(address, count, CTL_REG_COMMAND_CODE));
    if (covers(address, count, CTL_REG_TRANSFER_OPERATION))
        ctl_transfer_operation(&core->transfer, &core->banks, &core->board.config, core->written.transfer);
    if (covers(address, count, CTL_REG_READBACK_TAG))
        read_back(core);
}

/* The groups that the panel writes. */
typedef union {
    uint16_t parameter[CTL_GROUP_PARAMETER];
    uint16_t master[CTL_GROUP_MASTER];
    uint16_t exchange[CTL_GROUP_EXCHANGE];
    uint16_t order[CTL_GROUP_ORDER];
    uint16_t hand[CTL_GROUP_HAND];
    uint16_t signal[CTL_GROUP_SIGNAL];
    uint16_t command[CTL_GROUP_COMMAND];
    uint16_t transfer[CTL_GROUP_TRANSFER];
    uint16_t readback[CTL_GROUP_READBACK];
} writable_group;

uint8_t ctl_map_write(ctl_core* core, uint32_t address, const uint16_t* values, uint32_t count)
{
    const group_name group = group_of(address);
    if (group == GROUPS || count > ranges[group].count - (address - ranges[group].base))
        return CTL_ILLEGAL_ADDRESS;
    uint16_t* target = writable(core, group);
    if (target == NULL || has_newer(core, address, count))
        return CTL_ILLEGAL_ADDRESS;
    uint16_t changed[sizeof(writable_group) / sizeof(uint16_t)];
    memcpy(changed, target, ranges[group].count * sizeof changed[0]);
    memcpy(&changed[address - ranges[group].base], values, count * sizeof changed[0]);
    if (!ctl_within_limits(changed, ranges[group].base, ranges[group].count))
        return CTL_ILLEGAL_VALUE;
    memcpy(target, changed, ranges[group].count * sizeof changed[0]);
    if (group == GROUP_PARAMETER || group == GROUP_MASTER || group == GROUP_HAND || group == GROUP_SIGNAL)
        core->board.parameter_writes += 1;
    if (group == GROUP_HAND)
        ctl_kept_trims_follow(&core->kept_trims, &core->board, &core->banks, ctl_trims(&core->board));
    if (group == GROUP_EXCHANGE && !(covers(address, count, CTL_REG_EXCHANGE_HEARTBEAT) &&
                                     covers(address, count, CTL_REG_EXCHANGE_PERMIT)))
        core->written.exchange[PERMIT] = 0;
    act(core, address, count);
    return 0;
}

void ctl_map_init(ctl_core* core)
{
    ctl_parameters_reset(core->written.parameter);
    ctl_reset_to_defaults(core->written.master, CTL_REG_MASTER_SOURCE, CTL_GROUP_MASTER);
    ctl_reset_to_defaults(core->written.signal, CTL_REG_SIGNAL_START_BUTTON_CONTACT, CTL_GROUP_SIGNAL);
    ctl_reset_to_defaults(core->written.hand, CTL_REG_HAND_SPEED, CTL_GROUP_HAND);
    core->written.readback[2] = CTL_DEFAULT_READBACK_COUNT;
}
