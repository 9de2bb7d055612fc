/* SPDX-License-Identifier: Apache-2.0 */
/* The core with the whole-number machine on a bench, in C and in whole numbers, so that host and target do
 * the same: programs of every kind, installed over the registers as a panel does it. */
#ifndef BOARD_BENCH_H
#define BOARD_BENCH_H

#include "machine/whole_machine.h"

/* host.c or target.c: prints; returns the instructions carried out so far, 0 on the host. */
void bench_print(const char* text);
uint32_t bench_counter(void);
/* Runs with the number of the command line; returns 0 when all went well. */
int bench_run(uint32_t number);

void bench_print_number(const char* before, uint32_t number, const char* behind);
void bench_print_hex(const char* before, uint32_t number, const char* behind);

#define BENCH_SESSION 7u /* of a download */

typedef struct {
    const char* name;
    uint16_t kind;
    uint32_t (*build)(uint16_t* registers); /* returns the length */
    uint32_t counts_per_s;                  /* of the encoder that leads it; 0: the clock does */
    bool is_wheel;                          /* on film that somebody else drives */
} bench_case;

extern const bench_case bench_cases[];
extern const uint32_t bench_case_count;
/* The program that each cutter among them changes to, with other bags. */
extern const bench_case bench_other_cutter;

/* Instructions of the longest call of each function of the core, since they were set to 0. */
typedef struct {
    uint32_t receive; /* ctl_receive() of what the receiver holds */
    uint32_t silence; /* ctl_receive_silence(), which carries a request out */
    uint32_t take;    /* ctl_take_answer() */
    uint32_t work;    /* the piece of a seal, a check or a save in a slice */
} bench_calls;

extern bench_calls bench_longest;

typedef struct {
    ctl_core core;
    whole_machine machine;
    uint64_t now_us;
    uint16_t counter;        /* of the last command */
    uint32_t slice_cost;     /* instructions of the last slice */
    uint32_t request_cost;   /* of the last request */
    uint32_t max_slice_cost; /* since they were set to 0 */
    uint32_t max_request_cost;
} bench;

/* Powers up on a machine of everything that goes wrong, with marks, anti-cut and empty bags, on the line that
 * leads this program. */
void bench_power_up(bench* self, const bench_case* program);
/* Sets the parameters for that; then also for the eight cam switches. */
void bench_turn_on(ctl_core* core);
void bench_switch_on(ctl_core* core);
/* Returns the figures of a board at 8 MHz whose processor has 60 MHz. */
ctl_config bench_config(void);
/* Fills in the callbacks of a blank flash in memory. */
void bench_connect_flash(ctl_port* port);
/* Calls the core for the next slice. */
void bench_slice(bench* self, uint32_t slice_us);
/* Downloads and seals; returns the result of the transfer and the bank's CRC-32. */
uint16_t bench_download(bench* self, const bench_case* program, uint32_t* crc);
/* Applies it; returns the refusal. */
uint16_t bench_apply(bench* self, uint16_t mode, uint32_t crc);
/* Does all of it at standstill; returns 0, or the result of the transfer or the refusal. */
uint16_t bench_install(bench* self, const bench_case* program);
/* Returns the refusal. */
uint16_t bench_command(bench* self, uint16_t code, uint16_t argument0, uint16_t argument1,
                       uint32_t argument2);
/* Carries out one request of the line, `size` bytes without CRC-16; returns the size of the answer, which
 * stays in `frame`. */
size_t bench_exchange(bench* self, uint8_t* frame, size_t size);
/* Composes a request that writes registers and reads others; returns its size without CRC-16. */
size_t bench_write_read_frame(uint8_t* frame, uint16_t address, const uint16_t* values, uint16_t count,
                              uint16_t read_address, uint16_t read_count);
/* Carries out such a request; returns 0 or the exception. */
uint16_t bench_write_read(bench* self, uint16_t address, const uint16_t* values, uint16_t count,
                          uint16_t read_address, uint16_t* read, uint16_t read_count);

#endif
