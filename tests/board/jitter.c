/* SPDX-License-Identifier: Apache-2.0 */
/* When pulses leave a board of 31 million instructions a second, which is what 60 MHz give an ARM7TDMI: the
 * real loop of firmware.c with a cutter at full speed and a master that asks as fast as 115200 baud allow,
 * downloads, seals and saves meanwhile. In QEMU with -icount shift=5 an instruction takes 32 ns of the timer.
 * Prints how many ticks a pulse of the knife is off its table, and how late after its tick a board learns of
 * a pulse: its pulses must leave that much later, all by the same time. */
#include "base/ctl_crc.h"
#include "base/ctl_words.h"
#include "bench_target.h"
#include "board.h"
#include "versatilepb/devices.h"

#include <string.h>

#define CLOCK_VALUE 0x101E3004u
#define US_PER_S 1000000u
#define BITS_PER_BYTE 10u
#define BAUD 115200u
#define GAP_US 1750u
#define TICKS_PER_US 8u
#define POLLS 100u

enum { BEGIN, BLOCKS, SEAL, APPLY, START, POLL, SAVE, END };
static const uint8_t script[] = {BEGIN, BLOCKS, SEAL, APPLY, START, POLL,
                                 BEGIN, BLOCKS, SEAL, SAVE,  POLL,  END};

static struct {
    whole_machine machine;
    ctl_port inner; /* of the machine */
    ctl_core* core;
    uint16_t image[CTL_BANK_REGISTERS];
    uint32_t length;
    uint32_t crc;
    /* The master. */
    uint32_t at; /* in the script */
    uint32_t number;
    uint16_t counter;
    uint8_t frame[CTL_FRAME_BYTES];
    size_t size;
    uint64_t arrives_us; /* of the request's last byte; 0: none is under way */
    uint64_t free_us;    /* the line, for the next request */
    /* The table beside the machine's, from full speed on. */
    ctl_step table;
    uint32_t tick;
    bool follows;
    uint64_t started_us; /* the core's time when its ticks were 0 */
    uint32_t pulses;
    uint32_t off_ticks;
    uint32_t late_us;
    uint32_t requests;
    uint32_t busy; /* answers */
} self;

static void compare(ctl_train train)
{
    while (train.count != 0) {
        const uint32_t leaves = ctl_train_next(&train);
        ctl_event event = {0, false};
        while (!event.pulse) {
            if (ctl_step_between_cycles(&self.table))
                ctl_step_begin_cycle(&self.table);
            event = ctl_step_next(&self.table);
            self.tick += event.ticks;
        }
        const uint32_t off = leaves - self.tick;
        const uint32_t ticks = off > UINT32_MAX / 2u ? 0u - off : off;
        self.off_ticks = ticks > self.off_ticks ? ticks : self.off_ticks;
        self.pulses += 1;
    }
}

static void be_late(uint64_t due_us)
{
    const uint64_t now_us = board_now_us();
    if (self.follows && now_us > due_us && now_us - due_us > self.late_us)
        self.late_us = (uint32_t)(now_us - due_us);
}

static void take_pulses(void* context, const ctl_train* train)
{
    be_late(self.started_us + train->tick / TICKS_PER_US);
    if (self.follows)
        compare(*train);
    self.inner.pulses(context, train);
}

/* It may begin with the slice. */
static void take_feed(void* context, ctl_axis axis, int64_t from, int64_t to)
{
    be_late(self.core == NULL ? UINT64_MAX : self.core->board.now_us - CTL_SLICE_US);
    self.inner.feed(context, axis, from, to);
}

void board_init(void)
{
    bench_open();
    self.length = bench_cases[0].build(self.image);
    self.crc = ~ctl_crc32_registers(CTL_CRC32_START, self.image, self.length);
    whole_machine_init(&self.machine, (whole_disturbance){.stretch_ppm = 800});
}

ctl_config board_config(void)
{
    ctl_config config = bench_config();
    config.frame_gap_us = GAP_US;
    return config;
}

void board_connect(ctl_port* port)
{
    whole_machine_connect(&self.machine, port);
    self.inner = *port;
    port->pulses = take_pulses;
    port->feed = take_feed;
    bench_connect_flash(port);
}

uint64_t board_now_us(void)
{
    return ~DEVICE(CLOCK_VALUE); /* the run is over before it wraps */
}

void board_idle(void) {}

void board_watchdog(void) {}

static size_t transfer(uint16_t operation, uint16_t block, const uint16_t* data, uint16_t size)
{
    uint16_t request[CTL_GROUP_TRANSFER] = {BENCH_SESSION, operation, block, size};
    memcpy(&request[4], data, size * sizeof request[0]);
    return bench_write_read_frame(self.frame, CTL_REG_TRANSFER_SESSION, request, (uint16_t)(4u + size),
                                  CTL_REG_TRANSFER_RESULT_SESSION, CTL_GROUP_TRANSFER_RESULT);
}

/* A command that is asked about again keeps its counter. */
static size_t command(uint16_t code, uint16_t argument1, uint32_t argument2)
{
    uint16_t request[CTL_GROUP_COMMAND] = {self.counter, code, 0, argument1};
    ctl_put32(&request[4], argument2);
    return bench_write_read_frame(self.frame, CTL_REG_COMMAND_COUNTER, request, CTL_GROUP_COMMAND,
                                  CTL_REG_RESULT_COUNTER, CTL_GROUP_RESULT);
}

