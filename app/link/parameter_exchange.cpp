// SPDX-License-Identifier: Apache-2.0
#include "app/link/parameter_exchange.h"

#include "modbus/map/codec.h"

#include <algorithm>

namespace campanel::link {

namespace {

const modbus::RegisterInfo* numericRegister(const std::string& name)
{
    const auto rows = modbus::registers();
    const auto found = std::ranges::find(rows, name, &modbus::RegisterInfo::name);
    const bool isNumeric = found != rows.end() && found->type != modbus::RegisterType::Text &&
                           found->type != modbus::RegisterType::Block;
    return isNumeric ? &*found : nullptr;
}

} // namespace

tl::expected<double, modbus::LinkError> exchangeParameter(modbus::RtuClient& client,
                                                          const ParameterRequest& request)
{
    const modbus::RegisterInfo* info = numericRegister(request.name);
    if (!info || (request.value && !modbus::isWrittenAlone(*info)))
        return tl::unexpected(modbus::LinkError{
            modbus::LinkErrorKind::ValueRefused, client.settings().port, request.name, {}, 0});
    if (request.value) {
        if (const auto written = client.writeParameter(*info, *request.value); !written)
            return tl::unexpected(written.error());
        return modbus::quantise(*info, *request.value).value_or(*request.value);
    }
    const auto kept = client.readProven(info->address, info->count);
    if (!kept)
        return tl::unexpected(kept.error());
    return modbus::RegisterReader(*kept, info->address).physical(*info);
}

ParameterEnd parameterEndAfter(const modbus::LinkError& error)
{
    switch (error.kind) {
    case modbus::LinkErrorKind::ValueRefused:
    case modbus::LinkErrorKind::Exception:
    case modbus::LinkErrorKind::RangeNotReadable:
        return ParameterEnd::Refused;
    case modbus::LinkErrorKind::NotOpen:
        return ParameterEnd::NotSent;
    default:
        return ParameterEnd::OutcomeUnknown;
    }
}

} // namespace campanel::link
