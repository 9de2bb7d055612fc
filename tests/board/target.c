/* SPDX-License-Identifier: Apache-2.0 */
/* The bench in QEMU, which semihosting starts with a number and ends. With -icount shift=10 an instruction
 * takes 1.024 us of the virtual time that the timer counts. */
#include "bench_target.h"
#include "versatilepb/devices.h"

#define UART_DATA 0x101F1000u
#define UART_CONTROL 0x101F1030u
#define UART_ENABLED 0x301u
#define TIMER_LOAD 0x101E3000u
#define TIMER_VALUE 0x101E3004u
#define TIMER_CONTROL 0x101E3008u
#define FREE_RUNNING 0x82u
#define NS_PER_INSTRUCTION 1024u
#define NS_PER_US 1000u

enum { COMMAND_LINE = 0x15, EXIT = 0x18 };
#define STOPPED ((void*)0x20026u)
#define FAILED ((void*)0x20023u)

void board_interrupt(void);
void board_interrupt(void) {}

static uint32_t ask_host(uint32_t number, void* data)
{
    register uint32_t operation __asm__("r0") = number;
    register void* argument __asm__("r1") = data;
#ifdef __thumb__
    __asm__ volatile("svc 0xAB" : "+r"(operation) : "r"(argument) : "memory", "lr");
#else
    __asm__ volatile("svc 0x123456" : "+r"(operation) : "r"(argument) : "memory", "lr");
#endif
    return operation;
}

/* The number behind the program's name. */
uint32_t bench_number(void)
{
    char text[80];
    struct {
        char* text;
        uint32_t size;
    } line = {text, sizeof text};
    uint32_t number = 0;
    if (ask_host(COMMAND_LINE, &line) != 0)
        return 0;
    for (const char* at = text; *at != 0; ++at) {
        if (*at == ' ')
            number = 0;
        else if (*at >= '0' && *at <= '9')
            number = 10u * number + (uint32_t)(*at - '0');
    }
    return number;
}

void bench_print(const char* text)
{
    while (*text != 0)
        DEVICE(UART_DATA) = (uint8_t)*text++;
}

uint32_t bench_counter(void)
{
    return (uint32_t)((uint64_t)~DEVICE(TIMER_VALUE) * NS_PER_US / NS_PER_INSTRUCTION);
}

void bench_exit(bool good)
{
    (void)ask_host(EXIT, good ? STOPPED : FAILED);
}

void bench_open(void)
{
    DEVICE(UART_CONTROL) = UART_ENABLED;
    DEVICE(TIMER_LOAD) = UINT32_MAX;
    DEVICE(TIMER_CONTROL) = FREE_RUNNING;
}
