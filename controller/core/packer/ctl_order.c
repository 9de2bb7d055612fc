/* SPDX-License-Identifier: Apache-2.0 */
#include "packer/ctl_order.h"

#include "base/ctl_kept.h"
#include "base/ctl_words.h"
#include "ctl_registers.h"

#include <stddef.h>
#include <string.h>

/* What survives a power cut, in registers: the counts, and the lot beside them. */
#define KEPT_VERSION 1u
enum { LOT_NUMBER, LOT, LOT_REGISTERS = LOT + CTL_ORDER_LOT_REGISTERS };
enum {
    VERSION,
    STATE,
    NUMBER,
    ACTION,
    QUANTITY,
    CUT = QUANTITY + 2,
    COUNTS = CUT + 2,
    KEPT_REGISTERS = COUNTS + 2 * CTL_BAG_CLASSES
};
_Static_assert(2u * KEPT_REGISTERS <= CTL_KEPT_BYTES && 2u * LOT_REGISTERS <= CTL_KEPT_BYTES,
               "the order fits the records");

static void keep(ctl_order* order)
{
    uint16_t record[KEPT_REGISTERS];
    if (!ctl_keeps(order->board))
        return;
    record[VERSION] = KEPT_VERSION;
    record[STATE] = order->state;
    record[NUMBER] = order->number;
    record[ACTION] = order->action;
    ctl_put32(&record[QUANTITY], order->quantity);
    ctl_put32(&record[CUT], order->cut);
    for (uint32_t i = 0; i < CTL_BAG_CLASSES; ++i)
        ctl_put32(&record[COUNTS + 2u * i], order->counts[i]);
    order->kept = ctl_keep(order->board, CTL_KEPT_COUNTS, record, KEPT_REGISTERS);
}

static void keep_lot(const ctl_order* order)
{
    uint16_t record[LOT_REGISTERS];
    record[LOT_NUMBER] = order->number;
    memcpy(&record[LOT], order->lot, sizeof order->lot);
    (void)ctl_keep(order->board, CTL_KEPT_LOT, record, LOT_REGISTERS);
}

static void restore(ctl_order* order)
{
    uint16_t record[KEPT_REGISTERS];
    uint16_t lot[LOT_REGISTERS];
    if (!ctl_kept(order->board, CTL_KEPT_COUNTS, record, KEPT_REGISTERS) || record[VERSION] != KEPT_VERSION ||
        record[STATE] > CTL_ORDER_STATE_ENDED || record[ACTION] > CTL_ORDER_ACTION_STOP)
        return;
    order->state = record[STATE];
    order->number = record[NUMBER];
    order->action = record[ACTION];
    order->quantity = ctl_get32(&record[QUANTITY]);
    order->cut = ctl_get32(&record[CUT]);
    uint32_t known = 0;
    for (uint32_t i = 0; i < CTL_BAG_CLASSES; ++i) {
        order->counts[i] = ctl_get32(&record[COUNTS + 2u * i]);
        known += order->counts[i];
    }
    order->counts[CTL_BAG_REJECTED] += order->cut - known;
    if (ctl_kept(order->board, CTL_KEPT_LOT, lot, LOT_REGISTERS) && lot[LOT_NUMBER] == order->number)
        memcpy(order->lot, &lot[LOT], sizeof order->lot);
}

void ctl_order_init(ctl_order* order, const ctl_board* board)
{
    memset(order, 0, sizeof *order);
    order->board = board;
    order->kept = ctl_keeps(board);
    if (order->kept)
        restore(order);
}

static void complete(ctl_order* order)
{
    if (order->state == CTL_ORDER_STATE_ACTIVE && !order->on_the_way &&
        order->counts[CTL_BAG_GOOD] >= order->quantity)
        order->state = CTL_ORDER_STATE_COMPLETE;
}

uint16_t ctl_order_start(ctl_order* order, const ctl_packer* packer, uint16_t number, uint16_t action,
                         uint32_t quantity, const uint16_t* lot, const ctl_bank* bank)
{
    const bool goes_on = order->state == CTL_ORDER_STATE_ACTIVE;
    if (number == 0 || action > CTL_ORDER_ACTION_STOP || quantity == 0 || quantity > CTL_ORDER_MAX_QUANTITY)
        return CTL_REFUSAL_BAD_ARGUMENT;
    if (goes_on && number != order->number)
        return CTL_REFUSAL_ORDER_UNDER_WAY;
    if (order->board->port.feed == NULL || (bank != NULL && !ctl_packer_drives(packer, bank)))
        return CTL_REFUSAL_NO_BAGS;
    order->number = number;
    order->action = action;
    order->quantity = quantity;
    memcpy(order->lot, lot, sizeof order->lot);
    if (!goes_on) {
        order->state = CTL_ORDER_STATE_ACTIVE;
        order->on_the_way = false;
        order->cut = 0;
        memset(order->counts, 0, sizeof order->counts);
    }
    complete(order);
    keep_lot(order);
    keep(order);
    return CTL_REFUSAL_NONE;
}

static void take_newest(ctl_order* order, const ctl_packer* packer)
{
    if (!order->on_the_way)
        return;
    order->counts[packer->spoiled_behind ? CTL_BAG_REJECTED : order->newest] += 1;
    order->on_the_way = false;
}

uint16_t ctl_order_end(ctl_order* order, const ctl_packer* packer, uint16_t number)
{
    if (order->state != CTL_ORDER_STATE_ACTIVE || number != order->number)
        return CTL_REFUSAL_NO_ORDER;
    take_newest(order, packer);
    order->state = CTL_ORDER_STATE_ENDED;
    keep(order);
    return CTL_REFUSAL_NONE;
}

void ctl_order_bag(ctl_order* order, const ctl_packer* packer)
{
    if (order->state != CTL_ORDER_STATE_ACTIVE || !ctl_packer_active(packer))
        return;
    take_newest(order, packer);
    complete(order);
    if (order->state == CTL_ORDER_STATE_ACTIVE) {
        order->cut += 1;
        order->newest = ctl_packer_bag_class(packer);
        order->on_the_way = true;
    }
    keep(order);
}

void ctl_order_pass(ctl_order* order, const ctl_packer* packer)
{
    take_newest(order, packer);
    complete(order);
    keep(order);
}

uint32_t ctl_order_left(const ctl_order* order)
{
    const uint32_t good =
        order->counts[CTL_BAG_GOOD] + (order->on_the_way && order->newest == CTL_BAG_GOOD ? 1u : 0u);
    return good < order->quantity ? order->quantity - good : 0u;
}

void ctl_order_registers(const ctl_order* order, uint16_t* registers)
{
    uint16_t* at = registers;
    *at++ = order->state;
    *at++ = order->number;
    *at++ = order->action;
    *at++ = order->kept ? 1u : 0u;
    ctl_put32(at, order->quantity);
    ctl_put32(at + 2, order->counts[CTL_BAG_GOOD]);
    ctl_put32(at + 4, order->counts[CTL_BAG_REJECTED]);
    ctl_put32(at + 6, order->counts[CTL_BAG_EMPTY]);
    ctl_put32(at + 8, order->cut);
    at[10] = order->on_the_way ? 1u : 0u;
    memcpy(at + 11, order->lot, sizeof order->lot);
}
