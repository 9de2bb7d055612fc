/* SPDX-License-Identifier: Apache-2.0 */
/* A slot, high byte first: magic, sequence, generation (32 bits each), the number of parameters, these, the
 * number of the registers of the group `master`, these, the number of the trims in the group `hand`, these,
 * the bank's registers, CRC-32 of all before it. Slots of older versions have no trims, no master either, or
 * no number at all. */
#include "bank/ctl_flash.h"

#include "bank/ctl_check.h"
#include "base/ctl_crc.h"
#include "base/ctl_limits.h"
#include "base/ctl_words.h"

#include <stddef.h>
#include <string.h>

#define MAGIC 0x43414D36u               /* "CAM6" */
#define MAGIC_WITHOUT_TRIMS 0x43414D35u /* "CAM5" */
#define MAGIC_OF_MAP_1_5 0x43414D34u    /* "CAM4" */
#define MAGIC_OF_MAP_1_2 0x43414D33u    /* "CAM3" */
#define MAGIC_OF_MAP_1_1 0x43414D32u    /* "CAM2" */
#define PARAMETERS_OF_MAP_1_2 38u
#define PARAMETERS_OF_MAP_1_1 10u
#define MAX_PARAMETERS 256u
#define BLANK 0xFFFFFFFFu
#define FIXED_REGISTERS 6u
#define MASTER_AT (FIXED_REGISTERS + CTL_GROUP_PARAMETER)
#define TRIMS_AT (MASTER_AT + CTL_GROUP_MASTER)
#define HEAD_REGISTERS (TRIMS_AT + CTL_TRIMS)
#define SAVED_MASTER_AT (MASTER_AT + 2u) /* behind both numbers, */
#define SAVED_TRIMS_AT (TRIMS_AT + 3u)   /* and behind all three */
#define MASTER_BYTES (CTL_GROUP_MASTER * sizeof(uint16_t))
#define TRIM_BYTES (CTL_TRIMS * sizeof(uint16_t))
#define PARAMETER_BYTES (CTL_GROUP_PARAMETER * sizeof(uint16_t))
#define CHUNK_REGISTERS 32u

_Static_assert(CTL_GROUP_PARAMETER <= MAX_PARAMETERS, "a slot holds all parameters");
_Static_assert(CTL_FLASH_HEAD_REGISTERS == HEAD_REGISTERS + 3u, "the head has the numbers, too");

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
    case MAGIC_WITHOUT_TRIMS:
    case MAGIC_OF_MAP_1_5:
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

/* Registers that an older slot does not hold keep their defaults; those of a newer version are left out. */
static void read_group(slot_stream* stream, uint32_t count, uint16_t* registers, uint32_t registers_count)
{
    const uint32_t known = count < registers_count ? count : registers_count;
    read_some(stream, registers, known);
    for (uint32_t i = known; i < count; ++i) {
        uint16_t unknown = 0;
        read_some(stream, &unknown, 1);
    }
}

/* Reads a group with its number before it; false when that is none. */
static bool read_counted_group(slot_stream* stream, uint16_t* registers, uint32_t registers_count)
{
    uint16_t count = 0;
    read_some(stream, &count, 1);
    if (count > MAX_PARAMETERS)
        return false;
    read_group(stream, count, registers, registers_count);
    return true;
}

/* Reads a slot into `head` and `bank`; false when its contents are not whole. */
static bool read_slot(const ctl_board* board, uint32_t slot, uint16_t* head, ctl_bank* bank)
{
    slot_stream stream = open_slot(board, slot);
    read_some(&stream, head, FIXED_REGISTERS);
    const uint32_t magic = ctl_get32(head);
    const uint32_t count = read_parameter_count(&stream, magic);
    if (!stream.ok || count == 0)
        return false;
    memcpy(&head[FIXED_REGISTERS], board->parameter, PARAMETER_BYTES);
    memcpy(&head[MASTER_AT], board->master, MASTER_BYTES);
    memcpy(&head[TRIMS_AT], ctl_trims(board), TRIM_BYTES);
    read_group(&stream, count, &head[FIXED_REGISTERS], CTL_GROUP_PARAMETER);
    const bool has_master = magic == MAGIC || magic == MAGIC_WITHOUT_TRIMS;
    if (has_master && !read_counted_group(&stream, &head[MASTER_AT], CTL_GROUP_MASTER))
        return false;
    if (magic == MAGIC && !read_counted_group(&stream, &head[TRIMS_AT], CTL_TRIMS))
        return false;
    read_some(&stream, bank->registers, CTL_BANK_HEADER_REGISTERS);
    if (!stream.ok || ctl_bank_length(bank) > CTL_BANK_STORAGE)
        return false;
    read_some(&stream, &bank->registers[CTL_BANK_HEADER_REGISTERS],
              ctl_bank_length(bank) - CTL_BANK_HEADER_REGISTERS);
    const uint32_t computed = ~stream.crc;
    uint16_t stored[2] = {0, 0};
    read_some(&stream, stored, 2);
    return stream.ok && ctl_get32(stored) == computed && ctl_parameters_valid(&head[FIXED_REGISTERS]) &&
           ctl_within_limits(&head[MASTER_AT], CTL_REG_MASTER_SOURCE, CTL_GROUP_MASTER) &&
           ctl_within_limits(&head[TRIMS_AT], CTL_REG_HAND_CUT, CTL_TRIMS) &&
           ctl_bank_check(bank, &board->config, ctl_bank_length(bank)).result == CTL_TRANSFER_RESULT_ACCEPTED;
}

