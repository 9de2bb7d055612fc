/* SPDX-License-Identifier: Apache-2.0 */
#include "bank/ctl_check.h"

#include "bank/ctl_inputs.h"
#include "engine/ctl_cam.h"
#include "engine/ctl_interval.h"
#include "engine/ctl_press.h"
#include "engine/ctl_step.h"

static ctl_verdict check_rows(const ctl_bank* bank, const ctl_config* config, ctl_row_check* check,
                              uint32_t rows)
{
    switch (ctl_bank_layout(bank)) {
    case CTL_TABLE_LAYOUT_CAM_POINTS:
        return ctl_cam_check(bank, config, check, rows);
    case CTL_TABLE_LAYOUT_INTERVALS:
        return ctl_interval_check_some(bank, config, check, rows);
    case CTL_TABLE_LAYOUT_PRESS_STAGES:
        return ctl_press_check(bank, config);
    default:
        return ctl_step_check(bank, config, check, rows);
    }
}

ctl_verdict ctl_bank_check_some(const ctl_bank* bank, const ctl_config* config, uint32_t length,
                                ctl_row_check* check, uint32_t registers)
{
    const uint32_t bad_offset =
        check->row == 0 ? ctl_bank_bad_header(bank, config, length) : CTL_BANK_HEADER_REGISTERS;
    if (bad_offset != CTL_BANK_HEADER_REGISTERS)
        return ctl_refuse(CTL_TRANSFER_RESULT_BAD_HEADER, bad_offset);
    const uint32_t rows = registers / ctl_bank_row_registers(bank);
    const ctl_verdict verdict = check_rows(bank, config, check, rows == 0 ? 1u : rows);
    if (verdict.result != CTL_TRANSFER_RESULT_ACCEPTED)
        return verdict;
    const uint32_t wrong = ctl_wrong_input(bank, config);
    return wrong == CTL_NO_WRONG_INPUT ? verdict : ctl_refuse(CTL_TRANSFER_RESULT_BAD_SUM, wrong);
}

ctl_verdict ctl_bank_check(const ctl_bank* bank, const ctl_config* config, uint32_t length)
{
    ctl_row_check check = {0};
    return ctl_bank_check_some(bank, config, length, &check, UINT32_MAX);
}
