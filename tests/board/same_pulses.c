/* SPDX-License-Identifier: Apache-2.0 */
/* The same run on any processor: a CRC-32 over every pulse and what the registers show, for every kind. The
 * argument is the number of slices of each. */
#include "base/ctl_crc.h"
#include "bench.h"
#include "link/ctl_map.h"

#define SHOWN_EVERY 400u

static bench the_bench;
static uint32_t crc;
static uint32_t pulses; /* of all axes */
static ctl_port inner;

static void add(uint32_t value)
{
    const uint8_t bytes[4] = {(uint8_t)(value >> 24), (uint8_t)(value >> 16), (uint8_t)(value >> 8),
                              (uint8_t)value};
    crc = ctl_crc32_bytes(crc, bytes, sizeof bytes);
}

/* Every pulse with its tick. */
static void main_pulses(void* context, const ctl_train* train)
{
    ctl_train left = *train;
    add((uint32_t)train->direction);
    while (left.count != 0)
        add(ctl_train_next(&left));
    pulses += train->count;
    inner.pulses(context, train);
}

/* As a board with pulse timers takes them. */
static void feed(void* context, ctl_axis axis, int64_t from, int64_t to)
{
    ctl_train left = ctl_train_line(from, to, the_bench.core.board.slice_ticks);
    add((uint32_t)axis << 28 ^ (uint32_t)left.direction);
    pulses += left.count;
    while (left.count != 0)
        add(ctl_train_next(&left));
    inner.feed(context, axis, from, to);
}

static void outputs(void* context, uint32_t levels)
{
    add(levels | 0x30000000u);
    inner.outputs(context, levels);
}

static void add_registers(uint32_t address, uint32_t count)
{
    uint16_t values[CTL_GROUP_PACKER > CTL_GROUP_STATUS ? CTL_GROUP_PACKER : CTL_GROUP_STATUS];
    if (ctl_map_read(&the_bench.core, address, values, count) == 0)
        crc = ctl_crc32_registers(crc, values, count);
}

/* Numbers without a library: the same ones everywhere. */
static uint32_t random_below(uint64_t* seed, uint32_t bound)
{
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    *seed ^= *seed << 17;
    return (uint32_t)(*seed >> 33) % bound;
}

static void run(const bench_case* program, uint32_t slices)
{
    ctl_core* core = &the_bench.core;
    uint64_t seed = 88172645463325252u;
    crc = CTL_CRC32_START;
    pulses = 0;
    bench_power_up(&the_bench, program);
    bench_switch_on(&the_bench.core);
    inner = core->board.port;
    core->board.port.pulses = main_pulses;
    core->board.port.feed = feed;
    core->board.port.outputs = outputs;
    bench_print(program->name);
    bench_print_number(": installed ", bench_install(&the_bench, program), "");
    uint32_t refused = 0;
    for (uint32_t i = 0; i < slices; ++i) {
        if (core->motion.state == CTL_STATE_READY)
            refused += bench_command(&the_bench, CTL_COMMAND_START, 0, 0, 0) != CTL_REFUSAL_NONE;
        else if (random_below(&seed, 5000) == 0)
            (void)bench_command(&the_bench, CTL_COMMAND_STOP_AT_CYCLE_END, 0, 0, 0);
        else if (random_below(&seed, 10000) == 0)
            (void)bench_command(&the_bench, CTL_COMMAND_STOP_NOW, 0, 0, 0);
        bench_slice(&the_bench, random_below(&seed, 4) == 0 ? 50u + random_below(&seed, 400) : CTL_SLICE_US);
        if (i % SHOWN_EVERY == 0) {
            add_registers(CTL_REG_STATUS_TAG, CTL_GROUP_STATUS);
            add_registers(CTL_REG_PACKER_MARK_STATE, CTL_GROUP_PACKER);
            add_registers(CTL_REG_IO_INPUTS, CTL_GROUP_IO);
        }
    }
    bench_print_number(", refused ", refused, "");
    bench_print_number(", state ", core->motion.state, "");
    bench_print_number(", faults ", core->motion.fault, "");
    bench_print_number(", cycles ", core->motion.cycle_count, "");
    bench_print_number(", bags ", core->packer.bags, "");
    bench_print_number(", pulses ", pulses, "");
    bench_print_hex(", CRC-32 ", ~crc, "\n");
}

int bench_run(uint32_t slices)
{
    for (uint16_t kind = 1; kind <= CTL_PROGRAM_KIND_LAST; ++kind) {
        uint32_t found = 0;
        for (uint32_t i = 0; i < bench_case_count; ++i)
            found += bench_cases[i].kind == kind;
        if (found == 0)
            bench_print_number("kind ", kind, " has no case\n");
    }
    for (uint32_t i = 0; i < bench_case_count; ++i)
        run(&bench_cases[i], slices);
    return 0;
}
