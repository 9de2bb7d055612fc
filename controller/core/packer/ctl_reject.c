/* SPDX-License-Identifier: Apache-2.0 */
#include "packer/ctl_reject.h"

bool ctl_packer_rejects(const ctl_packer* packer, bool first)
{
    const ctl_last_cut* last = &packer->last_cut;
    if (!ctl_packer_active(packer))
        return false;
    return first || last->bags > 1u || !last->had_products || (ctl_packer_tracks(packer) && !last->tracked);
}
