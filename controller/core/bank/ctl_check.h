/* SPDX-License-Identifier: Apache-2.0 */
/* The check that a bank must pass before it may move the axis. */
#ifndef CTL_CHECK_H
#define CTL_CHECK_H

#include "base/ctl_bank.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Checks everything that must hold for the rows to be executed on this board; `length` registers were
 * received. Which rows are good is decided by the engine of the layout. */
ctl_verdict ctl_bank_check(const ctl_bank* bank, const ctl_config* config, uint32_t length);
/* The same in pieces: goes on by at most `registers` registers of rows. Returns CTL_TRANSFER_RESULT_BUSY
 * while there are more. */
ctl_verdict ctl_bank_check_some(const ctl_bank* bank, const ctl_config* config, uint32_t length,
                                ctl_row_check* check, uint32_t registers);

#ifdef __cplusplus
}
#endif

#endif
