/* SPDX-License-Identifier: Apache-2.0 */
#include "bank/ctl_transfer.h"

#include "base/ctl_crc.h"
#include "base/ctl_words.h"

#include <string.h>

/* The transfer registers as written by the panel. */
enum { SESSION = 0, OPERATION = 1, BLOCK = 2, LENGTH = 3, DATA = 4 };
_Static_assert(CTL_GROUP_TRANSFER == DATA + CTL_BLOCK_REGISTERS, "the payload ends the group");
_Static_assert(CTL_MAX_TRANSFER_LENGTH == CTL_BLOCK_REGISTERS, "no block is longer than its payload");
_Static_assert(32u * CTL_TRANSFER_BLOCK_WORDS * CTL_BLOCK_REGISTERS >= CTL_BANK_REGISTERS,
               "there is a bit for each block of a bank");
_Static_assert(CTL_GROUP_TRANSFER_RESULT == 8u, "ctl_transfer_result() fills the group");

static uint32_t block_count(const ctl_transfer* transfer)
{
    return (transfer->length + CTL_BLOCK_REGISTERS - 1u) / CTL_BLOCK_REGISTERS;
}

static bool has_block(const ctl_transfer* transfer, uint32_t block)
{
    return (transfer->received_blocks[block / 32u] >> block % 32u & 1u) != 0;
}

static uint16_t next_missing(const ctl_transfer* transfer)
{
    const uint32_t blocks = block_count(transfer);
    uint32_t block = 0;
    while (block < blocks && has_block(transfer, block))
        ++block;
    return (uint16_t)block;
}

void ctl_transfer_discard(ctl_transfer* transfer)
{
    transfer->state = CTL_STAGED_STATE_EMPTY;
    transfer->session = 0;
    transfer->kind = 0;
    transfer->length = 0;
    memset(transfer->received_blocks, 0, sizeof transfer->received_blocks);
    transfer->staged_crc = 0;
    transfer->sealing = false;
    transfer->refused = (ctl_verdict){0};
}

void ctl_transfer_apply(ctl_transfer* transfer, ctl_banks* banks)
{
    ctl_banks_swap(banks, transfer->staged_crc);
    ctl_transfer_discard(transfer);
}

static uint16_t begin(ctl_transfer* transfer, const ctl_config* config, const uint16_t* request)
{
    const uint16_t kind = request[DATA];
    const uint16_t length = request[DATA + 1];
    if (request[LENGTH] != 3)
        return CTL_TRANSFER_RESULT_BAD_LENGTH;
    if (request[SESSION] == 0)
        return CTL_TRANSFER_RESULT_WRONG_SESSION;
    if (request[DATA + 2] != CTL_MAP_MAJOR)
        return CTL_TRANSFER_RESULT_WRONG_MAP_VERSION;
    if (kind > CTL_PROGRAM_KIND_LAST || (CTL_PROGRAM_KINDS & 1u << kind) == 0)
        return CTL_TRANSFER_RESULT_KIND_NOT_SUPPORTED;
    if (length <= CTL_BANK_HEADER_REGISTERS || length > ctl_bank_capacity(config))
        return CTL_TRANSFER_RESULT_BAD_LENGTH;
    /* The same transfer begun again goes on where it was interrupted. */
    if (transfer->state == CTL_STAGED_STATE_RECEIVING && transfer->session == request[SESSION] &&
        transfer->kind == kind && transfer->length == length)
        return CTL_TRANSFER_RESULT_ACCEPTED;
    ctl_transfer_discard(transfer);
    transfer->state = CTL_STAGED_STATE_RECEIVING;
    transfer->session = request[SESSION];
    transfer->kind = kind;
    transfer->length = length;
    return CTL_TRANSFER_RESULT_ACCEPTED;
}

static uint16_t receive_block(ctl_transfer* transfer, ctl_bank* shadow, const uint16_t* request)
{
    const uint32_t block = request[BLOCK];
    if (transfer->state != CTL_STAGED_STATE_RECEIVING)
        return CTL_TRANSFER_RESULT_NOT_RECEIVING;
    if (request[SESSION] != transfer->session)
        return CTL_TRANSFER_RESULT_WRONG_SESSION;
    if (transfer->sealing)
        return CTL_TRANSFER_RESULT_BUSY;
    if (block >= block_count(transfer))
        return CTL_TRANSFER_RESULT_BAD_BLOCK;
    const uint32_t first = block * CTL_BLOCK_REGISTERS;
    const uint32_t left = transfer->length - first;
    const uint32_t expected = left < CTL_BLOCK_REGISTERS ? left : CTL_BLOCK_REGISTERS;
    if (request[LENGTH] != expected)
        return CTL_TRANSFER_RESULT_BAD_LENGTH;
    memcpy(&shadow->registers[first], &request[DATA], expected * sizeof request[0]);
    transfer->received_blocks[block / 32u] |= 1u << block % 32u;
    transfer->refused = (ctl_verdict){0};
    return CTL_TRANSFER_RESULT_ACCEPTED;
}

