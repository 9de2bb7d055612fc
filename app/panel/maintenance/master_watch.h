// SPDX-License-Identifier: Apache-2.0
// `Maintenance.master` in QML: the encoder that leads the line, live while a page shows it, its machine data,
// and the measurement of the delay. It takes the lag of each cut; at two speeds a delay is offered.
#pragma once

#include "app/link/link_values.h"
#include "app/panel/kit/row_model.h"
#include "app/panel/kit/watched.h"
#include "app/panel/maintenance/master_fields.h"

#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

class Controller;

struct MasterRow {
    Q_GADGET
    Q_PROPERTY(QString name MEMBER name)
    Q_PROPERTY(QString value MEMBER value)

public:
    QString name{};
    QString value{}; // with its unit

    bool operator==(const MasterRow&) const = default;
};

class MasterWatch : public campanel::panel::Watched {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The master belongs to Maintenance")
    // True when the controller has an input for an encoder.
    Q_PROPERTY(bool available READ available NOTIFY changed FINAL)
    // True when an encoder is selected as the master.
    Q_PROPERTY(bool leads READ leads NOTIFY changed FINAL)
    // True when the encoder is a wheel on the film.
    Q_PROPERTY(bool wheel READ wheel NOTIFY changed FINAL)
    // The position of the encoder in its revolution; NaN while unknown.
    Q_PROPERTY(double angleDeg READ angleDeg NOTIFY changed FINAL)
    // Its counts per revolution and the film of one, for the drawing.
    Q_PROPERTY(QString countsText READ countsText NOTIFY changed FINAL)
    Q_PROPERTY(QString revolutionText READ revolutionText NOTIFY changed FINAL)
    Q_PROPERTY(QString stateText READ stateText NOTIFY changed FINAL)
    // The delay as measured so far, and the next step.
    Q_PROPERTY(QString delayText READ delayText NOTIFY changed FINAL)
    // The sentence in place of the page while there is nothing to show; else empty.
    Q_PROPERTY(QString emptyText READ emptyText NOTIFY changed FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* rows READ rows CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::MasterFields* fields READ fields CONSTANT FINAL)

public:
    using Rows = RowModel<MasterRow, &MasterRow::name>;

    // The controller must outlive the object.
    MasterWatch(Controller& controller, QObject* parent);

    [[nodiscard]] bool available() const { return line() && line()->isAvailable; }
    [[nodiscard]] bool leads() const { return m_fields.value("master.source") > 0; }
    [[nodiscard]] bool wheel() const { return m_fields.value("master.place") > 0; }
    [[nodiscard]] double angleDeg() const;
    [[nodiscard]] QString countsText() const;
    [[nodiscard]] QString revolutionText() const;
    [[nodiscard]] QString stateText() const;
    [[nodiscard]] QString delayText() const;
    [[nodiscard]] QString emptyText() const;
    [[nodiscard]] Rows* rows() { return &m_rows; }
    [[nodiscard]] MasterFields* fields() { return &m_fields; }

signals:
    void changed();

private:
    [[nodiscard]] bool isReported() const;
    void noteConnection();
    void noteFields();
    void takeLine();
    [[nodiscard]] const std::optional<modbus::MasterStatus>& line() const;
    void takeCut();
    void show();

    Controller& m_controller;
    MasterFields m_fields;
    Rows m_rows{this};
    program::MasterDelay m_delay;
    std::optional<std::uint32_t> m_bag; // the one of the last cut
    double m_presentMs = 0.0;           // the delay during the measurement
};

} // namespace campanel::panel
