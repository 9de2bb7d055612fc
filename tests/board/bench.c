/* SPDX-License-Identifier: Apache-2.0 */
#include "bench.h"

#include "base/ctl_crc.h"
#include "base/ctl_words.h"
#include "link/ctl_map.h"

#include <string.h>

#define BENCH_DEAD_US 10000u /* of a sensor with a slow filter */
#define BENCH_TORQUE 100     /* 0.1 % */
#define FLASH_BYTES 16384u
#define ERASED_AT_A_TIME 128u
/* A seal or a save in pieces is over by then. */
#define PATIENCE_SLICES 200000u
#define RECEIVER_BYTES 16u /* of the UART */

bench_calls bench_longest;

/* The flash of the bench: one controller at a time, and too large for its stack. */
static uint8_t flash[CTL_FLASH_SLOTS][FLASH_BYTES];
static uint32_t erased_slot;
static uint32_t erased = FLASH_BYTES;

static bool flash_read(void* context, uint32_t slot, uint32_t offset, uint8_t* bytes, uint32_t size)
{
    (void)context;
    memcpy(bytes, &flash[slot][offset], size);
    return true;
}

static bool flash_erase(void* context, uint32_t slot)
{
    (void)context;
    erased_slot = slot;
    erased = 0;
    return true;
}

/* It erases by itself, a little whenever it is asked. */
static ctl_flash_progress flash_progress(void* context)
{
    (void)context;
    if (erased == FLASH_BYTES)
        return CTL_FLASH_DONE;
    memset(&flash[erased_slot][erased], 0xFF, ERASED_AT_A_TIME);
    erased += ERASED_AT_A_TIME;
    return CTL_FLASH_BUSY;
}

static bool flash_write(void* context, uint32_t slot, uint32_t offset, const uint8_t* bytes, uint32_t size)
{
    (void)context;
    memcpy(&flash[slot][offset], bytes, size);
    return true;
}

/* A drive whose last digit flickers. */
static int32_t torque(void* context)
{
    static int32_t reported;
    (void)context;
    reported ^= 1;
    return BENCH_TORQUE + reported;
}

void bench_connect_flash(ctl_port* port)
{
    memset(flash, 0xFF, sizeof flash);
    erased = FLASH_BYTES;
    port->flash_read = flash_read;
    port->flash_erase = flash_erase;
    port->flash_write = flash_write;
    port->flash_progress = flash_progress;
}

static void print_digits(const char* before, uint32_t number, uint32_t base, uint32_t least,
                         const char* behind)
{
    char text[12];
    uint32_t at = sizeof text - 1u;
    text[at] = 0;
    do {
        text[--at] = "0123456789ABCDEF"[number % base];
        number /= base;
    } while (number != 0 || at > sizeof text - 1u - least);
    bench_print(before);
    bench_print(&text[at]);
    bench_print(behind);
}

void bench_print_number(const char* before, uint32_t number, const char* behind)
{
    print_digits(before, number, 10u, 1u, behind);
}

void bench_print_hex(const char* before, uint32_t number, const char* behind)
{
    print_digits(before, number, 16u, 8u, behind);
}

static void set_parameter(ctl_core* core, uint32_t address, uint16_t value)
{
    if (ctl_map_write(core, address, &value, 1) != 0)
        bench_print("a parameter was refused\n");
}

void bench_turn_on(ctl_core* core)
{
    const uint16_t home_hz[2] = {0, CTL_MAX_PARAMETER_HOME_FREQUENCY};
    (void)ctl_map_write(core, CTL_REG_PARAMETER_HOME_FREQUENCY, home_hz, 2);
    set_parameter(core, CTL_REG_PARAMETER_EMPTY_BAG, 1);
    set_parameter(core, CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT, CTL_MAX_PARAMETER_HEARTBEAT_TIMEOUT);
    set_parameter(core, CTL_REG_PARAMETER_SKIP_LIMIT, CTL_MAX_PARAMETER_SKIP_LIMIT);
    set_parameter(core, CTL_REG_PARAMETER_MARK_DEAD_TIME, BENCH_DEAD_US);
    set_parameter(core, CTL_REG_PARAMETER_EYE_DEAD_TIME, BENCH_DEAD_US);
    set_parameter(core, CTL_REG_PARAMETER_EYE_END_DEAD_TIME, BENCH_DEAD_US);
    set_parameter(core, CTL_REG_PARAMETER_JAM_DETECTION, 1);
}

