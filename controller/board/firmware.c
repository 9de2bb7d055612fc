/* SPDX-License-Identifier: Apache-2.0 */
/* The loop around the core: time is cut into slices, bytes go in, answers come out. */
#include "board.h"

/* The slices that one turn makes up for; a board may set another number. A larger delay is permanent: the
 * machine runs late, but the line is still answered. */
#ifndef MAX_SLICES
#define MAX_SLICES 400u
#endif

typedef struct {
    ctl_core core;
    uint64_t slice_end_us; /* of the last slice, in the core's time */
    uint64_t given_up_us;  /* by which the core's time is behind the board's */
} firmware;

static firmware the_firmware; /* too large for the stack, and the core must not move */

/* Returns whether all slices that are due were run. */
static bool run_slices(firmware* self)
{
    const uint32_t slice_us = self->core.board.config.slice_us;
    const uint64_t now_us = board_now_us() - self->given_up_us;
    for (uint32_t i = 0; self->slice_end_us + slice_us <= now_us; ++i) {
        if (i == MAX_SLICES) {
            self->given_up_us += now_us - self->slice_end_us;
            return false;
        }
        self->slice_end_us += slice_us;
        ctl_tick(&self->core, self->slice_end_us);
        board_end_slice(&self->core);
    }
    return true;
}

/* An answer goes out in the turn behind its request, so that the slices are not late for both at once. */
static void serve_line(firmware* self)
{
    uint8_t bytes[CTL_FRAME_BYTES];
    const size_t answered = ctl_take_answer(&self->core, bytes);
    if (answered != 0)
        board_send(bytes, answered);
    uint64_t last_us = 0;
    bool error = false;
    const size_t size = board_take_bytes(bytes, sizeof bytes, &last_us, &error);
    if (error)
        ctl_receive_error(&self->core, last_us - self->given_up_us);
    if (size != 0)
        ctl_receive(&self->core, bytes, size, last_us - self->given_up_us);
    ctl_receive_silence(&self->core, board_now_us() - self->given_up_us);
}

int main(void)
{
    firmware* self = &the_firmware;
    board_init();
    const ctl_config config = board_config();
    ctl_port port = {0};
    board_connect(&port);
    self->slice_end_us = board_now_us();
    ctl_init(&self->core, &config, &port, self->slice_end_us);
    for (;;) {
        if (run_slices(self))
            board_watchdog();
        serve_line(self);
        board_idle();
    }
}
