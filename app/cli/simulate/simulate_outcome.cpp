// SPDX-License-Identifier: Apache-2.0
// Explains why a simulated run ended before its last bag, and what to do.
#include "app/cli/report.h"
#include "app/cli/simulate/simulate_figures.h"
#include "app/panel/words/alarm_catalogue.h"
#include "modbus/map/protocol.h"

#include <QStringList>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

// Returns the names of all bits set.
QStringList wordsOf(std::string_view enumeration, std::uint32_t bits)
{
    QStringList words;
    for (std::uint16_t bit = 0; bit < controller::alarmBits; ++bit) {
        if ((bits >> bit & 1u) == 0)
            continue;
        words << QString::fromStdString(modbus::enumText(enumeration, bit));
        if (enumeration == "WarningBit")
            words << panel::AlarmCatalogue::of(static_cast<modbus::WarningBit>(bit)).action();
    }
    return words;
}

QString sentenceOf(const controller::PackingResult& result)
{
    const auto code = static_cast<std::uint16_t>(result.detail);
    switch (result.end) {
    case controller::PackingEnd::Done:
        return {};
    case controller::PackingEnd::BadBank:
        return u"The controller does not accept the program: "_s +
               QString::fromStdString(modbus::enumText("TransferResult", code));
    case controller::PackingEnd::BadParameter:
        return u"The controller does not accept the parameter at 0x%1."_s.arg(result.detail, 4, 16,
                                                                              QChar(u'0'));
    case controller::PackingEnd::Refused:
        return u"The controller refuses to start: "_s +
               QString::fromStdString(modbus::enumText("Refusal", code));
    case controller::PackingEnd::Alarm:
        return u"After %1 bags: "_s.arg(result.bags) + wordsOf("WarningBit", result.detail).join(u' ');
    case controller::PackingEnd::Fault:
        return u"After %1 bags the machine went into fault: "_s.arg(result.bags) +
               wordsOf("FaultBit", result.detail).join(u' ');
    case controller::PackingEnd::NoBags:
        return u"After %1 bags, no bag was cut for hundreds of cycles: film or knife stood still. Check the supply of products."_s
            .arg(result.bags);
    }
    return {};
}

} // namespace

Outcome outcomeOf(const controller::PackingResult& result)
{
    if (result.end == controller::PackingEnd::Done)
        return {};
    return fail(ExitCode::Refused, sentenceOf(result));
}

} // namespace campanel::cli
