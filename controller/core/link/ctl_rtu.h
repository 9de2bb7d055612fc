/* SPDX-License-Identifier: Apache-2.0 */
/* Frames of a Modbus RTU slave: bytes in, bytes out. A frame ends with 3.5 characters of silence. What a
 * frame asks for is carried out by ctl_function.h. */
#ifndef CTL_RTU_H
#define CTL_RTU_H

#include "base/ctl_port.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_FRAME_BYTES 256u
#define CTL_EXCEPTION_FLAG 0x80u /* of the function code in an answer */

typedef struct {
    uint8_t request[CTL_FRAME_BYTES];
    uint32_t received;     /* bytes of the frame so far, those beyond the buffer counted too */
    uint16_t received_crc; /* of these bytes */
    bool line_error;
    uint64_t last_byte_us;
    uint8_t answer[CTL_FRAME_BYTES];
    uint32_t answer_size;   /* waiting to be taken, with its CRC-16 */
    uint32_t answer_summed; /* bytes that its CRC-16 covers so far */
    uint16_t answer_crc;
    uint16_t crc_errors;
    uint16_t frame_errors;
    uint16_t exceptions;
    uint16_t requests;
} ctl_rtu;

/* Takes bytes off the line; the last of them ended at now_us. */
void ctl_rtu_receive(ctl_rtu* rtu, const uint8_t* bytes, size_t size, uint64_t now_us);
/* Marks the frame under way as damaged: it will be dropped. */
void ctl_rtu_receive_error(ctl_rtu* rtu, uint64_t now_us);
/* Ends the frame under way when the line has been silent for long enough. Returns the size of a good request
 * to this unit, from its function code at request[1] on; 0 when there is none. */
size_t ctl_rtu_request(ctl_rtu* rtu, const ctl_config* config, uint64_t now_us);
/* Puts the answer to it on the way, whose function code and data, `size` bytes, are at answer[1]. */
void ctl_rtu_answer(ctl_rtu* rtu, size_t size);
/* Sums up at most `most` bytes of the waiting answer; moves it to `bytes` when its CRC-16 is done. Returns
 * its size, 0 when there is none or it is not done. */
size_t ctl_rtu_take_answer(ctl_rtu* rtu, uint8_t* bytes, uint32_t most);

#ifdef __cplusplus
}
#endif

#endif
