// SPDX-License-Identifier: Apache-2.0
// `Controller` in QML: the live controller. Unknown numbers are NaN and unknown strings empty. Lives in the
// GUI thread; all its data arrives from the link as values.
#pragma once

#include "app/link/link.h"
#include "app/panel/controller/actual_trace.h"
#include "app/panel/controller/availability.h"
#include "app/panel/controller/bag_statistics.h"
#include "app/panel/controller/controller_values.h"
#include "app/panel/controller/master_direction.h"
#include "app/panel/controller/master_setting.h"
#include "app/panel/controller/packing_line.h"
#include "app/panel/controller/parameter_field.h"
#include "app/panel/controller/run_statements.h"
#include "app/panel/controller/start_permit.h"
#include "app/panel/controller/status_rate.h"
#include "app/panel/controller/stroke_model.h"
#include "app/panel/controller/telemetry.h"
#include "app/panel/controller/torque_watch.h"
#include "app/panel/kit/access_check.h"
#include "app/panel/kit/axis_position.h"
#include "app/panel/kit/numbers.h"
#include "app/panel/kit/singleton.h"
#include "app/panel/recipe/controller_program.h"

#include <QDateTime>
#include <QHash>
#include <QList>
#include <QObject>
#include <QPointF>
#include <QStringList>
#include <QTimer>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string_view>

namespace campanel::panel {

class Settings;

class Controller : public QObject, public Singleton<Controller> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

    Q_PROPERTY(Connection connection READ connection NOTIFY connectionChanged FINAL)
    Q_PROPERTY(QString connectionText READ connectionText NOTIFY connectionChanged FINAL)
    Q_PROPERTY(bool simulated READ simulated NOTIFY connectionChanged FINAL)
    Q_PROPERTY(double statusPerSecond READ statusPerSecond NOTIFY qualityChanged FINAL)
    Q_PROPERTY(int linkQuality READ linkQuality NOTIFY qualityChanged FINAL)
    Q_PROPERTY(bool fresh READ fresh NOTIFY freshChanged FINAL)
    Q_PROPERTY(double ageMs READ ageMs NOTIFY ageChanged FINAL)

    // True while a Stop waits for the line, see stopWaitsText.
    Q_PROPERTY(bool stopWaits READ stopWaits NOTIFY connectionChanged FINAL)
    Q_PROPERTY(QString stopWaitsText READ stopWaitsText NOTIFY connectionChanged FINAL)

    Q_PROPERTY(State state READ state NOTIFY stateChanged FINAL)
    Q_PROPERTY(QString stateText READ stateText NOTIFY stateChanged FINAL)
    // Cause and action of each alarm of the controller, the most urgent first.
    Q_PROPERTY(QStringList alarmTexts READ alarmTexts NOTIFY stateChanged FINAL)
    Q_PROPERTY(bool faulted READ faulted NOTIFY stateChanged FINAL)

    Q_PROPERTY(campanel::panel::LiveValues live READ live NOTIFY liveChanged FINAL)
    Q_PROPERTY(campanel::panel::BagValues bags READ bags NOTIFY bagChanged FINAL)
    Q_PROPERTY(campanel::panel::ActiveProgramValues active READ active NOTIFY programChanged FINAL)
    Q_PROPERTY(QList<QPointF> actualTrace READ actualTrace NOTIFY liveChanged FINAL)

    Q_PROPERTY(campanel::panel::MasterDirection* direction READ direction CONSTANT FINAL)
    // The master of the cycles by the settings: the clock, or an encoder of the line.
    Q_PROPERTY(campanel::panel::MasterSetting* masterSetting READ masterSetting CONSTANT FINAL)
    // The packing line, only for a rotary cutter.
    Q_PROPERTY(campanel::panel::PackingLine* packing READ packing CONSTANT FINAL)
    // The numbers of its registers by their names.
    Q_PROPERTY(campanel::panel::Telemetry* telemetry READ telemetry CONSTANT FINAL)
    // The sentences of Run about the machine.
    Q_PROPERTY(campanel::panel::RunStatements* run READ run CONSTANT FINAL)
    // The torque of the axis, of any program but a press's.
    Q_PROPERTY(campanel::panel::TorqueWatch* torque READ torque CONSTANT FINAL)
    // The figures of a press.
    Q_PROPERTY(QStringList stageNames READ stageNames NOTIFY stateChanged FINAL)
    Q_PROPERTY(campanel::panel::StrokeModel* strokes READ strokes CONSTANT FINAL)

