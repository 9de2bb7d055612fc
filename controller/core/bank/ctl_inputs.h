/* SPDX-License-Identifier: Apache-2.0 */
/* The rows of a program against the inputs in its header: what a panel reads back is what the machine does.
 */
#ifndef CTL_INPUTS_H
#define CTL_INPUTS_H

#include "base/ctl_bank.h"

#define CTL_NO_WRONG_INPUT 0u

/* Offset of the input that the rows contradict by more than one pulse or one timer tick, or
 * CTL_NO_WRONG_INPUT. Every other check of the bank has passed. The positions of a press are checked with its
 * rows. */
uint32_t ctl_wrong_input(const ctl_bank* bank, const ctl_config* config);

#endif
