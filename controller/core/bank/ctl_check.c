/* SPDX-License-Identifier: Apache-2.0 */
#include "bank/ctl_check.h"

#include "bank/ctl_inputs.h"
#include "engine/ctl_cam.h"
#include "engine/ctl_interval.h"
#include "engine/ctl_press.h"
#include "engine/ctl_step.h"

static ctl_verdict check_rows(const ctl_bank* bank, const ctl_config* config)
{
    switch (ctl_bank_layout(bank)) {
    case CTL_TABLE_LAYOUT_CAM_POINTS:
        return ctl_cam_check(bank, config);
    case CTL_TABLE_LAYOUT_INTERVALS:
        return ctl_interval_check(bank, config);
    case CTL_TABLE_LAYOUT_PRESS_STAGES:
        return ctl_press_check(bank, config);
    default:
        return ctl_step_check(bank, config);
    }
}

ctl_verdict ctl_bank_check(const ctl_bank* bank, const ctl_config* config, uint32_t length)
{
    const uint32_t bad_offset = ctl_bank_bad_header(bank, length);
    if (bad_offset != CTL_BANK_HEADER_REGISTERS)
        return ctl_refuse(CTL_TRANSFER_RESULT_BAD_HEADER, bad_offset);
    const ctl_verdict verdict = check_rows(bank, config);
    if (verdict.result != CTL_TRANSFER_RESULT_ACCEPTED)
        return verdict;
    const uint32_t wrong = ctl_wrong_input(bank, config);
    return wrong == CTL_NO_WRONG_INPUT ? verdict : ctl_refuse(CTL_TRANSFER_RESULT_BAD_SUM, wrong);
}
