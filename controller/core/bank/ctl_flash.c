/* SPDX-License-Identifier: Apache-2.0 */
/* A slot, high byte first: magic, sequence, generation (32 bits each), the number of parameters, these, the
 * bank's registers, CRC-32 of all before it. Slots of older versions have no number. */
#include "bank/ctl_flash.h"

#include "bank/ctl_check.h"
#include "base/ctl_crc.h"
#include "base/ctl_limits.h"
#include "base/ctl_words.h"

#include <string.h>

#define MAGIC 0x43414D34u            /* "CAM4" */
#define MAGIC_OF_MAP_1_2 0x43414D33u /* "CAM3" */
#define MAGIC_OF_MAP_1_1 0x43414D32u /* "CAM2" */
#define PARAMETERS_OF_MAP_1_2 38u
#define PARAMETERS_OF_MAP_1_1 10u
#define MAX_PARAMETERS 256u
#define BLANK 0xFFFFFFFFu
#define FIXED_REGISTERS 6u
#define HEAD_REGISTERS (FIXED_REGISTERS + CTL_GROUP_PARAMETER)
#define PARAMETER_BYTES (CTL_GROUP_PARAMETER * sizeof(uint16_t))
#define CHUNK_REGISTERS 32u

_Static_assert(CTL_GROUP_PARAMETER <= MAX_PARAMETERS, "a slot holds all parameters");

typedef struct {
    const ctl_port* port;
    uint32_t slot;
    uint32_t offset; /* bytes read or written so far */
    uint32_t crc;
    bool ok;
} slot_stream;

static void read_some(slot_stream* stream, uint16_t* registers, uint32_t count)
{
    const ctl_port* port = stream->port;
    uint8_t bytes[2 * CHUNK_REGISTERS];
    while (stream->ok && count != 0) {
        const uint32_t part = count < CHUNK_REGISTERS ? count : CHUNK_REGISTERS;
        stream->ok = port->flash_read(port->context, stream->slot, stream->offset, bytes, 2 * part);
        stream->crc = ctl_crc32_bytes(stream->crc, bytes, 2 * part);
        for (uint32_t i = 0; i < part; ++i)
            registers[i] = ctl_get_bytes16(&bytes[2 * i]);
        stream->offset += 2 * part;
        registers += part;
        count -= part;
    }
}

static void write_some(slot_stream* stream, const uint16_t* registers, uint32_t count)
{
    const ctl_port* port = stream->port;
    uint8_t bytes[2 * CHUNK_REGISTERS];
    while (stream->ok && count != 0) {
        const uint32_t part = count < CHUNK_REGISTERS ? count : CHUNK_REGISTERS;
        for (uint32_t i = 0; i < part; ++i)
            ctl_put_bytes16(&bytes[2 * i], registers[i]);
        stream->crc = ctl_crc32_bytes(stream->crc, bytes, 2 * part);
        stream->ok = port->flash_write(port->context, stream->slot, stream->offset, bytes, 2 * part);
        stream->offset += 2 * part;
        registers += part;
        count -= part;
    }
}

static slot_stream open_slot(const ctl_board* board, uint32_t slot)
{
    const slot_stream stream = {&board->port, slot, 0, CTL_CRC32_START, true};
    return stream;
}

/* Reads how many parameters follow; 0 when this is no slot. */
static uint32_t read_parameter_count(slot_stream* stream, uint32_t magic)
{
    uint16_t count = 0;
    switch (magic) {
    case MAGIC:
        read_some(stream, &count, 1);
        return count <= MAX_PARAMETERS ? count : 0;
    case MAGIC_OF_MAP_1_2:
        return PARAMETERS_OF_MAP_1_2;
    case MAGIC_OF_MAP_1_1:
        return PARAMETERS_OF_MAP_1_1;
    default:
        return 0;
    }
}

/* Parameters that an older slot does not hold keep their defaults; those of a newer version are left out. */
static void read_parameters(slot_stream* stream, uint32_t count, uint16_t* parameter)
{
    const uint32_t known = count < CTL_GROUP_PARAMETER ? count : CTL_GROUP_PARAMETER;
    read_some(stream, parameter, known);
    for (uint32_t i = known; i < count; ++i) {
        uint16_t unknown = 0;
        read_some(stream, &unknown, 1);
    }
}

