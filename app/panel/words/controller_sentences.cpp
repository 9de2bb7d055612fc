// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/controller_sentences.h"

#include "app/panel/kit/format.h"
#include "app/panel/words/alarm_catalogue.h"

#include <algorithm>
#include <cmath>

namespace campanel::panel {

QString ControllerSentences::inLanguage(std::string_view text)
{
    return QCoreApplication::translate("Protocol", std::string(text).c_str());
}

QString ControllerSentences::textOf(const modbus::EnumValue* row)
{
    const QString text = row && !row->text.empty() ? inLanguage(row->text) : QString();
    return text.contains(u"%1") ? text.arg(QString::fromUtf8(row->number)) : text;
}

QStringList ControllerSentences::texts(std::string_view enumName)
{
    QStringList texts;
    for (const modbus::EnumValue& row : modbus::valuesOf(enumName))
        texts << textOf(&row);
    return texts;
}

QStringList ControllerSentences::alarms(const modbus::StatusBlock& status)
{
    QStringList texts;
    const auto add = [&](const auto& bits, auto which) {
        for (const modbus::EnumValue& row : bits) {
            const auto bit = static_cast<decltype(which)>(row.value);
            const AlarmKind& kind = AlarmCatalogue::of(bit);
            if (status.has(bit) && kind.severity != AlarmSeverity::Notice) // those are normal after power-up
                texts << kind.sentence();
        }
    };
    add(modbus::faultBits, modbus::FaultBit());
    add(modbus::warningBits, modbus::WarningBit());
    return texts;
}

QString ControllerSentences::refusal(modbus::Refusal reason)
{
    if (modbus::findValue(reason))
        return text(reason);
    return tr("The controller reports reason %1, which this panel does not know. Update the panel.")
        .arg(static_cast<int>(reason));
}

QString ControllerSentences::programChange(const program::ProgramChange& change, double rateBagsPerMin)
{
    const QString text = undisturbedChange(change, rateBagsPerMin);
    if (change.productWaitS <= 0)
        return text;
    return tr("%1 A product under the first cut adds %2 s.")
        .arg(text, Format().number(change.productWaitS, 1));
}

QString ControllerSentences::undisturbedChange(const program::ProgramChange& change, double rateBagsPerMin)
{
    constexpr double noSlower = 0.995;
    const Format format;
    const QString rate = format.number(rateBagsPerMin, 1);
    const QString seconds = format.number(change.timeS, 1);
    const QString time = change.productWaitS > 0 ? tr("at least %1 s").arg(seconds) : tr("%1 s").arg(seconds);
    const bool hasBags = rateBagsPerMin > 0;
    if (change.way == program::ChangeWay::FollowsLine)
        return tr("The machine keeps following the line; the new recipe starts with the next cycle.");
    if (change.way == program::ChangeWay::LeavesLine)
        return tr("Stops at the end of a cycle, then follows the line again (%1 at its present speed).")
            .arg(time);
    if (change.shareBefore >= noSlower && change.shareBehind >= noSlower)
        return tr("The machine keeps running; the new recipe starts with the next cycle.");
    if (change.shareBefore >= noSlower)
        return hasBags ? tr("No slowing down. Speeds up to %1 bags/min within %2.").arg(rate, time)
                       : tr("No slowing down. Speeds up to full speed within %1.").arg(time);
    const QString percent = format.number(100 * change.shareBefore, change.shareBefore < 0.1 ? 1 : 0);
    const QString count = QString::number(std::max(1L, std::lround(change.cycles)));
    return hasBags
               ? tr("Slows down to %1 % (bags: %2, %3), then %4 bags/min.").arg(percent, count, time, rate)
               : tr("Slows down to %1 % (cycles: %2, %3), then full speed.").arg(percent, count, time);
}

QString ControllerSentences::scrapRange(const program::ChangePrice& price)
{
    const QString most = QString::number(price.maxScrap);
    return price.minScrap == price.maxScrap
               ? most
               : tr("%1 to %2", "numbers of bags").arg(QString::number(price.minScrap), most);
}

QString ControllerSentences::changePrice(const program::ChangePrice& price)
{
    const Format format;
    const QString scrap = tr("Scrap bags: %1; the first good bag within %2 s.")
                              .arg(scrapRange(price), format.number(price.maxSeconds, 1));
    if (price.maxSkipped == 0)
        return scrap;
    return tr("%1 Skipped cuts: up to %2, a bag of up to %3.", "%1: whole sentence")
        .arg(scrap, QString::number(price.maxSkipped),
             format.measure(price.longestBagMm, 0, QStringLiteral("mm")));
}

QString ControllerSentences::changeUnderWay(const program::ChangePrice& price, double bagLengthMm)
{
    const Format format;
    const QString length = format.compactMeasure(bagLengthMm, 0, 1, QStringLiteral("mm"));
    const QString seconds = format.number(price.maxSeconds, 0);
    return price.maxSkipped == 0
               ? tr("Changing to %1: scrap %2, up to %3 s").arg(length, scrapRange(price), seconds)
               : tr("Changing to %1: scrap %2, a bag of up to %4, up to %3 s")
                     .arg(length, scrapRange(price), seconds,
                          format.measure(price.longestBagMm, 0, QStringLiteral("mm")));
}

QString ControllerSentences::nextLength(const program::ChangeFilm& film)
{
    return film.toMm == film.fromMm
               ? QString()
               : QStringLiteral("← ") + Format().compactMeasure(film.toMm, 0, 1, QStringLiteral("mm"));
}

QString ControllerSentences::transferResult(const modbus::TransferAnswer& answer)
{
    const modbus::EnumValue* known = modbus::findValue(answer.result);
    if (!known)
        return {};
    const std::string number = std::to_string(answer.detail);
    modbus::EnumValue row = *known;
    row.number = number;
    return textOf(&row);
}

} // namespace campanel::panel
