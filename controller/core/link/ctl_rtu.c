/* SPDX-License-Identifier: Apache-2.0 */
#include "link/ctl_rtu.h"

#include "base/ctl_crc.h"

#include <string.h>

#define SHORTEST_FRAME 4u /* unit, function, CRC-16 */
#define BROADCAST 0u

static size_t end_frame(ctl_rtu* rtu, uint8_t own_unit)
{
    const uint32_t size = rtu->received;
    const bool damaged = rtu->line_error || size < SHORTEST_FRAME || size > CTL_FRAME_BYTES;
    rtu->received = 0;
    rtu->line_error = false;
    if (damaged) {
        rtu->frame_errors += 1;
        return 0;
    }
    if (rtu->received_crc != 0) { /* over the frame with its CRC-16 it comes to 0 */
        rtu->crc_errors += 1;
        return 0;
    }
    const uint8_t unit = rtu->request[0];
    return unit == own_unit || unit == BROADCAST ? size - 3u : 0u;
}

size_t ctl_rtu_request(ctl_rtu* rtu, const ctl_config* config, uint64_t now_us)
{
    const bool pending = rtu->received != 0 || rtu->line_error;
    return pending && now_us >= rtu->last_byte_us + config->frame_gap_us ? end_frame(rtu, config->unit) : 0u;
}

void ctl_rtu_answer(ctl_rtu* rtu, size_t size)
{
    rtu->answer_size = 0; /* an answer that was not taken is overtaken */
    if (rtu->request[0] == BROADCAST)
        return;
    rtu->answer[0] = rtu->request[0];
    if ((rtu->answer[1] & CTL_EXCEPTION_FLAG) != 0)
        rtu->exceptions += 1;
    rtu->answer_crc = CTL_CRC16_START;
    rtu->answer_summed = 0;
    rtu->answer_size = (uint32_t)size + 3;
    rtu->requests += 1;
}

void ctl_rtu_receive(ctl_rtu* rtu, const uint8_t* bytes, size_t size, uint64_t now_us)
{
    if (size == 0)
        return; /* `bytes` may be null then, which memcpy() does not allow */
    if (rtu->received < CTL_FRAME_BYTES) {
        const size_t space = CTL_FRAME_BYTES - rtu->received;
        const size_t part = size < space ? size : space;
        memcpy(&rtu->request[rtu->received], bytes, part);
        rtu->received_crc =
            ctl_crc16_bytes(rtu->received == 0 ? CTL_CRC16_START : rtu->received_crc, bytes, part);
    }
    /* One beyond the buffer is enough to know that the frame is too long. */
    rtu->received =
        size > CTL_FRAME_BYTES - rtu->received ? CTL_FRAME_BYTES + 1 : rtu->received + (uint32_t)size;
    rtu->last_byte_us = now_us;
}

void ctl_rtu_receive_error(ctl_rtu* rtu, uint64_t now_us)
{
    rtu->line_error = true;
    rtu->last_byte_us = now_us;
}

size_t ctl_rtu_take_answer(ctl_rtu* rtu, uint8_t* bytes, uint32_t most)
{
    const uint32_t size = rtu->answer_size;
    if (size == 0)
        return 0;
    const uint32_t left = size - 2u - rtu->answer_summed;
    const uint32_t part = left < most ? left : most;
    rtu->answer_crc = ctl_crc16_bytes(rtu->answer_crc, &rtu->answer[rtu->answer_summed], part);
    rtu->answer_summed += part;
    if (part != left)
        return 0;
    rtu->answer[size - 2u] = (uint8_t)(rtu->answer_crc & 0xFFu);
    rtu->answer[size - 1u] = (uint8_t)(rtu->answer_crc >> 8);
    memcpy(bytes, rtu->answer, size);
    rtu->answer_size = 0;
    return size;
}
