// SPDX-License-Identifier: Apache-2.0
// `Service.dryRun` in QML: the edited recipe turned by hand on the screen. Computes the knife, the film or
// the axis at each angle of the master; sends nothing to the controller. NaN while there is no motion.
#pragma once

#include "app/panel/kit/figure_model.h"
#include "app/panel/kit/numbers.h"

#include <QObject>
#include <QPointF>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class Editor;
struct Solution;

class DryRun : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The dry run belongs to Maintenance")
    // True when the recipe has a motion, even one that exceeds a limit.
    Q_PROPERTY(bool available READ available NOTIFY changed FINAL)
    Q_PROPERTY(bool cutter READ cutter NOTIFY changed FINAL)
    Q_PROPERTY(double masterDeg READ masterDeg NOTIFY changed FINAL) // 0..360, one cycle
    Q_PROPERTY(double timeS READ timeS NOTIFY changed FINAL)         // within the cycle, at full speed
    Q_PROPERTY(bool playing READ playing WRITE setPlaying NOTIFY playingChanged FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* figures READ figures CONSTANT FINAL)

    // Figures of a rotary cutter: angles of the master, then of the knife shaft in this cycle.
    Q_PROPERTY(double syncStartMasterDeg READ syncStartMasterDeg NOTIFY changed FINAL)
    Q_PROPERTY(double syncEndMasterDeg READ syncEndMasterDeg NOTIFY changed FINAL)
    Q_PROPERTY(double cutMasterDeg READ cutMasterDeg NOTIFY changed FINAL)
    Q_PROPERTY(double knifeDeg READ knifeDeg NOTIFY changed FINAL)
    Q_PROPERTY(double syncStartDeg READ syncStartDeg NOTIFY changed FINAL)
    Q_PROPERTY(double syncEndDeg READ syncEndDeg NOTIFY changed FINAL)
    Q_PROPERTY(double cutDeg READ cutDeg NOTIFY changed FINAL)
    Q_PROPERTY(bool synchronous READ synchronous NOTIFY changed FINAL)
    Q_PROPERTY(double filmPositionMm READ filmPositionMm NOTIFY changed FINAL)
    Q_PROPERTY(double bagLengthMm READ bagLengthMm NOTIFY changed FINAL)
    // The bag boundaries as (mm before the knife, 0), as drawn by a FilmPicture.
    Q_PROPERTY(QList<QPointF> cuts READ cuts NOTIFY changed FINAL)

public:
    explicit DryRun(QObject* parent);

    // Sets the recipe to turn; it must outlive the object.
    void follow(const Editor& editor);

    [[nodiscard]] bool available() const;
    [[nodiscard]] bool cutter() const;
    [[nodiscard]] double masterDeg() const { return m_masterDeg; }
    [[nodiscard]] double timeS() const;
    [[nodiscard]] bool playing() const { return m_timer.isActive(); }
    void setPlaying(bool isPlaying);
    [[nodiscard]] FigureModel* figures() { return &m_figures; }
    [[nodiscard]] double syncStartMasterDeg() const;
    [[nodiscard]] double syncEndMasterDeg() const;
    [[nodiscard]] double cutMasterDeg() const;
    [[nodiscard]] double knifeDeg() const { return knifeDegAt(m_masterDeg); }
    [[nodiscard]] double syncStartDeg() const { return knifeDegAt(syncStartMasterDeg()); }
    [[nodiscard]] double syncEndDeg() const { return knifeDegAt(syncEndMasterDeg()); }
    [[nodiscard]] double cutDeg() const { return knifeDegAt(cutMasterDeg()); }
    [[nodiscard]] bool synchronous() const;
    [[nodiscard]] double filmPositionMm() const;
    [[nodiscard]] double bagLengthMm() const;
    [[nodiscard]] QList<QPointF> cuts() const;

    // Turns the master by this angle; past 360 degrees the next cycle begins.
    Q_INVOKABLE void turn(double deg);
    Q_INVOKABLE void toStart();
    // Starts a drag on the dial, relative to its center, and moves it.
    Q_INVOKABLE void grab(double x, double y);
    Q_INVOKABLE void drag(double x, double y);

signals:
    void changed();
    void playingChanged();

private:
    [[nodiscard]] const Solution* solution() const;
    [[nodiscard]] double knifeDegAt(double masterDeg) const;
    void update();
    void addCutterRows(QList<FigureRow>& rows) const;

    const Editor* m_editor = nullptr;
    FigureModel m_figures{this};
    QTimer m_timer;
    double m_masterDeg = 0;
    int m_cycle = 0;
    double m_fingerDeg = 0;
};

} // namespace campanel::panel
