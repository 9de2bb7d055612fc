/* SPDX-License-Identifier: Apache-2.0 */
/* The simplest machine that every kind of program runs on, in whole numbers, so that it gives the same on any
 * processor: drives that are where their pulses put them, a shaft with an index mark, printed film, products,
 * a knife; the ram of a press over a springy work piece. It stands in for the machine where there is none. */
#ifndef WHOLE_MACHINE_H
#define WHOLE_MACHINE_H

#include "machine/whole_line.h"

typedef struct {
    int64_t top;       /* pulses: upper position */
    int64_t touch;     /* pulses below it: upper side of the work piece */
    uint32_t force_16; /* N per pulse beyond that, in 1/65536 */
} whole_press;

typedef struct {
    whole_line line;
    whole_press press;
    int64_t position; /* of the main drive, pulses */
    int64_t before;   /* that at the start of the slice */
    int64_t mark;     /* one of the index marks, pulses */
    uint64_t turn;    /* pulses from mark to mark, times parts */
    uint32_t parts;
    bool index_passed;
    int64_t index_at;
    bool has_press;
    bool is_enabled; /* by the output pin */
    uint16_t inputs; /* as they were at the end of the slice */
    uint32_t outputs;
    uint32_t generation; /* of the program that the machine is set up for */
} whole_machine;

/* Stands with its shaft at 300 degrees and no program. */
void whole_machine_init(whole_machine* machine, whole_disturbance disturbance);
/* Fills in the callbacks of the machine; flash is left to the board. */
void whole_machine_connect(whole_machine* machine, ctl_port* port);
/* Ends a slice: sensors see what passed them, the knife cuts, another program sets up the machine. */
void whole_machine_follow(whole_machine* machine, ctl_core* core);

#endif
