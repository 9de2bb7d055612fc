/* SPDX-License-Identifier: Apache-2.0 */
#include "bank/ctl_banks.h"

#include "base/ctl_crc.h"

/* Registers of the active bank that the background check reads per slice: a full bank in under a second. */
#define CHECKED_PER_SLICE 2u

void ctl_banks_swap(ctl_banks* banks, uint32_t crc)
{
    banks->active ^= 1u;
    banks->has_active = true;
    banks->active_crc = crc;
    banks->generation += 1;
    banks->check_position = 0;
}

bool ctl_active_bank_intact(const ctl_banks* banks)
{
    if (banks->proof != CTL_PROOF_NONE)
        return banks->proof == CTL_PROOF_INTACT;
    return ctl_bank_length(ctl_active_bank(banks)) <= CTL_BANK_STORAGE &&
           ctl_bank_crc(ctl_active_bank(banks)) == banks->active_crc;
}

bool ctl_banks_check(ctl_banks* banks)
{
    const ctl_bank* bank = ctl_active_bank(banks);
    if (banks->check_position == 0) {
        banks->check_crc = CTL_CRC32_START;
        banks->check_length = ctl_bank_length(bank);
        banks->check_rows = bank->registers[CTL_OFFSET_BANK_ROW_COUNT];
    }
    /* The number of rows itself is damaged: found at once, because it leads out of the bank. */
    if (banks->check_length > CTL_BANK_STORAGE ||
        banks->check_rows != bank->registers[CTL_OFFSET_BANK_ROW_COUNT])
        return false;
    const uint32_t left = banks->check_length - banks->check_position;
    const uint32_t part = left < CHECKED_PER_SLICE ? left : CHECKED_PER_SLICE;
    banks->check_crc = ctl_crc32_registers(banks->check_crc, &bank->registers[banks->check_position], part);
    banks->check_position += part;
    if (banks->check_position < banks->check_length)
        return true;
    banks->check_position = 0;
    return ~banks->check_crc == banks->active_crc;
}
