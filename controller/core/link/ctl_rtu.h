/* SPDX-License-Identifier: Apache-2.0 */
/* Frames of a Modbus RTU slave: bytes in, bytes out. A frame ends with 3.5 characters of silence. What a
 * frame asks for is carried out by ctl_function.h. */
#ifndef CTL_RTU_H
#define CTL_RTU_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_FRAME_BYTES 256u

struct ctl_core;

typedef struct {
    uint8_t request[CTL_FRAME_BYTES];
    uint32_t received; /* bytes of the frame so far, those beyond the buffer counted too */
    bool line_error;
    uint64_t last_byte_us;
    uint8_t answer[CTL_FRAME_BYTES];
    uint32_t answer_size; /* waiting to be taken */
    uint16_t crc_errors;
    uint16_t frame_errors;
    uint16_t exceptions;
    uint16_t requests;
} ctl_rtu;

/* Bytes off the line; the last of them ended at now_us. */
void ctl_receive(struct ctl_core* core, const uint8_t* bytes, size_t size, uint64_t now_us);
/* The receiver saw a parity, framing or overrun error: the frame under way will be dropped. */
void ctl_receive_error(struct ctl_core* core, uint64_t now_us);
/* The answer that is ready, to be sent now; at most CTL_FRAME_BYTES. Returns its size, 0 when there is none.
 */
size_t ctl_take_answer(struct ctl_core* core, uint8_t* bytes);

/* Ends the frame under way when the line has been silent for long enough; called by ctl_tick(). */
void ctl_rtu_tick(struct ctl_core* core, uint64_t now_us);

#ifdef __cplusplus
}
#endif

#endif
