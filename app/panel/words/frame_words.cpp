// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/frame_words.h"

#include "app/panel/kit/format.h"
#include "app/panel/words/controller_sentences.h"
#include "app/panel/words/register_words.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::panel {

using modbus::DecodedFrame;
using modbus::FrameVerdict;

namespace {

const modbus::NamedValue* valueNamed(const DecodedFrame& frame, std::string_view name)
{
    const auto found = std::ranges::find_if(frame.values, [name](const modbus::NamedValue& value) {
        return value.info != nullptr && value.info->name == name;
    });
    return found == frame.values.end() ? nullptr : &*found;
}

QString valueOf(const DecodedFrame& frame, std::string_view name)
{
    const modbus::NamedValue* value = valueNamed(frame, name);
    return value ? RegisterWords::value(*value) : QString();
}

QString state(const DecodedFrame& frame)
{
    const modbus::NamedValue* value = valueNamed(frame, "status.state");
    const bool isKnown = value && value->raw <= static_cast<int>(modbus::State::Fault);
    return isKnown ? ControllerSentences::text(static_cast<modbus::State>(value->raw))
                   : valueOf(frame, "status.state");
}

QString assignment(const modbus::NamedValue& value)
{
    return QString::fromStdString(value.name()) + u" = "_s + RegisterWords::value(value);
}

bool starts(const std::optional<modbus::RegisterSpan>& span, std::string_view name)
{
    const auto known = modbus::findSpan(name);
    return span && known && span->address == known->address;
}

QString registerAt(quint16 address)
{
    const auto rows = modbus::registers();
    const auto row = std::ranges::find(rows, address, &modbus::RegisterInfo::address);
    return row == rows.end() ? RegisterWords::address(address) : RegisterWords::name(*row);
}

} // namespace

QString FrameWords::verdict(FrameVerdict verdict)
{
    switch (verdict) {
    case FrameVerdict::Sent:
        return tr("Sent");
    case FrameVerdict::Answer:
        return tr("Response");
    case FrameVerdict::Exception:
        return tr("Refused by the controller");
    case FrameVerdict::Foreign:
        return tr("Dropped: response to another request");
    case FrameVerdict::BadChecksum:
        return tr("Dropped: wrong checksum");
    case FrameVerdict::Malformed:
        return tr("Dropped: invalid frame");
    case FrameVerdict::Incomplete:
        return tr("Dropped: incomplete frame");
    case FrameVerdict::Silence:
        return tr("Response timeout");
    case FrameVerdict::Stray:
        return tr("Skipped: stray bytes");
    case FrameVerdict::Drained:
        return tr("Dropped: no request pending");
    case FrameVerdict::PortGone:
        return tr("Port removed");
    }
    return {};
}

QString FrameWords::exception(int code)
{
    return ControllerSentences::inLanguage(modbus::exceptionName(code));
}

QString FrameWords::question(const DecodedFrame& frame)
{
    if (starts(frame.written, "exchange.tag"))
        return tr("Status request, heartbeat %1").arg(valueOf(frame, "exchange.heartbeat"));
    if (starts(frame.written, "command.counter"))
        return tr("Command %1, counter %2", "name, number")
            .arg(valueOf(frame, "command.code"), valueOf(frame, "command.counter"));
    if (starts(frame.written, "transfer.session"))
        return tr("Transfer %1, block %2", "operation, number")
            .arg(valueOf(frame, "transfer.operation"), valueOf(frame, "transfer.block"));
    if (const modbus::NamedValue* from = valueNamed(frame, "readback.address"))
        return tr("Read %1, count %2")
            .arg(registerAt(static_cast<quint16>(from->raw)), valueOf(frame, "readback.count"));
    if (frame.written && !frame.values.empty())
        return tr("Write %1").arg(assignment(frame.values.front()));
    if (frame.read)
        return tr("Read %1, count %2")
            .arg(registerAt(frame.read->address), QString::number(frame.read->count));
    return tr("Sent: function %1").arg(frame.function.value_or(0));
}

QString FrameWords::answer(const DecodedFrame& frame)
{
    if (starts(frame.read, "status.tag")) {
        const modbus::NamedValue* angle = valueNamed(frame, "status.master_angle");
        const QString degrees =
            angle && angle->physical ? Format().number(*angle->physical, 2) + u'°' : Format::unknownText();
        return tr("Status: %1, %2", "state, angle").arg(state(frame), degrees);
    }
    if (starts(frame.read, "result.counter"))
        return tr("Command %1: %2", "name, what became of it")
            .arg(valueOf(frame, "result.code"), valueOf(frame, "result.status"));
    if (starts(frame.read, "transfer_result.session"))
        return tr("Transfer %1: %2", "operation, what became of it")
            .arg(valueOf(frame, "transfer_result.operation"), valueOf(frame, "transfer_result.result"));
    if (frame.values.empty())
        return tr("Response: done");
    // The values read follow the echo of the question.
    constexpr std::size_t echo = 3;
    const bool isReadback = starts(frame.read, "readback_result.tag") && frame.values.size() > echo;
    return tr("Response: %1").arg(assignment(frame.values[isReadback ? echo : 0]));
}

QString FrameWords::line(const modbus::FrameRecord& record)
{
    const DecodedFrame frame = modbus::decodeFrame(record);
    if (frame.exception)
        return tr("Exception %1: %2", "number, name").arg(*frame.exception).arg(exception(*frame.exception));
    if (frame.unit && record.verdict == FrameVerdict::Sent)
        return question(frame);
    if (frame.unit && record.verdict == FrameVerdict::Answer)
        return answer(frame);
    return record.length > 0 ? tr("%1, %2 bytes", "what, number")
                                   .arg(verdict(record.verdict), QString::number(record.length))
                             : verdict(record.verdict);
}

QStringList FrameWords::details(const modbus::FrameRecord& record)
{
    const DecodedFrame frame = modbus::decodeFrame(record);
    QStringList lines{verdict(record.verdict)};
    if (frame.unit)
        lines << tr("Unit %1, function %2").arg(*frame.unit).arg(frame.function.value_or(0));
    if (frame.exception)
        lines
            << tr("Exception %1: %2", "number, name").arg(*frame.exception).arg(exception(*frame.exception));
    for (const modbus::NamedValue& value : frame.values)
        lines << assignment(value);
    return lines;
}

QString FrameWords::bytes(const modbus::FrameRecord& record)
{
    return QString::fromStdString(modbus::hexBytes(record.bytes()));
}

} // namespace campanel::panel
