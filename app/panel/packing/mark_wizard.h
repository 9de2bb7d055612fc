// SPDX-License-Identifier: Apache-2.0
// Finds the true distance from mark sensor to knife with bags and a ruler. A few bags are cut, and the
// distance of their cuts behind their marks is measured. The parameter is corrected by the difference, and
// the next bags are checked. Nothing is changed before the step that announces it.
#pragma once

#include "app/link/link_values.h"
#include "app/panel/kit/numbers.h"
#include "app/panel/kit/value.h"

#include <QList>
#include <QObject>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

class Controller;
class PackingFields;

class MarkWizard : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The wizard belongs to the packing setup")
    Q_PROPERTY(Step step READ step NOTIFY changed FINAL)
    // The instructions of this step, in whole sentences.
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    // The reason why the wizard cannot continue; empty when it can or has ended.
    Q_PROPERTY(QString blockedReason READ blockedReason NOTIFY changed FINAL)
    Q_PROPERTY(bool canGoOn READ canGoOn NOTIFY changed FINAL)
    Q_PROPERTY(bool canReadRuler READ canReadRuler NOTIFY changed FINAL)
    // The progress 0..1 of the bags in this step.
    Q_PROPERTY(double progress READ progress NOTIFY changed FINAL)
    // The measurements, "3.1 mm, 3.0 mm"; empty before the first.
    Q_PROPERTY(QString measuredText READ measuredText NOTIFY changed FINAL)
    Q_PROPERTY(QString meanText READ meanText NOTIFY changed FINAL)
    Q_PROPERTY(QString offsetText READ offsetText NOTIFY changed FINAL)
    Q_PROPERTY(QString oldText READ oldText NOTIFY changed FINAL)
    Q_PROPERTY(QString newText READ newText NOTIFY changed FINAL)
    // The maximum of a measurement, mm.
    Q_PROPERTY(campanel::panel::Value* measurement READ measurement CONSTANT FINAL)

public:
    enum class Step { Explain, Cutting, Measure, Confirm, Writing, Watch, Done, Failed };
    Q_ENUM(Step)
    static constexpr int bagsToCut = 5;
    static constexpr int maxMeasured = 5;

    // Machine and fields must outlive the object.
    MarkWizard(Controller& controller, PackingFields& fields, QObject* parent);

    // Restarts the wizard; closing it does the same.
    Q_INVOKABLE void restart();
    // Continues with the next step; in Confirm it writes the value.
    Q_INVOKABLE void goOn();
    // Adds the distance of a cut behind its mark; negative: before it.
    void addMeasurement(double behindMm);
    Q_INVOKABLE void dropMeasurement();
    // Measures the last bag of the simulated machine.
    Q_INVOKABLE void measureSimulatedBag();
    [[nodiscard]] Step step() const { return m_step; }
    [[nodiscard]] QString text() const;
    [[nodiscard]] QString blockedReason() const;
    [[nodiscard]] bool canGoOn() const;
    [[nodiscard]] bool canReadRuler() const;
    [[nodiscard]] double progress() const;
    [[nodiscard]] QString measuredText() const;
    [[nodiscard]] QString meanText() const;
    [[nodiscard]] QString offsetText() const;
    [[nodiscard]] QString oldText() const;
    [[nodiscard]] QString newText() const;
    [[nodiscard]] Value* measurement() { return &m_measurement; }
    // Returns mm; NaN while an input is unknown.
    [[nodiscard]] double newDistanceMm() const;

signals:
    void changed();

private:
    void updateMeasurement();
    void setStep(Step step);
    void followBags();
    void judgeBags();
    [[nodiscard]] int bagsSinceStep() const;
    [[nodiscard]] int bagsToWatch() const;
    [[nodiscard]] int bagsUnderWay() const;
    void takeRuler(const link::RulerOutcome& outcome);
    void takeWritten(const QString& name, bool isDone, const QString& sentence);
    [[nodiscard]] double meanMm() const;
    [[nodiscard]] QString rulerText() const;
    [[nodiscard]] QString watchedText() const;

    Controller& m_controller;
    PackingFields& m_fields;
    Value m_measurement;
    Step m_step = Step::Explain;
    link::SteadyTime m_steppedAt;
    std::optional<std::uint32_t> m_firstBag; // at the start of the step
    QList<double> m_measuredMm;
    double m_oldMm = unknown;
    double m_offsetMm = unknown;
    double m_newMm = unknown; // the written distance
    QString m_failure;
    QList<double> m_errorsMm; // mark errors of the last bags
    bool m_isRulerAsked = false;
    std::optional<link::RulerOutcome> m_ruler; // last measurement
    bool m_isSameBag = false;
};

} // namespace campanel::panel
