// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/register_words.h"

#include "app/panel/kit/format.h"
#include "app/panel/words/master_sentences.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::panel {

QString RegisterWords::group(const QString& group)
{
    if (group == u"identity")
        return tr("Identity");
    if (group == u"clock")
        return tr("Clock");
    if (group == u"parameter")
        return tr("Parameters");
    if (group == u"master")
        return MasterSentences::title();
    if (group == u"status")
        return tr("Status");
    if (group == u"io")
        return tr("Inputs and outputs");
    if (group == u"exchange")
        return tr("Exchange");
    if (group == u"command")
        return tr("Command");
    if (group == u"result")
        return tr("Command result");
    if (group == u"transfer")
        return tr("Transfer");
    if (group == u"transfer_result")
        return tr("Transfer result");
    if (group == u"readback")
        return tr("Read-back");
    if (group == u"readback_result")
        return tr("Read-back result");
    if (group == u"active")
        return tr("Active program");
    if (group == u"staged")
        return tr("Staged program");
    return group;
}

QString RegisterWords::readOnlyReason(const QString& group)
{
    if (group == u"parameter" || group == u"master" || group == u"signal")
        return {};
    if (group == u"exchange")
        return tr("Read only: the panel writes this register with every status request.");
    if (group == u"command")
        return tr(
            "Read only: the command keys write this register, each command once and with its own counter.");
    if (group == u"transfer")
        return tr("Read only: written by downloads.");
    if (group == u"readback")
        return tr("Read only: the panel uses this register to read other registers.");
    if (group == u"active" || group == u"staged")
        return tr("Read only: changed by a program download.");
    if (group == u"clock")
        return tr("Read only: set by the panel after connecting.");
    return tr("Read only: only the controller writes this register.");
}

QString RegisterWords::value(const modbus::NamedValue& value)
{
    if (!value.info)
        return QString::fromUtf8(value.text());
    if (value.info->type == modbus::RegisterType::Text)
        return QString::fromUtf8(value.words);
    if (!value.physical)
        return QString::fromUtf8(value.text());
    const QString number = Format().number(*value.physical, decimals(*value.info));
    return value.info->unit.empty() ? number : number + u' ' + QString::fromUtf8(value.info->unit);
}

QString RegisterWords::outOfRange(const modbus::CodecError& error)
{
    constexpr int maxDecimals = 6;
    const Format format;
    const QString maximum = format.compact(error.maximum, 0, maxDecimals);
    return tr("%1 cannot be %2; the allowed range is %3 to %4. Enter another value.", "%1: register")
        .arg(QString::fromUtf8(error.registerName), format.compact(error.value, 0, maxDecimals),
             format.compact(error.minimum, 0, maxDecimals),
             error.unit.empty() ? maximum : maximum + u' ' + QString::fromUtf8(error.unit));
}

QString RegisterWords::raw(const modbus::NamedValue& value)
{
    constexpr int digitsOfRegister = 4;
    if (value.info && value.info->type == modbus::RegisterType::Text)
        return {};
    const auto bits = static_cast<quint32>(value.raw);
    return value.count > 1 ? Format::hex(bits, 2 * digitsOfRegister)
                           : Format::hex(bits & 0xFFFFU, digitsOfRegister);
}

QString RegisterWords::address(quint16 address)
{
    constexpr int digitsOfRegister = 4;
    return Format::hex(address, digitsOfRegister);
}

int RegisterWords::decimals(const modbus::RegisterInfo& info)
{
    return std::max(0, static_cast<int>(std::lround(-std::log10(info.scale))));
}

QString RegisterWords::type(const modbus::RegisterInfo& info)
{
    switch (info.type) {
    case modbus::RegisterType::U16:
        return u"u16"_s;
    case modbus::RegisterType::I16:
        return u"i16"_s;
    case modbus::RegisterType::U32:
        return u"u32"_s;
    case modbus::RegisterType::I32:
        return u"i32"_s;
    case modbus::RegisterType::Text:
        return u"text"_s;
    case modbus::RegisterType::Block:
        break;
    }
    return u"block"_s;
}

} // namespace campanel::panel