static size_t block(void)
{
    const uint32_t first = self.number * CTL_BLOCK_REGISTERS;
    const uint32_t left = self.length - first;
    return transfer(CTL_TRANSFER_OPERATION_BLOCK, (uint16_t)self.number, &self.image[first],
                    (uint16_t)(left < CTL_BLOCK_REGISTERS ? left : CTL_BLOCK_REGISTERS));
}

static size_t next_request(void)
{
    const uint16_t announced[3] = {bench_cases[0].kind, (uint16_t)self.length, CTL_MAP_MAJOR};
    const uint16_t exchange[CTL_GROUP_EXCHANGE] = {(uint16_t)self.requests, (uint16_t)self.requests, 0};
    switch (script[self.at]) {
    case BEGIN:
        return transfer(CTL_TRANSFER_OPERATION_BEGIN, 0, announced, 3);
    case BLOCKS:
        return block();
    case SEAL:
        return transfer(CTL_TRANSFER_OPERATION_SEAL, 0, announced, 0);
    case APPLY:
        return command(CTL_COMMAND_APPLY_STAGED, BENCH_SESSION, self.crc);
    case START:
        return command(CTL_COMMAND_START, 0, 0);
    case SAVE:
        return command(CTL_COMMAND_SAVE_TO_FLASH, 0, self.crc);
    default:
        return bench_write_read_frame(self.frame, CTL_REG_EXCHANGE_TAG, exchange, CTL_GROUP_EXCHANGE,
                                      CTL_REG_STATUS_TAG, CTL_GROUP_STATUS);
    }
}

size_t board_take_bytes(uint8_t* bytes, size_t size, uint64_t* last_us, bool* error)
{
    const uint64_t now_us = board_now_us();
    *error = false;
    if (self.core == NULL || now_us < self.free_us)
        return 0;
    if (self.arrives_us == 0) {
        self.size = next_request();
        const uint16_t crc = ctl_crc16(self.frame, self.size);
        self.frame[self.size] = (uint8_t)(crc & 0xFFu);
        self.frame[self.size + 1u] = (uint8_t)(crc >> 8);
        self.size += 2u;
        self.arrives_us = now_us + self.size * BITS_PER_BYTE * US_PER_S / BAUD;
    }
    if (now_us < self.arrives_us)
        return 0;
    *last_us = self.arrives_us;
    self.arrives_us = 0;
    self.free_us = UINT64_MAX; /* until it is answered */
    const size_t taken = self.size < size ? self.size : size;
    memcpy(bytes, self.frame, taken);
    return taken;
}

static void fail(const char* what, uint32_t number)
{
    bench_print(what);
    bench_print_number(" ", number, "\n");
    bench_exit(false);
}

static void advance(void)
{
    self.at += 1;
    self.number = 0;
    self.counter += 1;
}

/* Goes on in the script by what was answered. */
void board_send(const uint8_t* bytes, size_t size)
{
    const uint16_t state = ctl_get_bytes16(&bytes[7]);
    const uint16_t result = ctl_get_bytes16(&bytes[9]);
    const uint8_t step = script[self.at];
    self.requests += 1;
    self.free_us = board_now_us() + size * BITS_PER_BYTE * US_PER_S / BAUD + GAP_US;
    if (bytes[1] != 23)
        fail("exception", bytes[2]);
    if (step == POLL) {
        self.number += self.follows ? 1u : 0u;
        if (self.number == POLLS)
            advance();
        return;
    }
    if (step == BEGIN || step == BLOCKS || step == SEAL) {
        self.busy += result == CTL_TRANSFER_RESULT_BUSY;
        if (result == CTL_TRANSFER_RESULT_BUSY)
            return;
        if (result != CTL_TRANSFER_RESULT_ACCEPTED)
            fail("transfer", result);
        self.number += 1;
        if (step != BLOCKS || self.number * CTL_BLOCK_REGISTERS >= self.length)
            advance();
        return;
    }
    self.busy += state == CTL_COMMAND_STATUS_BUSY;
    if (state == CTL_COMMAND_STATUS_BUSY)
        return;
    if (result != CTL_REFUSAL_NONE)
        fail("command", result);
    advance();
}

static void finish(void)
{
    bench_print_number("jitter_pulses ", self.pulses, "\n");
    bench_print_number("jitter_requests ", self.requests, "\n");
    bench_print_number("jitter_busy_answers ", self.busy, "\n");
    bench_print_number("jitter_off_ticks ", self.off_ticks, "\n");
    bench_print_number("jitter_late_us ", self.late_us, "\n");
    bench_exit(true);
}

void board_end_slice(ctl_core* core)
{
    if (self.core == NULL) {
        self.core = core;
        self.started_us = core->board.started_us;
        self.counter = 1;
        bench_turn_on(core);
    }
    whole_machine_follow(&self.machine, core);
    const ctl_motion* motion = &core->motion;
    if (!self.follows && motion->state == CTL_STATE_RUNNING && motion->ramp.speed == motion->ramp.full) {
        self.table = motion->table.step;
        self.tick = core->board.tick;
        self.follows = true;
    }
    if (self.follows && motion->state != CTL_STATE_RUNNING)
        fail("state", motion->state);
    if (script[self.at] == END)
        finish();
}
