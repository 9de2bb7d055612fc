// SPDX-License-Identifier: Apache-2.0
// The controller's states, faults, warnings and refusals as translated text.
#pragma once

#include "app/link/link_values.h"
#include "app/program/change_film.h"

#include <QCoreApplication>
#include <QStringList>

namespace campanel::panel {

class ControllerSentences {
    Q_DECLARE_TR_FUNCTIONS(ControllerSentences)

public:
    // Returns the text of the value's row in the language; empty where the panel shows none.
    template <typename E> [[nodiscard]] static QString text(E value)
    {
        return textOf(modbus::findValue(value));
    }
    // Returns the sentence of an input or an output, in the language.
    template <typename Bit> [[nodiscard]] static QString purpose(Bit bit)
    {
        const modbus::EnumValue* row = modbus::findValue(bit);
        return row ? inLanguage(row->detail) : QString();
    }
    // Returns the texts of all values of an enumeration.
    [[nodiscard]] static QStringList texts(std::string_view enumName);
    // Translates a text that modbus/ marks.
    [[nodiscard]] static QString inLanguage(std::string_view text);
    // Returns two sentences of the alarm catalogue for each alarm: description and action. Faults come first.
    [[nodiscard]] static QStringList alarms(const modbus::StatusBlock& status);
    [[nodiscard]] static QString refusal(modbus::Refusal reason);
    // Returns what a running machine does at a change of program; rate 0: the program has no bags.
    [[nodiscard]] static QString programChange(const program::ProgramChange& change, double rateBagsPerMin);
    // Returns what such a change costs, and what Run says of it while it happens.
    [[nodiscard]] static QString changePrice(const program::ChangePrice& price);
    [[nodiscard]] static QString changeUnderWay(const program::ChangePrice& price, double bagLengthMm);
    // Returns the length of the bags of the new program, for the film, which has them at the left; empty: it
    // stays.
    [[nodiscard]] static QString nextLength(const program::ChangeFilm& film);
    [[nodiscard]] static QString transferResult(const modbus::TransferAnswer& answer);

private:
    [[nodiscard]] static QString scrapRange(const program::ChangePrice& price);
    [[nodiscard]] static QString textOf(const modbus::EnumValue* row);
    // Returns the same where no product waits under a cut.
    [[nodiscard]] static QString undisturbedChange(const program::ProgramChange& change,
                                                   double rateBagsPerMin);
};

} // namespace campanel::panel
