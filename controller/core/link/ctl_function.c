/* SPDX-License-Identifier: Apache-2.0 */
#include "link/ctl_function.h"

#include "base/ctl_words.h"
#include "ctl_registers.h"
#include "link/ctl_map.h"
#include "link/ctl_rtu.h"

#include <string.h>

enum { READ = 3, WRITE_ONE = 6, WRITE = 16, READ_WRITE = 23 };
enum { MAX_READ = 125, MAX_WRITTEN = 123, MAX_WRITTEN_AND_READ = 121 };
/* Beside the values a frame has unit, function code, counts and CRC-16. */
_Static_assert(2 * MAX_READ + 5 <= CTL_FRAME_BYTES, "the longest answer fits");
_Static_assert(2 * MAX_WRITTEN + 9 <= CTL_FRAME_BYTES, "the longest write fits");
_Static_assert(2 * MAX_WRITTEN_AND_READ + 13 <= CTL_FRAME_BYTES, "the longest write and read fits");
_Static_assert(CTL_GROUP_STATUS <= MAX_READ && CTL_GROUP_READBACK_RESULT <= MAX_READ,
               "an answer has them whole");
_Static_assert(CTL_GROUP_TRANSFER <= MAX_WRITTEN_AND_READ, "a block is written in one frame");

static size_t exception(const uint8_t* request, uint8_t code, uint8_t* answer)
{
    answer[0] = (uint8_t)(request[0] | CTL_EXCEPTION_FLAG);
    answer[1] = code;
    return 2;
}

static uint8_t write_registers(struct ctl_core* core, uint16_t address, const uint8_t* bytes, uint32_t count)
{
    uint16_t values[MAX_WRITTEN];
    for (uint32_t i = 0; i < count; ++i)
        values[i] = ctl_get_bytes16(&bytes[2 * i]);
    return ctl_map_write(core, address, values, count);
}

static size_t read_registers(struct ctl_core* core, const uint8_t* request, const uint8_t* range,
                             uint8_t* answer)
{
    const uint32_t count = ctl_get_bytes16(&range[2]);
    if (count == 0 || count > MAX_READ)
        return exception(request, CTL_ILLEGAL_VALUE, answer);
    uint16_t values[MAX_READ];
    const uint8_t refused = ctl_map_read(core, ctl_get_bytes16(range), values, count);
    if (refused != 0)
        return exception(request, refused, answer);
    answer[0] = request[0];
    answer[1] = (uint8_t)(2 * count);
    for (uint32_t i = 0; i < count; ++i)
        ctl_put_bytes16(&answer[2 + 2 * i], values[i]);
    return 2 + 2 * count;
}

static size_t write_one(struct ctl_core* core, const uint8_t* request, uint8_t* answer)
{
    const uint8_t refused = write_registers(core, ctl_get_bytes16(&request[1]), &request[3], 1);
    if (refused != 0)
        return exception(request, refused, answer);
    memcpy(answer, request, 5);
    return 5;
}

static size_t write_many(struct ctl_core* core, const uint8_t* request, size_t size, uint8_t* answer)
{
    const uint32_t count = size < 6 ? 0 : ctl_get_bytes16(&request[3]);
    if (count == 0 || count > MAX_WRITTEN || request[5] != 2 * count || size != 6 + 2 * count)
        return exception(request, CTL_ILLEGAL_VALUE, answer);
    const uint8_t refused = write_registers(core, ctl_get_bytes16(&request[1]), &request[6], count);
    if (refused != 0)
        return exception(request, refused, answer);
    memcpy(answer, request, 5);
    return 5;
}

/* The range to read is checked first, so that a refused exchange has written nothing. */
static size_t read_write(struct ctl_core* core, const uint8_t* request, size_t size, uint8_t* answer)
{
    const uint32_t count = size < 10 ? 0 : ctl_get_bytes16(&request[7]);
    if (count == 0 || count > MAX_WRITTEN_AND_READ || request[9] != 2 * count || size != 10 + 2 * count)
        return exception(request, CTL_ILLEGAL_VALUE, answer);
    const uint32_t read = ctl_get_bytes16(&request[3]);
    uint8_t refused = read == 0 || read > MAX_READ
                          ? CTL_ILLEGAL_VALUE
                          : ctl_map_readable(core, ctl_get_bytes16(&request[1]), read);
    if (refused != 0)
        return exception(request, refused, answer);
    refused = write_registers(core, ctl_get_bytes16(&request[5]), &request[10], count);
    if (refused != 0)
        return exception(request, refused, answer);
    return read_registers(core, request, &request[1], answer);
}

size_t ctl_function(struct ctl_core* core, const uint8_t* request, size_t size, uint8_t* answer)
{
    switch (request[0]) {
    case READ:
        return size == 5 ? read_registers(core, request, &request[1], answer)
                         : exception(request, CTL_ILLEGAL_VALUE, answer);
    case WRITE_ONE:
        return size == 5 ? write_one(core, request, answer) : exception(request, CTL_ILLEGAL_VALUE, answer);
    case WRITE:
        return write_many(core, request, size, answer);
    case READ_WRITE:
        return read_write(core, request, size, answer);
    default:
        return exception(request, CTL_ILLEGAL_FUNCTION, answer);
    }
}
