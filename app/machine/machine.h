// SPDX-License-Identifier: Apache-2.0
// `Machine` in QML: the live controller. Every number is NaN and every string empty while it is not known.
// Lives in the GUI thread; everything it knows came from the link as values.
#pragma once

#include <QList>
#include <QObject>
#include <QPointF>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

#include <limits>

class QJSEngine;
class QQmlEngine;

namespace campanel::machine {

class Machine : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

    Q_PROPERTY(Connection connection READ connection NOTIFY connectionChanged FINAL)
    Q_PROPERTY(QString connectionText READ connectionText NOTIFY connectionChanged FINAL)
    Q_PROPERTY(QString portName READ portName NOTIFY connectionChanged FINAL)
    Q_PROPERTY(bool simulated READ simulated NOTIFY connectionChanged FINAL)
    Q_PROPERTY(double statusPerSecond READ statusPerSecond NOTIFY qualityChanged FINAL)
    Q_PROPERTY(int linkQuality READ linkQuality NOTIFY qualityChanged FINAL)
    Q_PROPERTY(bool fresh READ fresh NOTIFY freshChanged FINAL)
    Q_PROPERTY(double ageMs READ ageMs NOTIFY ageChanged FINAL)

    Q_PROPERTY(State state READ state NOTIFY stateChanged FINAL)
    Q_PROPERTY(QString stateText READ stateText NOTIFY stateChanged FINAL)
    Q_PROPERTY(QString alarmText READ alarmText NOTIFY stateChanged FINAL)
    Q_PROPERTY(bool faulted READ faulted NOTIFY stateChanged FINAL)

    Q_PROPERTY(double rateBagsPerMin READ rateBagsPerMin NOTIFY liveChanged FINAL)
    Q_PROPERTY(double masterAngleDeg READ masterAngleDeg NOTIFY liveChanged FINAL)
    Q_PROPERTY(double knifeAngleDeg READ knifeAngleDeg NOTIFY liveChanged FINAL)
    Q_PROPERTY(double knifeSpeedMmPerS READ knifeSpeedMmPerS NOTIFY liveChanged FINAL)
    Q_PROPERTY(double followingErrorPulses READ followingErrorPulses NOTIFY liveChanged FINAL)
    Q_PROPERTY(double followingErrorMm READ followingErrorMm NOTIFY liveChanged FINAL)
    Q_PROPERTY(double pulseFrequencyHz READ pulseFrequencyHz NOTIFY liveChanged FINAL)
    Q_PROPERTY(double cycleCount READ cycleCount NOTIFY liveChanged FINAL)
    Q_PROPERTY(QList<QPointF> actualTrace READ actualTrace NOTIFY liveChanged FINAL)

    Q_PROPERTY(double bagCount READ bagCount NOTIFY bagChanged FINAL)
    Q_PROPERTY(double bagLengthMm READ bagLengthMm NOTIFY bagChanged FINAL)
    Q_PROPERTY(double bagDeviationMm READ bagDeviationMm NOTIFY bagChanged FINAL)
    Q_PROPERTY(double bagMeanMm READ bagMeanMm NOTIFY bagChanged FINAL)
    Q_PROPERTY(double bagScatterMm READ bagScatterMm NOTIFY bagChanged FINAL)
    Q_PROPERTY(QList<double> bagSeries READ bagSeries NOTIFY bagChanged FINAL)
    Q_PROPERTY(double bagToleranceMm READ bagToleranceMm CONSTANT FINAL)

    Q_PROPERTY(double generation READ generation NOTIFY programChanged FINAL)
    Q_PROPERTY(bool hasActiveProgram READ hasActiveProgram NOTIFY programChanged FINAL)
    Q_PROPERTY(QString activeName READ activeName NOTIFY programChanged FINAL)
    Q_PROPERTY(double activeVersion READ activeVersion NOTIFY programChanged FINAL)
    Q_PROPERTY(double activeBagLengthMm READ activeBagLengthMm NOTIFY programChanged FINAL)
    Q_PROPERTY(double activeRateBagsPerMin READ activeRateBagsPerMin NOTIFY programChanged FINAL)
    Q_PROPERTY(double cycleSeconds READ cycleSeconds NOTIFY programChanged FINAL)
    Q_PROPERTY(double syncStartDeg READ syncStartDeg NOTIFY programChanged FINAL)
    Q_PROPERTY(double syncEndDeg READ syncEndDeg NOTIFY programChanged FINAL)
    Q_PROPERTY(double cutAngleDeg READ cutAngleDeg NOTIFY programChanged FINAL)
    Q_PROPERTY(QVariant targetCurves READ targetCurves NOTIFY programChanged FINAL)