void bench_switch_on(ctl_core* core)
{
    const uint32_t each = CTL_REG_PARAMETER_SWITCH2_MODE - CTL_REG_PARAMETER_SWITCH1_MODE;
    for (uint32_t i = 0; i < 8u; ++i) {
        const uint32_t base = CTL_REG_PARAMETER_SWITCH1_MODE + each * i;
        set_parameter(core, base, i == 7u ? CTL_SWITCH_MODE_REJECTED_BAGS : CTL_SWITCH_MODE_CYCLES);
        set_parameter(core, base + 1u, (uint16_t)(4000u * i));
        set_parameter(core, base + 2u, (uint16_t)(4000u * i + 3000u));
        set_parameter(core, base + 3u, (uint16_t)(2u * i));
        set_parameter(core, base + 4u, (uint16_t)(1u + i / 4u));
    }
}

ctl_config bench_config(void)
{
    return (ctl_config){
        .unit = 1,
        .frame_gap_us = 1,
        .unique_id = 1,
        .timer_clock_hz = 8000000,
        .timer_bits = 16,
        .max_pulse_hz = 200000,
        .max_rows_per_slice = 16,
        .work_registers = 24,
    };
}

/* The encoder leads what can follow it from now on. */
static void follow_shaft(ctl_core* core, bool is_wheel)
{
    set_parameter(core, CTL_REG_MASTER_SOURCE, CTL_MASTER_SOURCE_ENCODER);
    set_parameter(core, CTL_REG_MASTER_PLACE, is_wheel ? CTL_MASTER_PLACE_WHEEL : CTL_MASTER_PLACE_SHAFT);
    set_parameter(core, CTL_REG_MASTER_INDEX_LIMIT, 1);
}

void bench_power_up(bench* self, const bench_case* program)
{
    const ctl_config config = bench_config();
    const whole_disturbance disturbance = {.stretch_ppm = 800, .missing_every = 7, .misplaced_every = 11};
    ctl_port port;
    memset(&port, 0, sizeof port);
    self->now_us = 0;
    self->counter = 0;
    whole_machine_init(&self->machine, disturbance);
    whole_machine_connect(&self->machine, &port);
    if (program->counts_per_s != 0) {
        whole_shaft_init(&self->machine.line.shaft, program->counts_per_s, program->is_wheel);
        whole_line_connect_shaft(&port);
    }
    bench_connect_flash(&port);
    port.torque = torque;
    ctl_init(&self->core, &config, &port, 0);
    bench_turn_on(&self->core);
    if (program->counts_per_s != 0)
        follow_shaft(&self->core, program->is_wheel);
}

static uint32_t larger(uint32_t one, uint32_t other)
{
    return one > other ? one : other;
}

void bench_slice(bench* self, uint32_t slice_us)
{
    self->now_us += slice_us;
    whole_line_turn_shaft(&self->machine.line, slice_us);
    const uint32_t from = bench_counter();
    ctl_tick(&self->core, self->now_us);
    self->slice_cost = bench_counter() - from;
    self->max_slice_cost = larger(self->max_slice_cost, self->slice_cost);
    whole_machine_follow(&self->machine, &self->core);
}

static void note(bench* self, uint32_t* longest, uint32_t from)
{
    const uint32_t cost = bench_counter() - from;
    *longest = larger(*longest, cost);
    self->request_cost += cost;
}

size_t bench_exchange(bench* self, uint8_t* frame, size_t size)
{
    const uint16_t crc = ctl_crc16(frame, size);
    frame[size] = (uint8_t)(crc & 0xFFu);
    frame[size + 1u] = (uint8_t)(crc >> 8);
    self->request_cost = 0;
    for (size_t at = 0; at < size + 2u; at += RECEIVER_BYTES) {
        const size_t left = size + 2u - at;
        const uint32_t from = bench_counter();
        ctl_receive(&self->core, &frame[at], left < RECEIVER_BYTES ? left : RECEIVER_BYTES, self->now_us);
        note(self, &bench_longest.receive, from);
    }
    uint32_t from = bench_counter();
    ctl_receive_silence(&self->core, self->now_us + 1u);
    note(self, &bench_longest.silence, from);
    size_t answered = 0;
    while (answered == 0 && self->core.rtu.answer_size != 0) {
        from = bench_counter();
        answered = ctl_take_answer(&self->core, frame);
        note(self, &bench_longest.take, from);
    }
    self->max_request_cost = larger(self->max_request_cost, self->request_cost);
    return answered;
}

