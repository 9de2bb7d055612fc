/* SPDX-License-Identifier: Apache-2.0 */
#include "link/ctl_rtu.h"

#include "base/ctl_crc.h"
#include "ctl_core.h"
#include "link/ctl_function.h"

#include <string.h>

#define SHORTEST_FRAME 4u /* unit, function, CRC-16 */
#define BROADCAST 0u

static void answer(ctl_rtu* rtu, size_t pdu_size)
{
    rtu->answer[0] = rtu->request[0];
    if ((rtu->answer[1] & CTL_EXCEPTION_FLAG) != 0)
        rtu->exceptions += 1;
    const uint16_t crc = ctl_crc16(rtu->answer, pdu_size + 1);
    rtu->answer[pdu_size + 1] = (uint8_t)(crc & 0xFFu);
    rtu->answer[pdu_size + 2] = (uint8_t)(crc >> 8);
    rtu->answer_size = (uint32_t)pdu_size + 3;
    rtu->requests += 1;
}

static void end_frame(ctl_core* core)
{
    ctl_rtu* rtu = &core->rtu;
    const uint32_t size = rtu->received;
    const bool damaged = rtu->line_error || size < SHORTEST_FRAME || size > CTL_FRAME_BYTES;
    rtu->received = 0;
    rtu->line_error = false;
    if (damaged) {
        rtu->frame_errors += 1;
        return;
    }
    if (ctl_crc16(rtu->request, size) != 0) { /* over the frame with its CRC-16 it comes to 0 */
        rtu->crc_errors += 1;
        return;
    }
    const uint8_t unit = rtu->request[0];
    if (unit != core->config.unit && unit != BROADCAST)
        return;
    const size_t pdu_size = ctl_function(core, &rtu->request[1], size - 3, &rtu->answer[1]);
    rtu->answer_size = 0; /* an answer that was not taken is overtaken */
    if (unit != BROADCAST)
        answer(rtu, pdu_size);
}

void ctl_rtu_tick(ctl_core* core, uint64_t now_us)
{
    const ctl_rtu* rtu = &core->rtu;
    if ((rtu->received != 0 || rtu->line_error) && now_us >= rtu->last_byte_us + core->config.frame_gap_us)
        end_frame(core);
}

void ctl_receive(ctl_core* core, const uint8_t* bytes, size_t size, uint64_t now_us)
{
    ctl_rtu* rtu = &core->rtu;
    ctl_rtu_tick(core, now_us);
    if (rtu->received < CTL_FRAME_BYTES) {
        const size_t space = CTL_FRAME_BYTES - rtu->received;
        memcpy(&rtu->request[rtu->received], bytes, size < space ? size : space);
    }
    /* One beyond the buffer is enough to know that the frame is too long. */
    rtu->received =
        size > CTL_FRAME_BYTES - rtu->received ? CTL_FRAME_BYTES + 1 : rtu->received + (uint32_t)size;
    rtu->last_byte_us = now_us;
}

void ctl_receive_error(ctl_core* core, uint64_t now_us)
{
    ctl_rtu_tick(core, now_us);
    core->rtu.line_error = true;
    core->rtu.last_byte_us = now_us;
}

size_t ctl_take_answer(ctl_core* core, uint8_t* bytes)
{
    const size_t size = core->rtu.answer_size;
    memcpy(bytes, core->rtu.answer, size);
    core->rtu.answer_size = 0;
    return size;
}
