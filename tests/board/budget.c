/* SPDX-License-Identifier: Apache-2.0 */
/* Instructions of every call of the core, for every kind of program, with everything on: one line per figure,
 * its name and its number. */
#include "calls.h"
#include "link/ctl_map.h"

#include <string.h>

#define RUNNING_SLICES 20000u
#define HEARTBEAT_SLICES 400u
#define SETTLING_SLICES 4000u
#define CHANGE_SLICES 60000u
#define LATER_SLICES 107u

#ifndef CHANGES /* one, where an emulator takes long */
#define CHANGES 12u
#endif
#ifndef MEASURED_CASES /* the cutters only, where an emulator takes long for the others */
#define MEASURED_CASES bench_case_count
#endif

extern uint32_t stack_bottom[];
extern uint32_t stack_top[];
#define PAINT 0xA5A5A5A5u

static bench the_bench;

static void figure(const char* name, const char* what, uint32_t value)
{
    bench_print(name);
    bench_print_number(what, value, "\n");
}

/* The panel's periodic exchange: tag, heartbeat and jog keys out, the status block back. */
static void exchange_status(bench* self, uint32_t number)
{
    const uint16_t written[CTL_GROUP_EXCHANGE] = {(uint16_t)number, (uint16_t)number, 0};
    uint16_t status[CTL_GROUP_STATUS];
    (void)bench_write_read(self, CTL_REG_EXCHANGE_TAG, written, CTL_GROUP_EXCHANGE, CTL_REG_STATUS_TAG,
                           status, CTL_GROUP_STATUS);
}

static void read_group(bench* self, uint16_t address, uint16_t count, const char* name)
{
    uint8_t frame[CTL_FRAME_BYTES] = {
        1, 3, (uint8_t)(address >> 8), (uint8_t)address, (uint8_t)(count >> 8), (uint8_t)count};
    (void)bench_exchange(self, frame, 6);
    figure("request_", name, self->request_cost);
}

/* Runs with the line at full load: a request as often as 115200 baud allows. */
static void run(const char* name, uint32_t slices)
{
    bench* self = &the_bench;
    uint64_t sum = 0;
    uint32_t counted = 0;
    uint32_t worst = 0;
    self->max_request_cost = 0;
    for (uint32_t i = 0; i < slices; ++i) {
        if (self->core.motion.state == CTL_STATE_READY)
            (void)bench_command(self, CTL_COMMAND_START, 0, 0, 0);
        if (i % HEARTBEAT_SLICES == 0)
            exchange_status(self, i);
        bench_slice(self, CTL_SLICE_US);
        if (self->core.motion.state != CTL_STATE_RUNNING)
            continue;
        sum += self->slice_cost;
        counted += 1;
        if (self->slice_cost > worst)
            worst = self->slice_cost;
    }
    bench_print("slice_");
    figure(name, "_mean ", counted == 0 ? UINT32_MAX : (uint32_t)(sum / counted));
    bench_print("slice_");
    figure(name, "_worst ", worst);
    bench_print("request_running_");
    figure(name, "_worst ", self->max_request_cost);
}

/* Everything long that a panel may ask for while the machine runs, and the slices meanwhile. */
static void work_beside(const bench_case* program)
{
    bench* self = &the_bench;
    uint32_t crc = 0;
    self->max_request_cost = 0;
    self->max_slice_cost = 0;
    const uint16_t sealed = bench_download(self, program, &crc);
    bench_print("download_");
    figure(program->name, "_request_worst ", self->max_request_cost);
    bench_print("download_");
    figure(program->name, "_slice_worst ", self->max_slice_cost);
    self->max_request_cost = 0;
    self->max_slice_cost = 0;
    const uint16_t saved = bench_command(self, CTL_COMMAND_SAVE_TO_FLASH, 0, 0, self->core.banks.active_crc);
    bench_print("save_");
    figure(program->name, "_request_worst ", self->max_request_cost);
    bench_print("save_");
    figure(program->name, "_slice_worst ", self->max_slice_cost);
    if (sealed != CTL_TRANSFER_RESULT_ACCEPTED || saved != CTL_REFUSAL_NONE)
        bench_print_number("refused ", 100u * sealed + saved, "\n");
}

