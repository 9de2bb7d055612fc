/* SPDX-License-Identifier: Apache-2.0 */
/* A slot, high byte first: magic, sequence, generation (32 bits each), each of `groups` behind the number of
 * its registers, the bank's registers, CRC-32 of all before it. Slots of older versions end with an earlier
 * group, or have no number. */
#include "bank/ctl_flash.h"

#include "bank/ctl_check.h"
#include "base/ctl_crc.h"
#include "base/ctl_limits.h"
#include "base/ctl_words.h"

#include <stddef.h>
#include <string.h>

#define MAGIC 0x43414D36u             /* "CAM6" */
#define MAGIC_WITH_MASTER 0x43414D35u /* "CAM5" */
#define MAGIC_OF_MAP_1_5 0x43414D34u  /* "CAM4" */
#define MAGIC_OF_MAP_1_2 0x43414D33u  /* "CAM3" */
#define MAGIC_OF_MAP_1_1 0x43414D32u  /* "CAM2" */
#define PARAMETERS_OF_MAP_1_2 38u
#define PARAMETERS_OF_MAP_1_1 10u
#define MAX_REGISTERS 256u /* of a group */
#define BLANK 0xFFFFFFFFu
#define FIXED_REGISTERS 6u
#define CHUNK_REGISTERS 32u

typedef struct {
    uint16_t base;  /* address of its first register */
    uint16_t count; /* of its registers */
} saved_group;

static const saved_group groups[CTL_FLASH_GROUPS] = {
    {CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT, CTL_GROUP_PARAMETER},
    {CTL_REG_MASTER_SOURCE, CTL_GROUP_MASTER},
    {CTL_REG_HAND_CUT, CTL_TRIMS},
    {CTL_REG_SIGNAL_START_BUTTON_CONTACT, CTL_GROUP_SIGNAL},
};

_Static_assert(CTL_GROUP_PARAMETER <= MAX_REGISTERS, "a slot holds all parameters");
_Static_assert(CTL_FLASH_HEAD_REGISTERS == FIXED_REGISTERS + CTL_FLASH_GROUPS + CTL_GROUP_PARAMETER +
                                               CTL_GROUP_MASTER + CTL_TRIMS + CTL_GROUP_SIGNAL,
               "the head has all groups with their numbers");

static const uint16_t* values_of(const ctl_board* board, uint32_t group)
{
    const uint16_t* const values[CTL_FLASH_GROUPS] = {board->parameter, board->master, ctl_trims(board),
                                                      board->signal};
    return values[group];
}

/* Where the group's registers are in a head, behind their number. */
static uint32_t place_of(uint32_t group)
{
    uint32_t place = FIXED_REGISTERS + 1u;
    for (uint32_t before = 0; before < group; ++before)
        place += groups[before].count + 1u;
    return place;
}

static size_t bytes_of(uint32_t group)
{
    return groups[group].count * sizeof(uint16_t);
}

/* Puts the present values into a head. */
static void fill_head(uint16_t* head, const ctl_board* board)
{
    for (uint32_t group = 0; group < CTL_FLASH_GROUPS; ++group) {
        head[place_of(group) - 1u] = groups[group].count;
        memcpy(&head[place_of(group)], values_of(board, group), bytes_of(group));
    }
}

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

/* Returns how many groups follow; 0 when this is no slot. */
static uint32_t stored_groups(uint32_t magic)
{
    switch (magic) {
    case MAGIC:
        return CTL_FLASH_GROUPS;
    case MAGIC_WITH_MASTER:
        return 2;
    case MAGIC_OF_MAP_1_5:
    case MAGIC_OF_MAP_1_2:
    case MAGIC_OF_MAP_1_1:
        return 1;
    default:
        return 0;
    }
}

/* Reads how many registers of the next group follow. */
static uint16_t read_count(slot_stream* stream, uint32_t magic)
{
    uint16_t count = PARAMETERS_OF_MAP_1_1;
    if (magic == MAGIC_OF_MAP_1_2)
        count = PARAMETERS_OF_MAP_1_2;
    else if (magic != MAGIC_OF_MAP_1_1)
        read_some(stream, &count, 1);
    return count;
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

static bool within_limits(const uint16_t* head)
{
    bool within = true;
    for (uint32_t group = 0; group < CTL_FLASH_GROUPS; ++group)
        within = within && ctl_within_limits(&head[place_of(group)], groups[group].base, groups[group].count);
    return within;
}

/* Reads a slot into `head` and `bank`; false when its contents are not whole. */
static bool read_slot(const ctl_board* board, uint32_t slot, uint16_t* head, ctl_bank* bank)
{
    slot_stream stream = open_slot(board, slot);
    read_some(&stream, head, FIXED_REGISTERS);
    const uint32_t magic = ctl_get32(head);
    const uint32_t stored = stored_groups(magic);
    if (!stream.ok || stored == 0)
        return false;
    fill_head(head, board);
    for (uint32_t group = 0; group < stored; ++group) {
        const uint16_t count = read_count(&stream, magic);
        if (!stream.ok || count == 0 || count > MAX_REGISTERS)
            return false;
        read_group(&stream, count, &head[place_of(group)], groups[group].count);
    }
    read_some(&stream, bank->registers, CTL_BANK_HEADER_REGISTERS);
    if (!stream.ok || ctl_bank_length(bank) > CTL_BANK_STORAGE)
        return false;
    read_some(&stream, &bank->registers[CTL_BANK_HEADER_REGISTERS],
              ctl_bank_length(bank) - CTL_BANK_HEADER_REGISTERS);
    const uint32_t computed = ~stream.crc;
    uint16_t sum[2] = {0, 0};
    read_some(&stream, sum, 2);
    return stream.ok && ctl_get32(sum) == computed && within_limits(head) &&
           ctl_bank_check(bank, &board->config, ctl_bank_length(bank)).result == CTL_TRANSFER_RESULT_ACCEPTED;
}

void ctl_flash_load(ctl_flash* flash, const ctl_board* board, ctl_banks* banks,
                    uint16_t* const values[CTL_FLASH_GROUPS])
{
    for (uint32_t slot = 0; slot < CTL_FLASH_SLOTS; ++slot) {
        uint16_t head[CTL_FLASH_HEAD_REGISTERS];
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
        for (uint32_t group = 0; group < CTL_FLASH_GROUPS; ++group)
            memcpy(values[group], &head[place_of(group)], bytes_of(group));
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
    fill_head(saving->head, board);
    if (!board->port.flash_erase(board->port.context, saving->slot))
        saving->bank = NULL; /* the next piece says so */
}

bool ctl_flash_saves(const ctl_flash* flash, const ctl_board* board, const ctl_banks* banks)
{
    const ctl_flash_saving* saving = &flash->saving;
    bool same = saving->busy && saving->bank == ctl_active_bank(banks);
    for (uint32_t group = 0; group < CTL_FLASH_GROUPS; ++group)
        same = same && memcmp(&saving->head[place_of(group)], values_of(board, group), bytes_of(group)) == 0;
    return same;
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