    Q_PROPERTY(bool canStart READ canStart NOTIFY commandsChanged FINAL)
    Q_PROPERTY(QString startBlockedReason READ startBlockedReason NOTIFY commandsChanged FINAL)
    Q_PROPERTY(campanel::panel::StartPermit* startPermit READ startPermit CONSTANT FINAL)
    Q_PROPERTY(QString commandMessage READ commandMessage NOTIFY commandMessageChanged FINAL)

public:
    enum class Connection { Searching, Connecting, Connected, Lost, WrongDevice, PortProblem };
    Q_ENUM(Connection)
    enum class State { Unknown, Idle, Ready, Running, Stopping, Jogging, Homing, Fault };
    Q_ENUM(State)

    // The age from which data is gray on the screen.
    static constexpr std::chrono::milliseconds freshFor{1000};

    using Clock = std::function<link::SteadyTime()>;
    using WallClock = std::function<QDateTime()>;

    // Link and settings must outlive the object. Connects only after open().
    Controller(link::Link& link, Settings& settings, QObject* parent);

    // Connects with the settings, now and whenever they change.
    void open();
    // Sets a clock for tests; the default is the steady clock.
    void setClock(Clock clock);
    void setWallClock(WallClock clock) { m_wallClock = std::move(clock); }

    [[nodiscard]] Connection connection() const;
    [[nodiscard]] QString connectionText() const;
    [[nodiscard]] QString portName() const { return m_report.portName; }
    [[nodiscard]] const Settings& settings() const { return m_settings; }
    [[nodiscard]] bool simulated() const { return m_report.simulated; }
    [[nodiscard]] bool stopWaits() const { return m_report.pendingStop.has_value(); }
    [[nodiscard]] QString stopWaitsText() const;
    [[nodiscard]] double statusPerSecond() const;
    [[nodiscard]] int linkQuality() const;
    [[nodiscard]] bool fresh() const { return m_fresh; }
    [[nodiscard]] double ageMs() const;
    [[nodiscard]] State state() const;
    // Returns true while the connected machine moves.
    [[nodiscard]] bool isMoving() const;
    [[nodiscard]] QString stateText() const;
    [[nodiscard]] QStringList alarmTexts() const;
    [[nodiscard]] QString alarmText() const { return alarmTexts().join(QLatin1Char('\n')); }
    [[nodiscard]] bool faulted() const;
    [[nodiscard]] LiveValues live() const;
    [[nodiscard]] BagValues bags() const;
    [[nodiscard]] ActiveProgramValues active() const;
    [[nodiscard]] QList<QPointF> actualTrace() const { return m_trace.points(); }
    [[nodiscard]] MasterDirection* direction() { return &m_direction; }
    [[nodiscard]] MasterSetting* masterSetting() { return &m_masterSetting; }
    [[nodiscard]] PackingLine* packing() { return &m_packing; }
    [[nodiscard]] Telemetry* telemetry() { return &m_telemetry; }
    [[nodiscard]] RunStatements* run() { return &m_run; }
    [[nodiscard]] TorqueWatch* torque() { return &m_torque; }
    [[nodiscard]] QStringList stageNames() const;
    [[nodiscard]] StrokeModel* strokes() { return &m_strokes; }
    // Returns the position of the axis, which does not wrap.
    [[nodiscard]] const AxisPosition& axisPosition() const { return m_axisPosition; }
    [[nodiscard]] double generation() const;
    [[nodiscard]] bool canStart() const { return startBlockedReason().isEmpty(); }
    [[nodiscard]] QString startBlockedReason() const { return blockedReason(Action::Start); }
    [[nodiscard]] bool startIsHeld() const;
    // Returns why the controller would refuse the command according to its last status; empty: it would
    // accept it.
    [[nodiscard]] QString blockedReason(Action action) const;
    // Returns what the panel permits now, the bits of exchange.permit.
    [[nodiscard]] std::uint16_t permit() const;
    [[nodiscard]] StartPermit* startPermit() { return &m_startPermit; }
    // Sets what blocks Start beyond the controller's own rules: a sentence, empty while nothing does. Emit
    // commandsChanged() when it changes.
    void setStartInterlock(std::function<QString()> reason) { m_startInterlock = std::move(reason); }
    [[nodiscard]] QString commandMessage() const { return m_commandMessage; }

    Q_INVOKABLE void start();
    // Stops at the end of the cycle; pressed again while stopping: at once. Without a connection the Stop
    // waits for the line.
    Q_INVOKABLE void stop();
    Q_INVOKABLE void withdrawStop();
    Q_INVOKABLE void home();
    Q_INVOKABLE void resetFault();
    Q_INVOKABLE void dismissMessage();

    // Returns the permissions of the person at the panel. Start, home, reset and a withdrawn Stop need an
    // operator; Stop is for everybody.
    [[nodiscard]] AccessCheck& accessCheck() { return m_access; }

