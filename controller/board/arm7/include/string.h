/* SPDX-License-Identifier: Apache-2.0 */
/* The part of <string.h> that the core uses; arm7/memory.c has the functions. */
#ifndef ARM7_STRING_H
#define ARM7_STRING_H

#include <stddef.h>

void* memcpy(void* restrict to, const void* restrict from, size_t size);
void* memmove(void* to, const void* from, size_t size);
void* memset(void* to, int value, size_t size);
int memcmp(const void* one, const void* other, size_t size);

#endif