static uint16_t seal(ctl_transfer* transfer, const uint16_t* request)
{
    if (transfer->state == CTL_STAGED_STATE_EMPTY)
        return CTL_TRANSFER_RESULT_NOT_RECEIVING;
    if (request[SESSION] != transfer->session)
        return CTL_TRANSFER_RESULT_WRONG_SESSION;
    if (transfer->state == CTL_STAGED_STATE_SEALED)
        return CTL_TRANSFER_RESULT_ACCEPTED;
    if (next_missing(transfer) != block_count(transfer))
        return CTL_TRANSFER_RESULT_BLOCKS_MISSING;
    if (transfer->sealing)
        return CTL_TRANSFER_RESULT_BUSY;
    if (transfer->refused.result != CTL_TRANSFER_RESULT_NONE) {
        transfer->detail = transfer->refused.detail;
        return transfer->refused.result;
    }
    transfer->sealing = true;
    transfer->checked = false;
    transfer->check = (ctl_row_check){0};
    transfer->crc = CTL_CRC32_START;
    transfer->crc_position = 0;
    return CTL_TRANSFER_RESULT_BUSY;
}

/* The next piece of the check of a bank that has come whole. */
static ctl_verdict check_piece(ctl_transfer* transfer, const ctl_bank* shadow, const ctl_config* config,
                               uint32_t registers)
{
    if (ctl_bank_kind(shadow) != transfer->kind)
        return ctl_refuse(CTL_TRANSFER_RESULT_BAD_HEADER, CTL_OFFSET_BANK_KIND);
    const ctl_verdict verdict =
        ctl_bank_check_some(shadow, config, transfer->length, &transfer->check, registers);
    transfer->checked = verdict.result == CTL_TRANSFER_RESULT_ACCEPTED;
    return transfer->checked ? ctl_refuse(CTL_TRANSFER_RESULT_BUSY, 0) : verdict;
}

static ctl_verdict crc_piece(ctl_transfer* transfer, const ctl_bank* shadow, uint32_t registers)
{
    const uint32_t left = transfer->length - transfer->crc_position;
    const uint32_t part = left < registers ? left : registers;
    transfer->crc = ctl_crc32_registers(transfer->crc, &shadow->registers[transfer->crc_position], part);
    transfer->crc_position += part;
    return ctl_refuse(part == left ? CTL_TRANSFER_RESULT_ACCEPTED : CTL_TRANSFER_RESULT_BUSY, 0);
}

void ctl_transfer_work(ctl_transfer* transfer, ctl_banks* banks, const ctl_config* config, uint32_t registers)
{
    const ctl_bank* shadow = ctl_staged_bank(banks);
    if (!transfer->sealing)
        return;
    const ctl_verdict verdict = transfer->checked ? crc_piece(transfer, shadow, registers)
                                                  : check_piece(transfer, shadow, config, registers);
    if (verdict.result == CTL_TRANSFER_RESULT_BUSY)
        return;
    transfer->sealing = false;
    if (transfer->operation == CTL_TRANSFER_OPERATION_SEAL) {
        transfer->result = verdict.result;
        transfer->detail = verdict.detail;
    }
    if (verdict.result != CTL_TRANSFER_RESULT_ACCEPTED) {
        transfer->refused = verdict;
        return;
    }
    transfer->staged_crc = ~transfer->crc;
    transfer->state = CTL_STAGED_STATE_SEALED;
}

static uint16_t carry_out(ctl_transfer* transfer, ctl_bank* shadow, const ctl_config* config,
                          const uint16_t* request)
{
    if (transfer->state == CTL_STAGED_STATE_ARMED)
        return CTL_TRANSFER_RESULT_STATE_REFUSES;
    switch (request[OPERATION]) {
    case CTL_TRANSFER_OPERATION_BEGIN:
        return begin(transfer, config, request);
    case CTL_TRANSFER_OPERATION_BLOCK:
        return receive_block(transfer, shadow, request);
    case CTL_TRANSFER_OPERATION_SEAL:
        return seal(transfer, request);
    default:
        return CTL_TRANSFER_RESULT_NONE;
    }
}

void ctl_transfer_operation(ctl_transfer* transfer, ctl_banks* banks, const ctl_config* config,
                            const uint16_t* request)
{
    transfer->operation = request[OPERATION];
    transfer->block = request[BLOCK];
    transfer->detail = 0;
    /* A bank that is still being saved is not to be changed. */
    const bool begins = request[OPERATION] == CTL_TRANSFER_OPERATION_BEGIN;
    if (begins && transfer->reader != NULL && transfer->reader == ctl_staged_bank(banks)) {
        transfer->result = CTL_TRANSFER_RESULT_BUSY;
        return;
    }
    transfer->result = carry_out(transfer, ctl_staged_bank(banks), config, request);
    while (transfer->sealing && config->work_registers == 0)
        ctl_transfer_work(transfer, banks, config, UINT32_MAX);
}

void ctl_transfer_read(const ctl_transfer* transfer, const ctl_bank* shadow, uint32_t first, uint16_t* values,
                       uint32_t count)
{
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t at = first + i;
        const bool is_here = at < transfer->length && has_block(transfer, at / CTL_BLOCK_REGISTERS);
        values[i] = is_here ? shadow->registers[at] : (uint16_t)0;
    }
}

void ctl_transfer_result(const ctl_transfer* transfer, uint16_t* registers)
{
    registers[0] = transfer->session;
    registers[1] = transfer->operation;
    registers[2] = transfer->block;
    registers[3] = transfer->result;
    registers[4] = transfer->detail;
    registers[5] = next_missing(transfer);
    ctl_put32(&registers[6], transfer->staged_crc);
}
