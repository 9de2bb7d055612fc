/* SPDX-License-Identifier: Apache-2.0 */
#include "calls.h"

#include "link/ctl_work.h"

#include <string.h>

#define SETTLING_SLICES 4000u
#define MAX_READ 125u
#define MAX_WRITE 121u /* in one request that reads as well */
#define MAX_WRITTEN_AND_READ 121u

static bool is_watched; /* a clock that is read costs instructions */

/* The linker puts it in place of the piece of work in a slice. */
void __real_ctl_work_slice(ctl_core* core);
void __wrap_ctl_work_slice(ctl_core* core);
void __wrap_ctl_work_slice(ctl_core* core)
{
    if (!is_watched) {
        __real_ctl_work_slice(core);
        return;
    }
    const uint32_t from = bench_counter();
    __real_ctl_work_slice(core);
    const uint32_t cost = bench_counter() - from;
    if (cost > bench_longest.work)
        bench_longest.work = cost;
}

static void begin(void)
{
    memset(&bench_longest, 0, sizeof bench_longest);
    is_watched = true;
}

static void print(const char* call, const char* what, const char* program, uint32_t cost)
{
    bench_print("call_");
    bench_print(call);
    bench_print(what);
    bench_print(" ");
    bench_print(program);
    bench_print_number(" ", cost, "\n");
}

/* Instructions of a request since begin(): in the line, and in pieces behind it. */
static void end(const char* what, const char* program)
{
    is_watched = false;
    print("request_", what, program, bench_longest.silence);
    if (bench_longest.work != 0)
        print("work_", what, program, bench_longest.work);
}

static void wait(bench* self)
{
    for (uint32_t i = 0; i < SETTLING_SLICES; ++i)
        bench_slice(self, CTL_SLICE_US);
}

typedef struct {
    const char* name;
    uint16_t code;
    bool settles; /* what it sets off is waited for, so that the next one is not refused */
} command_case;

static const command_case commands[] = {
    {"start", CTL_COMMAND_START, true},
    {"teach_marks", CTL_COMMAND_TEACH_MARKS, false},
    {"set_clock", CTL_COMMAND_SET_CLOCK, false},
    {"cancel_apply", CTL_COMMAND_CANCEL_APPLY, false},
    {"stop_at_cycle_end", CTL_COMMAND_STOP_AT_CYCLE_END, true},
    {"home", CTL_COMMAND_HOME, true},
    {"stop_now", CTL_COMMAND_STOP_NOW, true},
    {"reset_fault", CTL_COMMAND_RESET_FAULT, false},
    {"discard_staged", CTL_COMMAND_DISCARD_STAGED, false},
    {"unknown", CTL_COMMAND_TEACH_MARKS + 1000u, false},
};

static void give_commands(bench* self, const char* program)
{
    for (uint32_t i = 0; i < sizeof commands / sizeof commands[0]; ++i) {
        begin();
        (void)bench_command(self, commands[i].code, 0, 0, 1);
        end(commands[i].name, program);
        if (commands[i].settles)
            wait(self);
    }
    begin();
    (void)bench_command(self, CTL_COMMAND_SAVE_TO_FLASH, 0, 0, self->core.banks.active_crc);
    end("save", program);
}

static void read(bench* self, uint16_t address, uint16_t count, const char* what, const char* program)
{
    uint8_t frame[CTL_FRAME_BYTES] = {
        1, 3, (uint8_t)(address >> 8), (uint8_t)address, (uint8_t)(count >> 8), (uint8_t)count};
    begin();
    if (bench_exchange(self, frame, 6) != 5u + 2u * count)
        bench_print("refused 1\n");
    end(what, program);
}

static void write_read(bench* self, uint16_t address, const uint16_t* values, uint16_t count,
                       uint16_t read_address, uint16_t read_count, const char* what, const char* program)
{
    uint16_t values_read[MAX_READ];
    begin();
    if (bench_write_read(self, address, values, count, read_address, values_read, read_count) != 0)
        bench_print("refused 2\n");
    end(what, program);
}

static void read_and_write(bench* self, const char* program)
{
    const uint16_t exchange[CTL_GROUP_EXCHANGE] = {1, 1, 0};
    const uint16_t back[CTL_GROUP_READBACK] = {1, CTL_REG_ACTIVE, CTL_READBACK_REGISTERS};
    uint16_t parameters[CTL_GROUP_PARAMETER];
    memcpy(parameters, self->core.written.parameter, sizeof parameters);
    read(self, CTL_REG_IDENTITY_DEVICE_TYPE, CTL_GROUP_IDENTITY, "identity", program);
    read(self, CTL_REG_PACKER_MARK_STATE, CTL_GROUP_PACKER, "packer", program);
    read(self, CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT, CTL_GROUP_PARAMETER, "parameters", program);
    read(self, CTL_REG_ACTIVE, MAX_READ, "read_bank", program);
    read(self, CTL_REG_STAGED, MAX_READ, "read_staged", program);
    write_read(self, CTL_REG_EXCHANGE_TAG, exchange, CTL_GROUP_EXCHANGE, CTL_REG_STATUS_TAG, CTL_GROUP_STATUS,
               "status", program);
    write_read(self, CTL_REG_READBACK_TAG, back, CTL_GROUP_READBACK, CTL_REG_READBACK_RESULT_TAG,
               CTL_GROUP_READBACK_RESULT, "readback", program);
    write_read(self, CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT, parameters, MAX_WRITE,
               CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT, MAX_WRITE, "write_parameters", program);
    print("", "receive", program, bench_longest.receive);
    print("", "take_answer", program, bench_longest.take);
}

void calls_of_program(bench* self, const bench_case* program)
{
    uint32_t crc = 0;
    bench_power_up(self, program);
    bench_switch_on(&self->core);
    begin();
    if (bench_download(self, program, &crc) != CTL_TRANSFER_RESULT_ACCEPTED)
        bench_print("refused 3\n");
    end("download", program->name);
    begin();
    if (bench_apply(self, CTL_APPLY_MODE_WHEN_STOPPED, crc) != CTL_REFUSAL_NONE)
        bench_print("refused 4\n");
    end("apply", program->name);
    read_and_write(self, program->name);
    give_commands(self, program->name);
}
