/* SPDX-License-Identifier: Apache-2.0 */
/* Two slots in the first two sectors of the CFI flash (Intel's command set, words of 32 bits). */
#include "versatilepb/devices.h"

#define FLASH 0x34000000u
#define SECTOR_BYTES 0x40000u
#define COMMAND_ERASE 0x20u
#define COMMAND_CONFIRM 0xD0u
#define COMMAND_PROGRAM 0x40u
#define COMMAND_READ 0xFFu
#define READY 0x80u
#define FAILED 0x7Fu

static uint32_t slot_address(uint32_t slot)
{
    return FLASH + slot * SECTOR_BYTES;
}

bool flash_read(void* context, uint32_t slot, uint32_t offset, uint8_t* bytes, uint32_t size)
{
    (void)context;
    const volatile uint8_t* source = (const volatile uint8_t*)(slot_address(slot) + offset);
    for (uint32_t i = 0; i < size; ++i)
        bytes[i] = source[i];
    return true;
}

/* Waits for the end of an operation; returns whether it was done. */
static bool finish(uint32_t address)
{
    uint32_t status = 0;
    while (((status = DEVICE(address)) & READY) == 0) {
    }
    DEVICE(address) = COMMAND_READ;
    return (status & FAILED) == 0;
}

bool flash_erase(void* context, uint32_t slot)
{
    (void)context;
    DEVICE(slot_address(slot)) = COMMAND_ERASE;
    DEVICE(slot_address(slot)) = COMMAND_CONFIRM;
    return finish(slot_address(slot));
}

static bool program_word(uint32_t address, uint32_t word)
{
    DEVICE(address) = COMMAND_PROGRAM;
    DEVICE(address) = word;
    return finish(address) && DEVICE(address) == word;
}

bool flash_write(void* context, uint32_t slot, uint32_t offset, const uint8_t* bytes, uint32_t size)
{
    (void)context;
    for (uint32_t done = 0; done < size;) {
        const uint32_t address = slot_address(slot) + ((offset + done) & ~3u);
        uint32_t word = DEVICE(address);
        for (uint32_t lane = (offset + done) & 3u; lane < 4u && done < size; ++lane, ++done)
            word = (word & ~(0xFFu << 8u * lane)) | (uint32_t)bytes[done] << 8u * lane;
        if (!program_word(address, word))
            return false;
    }
    return true;
}
