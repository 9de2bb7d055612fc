// SPDX-License-Identifier: Apache-2.0
// `Maintenance.measurement` in QML: measures what commissioning would otherwise have to know. The controller
// turns an axis slowly and counts its pulses from index mark to index mark, or shows its direction; film per
// turn comes from a bag and a ruler. Nothing is changed before take() or turnAround().
#pragma once

#include "app/link/link_values.h"
#include "app/panel/controller/io_pins.h"
#include "app/panel/kit/numbers.h"
#include "app/panel/kit/watched.h"
#include "app/panel/maintenance/axis_fields.h"

#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

class Controller;
class Editor;

class AxisMeasurement : public campanel::panel::Watched {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The measurement of the axes belongs to Maintenance")
    Q_PROPERTY(Step step READ step NOTIFY changed FINAL)
    Q_PROPERTY(Subject subject READ subject NOTIFY changed FINAL)
    Q_PROPERTY(QString title READ title NOTIFY changed FINAL)
    // The instructions of the step, or its result, in whole sentences.
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    // The reason why the axis cannot be turned now; empty when it can.
    Q_PROPERTY(QString blockedReason READ blockedReason NOTIFY changed FINAL)
    Q_PROPERTY(double progress READ progress NOTIFY changed FINAL)
    Q_PROPERTY(QString presentText READ presentText NOTIFY changed FINAL)
    Q_PROPERTY(QString measuredText READ measuredText NOTIFY changed FINAL)
    Q_PROPERTY(bool canTake READ canTake NOTIFY changed FINAL)
    // The length of the last bag by the ruler.
    Q_PROPERTY(campanel::panel::Value* ruler READ ruler CONSTANT FINAL)
    // True when a bag was cut whose film the controller knows.
    Q_PROPERTY(bool hasBag READ hasBag NOTIFY changed FINAL)
    Q_PROPERTY(campanel::panel::AxisFields* fields READ fields CONSTANT FINAL)
    // The sentence in place of the page while there is nothing to measure; else empty.
    Q_PROPERTY(QString emptyText READ emptyText NOTIFY changed FINAL)

public:
    enum class Step { Ready, Moving, Question, Result, Writing, Done, Failed };
    Q_ENUM(Step)
    enum class Subject { Direction, Turns, Film };
    Q_ENUM(Subject)

    // The controller must outlive the object.
    AxisMeasurement(Controller& controller, QObject* parent);
    // Takes the pulses of the main motor from the editor's machine data, and puts measured ones there.
    void follow(Editor& editor);

    [[nodiscard]] Step step() const { return m_step; }
    [[nodiscard]] Subject subject() const { return m_subject; }
    [[nodiscard]] QString title() const;
    [[nodiscard]] QString text() const;
    [[nodiscard]] QString blockedReason() const;
    [[nodiscard]] double progress() const;
    [[nodiscard]] QString presentText() const;
    [[nodiscard]] QString measuredText() const;
    [[nodiscard]] bool canTake() const;
    [[nodiscard]] Value* ruler() { return &m_ruler; }
    [[nodiscard]] bool hasBag() const { return bagMm() > 0; }
    [[nodiscard]] AxisFields* fields() { return &m_fields; }
    [[nodiscard]] QString emptyText() const;

    // Reads the fields and what the controller can do; call it when the page opens.
    Q_INVOKABLE void open();
    // Prepares the measurement of a field of the list, or of the main motor's pulses.
    Q_INVOKABLE void begin(int row);
    Q_INVOKABLE void beginMainMotor();
    // Starts the axis. For technicians.
    Q_INVOKABLE void start();
    // Answers which way the axis went: as it should, or the other way. For technicians.
    Q_INVOKABLE void keepDirection();
    Q_INVOKABLE void turnAround();
    // Writes the measured value. For technicians.
    Q_INVOKABLE void take();
    // Measures the last bag of the simulated machine.
    Q_INVOKABLE void measureSimulatedBag();

signals:
    void changed();
    // Emitted for the audit trail, when an axis has come to rest and when the main motor's pulses were taken.
    void ended(const QString& subject, const QString& result, const QString& outcome);
    void taken(const QString& subject, double before, double after);

private:
    void prepare(Subject subject, modbus::MeasuredAxis axis, const char* name);
    void setStep(Step step);
    void fail(const QString& sentence);
    void read();
    void takeRead(const link::ReadOutcome& outcome);
    void takeCommand(const link::CommandOutcome& outcome);
    void takeWritten(const QString& name, bool isDone, const QString& sentence);
    void takeRuler(const link::RulerOutcome& outcome);
    void noteConnection();
    void note(const QString& outcome);
    void updateRuler();
    void write(double value);
    [[nodiscard]] bool isMainMotor() const { return m_subject == Subject::Turns && !m_name; }
    [[nodiscard]] double present() const;
    // Returns the measured value of the field, NaN while there is none.
    [[nodiscard]] double measured() const;
    [[nodiscard]] bool areTurnsEven() const;
    // Returns the film of the last bag by the present setting.
    [[nodiscard]] double bagMm() const;
    [[nodiscard]] double motorTurns() const;
    [[nodiscard]] QString amount(double value) const;
    [[nodiscard]] QString readyText() const;
    [[nodiscard]] QString resultText() const;

    Controller& m_controller;
    Editor* m_editor = nullptr;
    AxisFields m_fields;
    IoPins m_pins;
    Value m_ruler;
    Step m_step = Step::Ready;
    Subject m_subject = Subject::Direction;
    modbus::MeasuredAxis m_axis = modbus::MeasuredAxis::Knife;
    const char* m_name = nullptr; // of the parameter; null: the main motor's pulses
    std::optional<modbus::MeasureStatus> m_status;
    bool m_isTurning = false; // the controller has begun
    bool m_isAsked = false;   // a reading is under way
    bool m_isRulerAsked = false;
    double m_rulerMm = unknown;
    double m_before = unknown; // the setting before it was written
    QString m_sentence;        // of Done and Failed
};

} // namespace campanel::panel
