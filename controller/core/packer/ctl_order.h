/* SPDX-License-Identifier: Apache-2.0 */
/* The order under way: counts the bags of a packing machine by what becomes of them. A bag is on the way from
 * its cut until its jaws have opened, or the next cut; until then it may still be spoiled. What is counted is
 * kept at each bag where the board can. good + rejected + empty + on the way = cut at every moment. */
#ifndef CTL_ORDER_H
#define CTL_ORDER_H

#include "base/ctl_board.h"
#include "ctl_registers.h"
#include "packer/ctl_packer.h"

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_ORDER_MAX_QUANTITY 1000000u
#define CTL_ORDER_LOT_REGISTERS CTL_GROUP_ORDER

typedef struct {
    const ctl_board* board;
    uint16_t state;  /* CTL_ORDER_STATE_... */
    uint16_t number; /* 0: none yet */
    uint16_t action; /* CTL_ORDER_ACTION_... */
    bool kept;       /* the last record is */
    bool on_the_way; /* the newest bag is, and is `newest` unless it is spoiled */
    ctl_bag_class newest;
    uint32_t quantity;
    uint32_t counts[CTL_BAG_CLASSES];
    uint32_t cut;
    uint16_t lot[CTL_ORDER_LOT_REGISTERS];
} ctl_order;

/* Power-up: the order that was kept. What was on the way then is rejected, for nobody knows what it became.
 */
void ctl_order_init(ctl_order* order, const ctl_board* board);
/* Starts an order of `quantity` good bags of the active program `bank`, NULL: none; or changes quantity,
 * action and lot of the one under way. Returns CTL_REFUSAL_... */
uint16_t ctl_order_start(ctl_order* order, const ctl_packer* packer, uint16_t number, uint16_t action,
                         uint32_t quantity, const uint16_t* lot, const ctl_bank* bank);
uint16_t ctl_order_end(ctl_order* order, const ctl_packer* packer, uint16_t number);
/* A bag was cut and is recorded. */
void ctl_order_bag(ctl_order* order, const ctl_packer* packer);
/* Between two bags; the jaws are open. */
void ctl_order_pass(ctl_order* order, const ctl_packer* packer);
static inline bool ctl_order_waits(const ctl_order* order)
{
    return order->on_the_way;
}
/* Returns true while the run has to end with the order. */
static inline bool ctl_order_stops(const ctl_order* order)
{
    return order->state == CTL_ORDER_STATE_ACTIVE && order->action == CTL_ORDER_ACTION_STOP;
}
/* Returns the bags that are still to be cut, if all on the way are good. */
uint32_t ctl_order_left(const ctl_order* order);
/* Writes the registers of the group `order_status`. */
void ctl_order_registers(const ctl_order* order, uint16_t* registers);

#ifdef __cplusplus
}
#endif

#endif
