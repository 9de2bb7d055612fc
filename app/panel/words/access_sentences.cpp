// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/access_sentences.h"

#include "app/store/users/pin_hash.h"

#include <algorithm>

namespace campanel::panel {

namespace {

bool hasOnlyDigits(const QString& pin)
{
    return std::ranges::all_of(pin, [](QChar digit) { return digit >= u'0' && digit <= u'9'; });
}

// Returns true when all digits have the same distance: 0000, 1234, 9876.
bool isRow(const QString& pin)
{
    const int step = pin[1].unicode() - pin[0].unicode();
    for (qsizetype i = 1; i < pin.size(); ++i) {
        if (pin[i].unicode() - pin[i - 1].unicode() != step)
            return false;
    }
    return std::abs(step) <= 1;
}

} // namespace

QString AccessSentences::level(Level level)
{
    switch (level) {
    case Level::Viewer:
        return tr("View only");
    case Level::Operator:
        return tr("Operator");
    case Level::Technician:
        return tr("Technician");
    case Level::Service:
        break;
    }
    return tr("Service");
}

QString AccessSentences::permission(Level level)
{
    switch (level) {
    case Level::Viewer:
        return tr("view everything, stop the machine");
    case Level::Operator:
        return tr("start, bag length, rate, recipes, alarms");
    case Level::Technician:
        return tr("plus cam, machine, packing, connection");
    case Level::Service:
        break;
    }
    return tr("plus users and single registers");
}

QString AccessSentences::refusal(Level needed)
{
    switch (needed) {
    case Level::Viewer:
    case Level::Operator:
        return tr("Log in to operate the machine. Stop needs no login.");
    case Level::Technician:
        return tr("This requires the level Technician or Service. Users with this level:");
    case Level::Service:
        break;
    }
    return tr("This requires the level Service. Users with this level:");
}

QString AccessSentences::locked(const store::StoreError& reason)
{
    return reason.kind == store::StoreError::Kind::PinsLost
               ? store::StoreErrorText::describe(reason)
               : tr("%1 Until then PINs cannot be checked: only operators can work.", "%1: whole sentences")
                     .arg(store::StoreErrorText::describe(reason));
}

int AccessSentences::minPinDigits(Level level)
{
    return level == Level::Service ? store::minServicePinDigits : store::minPinDigits;
}

QString AccessSentences::pinRefusal(const QString& pin, Level level)
{
    if (!hasOnlyDigits(pin) || pin.size() < minPinDigits(level) || pin.size() > store::maxPinDigits)
        return level == Level::Service
                   ? tr("A PIN of the level Service has %1 to %2 digits.")
                         .arg(minPinDigits(level))
                         .arg(store::maxPinDigits)
                   : tr("A PIN has %1 to %2 digits.").arg(minPinDigits(level)).arg(store::maxPinDigits);
    if (std::ranges::count(pin, pin[0]) == pin.size())
        return tr("A PIN of equal digits is easy to guess. Choose another PIN.");
    if (isRow(pin))
        return tr("Sequences such as 1234 are easy to guess. Choose another PIN.");
    return {};
}

QString AccessSentences::seconds(qint64 waitMs)
{
    const qint64 whole = (waitMs + 999) / 1000;
    return whole < 60 ? tr("%1 s").arg(whole) : tr("%1 min %2 s").arg(whole / 60).arg(whole % 60);
}

QString AccessSentences::wrongPin(qint64 waitMs)
{
    return waitMs > 0 ? tr("Wrong PIN. Try again in %1.").arg(seconds(waitMs)) : tr("Wrong PIN. Try again.");
}

QString AccessSentences::mustWait(qint64 waitMs)
{
    return tr("Locked after wrong PINs. Try again in %1.").arg(seconds(waitMs));
}

} // namespace campanel::panel