    Q_PROPERTY(bool canStart READ canStart NOTIFY commandsChanged FINAL)
    Q_PROPERTY(QString startBlockedReason READ startBlockedReason NOTIFY commandsChanged FINAL)
    Q_PROPERTY(bool canHome READ canHome NOTIFY commandsChanged FINAL)
    Q_PROPERTY(QString commandMessage READ commandMessage NOTIFY commandMessageChanged FINAL)

public:
    enum class Connection { Searching, Connecting, Connected, Lost, WrongDevice, PortProblem };
    Q_ENUM(Connection)
    enum class State { Unknown, Idle, Ready, Running, Stopping, Jogging, Homing, Fault };
    Q_ENUM(State)

    explicit Machine(QObject* parent);

    // The instance that attachToEngine() gave to this engine.
    static Machine* create(QQmlEngine* qmlEngine, QJSEngine* jsEngine);

    [[nodiscard]] Connection connection() const { return m_connection; }
    [[nodiscard]] QString connectionText() const { return {}; }
    [[nodiscard]] QString portName() const { return {}; }
    [[nodiscard]] bool simulated() const { return true; }
    [[nodiscard]] double statusPerSecond() const { return unknown; }
    [[nodiscard]] int linkQuality() const { return 0; }
    [[nodiscard]] bool fresh() const { return false; }
    [[nodiscard]] double ageMs() const { return unknown; }
    [[nodiscard]] State state() const { return State::Unknown; }
    [[nodiscard]] QString stateText() const { return {}; }
    [[nodiscard]] QString alarmText() const { return {}; }
    [[nodiscard]] bool faulted() const { return false; }
    [[nodiscard]] double rateBagsPerMin() const { return unknown; }
    [[nodiscard]] double masterAngleDeg() const { return unknown; }
    [[nodiscard]] double knifeAngleDeg() const { return unknown; }
    [[nodiscard]] double knifeSpeedMmPerS() const { return unknown; }
    [[nodiscard]] double followingErrorPulses() const { return unknown; }
    [[nodiscard]] double followingErrorMm() const { return unknown; }
    [[nodiscard]] double pulseFrequencyHz() const { return unknown; }
    [[nodiscard]] double cycleCount() const { return unknown; }
    [[nodiscard]] QList<QPointF> actualTrace() const { return {}; }
    [[nodiscard]] double bagCount() const { return unknown; }
    [[nodiscard]] double bagLengthMm() const { return unknown; }
    [[nodiscard]] double bagDeviationMm() const { return unknown; }
    [[nodiscard]] double bagMeanMm() const { return unknown; }
    [[nodiscard]] double bagScatterMm() const { return unknown; }
    [[nodiscard]] QList<double> bagSeries() const { return {}; }
    [[nodiscard]] double bagToleranceMm() const { return 1.0; }
    [[nodiscard]] double generation() const { return unknown; }
    [[nodiscard]] bool hasActiveProgram() const { return false; }
    [[nodiscard]] QString activeName() const { return {}; }
    [[nodiscard]] double activeVersion() const { return unknown; }
    [[nodiscard]] double activeBagLengthMm() const { return unknown; }
    [[nodiscard]] double activeRateBagsPerMin() const { return unknown; }
    [[nodiscard]] double cycleSeconds() const { return unknown; }
    [[nodiscard]] double syncStartDeg() const { return unknown; }
    [[nodiscard]] double syncEndDeg() const { return unknown; }
    [[nodiscard]] double cutAngleDeg() const { return unknown; }
    [[nodiscard]] QVariant targetCurves() const { return {}; }
    [[nodiscard]] bool canStart() const { return false; }
    [[nodiscard]] QString startBlockedReason() const { return {}; }
    [[nodiscard]] bool canHome() const { return false; }
    [[nodiscard]] QString commandMessage() const { return {}; }

    Q_INVOKABLE void start();
    Q_INVOKABLE void stop();
    Q_INVOKABLE void stopNow();
    Q_INVOKABLE void home();
    Q_INVOKABLE void resetFault();
    Q_INVOKABLE void dismissMessage();

signals:
    void connectionChanged();
    void qualityChanged();
    void freshChanged();
    void ageChanged();
    void stateChanged();
    void liveChanged();
    void bagChanged();
    void programChanged();
    void commandsChanged();
    void commandMessageChanged();

private:
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    Connection m_connection = Connection::Searching;
};

} // namespace campanel::machine
