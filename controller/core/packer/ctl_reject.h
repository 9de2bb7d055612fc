/* SPDX-License-Identifier: Apache-2.0 */
/* Which bags a packing machine is to reject. */
#ifndef CTL_REJECT_H
#define CTL_REJECT_H

#include "packer/ctl_packer.h"

#ifdef __cplusplus
extern "C" {
#endif

/* After ctl_packer_on_cut(): the bag that ended there has no known length (`first`: the knife was moved
 * otherwise before), is more than one bag, is empty, or its cut did not follow a mark although marks are
 * followed. */
bool ctl_packer_rejects(const ctl_packer* packer, bool first);

#ifdef __cplusplus
}
#endif

#endif
