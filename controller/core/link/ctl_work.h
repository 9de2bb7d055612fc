/* SPDX-License-Identifier: Apache-2.0 */
/* Long work that a slow processor does in pieces, one piece per slice: the seal of a download, the check of
 * the active bank before the axis sets off, a save. */
#ifndef CTL_WORK_H
#define CTL_WORK_H

#ifdef __cplusplus
extern "C" {
#endif

struct ctl_core;

/* Does the next piece of what is to be done. */
void ctl_work_slice(struct ctl_core* core);

#ifdef __cplusplus
}
#endif

#endif
