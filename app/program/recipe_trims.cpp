// SPDX-License-Identifier: Apache-2.0
#include "app/program/recipe_trims.h"

#include "modbus/map/register_map.h"

namespace campanel::program {

double maxTrimMm(Trim trim)
{
    return modbus::findRegister(trimTable[static_cast<std::size_t>(trim)].registerName)->maximum;
}

} // namespace campanel::program
