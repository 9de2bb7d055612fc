/* SPDX-License-Identifier: Apache-2.0 */
/* Two slots in the first two sectors of the CFI flash (Intel's command set, words of 32 bits). It erases and
 * programs by itself: erase and write begin only, and flash_progress() goes on with the next word. */
#include "versatilepb/devices.h"

#include <string.h>

#define FLASH 0x34000000u
#define SECTOR_BYTES 0x40000u
#define COMMAND_ERASE 0x20u
#define COMMAND_CONFIRM 0xD0u
#define COMMAND_PROGRAM 0x40u
#define COMMAND_CLEAR 0x50u /* the failures in the status */
#define COMMAND_READ 0xFFu
#define READY 0x80u
#define FAILED 0x7Fu
#define MAX_BYTES 64u /* of one write */

/* The job under way; an erase has no bytes. */
static struct {
    bool busy;
    uint32_t address; /* of the word under way */
    uint32_t word;
    uint8_t bytes[MAX_BYTES];
    uint32_t done; /* bytes, up to and with the word under way */
    uint32_t size;
} job;

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

bool flash_erase(void* context, uint32_t slot)
{
    (void)context;
    job.busy = true;
    job.address = slot_address(slot);
    job.word = UINT32_MAX;
    job.size = 0;
    job.done = 0;
    DEVICE(job.address) = COMMAND_ERASE;
    DEVICE(job.address) = COMMAND_CONFIRM;
    return true;
}

/* Begins to program the word that the next bytes lie in. */
static void begin_word(uint32_t address)
{
    job.address = address & ~3u;
    job.word = DEVICE(job.address);
    for (uint32_t lane = address & 3u; lane < 4u && job.done < job.size; ++lane, ++job.done)
        job.word = (job.word & ~(0xFFu << 8u * lane)) | (uint32_t)job.bytes[job.done] << 8u * lane;
    DEVICE(job.address) = COMMAND_PROGRAM;
    DEVICE(job.address) = job.word;
}

bool flash_write(void* context, uint32_t slot, uint32_t offset, const uint8_t* bytes, uint32_t size)
{
    (void)context;
    if (job.busy || size == 0 || size > MAX_BYTES)
        return false;
    memcpy(job.bytes, bytes, size);
    job.busy = true;
    job.size = size;
    job.done = 0;
    begin_word(slot_address(slot) + offset);
    return true;
}

ctl_flash_progress flash_progress(void* context)
{
    (void)context;
    if (!job.busy)
        return CTL_FLASH_DONE;
    const uint32_t status = DEVICE(job.address);
    if ((status & READY) == 0)
        return CTL_FLASH_BUSY;
    DEVICE(job.address) = COMMAND_CLEAR;
    DEVICE(job.address) = COMMAND_READ;
    const bool ok = (status & FAILED) == 0 && DEVICE(job.address) == job.word;
    job.busy = ok && job.done < job.size;
    if (job.busy)
        begin_word(job.address + 4u);
    if (!ok)
        return CTL_FLASH_FAILED;
    return job.busy ? CTL_FLASH_BUSY : CTL_FLASH_DONE;
}