    // Returns the link, for the Editor and the Alarms.
    [[nodiscard]] link::Link& link() { return m_link; }
    [[nodiscard]] const link::LinkReport& report() const { return m_report; }
    [[nodiscard]] link::SteadyTime now() const { return m_clock(); }
    [[nodiscard]] bool isConnected() const { return m_report.state == link::LinkState::Connected; }
    [[nodiscard]] const std::optional<modbus::Identity>& identity() const { return m_report.identity; }
    [[nodiscard]] const std::optional<modbus::StatusBlock>& status() const { return m_status; }
    [[nodiscard]] const std::shared_ptr<const ControllerProgram>& program() const { return m_program; }
    // Returns why there is no program, or that there is one.
    [[nodiscard]] RunFacts::Program programState() const;
    [[nodiscard]] const BagStatistics& bagStatistics() const { return m_bags; }
    // The contact angle of the machine's jaws, which is in recipes and not in the controller; 0: none.
    [[nodiscard]] double contactAngleDeg() const { return m_contactAngleDeg; }
    void setContactAngle(double deg);
    void send(modbus::Command command, const modbus::CommandArguments& arguments = {});
    // Sends a command that starts the machine, with what the panel permits now.
    void startBy(modbus::Command command, const modbus::CommandArguments& arguments = {});
    // Returns the parameter with a name of the register table.
    [[nodiscard]] Parameter& parameter(std::string_view name);
    // Returns the parameter with that name of the table, for QML.
    [[nodiscard]] Q_INVOKABLE campanel::panel::ParameterField* parameterField(const QString& name);
    // Writes a parameter; for technicians. Returns false, without a reply, when the access check refuses.
    bool writeParameter(const modbus::RegisterInfo& info, double value, const Parameter::Reply& reply);

signals:
    void connectionChanged();
    void qualityChanged();
    void freshChanged();
    void ageChanged();
    void stateChanged();
    void liveChanged();
    void bagChanged();
    void programChanged();
    void savedChanged();
    void commandsChanged();
    void commandMessageChanged();
    // Emitted for the audit trail: before the request goes to the link, and with its result.
    void commandSending(const campanel::link::CommandRequest& request);
    void commandEnded(const campanel::link::CommandOutcome& outcome);
    void parameterWriting(const QString& name, double value);
    void parameterWritten(const campanel::link::ParameterOutcome& outcome);

private:
    void takeReport(const link::LinkReport& report);
    void takeStatus(const link::StatusBatch& batch);
    void takeProgram(const link::ActiveProgram& program);
    void takeBag(const modbus::BagRecord& bag);
    void takeOutcome(const link::CommandOutcome& outcome);
    void noteLoss();
    void noteReturn(const modbus::StatusBlock& status);
    [[nodiscard]] QString stopOutcomeText(const link::CommandOutcome& outcome) const;
    // Returns the program of the last status; null while another one is known.
    [[nodiscard]] const ControllerProgram* runningProgram() const;
    void trace(const modbus::StatusBlock& status);
    void restartBags();
    void forgetStatus();
    void updateAge();
    void showMessage(const QString& text);
    void doubtParameters();

    link::Link& m_link;
    Settings& m_settings;
    AccessCheck m_access;
    Clock m_clock;
    WallClock m_wallClock;
    link::LinkReport m_report;
    std::optional<modbus::StatusBlock> m_status; // last status, also after the connection is lost
    AxisPosition m_axisPosition;
    std::optional<link::SteadyTime> m_statusAt;
    std::shared_ptr<const ControllerProgram> m_program;
    std::uint32_t m_cyclesBefore = 0; // of the programs before it, since power-up
    double m_contactAngleDeg = 0;
    std::function<QString()> m_startInterlock;
    ActualTrace m_trace;
    BagStatistics m_bags;
    StrokeModel m_strokes{this};
    StatusRate m_rate;
    QTimer m_ageTimer;
    QTimer m_qualityTimer;
    bool m_fresh = false;
    QDateTime m_lostAt;                              // time when an existing connection was lost
    std::optional<modbus::StatusBlock> m_beforeLoss; // until the first status after the loss
    QString m_returnMessage;                         // changes found when the line was back
    bool m_hasStopWaited = false;                    // the last Stop had to wait for the line
    quint32 m_lastRequestId = 0;
    std::optional<link::SteadyTime> m_stopPressedAt;
    std::map<std::string_view, Parameter*> m_parameters;           // children
    std::map<std::string_view, ParameterField*> m_parameterFields; // children
    QString m_commandMessage;
    MasterDirection m_direction{*this};
    MasterSetting m_masterSetting{*this};
    Telemetry m_telemetry{this};
    PackingLine m_packing{*this};
    RunStatements m_run{*this};
    TorqueWatch m_torque{*this};
    StartPermit m_startPermit{*this, this};
};

} // namespace campanel::panel
