// SPDX-License-Identifier: Apache-2.0
// The forecast of a change of program while the machine runs: from the two programs and the parameters of the
// controller, by the controller's own formula.
#pragma once

#include "app/panel/controller/parameter.h"
#include "app/program/change_film.h"
#include "app/program/program_image.h"

#include <QList>
#include <QObject>
#include <QPointF>

#include <optional>
#include <vector>

namespace campanel::panel {

class Controller;

class ChangeForecast final : public QObject {
    Q_OBJECT

public:
    ChangeForecast(Controller& controller, QObject* parent);

    // Forecasts the change from the active program to this one; null: there is none. Reads the parameters
    // that are unknown. There is no forecast at standstill, before the parameters are known, and for a
    // controller that does not have them.
    void update(const program::ProgramImage* wanted);

    // Returns what the running machine will do and what that costs, without a forecast that it changes with
    // the next cycle.
    [[nodiscard]] QString text() const;
    // Returns the speed of film or cam over the change as corners of a line, seconds and per cent of the
    // speed before it; empty without a forecast, and when the speed goes on.
    [[nodiscard]] QList<QPointF> speeds() const;
    // Returns what the change costs; empty without a packing line.
    [[nodiscard]] const std::optional<program::ChangePrice>& price() const { return m_price; }
    // Returns where the cuts of the change will be on the film; meaningful with a price.
    [[nodiscard]] const program::ChangeFilm& film() const { return m_film; }
    // Returns the reason why the running machine cannot change; empty when it can or without a forecast.
    [[nodiscard]] QString refusal() const;

signals:
    void changed();

private:
    [[nodiscard]] std::optional<program::ChangeParameters> parameters() const;
    [[nodiscard]] std::optional<program::LeadingLine> line() const;
    [[nodiscard]] program::PriceParameters priceParameters() const;

    Controller& m_controller;
    std::vector<Parameter*> m_parameters;
    std::vector<Parameter*> m_master; // an older controller does not have them
    bool m_isKnown = false;
    std::optional<program::ProgramChange> m_change; // known and empty: the steps cannot be kept
    std::optional<program::ChangePrice> m_price;    // of a packing line
    program::ChangeFilm m_film;                     // of the price
    double m_rateBagsPerMin = 0;                    // of the wanted program; 0: it has no bags
};

} // namespace campanel::panel
