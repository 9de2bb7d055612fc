/* SPDX-License-Identifier: Apache-2.0 */
/* The functions and figures that the controller needs from the board that it runs on. A port fills ctl_port
 * and ctl_config and calls ctl_tick(); nothing else in the core touches hardware. */
#ifndef CTL_PORT_H
#define CTL_PORT_H

#include "base/ctl_train.h"

#include <stdbool.h>
#include <stdint.h>

#define CTL_FLASH_SLOTS 2u
#define CTL_SLICE_US 250u
#define CTL_KEPT_BYTES 64u
#define CTL_KEPT_RECORDS 3u

typedef enum { CTL_AXIS_FILM, CTL_AXIS_INFEED } ctl_axis;
typedef enum { CTL_FLASH_DONE, CTL_FLASH_BUSY, CTL_FLASH_FAILED } ctl_flash_progress;

/* The encoder that leads the line, since power-up. */
typedef struct {
    int64_t counts;
    uint32_t errors;  /* changes of A and B at once */
    uint32_t indexes; /* index marks passed, in either direction, */
    int64_t index_at; /* and the counts at the last one; the same edge of it in both directions */
} ctl_master_input;

typedef struct {
    void* context; /* passed to every callback */

    /* Pulses of the main axis, their ticks in timer ticks since power-up, modulo 2^32. They lie in the slice
     * that is being computed, in the order of time, in several calls; the board lets all axes move later by
     * the same time, long enough for its slowest turn. */
    void (*pulses)(void* context, const ctl_train* train);
    /* Encoder position since power-up, in pulses of the command. */
    int64_t (*encoder)(void* context);
    /* True once after the index mark was passed forward; gives the encoder position latched there. */
    bool (*index)(void* context, int64_t* encoder_at_mark);
    /* Scale at the ram of a press, 1/256 pulse of the command, with the zero of the encoder; NULL: encoder
     * only. */
    int64_t (*scale)(void* context);
    /* Present force of a press, N; NULL if there is no press. */
    int32_t (*force)(void* context);

    /* Film and infeed of a packing machine; all NULL if there is none. The axis runs evenly from one position
     * to the other in the slice that is being computed: for a rate generator as they are, for a pulse timer
     * by ctl_train_line(). Positions since power-up, 1/256 pulse of the command. */
    void (*feed)(void* context, ctl_axis axis, int64_t from, int64_t to);
    int64_t (*film)(void* context);
    int64_t (*infeed)(void* context);
    /* True once for each edge of a printed mark that passed its sensor; gives the film position latched
     * there, and whether the mark is at the sensor from now on. */
    bool (*mark)(void* context, int64_t* film_at_edge, bool* covered);
    /* True once for each edge of a product that passed the eye; gives the infeed position latched there, and
     * whether it covers the eye from now on. */
    bool (*eye)(void* context, int64_t* infeed_at_edge, bool* covered);

    /* The encoder that leads the line, decoded as CTL_MASTER_SIGNAL_... says; NULL: there is no input for
     * one. */
    void (*master)(void* context, uint16_t signal, ctl_master_input* input);
    /* From now on an edge of a mark, of a product and a cut latch the counts of that encoder; false: film and
     * infeed again. NULL: they cannot. */
    void (*latch_master)(void* context, bool on);

    /* Bits CTL_MEASURED_AXIS_...: the motors of these axes turn the other way from now on. Pulses and
     * positions stay those of the command, without a step; called at standstill. NULL: none can. */
    void (*reverse)(void* context, uint16_t axes);

    /* Present levels of the input pins, bits CTL_INPUT_BIT_..., 1: true; NULL if there are none. */
    uint16_t (*inputs)(void* context);
    /* Sets the output pins, bits CTL_OUTPUT_BIT_...; NULL if there are none. */
    void (*outputs)(void* context, uint32_t levels);

    /* Torque of the axis, 0.1 % of the drive's rated torque; NULL if the drive does not report it. */
    int32_t (*torque)(void* context);

    /* Flash that keeps its bytes over power loss; slot 0 or 1, erased bytes read 0xFF. False: it failed. */
    bool (*flash_read)(void* context, uint32_t slot, uint32_t offset, uint8_t* bytes, uint32_t size);
    bool (*flash_erase)(void* context, uint32_t slot);
    bool (*flash_write)(void* context, uint32_t slot, uint32_t offset, const uint8_t* bytes, uint32_t size);
    /* For a flash that erases and writes in the background. Returns CTL_FLASH_BUSY until it is done, then
     * CTL_FLASH_DONE or CTL_FLASH_FAILED. NULL: erase and write return when they are done. */
    ctl_flash_progress (*flash_progress)(void* context);

    /* CTL_KEPT_RECORDS records of at most CTL_KEPT_BYTES, the first replaced at each bag: a power cut at any
     * moment leaves the new one or the one before (FRAM, backup RAM). False: it failed. NULL: nothing
     * survives. */
    bool (*keep)(void* context, uint32_t record, const uint8_t* bytes, uint32_t size);
    /* Reads a record; returns its size, 0 when there is none, at most `size` of it read. */
    uint32_t (*kept)(void* context, uint32_t record, uint8_t* bytes, uint32_t size);
} ctl_port;

typedef struct {
    uint8_t unit;            /* Modbus unit, 1..247 */
    uint32_t frame_gap_us;   /* silence that ends a frame: 3.5 characters, 1750 us above 19200 baud */
    uint16_t firmware[3];    /* major, minor, patch */
    uint64_t unique_id;      /* of this board */
    uint32_t timer_clock_hz; /* clock of the pulse timer */
    uint16_t timer_bits;     /* its width, at most 16 */
    uint32_t max_pulse_hz;   /* maximum pulse frequency of the output stage */
    uint32_t slice_us;       /* maximum step of the control, 0: CTL_SLICE_US */
    uint32_t output_us;      /* from the reading of the encoders to the end of the pulses of that slice */

    /* The bounds of a slow processor or a small memory; 0: none. */
    uint16_t bank_registers;     /* maximum of a bank, header included */
    uint16_t row_capacity;       /* rows of a step table */
    uint16_t table_layouts;      /* bit n: table layout n can be executed */
    uint16_t max_rows_per_slice; /* maximum rows of a step table in one slice, at least 2 */
    uint16_t work_registers;     /* registers that one slice checks, sums up or saves */

    /* Bits CTL_IO_BIT_..._KEPT: axes whose position survives a power cut (absolute encoder, backup counter).
     * An encoder of the main axis that does counts from an index mark, in any turn, whatever its sign. */
    uint16_t kept_positions;

    uint16_t map_minor; /* registers of later minor versions of the map do not exist; 0: all do */
} ctl_config;

#endif
