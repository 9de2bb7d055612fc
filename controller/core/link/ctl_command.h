/* SPDX-License-Identifier: Apache-2.0 */
/* The commands of the panel, each carried out once: its counter is echoed with the result. */
#ifndef CTL_COMMAND_H
#define CTL_COMMAND_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct ctl_core;

/* Carries out the command in the command registers unless its counter is that of the last one. Refuses it
 * when its code was not in the same frame. */
void ctl_command(struct ctl_core* core, bool has_code);
/* Carries out the last command, which waited for the check of the bank. */
void ctl_command_checked(struct ctl_core* core, const uint16_t* request);
/* Carries out a press of the Start button, behind the check of the bank and a save that waits. The panel's
 * last command keeps its result; the next one overtakes the press. */
void ctl_command_button(struct ctl_core* core);
/* Takes over what the settings say of motors and film: at power-up, and from a standstill on. */
void ctl_machine_data_init(struct ctl_core* core);
void ctl_machine_data(struct ctl_core* core);
/* Answers the save with this counter, unless another command came meanwhile. */
void ctl_command_saved(struct ctl_core* core, uint16_t counter, bool done);
/* Goes on with the save that waited for the end of another one. */
void ctl_command_waited(struct ctl_core* core);

#ifdef __cplusplus
}
#endif

#endif
