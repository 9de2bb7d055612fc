/* SPDX-License-Identifier: Apache-2.0 */
/* The board to copy: every function of board.h and every callback of ctl_port that a machine with one axis
 * needs, without hardware. It compiles and links with the tests, and moves nothing. docs/porting.md says what
 * belongs into each place. */
#include "board.h"

#include <string.h>

/* The state that the hardware would hold. */
typedef struct {
    uint64_t now_us;
    int64_t position; /* pulses that have left */
    uint8_t flash[CTL_FLASH_SLOTS][2u * (CTL_BANK_STORAGE + CTL_GROUP_PARAMETER + 16u)];
} stub;

static stub the_stub;

/* Clock tree, timers, line, pins; the watchdog last. */
void board_init(void)
{
    memset(the_stub.flash, 0xFF, sizeof the_stub.flash);
}

ctl_config board_config(void)
{
    return (ctl_config){
        .unit = 1,
        .frame_gap_us = 1750, /* 3.5 characters, from 19200 baud on */
        .firmware = {0, 0, 0},
        .unique_id = 1,
        .timer_clock_hz = 8000000,
        .timer_bits = 16,
        .max_pulse_hz = 200000,
        .max_rows_per_slice = 16,
        .work_registers = 24,
        .table_layouts = 1u << CTL_TABLE_LAYOUT_STEP_TABLE | 1u << CTL_TABLE_LAYOUT_CAM_POINTS |
                         1u << CTL_TABLE_LAYOUT_PRESS_STAGES, /* intervals do not fit 60 MHz */
    };
}

/* Into a queue that the pulse timer's interrupt empties: ctl_train_next() gives it the tick of each pulse, to
 * which it adds the delay of this board and which it loads into the timer. Here they leave at once. */
static void pulses(void* context, const ctl_train* train)
{
    stub* self = context;
    self->position += train->direction * (int64_t)train->count;
}

/* Returns the quadrature counter; a board extends it to 64 bits here. */
static int64_t encoder(void* context)
{
    const stub* self = context;
    return self->position;
}

/* Returns true once per mark, with the capture register. */
static bool index_mark(void* context, int64_t* encoder_at_mark)
{
    const stub* self = context;
    *encoder_at_mark = self->position;
    return false;
}

static bool read_bytes(void* context, uint32_t slot, uint32_t offset, uint8_t* bytes, uint32_t size)
{
    const stub* self = context;
    memcpy(bytes, &self->flash[slot][offset], size);
    return true;
}

/* Begins only; so does write_bytes(). */
static bool erase_slot(void* context, uint32_t slot)
{
    stub* self = context;
    memset(self->flash[slot], 0xFF, sizeof self->flash[slot]);
    return true;
}

static bool write_bytes(void* context, uint32_t slot, uint32_t offset, const uint8_t* bytes, uint32_t size)
{
    stub* self = context;
    memcpy(&self->flash[slot][offset], bytes, size);
    return true;
}

/* Reads the status of the flash, and does not wait for it. */
static ctl_flash_progress flash_state(void* context)
{
    (void)context;
    return CTL_FLASH_DONE;
}

void board_connect(ctl_port* port)
{
    *port = (ctl_port){
        .context = &the_stub,
        .pulses = pulses,
        .encoder = encoder,
        .index = index_mark,
        .flash_read = read_bytes,
        .flash_erase = erase_slot,
        .flash_write = write_bytes,
        .flash_progress = flash_state,
    };
}

/* Returns a counter that runs by itself. */
uint64_t board_now_us(void)
{
    return the_stub.now_us;
}

/* Wait for interrupt: here a slice passes. */
void board_idle(void)
{
    the_stub.now_us += CTL_SLICE_US;
}

void board_watchdog(void) {}

/* From the ring that the receive interrupt fills. */
size_t board_take_bytes(uint8_t* bytes, size_t size, uint64_t* last_us, bool* error)
{
    (void)bytes;
    (void)size;
    *last_us = the_stub.now_us;
    *error = false;
    return 0;
}

/* Into a buffer of the transmitter; the driver of RS-485 is on until the last stop bit. */
void board_send(const uint8_t* bytes, size_t size)
{
    (void)bytes;
    (void)size;
}

/* A real machine moves by itself. */
void board_end_slice(ctl_core* core)
{
    (void)core;
}
