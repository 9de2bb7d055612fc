/* SPDX-License-Identifier: Apache-2.0 */
/* The commands of the panel, each carried out once: its counter is echoed with the result. */
#ifndef CTL_COMMAND_H
#define CTL_COMMAND_H

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

struct ctl_core;

/* Carries out the command in the command registers unless its counter is that of the last one. Refuses it
 * when its code was not in the same frame. */
void ctl_command(struct ctl_core* core, bool has_code);

#ifdef __cplusplus
}
#endif

#endif