/* Reads a slot into `head` and `bank`; false when its contents are not whole. */
static bool read_slot(const ctl_board* board, uint32_t slot, uint16_t* head, ctl_bank* bank)
{
    slot_stream stream = open_slot(board, slot);
    read_some(&stream, head, FIXED_REGISTERS);
    const uint32_t count = read_parameter_count(&stream, ctl_get32(head));
    if (!stream.ok || count == 0)
        return false;
    memcpy(&head[FIXED_REGISTERS], board->parameter, PARAMETER_BYTES);
    read_parameters(&stream, count, &head[FIXED_REGISTERS]);
    read_some(&stream, bank->registers, CTL_BANK_HEADER_REGISTERS);
    if (!stream.ok || ctl_bank_length(bank) > CTL_BANK_REGISTERS)
        return false;
    read_some(&stream, &bank->registers[CTL_BANK_HEADER_REGISTERS],
              ctl_bank_length(bank) - CTL_BANK_HEADER_REGISTERS);
    const uint32_t computed = ~stream.crc;
    uint16_t stored[2] = {0, 0};
    read_some(&stream, stored, 2);
    return stream.ok && ctl_get32(stored) == computed && ctl_parameters_valid(&head[FIXED_REGISTERS]) &&
           ctl_bank_check(bank, &board->config, ctl_bank_length(bank)).result == CTL_TRANSFER_RESULT_ACCEPTED;
}

void ctl_flash_load(ctl_flash* flash, const ctl_board* board, ctl_banks* banks, uint16_t* parameter)
{
    for (uint32_t slot = 0; slot < CTL_FLASH_SLOTS; ++slot) {
        uint16_t head[HEAD_REGISTERS];
        memset(head, 0xFF, sizeof head);
        ctl_bank* shadow = ctl_staged_bank(banks);
        if (!read_slot(board, slot, head, shadow)) {
            flash->slot_invalid = flash->slot_invalid || ctl_get32(head) != BLANK;
            continue;
        }
        const uint32_t sequence = ctl_get32(&head[2]);
        if (flash->any_valid && (int32_t)(sequence - flash->sequence) < 0)
            continue;
        flash->any_valid = true;
        flash->newest = (uint8_t)slot;
        flash->sequence = sequence;
        flash->saved_crc = ctl_bank_crc(shadow);
        banks->active ^= 1u;
        banks->has_active = true;
        banks->active_crc = flash->saved_crc;
        banks->generation = ctl_get32(&head[4]);
        memcpy(parameter, &head[FIXED_REGISTERS], PARAMETER_BYTES);
    }
}

bool ctl_flash_save(ctl_flash* flash, const ctl_board* board, const ctl_banks* banks)
{
    const uint32_t slot = flash->any_valid ? flash->newest ^ 1u : 0u;
    const ctl_bank* bank = ctl_active_bank(banks);
    const uint16_t count = CTL_GROUP_PARAMETER;
    uint16_t head[FIXED_REGISTERS];
    ctl_put32(head, MAGIC);
    ctl_put32(&head[2], flash->sequence + 1);
    ctl_put32(&head[4], banks->generation);

    slot_stream stream = open_slot(board, slot);
    stream.ok = board->port.flash_erase(board->port.context, slot);
    write_some(&stream, head, FIXED_REGISTERS);
    write_some(&stream, &count, 1);
    write_some(&stream, board->parameter, CTL_GROUP_PARAMETER);
    write_some(&stream, bank->registers, ctl_bank_length(bank));
    uint16_t crc[2];
    ctl_put32(crc, ~stream.crc);
    write_some(&stream, crc, 2);
    if (!stream.ok)
        return false;
    flash->any_valid = true;
    flash->newest = (uint8_t)slot;
    flash->sequence += 1;
    flash->saved_crc = banks->active_crc;
    return true;
}