static void start_and_change(const bench_case* program)
{
    bench* self = &the_bench;
    self->max_request_cost = 0;
    self->max_slice_cost = 0;
    const uint16_t started = bench_command(self, CTL_COMMAND_START, 0, 0, 0);
    bench_print("start_");
    figure(program->name, "_request_worst ", self->max_request_cost);
    bench_print("start_");
    figure(program->name, "_slice_worst ", self->max_slice_cost);
    if (started != CTL_REFUSAL_NONE)
        bench_print_number("refused ", started, "\n");
}

/* Returns false when the run did not go on with it. Behind an encoder it may leave that, and be started
 * again. */
static bool change_to(const bench_case* program, uint32_t later)
{
    bench* self = &the_bench;
    uint32_t crc = 0;
    const uint16_t sealed = bench_download(self, program, &crc);
    for (uint32_t i = 0; i < later; ++i)
        bench_slice(self, CTL_SLICE_US);
    self->max_slice_cost = 0;
    self->max_request_cost = 0;
    const uint16_t armed = bench_apply(self, CTL_APPLY_MODE_NEXT_CYCLE, crc);
    for (uint32_t i = 0; i < CHANGE_SLICES && self->core.banks.active_crc != crc; ++i) {
        if (self->core.motion.state == CTL_STATE_READY)
            (void)bench_command(self, CTL_COMMAND_START, 0, 0, 0);
        bench_slice(self, CTL_SLICE_US);
    }
    for (uint32_t i = 0; i < SETTLING_SLICES; ++i)
        bench_slice(self, CTL_SLICE_US);
    return sealed == CTL_TRANSFER_RESULT_ACCEPTED && armed == CTL_REFUSAL_NONE &&
           self->core.banks.active_crc == crc;
}

/* Other bags and these again, each time at another moment of the cycle. */
static void change(const bench_case* program)
{
    bench* self = &the_bench;
    uint32_t request = 0;
    uint32_t slice = 0;
    for (uint32_t i = 0; i < CHANGES; ++i) {
        if (!change_to(i % 2u == 0 ? &bench_other_cutter : program, LATER_SLICES * i))
            bench_print_number("refused ", i, "\n");
        request = self->max_request_cost > request ? self->max_request_cost : request;
        slice = self->max_slice_cost > slice ? self->max_slice_cost : slice;
    }
    bench_print("change_");
    figure(program->name, "_request_worst ", request);
    bench_print("change_");
    figure(program->name, "_slice_worst ", slice);
}

static void measure_stack(void)
{
    const uint32_t* at = stack_bottom;
    while (at < stack_top && *at == PAINT)
        ++at;
    figure("stack_bytes", " ", (uint32_t)(stack_top - at) * (uint32_t)sizeof *at);
}

/* The first case is the cutter; without cam switches it is the machine that the papers' controller drives. */
static void measure_line(uint32_t slices)
{
    bench_power_up(&the_bench, &bench_cases[0]);
    if (bench_install(&the_bench, &bench_cases[0]) == 0)
        run("cutter_without_switches", slices);
}

static void measure(const bench_case* program, uint32_t slices)
{
    bench* self = &the_bench;
    bench_power_up(self, program);
    bench_switch_on(&self->core);
    const uint16_t refused = bench_install(self, program);
    if (refused != 0) {
        bench_print_number("refused ", refused, "\n");
        return;
    }
    calls_of_program(self, program);
    bench_power_up(self, program);
    bench_switch_on(&self->core);
    (void)bench_install(self, program);
    start_and_change(program);
    run(program->name, slices);
    work_beside(program);
    if (program->build == bench_cases[0].build)
        change(program);
}

int bench_run(uint32_t number)
{
    bench* self = &the_bench;
    const uint32_t slices = number == 0 ? RUNNING_SLICES : number;
    measure_line(slices);
    for (uint32_t i = 0; i < MEASURED_CASES; ++i)
        measure(&bench_cases[i], slices);
    read_group(self, CTL_REG_IDENTITY_DEVICE_TYPE, CTL_GROUP_IDENTITY, "identity ");
    read_group(self, CTL_REG_STATUS_TAG, CTL_GROUP_STATUS, "status ");
    read_group(self, CTL_REG_PACKER_MARK_STATE, CTL_GROUP_PACKER, "packer ");
    read_group(self, CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT, CTL_GROUP_PARAMETER, "parameters ");
    read_group(self, CTL_REG_IO_INPUTS, CTL_GROUP_IO, "io ");
    measure_stack();
    return 0;
}