void ctl_flash_load(ctl_flash* flash, const ctl_board* board, ctl_banks* banks, uint16_t* parameter,
                    uint16_t* master, uint16_t* trims)
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
        memcpy(master, &head[MASTER_AT], MASTER_BYTES);
        memcpy(trims, &head[TRIMS_AT], TRIM_BYTES);
    }
}

void ctl_flash_begin_save(ctl_flash* flash, const ctl_board* board, const ctl_banks* banks)
{
    ctl_flash_saving* saving = &flash->saving;
    saving->busy = true;
    saving->bank = ctl_active_bank(banks);
    saving->bank_crc = banks->active_crc;
    saving->written = 0;
    saving->slot = flash->any_valid ? flash->newest ^ 1u : 0u;
    saving->crc = CTL_CRC32_START;
    ctl_put32(saving->head, MAGIC);
    ctl_put32(&saving->head[2], flash->sequence + 1u);
    ctl_put32(&saving->head[4], banks->generation);
    saving->head[FIXED_REGISTERS] = CTL_GROUP_PARAMETER;
    memcpy(&saving->head[FIXED_REGISTERS + 1u], board->parameter, PARAMETER_BYTES);
    saving->head[MASTER_AT + 1u] = CTL_GROUP_MASTER;
    memcpy(&saving->head[SAVED_MASTER_AT], board->master, MASTER_BYTES);
    saving->head[TRIMS_AT + 2u] = CTL_TRIMS;
    memcpy(&saving->head[SAVED_TRIMS_AT], ctl_trims(board), TRIM_BYTES);
    if (!board->port.flash_erase(board->port.context, saving->slot))
        saving->bank = NULL; /* the next piece says so */
}

bool ctl_flash_saves(const ctl_flash* flash, const ctl_board* board, const ctl_banks* banks)
{
    const ctl_flash_saving* saving = &flash->saving;
    return saving->busy && saving->bank == ctl_active_bank(banks) &&
           memcmp(&saving->head[FIXED_REGISTERS + 1u], board->parameter, PARAMETER_BYTES) == 0 &&
           memcmp(&saving->head[SAVED_MASTER_AT], board->master, MASTER_BYTES) == 0 &&
           memcmp(&saving->head[SAVED_TRIMS_AT], ctl_trims(board), TRIM_BYTES) == 0;
}

/* Writes the next registers; false when the flash refused. */
static bool write_piece(ctl_flash_saving* saving, const ctl_board* board, const uint16_t* registers,
                        uint32_t count)
{
    slot_stream stream = open_slot(board, saving->slot);
    stream.offset = 2u * saving->written;
    stream.crc = saving->crc;
    write_some(&stream, registers, count);
    saving->crc = stream.crc;
    saving->written += count;
    return stream.ok;
}

static uint32_t least(uint32_t one, uint32_t other)
{
    return one < other ? one : other;
}

ctl_flash_progress ctl_flash_save_piece(ctl_flash* flash, const ctl_board* board)
{
    ctl_flash_saving* saving = &flash->saving;
    const ctl_port* port = &board->port;
    const ctl_flash_progress before =
        port->flash_progress == NULL ? CTL_FLASH_DONE : port->flash_progress(port->context);
    if (before == CTL_FLASH_BUSY)
        return CTL_FLASH_BUSY;
    bool ok = before == CTL_FLASH_DONE && saving->bank != NULL;
    const uint32_t length = ok ? CTL_FLASH_HEAD_REGISTERS + ctl_bank_length(saving->bank) : 0u;
    if (ok && saving->written < CTL_FLASH_HEAD_REGISTERS) {
        const uint32_t count = least(CHUNK_REGISTERS, CTL_FLASH_HEAD_REGISTERS - saving->written);
        ok = write_piece(saving, board, &saving->head[saving->written], count);
    } else if (ok && saving->written < length) {
        const uint32_t at = saving->written - CTL_FLASH_HEAD_REGISTERS;
        /* Flash of 32-bit words: from an odd register on, an odd number ends at a whole word. */
        ok = write_piece(saving, board, &saving->bank->registers[at],
                         least(CHUNK_REGISTERS - saving->written % 2u, length - saving->written));
    } else if (ok && saving->written == length) {
        uint16_t crc[2];
        ctl_put32(crc, ~saving->crc);
        ok = write_piece(saving, board, crc, 2);
    } else if (ok) {
        saving->busy = false;
        flash->any_valid = true;
        flash->newest = (uint8_t)saving->slot;
        flash->sequence += 1;
        flash->saved_crc = saving->bank_crc;
        return CTL_FLASH_DONE;
    }
    saving->busy = ok;
    return ok ? CTL_FLASH_BUSY : CTL_FLASH_FAILED;
}
