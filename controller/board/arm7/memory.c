/* SPDX-License-Identifier: Apache-2.0 */
/* The memory functions that the compiler may call, so that no C library is needed. Words where both sides are
 * aligned: ARMv4T has no unaligned access. */
#include <stdint.h>
#include <string.h>

typedef uint32_t __attribute__((may_alias)) word;

static int is_aligned(const void* one, const void* other)
{
    return (((uintptr_t)one | (uintptr_t)other) & (sizeof(word) - 1u)) == 0;
}

void* memcpy(void* restrict to, const void* restrict from, size_t size)
{
    uint8_t* target = to;
    const uint8_t* source = from;
    if (is_aligned(to, from)) {
        for (; size >= sizeof(word); size -= sizeof(word)) {
            *(word*)(void*)target = *(const word*)(const void*)source;
            target += sizeof(word);
            source += sizeof(word);
        }
    }
    while (size-- != 0)
        *target++ = *source++;
    return to;
}

void* memmove(void* to, const void* from, size_t size)
{
    uint8_t* target = to;
    const uint8_t* source = from;
    if (target <= source || target >= source + size)
        return memcpy(to, from, size);
    while (size-- != 0)
        target[size] = source[size];
    return to;
}

void* memset(void* to, int value, size_t size)
{
    uint8_t* target = to;
    const uint8_t byte = (uint8_t)value;
    if (is_aligned(to, to)) {
        for (; size >= sizeof(word); size -= sizeof(word), target += sizeof(word))
            *(word*)(void*)target = byte * 0x01010101u;
    }
    while (size-- != 0)
        *target++ = byte;
    return to;
}

int memcmp(const void* one, const void* other, size_t size)
{
    const uint8_t* left = one;
    const uint8_t* right = other;
    size_t i = 0;
    if (is_aligned(one, other)) {
        while (i + sizeof(word) <= size &&
               *(const word*)(const void*)&left[i] == *(const word*)(const void*)&right[i])
            i += sizeof(word);
    }
    for (; i < size; ++i) {
        if (left[i] != right[i])
            return left[i] < right[i] ? -1 : 1;
    }
    return 0;
}
