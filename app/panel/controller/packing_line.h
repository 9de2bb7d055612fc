// SPDX-License-Identifier: Apache-2.0
// Film, marks, products and bags of a packing machine, as reported by its controller several times a second
// while a cutter's program is active. Unknown numbers are NaN and unknown texts empty.
#pragma once

#include "app/link/link.h"
#include "app/panel/controller/parameter.h"
#include "app/panel/kit/wide_counter.h"
#include "app/program/change_film.h"

#include <QList>
#include <QObject>
#include <QPointF>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

#include <array>
#include <optional>

namespace campanel::panel {

class Controller;

class PackingLine : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The packing line belongs to the Controller")
    // True with a cutter's program in a controller that reports its film, or did so before the connection was
    // lost.
    Q_PROPERTY(bool present READ present NOTIFY changed FINAL)
    // True when the last report is at most a second old.
    Q_PROPERTY(bool known READ known NOTIFY changed FINAL)
    Q_PROPERTY(bool fresh READ fresh NOTIFY changed FINAL)

    Q_PROPERTY(MarkState markState READ markState NOTIFY changed FINAL)
    // False once the controller's mark tracking is known to be off.
    Q_PROPERTY(bool marksWanted READ marksWanted NOTIFY changed FINAL)
    Q_PROPERTY(QString lastSkipText READ lastSkipText NOTIFY changed FINAL)
    // The film as a picture. Distances to the knife are in mm, with the film motor at filmPositionMm; lists
    // are empty while unknown. Marks are (distance, 1 when calculated), products (leading edge, trailing
    // edge); RunStatements has the cuts.
    Q_PROPERTY(double filmPositionMm READ filmPositionMm NOTIFY changed FINAL)
    Q_PROPERTY(double filmSpeedMmPerS READ filmSpeedMmPerS NOTIFY changed FINAL) // 0 at standstill
    Q_PROPERTY(bool knifeOpen READ knifeOpen NOTIFY changed FINAL)               // waits open for whole bags
    Q_PROPERTY(double sensorMm READ sensorMm NOTIFY changed FINAL) // distance of the mark sensor before the
                                                                   // knife
    Q_PROPERTY(
        double windowMm READ windowMm NOTIFY changed FINAL) // in both directions from the expected mark
    Q_PROPERTY(double nextMarkMm READ nextMarkMm NOTIFY changed FINAL) // expected position of the next mark
    Q_PROPERTY(QList<QPointF> seenMarks READ seenMarks NOTIFY changed FINAL)
    Q_PROPERTY(QList<QPointF> seenProducts READ seenProducts NOTIFY changed FINAL)

public:
    enum class MarkState { Unknown, Off, Searching, Aligning, Tracking };
    Q_ENUM(MarkState)

    // The controller must outlive the object.
    explicit PackingLine(Controller& controller);

    [[nodiscard]] bool present() const { return known() || recordsBags(); }
    [[nodiscard]] bool known() const { return m_status.has_value(); }
    [[nodiscard]] bool fresh() const;
    [[nodiscard]] MarkState markState() const;
    [[nodiscard]] bool marksWanted() const { return m_tracking.lastValue() != 0; }
    [[nodiscard]] QString lastSkipText() const;
    [[nodiscard]] int teachMarks() const { return m_status ? m_status->teachMarks : 0; }
    [[nodiscard]] double teachPitchMm() const;
    [[nodiscard]] double teachScatterMm() const;
    [[nodiscard]] double filmPositionMm() const;
    // Returns the film since power-up, or since the panel knows the line; does not wrap.
    [[nodiscard]] double filmTravelMm() const;
    [[nodiscard]] double filmSpeedMmPerS() const;
    [[nodiscard]] bool knifeOpen() const;
    [[nodiscard]] double sensorMm() const { return m_sensor.lastValue(); }
    [[nodiscard]] double windowMm() const { return m_window.lastValue(); }
    [[nodiscard]] double nextMarkMm() const;
    [[nodiscard]] QList<QPointF> cuts() const { return drawn(nextCuts()); }
    [[nodiscard]] std::vector<program::FilmCut> nextCuts() const;
    // Returns them as FilmPicture draws them.
    [[nodiscard]] static QList<QPointF> drawn(const std::vector<program::FilmCut>& cuts);
    [[nodiscard]] QList<QPointF> seenMarks() const;
    [[nodiscard]] QList<QPointF> seenProducts() const;

    // Measures the distances between the next marks; teachMarks counts up to that number.
    Q_INVOKABLE void teach(int marks);

    // Returns the last report, for the Machine and for lists of single bags.
    [[nodiscard]] const std::optional<modbus::PackerStatus>& status() const { return m_status; }
    // Returns the time when status() was read.
    [[nodiscard]] link::SteadyTime receivedAt() const { return m_receivedAt; }
    // Returns true when the controller records its bags: they arrive with bagRecorded() and not with its
    // status.
    [[nodiscard]] bool recordsBags() const;
    void noteConnection();
    void noteProgram();
    // Forgets which bag was reported last: it was begun under another program, and the next reading
    // identifies it.
    void forgetLastBag() { m_lastReportedBag.reset(); }

signals:
    void changed();
    // Emitted for each new bag, oldest first.
    void bagRecorded(const campanel::modbus::BagRecord& bag);
    // Emitted before it when the controller no longer has the bags since the last one.
    void bagsMissed();

private:
    void askWhenIdle();
    void ask();
    void readSetup();
    [[nodiscard]] std::array<Parameter*, 3> setup() const { return {&m_sensor, &m_window, &m_tracking}; }
    // Returns the size of the group in this controller.
    [[nodiscard]] std::uint16_t registers() const;
    void takeRead(const link::ReadOutcome& outcome);
    void reportBags();
    void forget();

    Controller& m_controller;
    Parameter& m_sensor;
    Parameter& m_window;
    Parameter& m_tracking;
    QTimer m_timer;
    std::optional<modbus::PackerStatus> m_status;
    WideCounter m_film; // 0.001 mm
    link::SteadyTime m_receivedAt;
    link::SteadyTime m_askedAt;
    bool m_isAsked = false;
    bool m_wasFresh = false;
    std::optional<std::uint32_t> m_lastReportedBag;
};

} // namespace campanel::panel