size_t bench_write_read_frame(uint8_t* frame, uint16_t address, const uint16_t* values, uint16_t count,
                              uint16_t read_address, uint16_t read_count)
{
    frame[0] = 1;
    frame[1] = 23;
    ctl_put_bytes16(&frame[2], read_address);
    ctl_put_bytes16(&frame[4], read_count);
    ctl_put_bytes16(&frame[6], address);
    ctl_put_bytes16(&frame[8], count);
    frame[10] = (uint8_t)(2u * count);
    for (uint32_t i = 0; i < count; ++i)
        ctl_put_bytes16(&frame[11u + 2u * i], values[i]);
    return 11u + 2u * count;
}

uint16_t bench_write_read(bench* self, uint16_t address, const uint16_t* values, uint16_t count,
                          uint16_t read_address, uint16_t* read, uint16_t read_count)
{
    uint8_t frame[CTL_FRAME_BYTES];
    (void)bench_exchange(self, frame,
                         bench_write_read_frame(frame, address, values, count, read_address, read_count));
    if (frame[1] != 23)
        return frame[2];
    for (uint32_t i = 0; i < read_count; ++i)
        read[i] = ctl_get_bytes16(&frame[3u + 2u * i]);
    return 0;
}

uint16_t bench_command(bench* self, uint16_t code, uint16_t argument0, uint16_t argument1, uint32_t argument2)
{
    uint16_t request[CTL_GROUP_COMMAND] = {++self->counter, code, argument0, argument1};
    uint16_t result[CTL_GROUP_RESULT] = {0};
    ctl_put32(&request[4], argument2);
    for (uint32_t i = 0; i < PATIENCE_SLICES; ++i) {
        (void)bench_write_read(self, CTL_REG_COMMAND_COUNTER, request, CTL_GROUP_COMMAND,
                               CTL_REG_RESULT_COUNTER, result, CTL_GROUP_RESULT);
        if (result[2] != CTL_COMMAND_STATUS_BUSY)
            break;
        bench_slice(self, CTL_SLICE_US);
    }
    return result[3];
}

static uint16_t transfer(bench* self, uint16_t operation, uint16_t block, const uint16_t* data, uint16_t size)
{
    uint16_t request[CTL_GROUP_TRANSFER] = {BENCH_SESSION, operation, block, size};
    uint16_t result[CTL_GROUP_TRANSFER_RESULT] = {0};
    if (size != 0)
        memcpy(&request[4], data, size * sizeof request[0]);
    (void)bench_write_read(self, CTL_REG_TRANSFER_SESSION, request, (uint16_t)(4u + size),
                           CTL_REG_TRANSFER_RESULT_SESSION, result, CTL_GROUP_TRANSFER_RESULT);
    return result[3];
}

uint16_t bench_download(bench* self, const bench_case* program, uint32_t* crc)
{
    static uint16_t registers[CTL_BANK_REGISTERS]; /* as the panel holds it */
    const uint16_t length = (uint16_t)program->build(registers);
    const uint16_t announced[3] = {program->kind, length, CTL_MAP_MAJOR};
    *crc = ~ctl_crc32_registers(CTL_CRC32_START, registers, length);
    uint16_t result = transfer(self, CTL_TRANSFER_OPERATION_BEGIN, 0, announced, 3);
    for (uint16_t first = 0; result == CTL_TRANSFER_RESULT_ACCEPTED && first < length;
         first += CTL_BLOCK_REGISTERS) {
        const uint16_t left = (uint16_t)(length - first);
        result =
            transfer(self, CTL_TRANSFER_OPERATION_BLOCK, (uint16_t)(first / CTL_BLOCK_REGISTERS),
                     &registers[first], left < CTL_BLOCK_REGISTERS ? left : (uint16_t)CTL_BLOCK_REGISTERS);
        bench_slice(self, CTL_SLICE_US);
    }
    if (result != CTL_TRANSFER_RESULT_ACCEPTED)
        return result;
    do {
        result = transfer(self, CTL_TRANSFER_OPERATION_SEAL, 0, NULL, 0);
        bench_slice(self, CTL_SLICE_US);
    } while (result == CTL_TRANSFER_RESULT_BUSY);
    return result;
}

uint16_t bench_apply(bench* self, uint16_t mode, uint32_t crc)
{
    const uint16_t refusal = bench_command(self, CTL_COMMAND_APPLY_STAGED, mode, BENCH_SESSION, crc);
    whole_machine_follow(&self->machine, &self->core);
    return refusal;
}

uint16_t bench_install(bench* self, const bench_case* program)
{
    uint32_t crc = 0;
    const uint16_t result = bench_download(self, program, &crc);
    return result != CTL_TRANSFER_RESULT_ACCEPTED ? result
                                                  : bench_apply(self, CTL_APPLY_MODE_WHEN_STOPPED, crc);
}
