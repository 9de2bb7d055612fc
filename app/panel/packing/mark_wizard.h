// SPDX-License-Identifier: Apache-2.0
// The true distance from mark sensor to knife, found with bags and a ruler: a few bags are cut, the distance
// of their cuts behind their marks is measured, the parameter is corrected by what it is off, and the next
// bags are watched. Nothing is changed before the step that says so.
#pragma once

#include "app/link/link_values.h"
#include "app/panel/kit/numbers.h"

#include <QList>
#include <QObject>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::machine {

class Machine;
class PackingFields;

class MarkWizard : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The wizard belongs to the packing setup")
    Q_PROPERTY(Step step READ step NOTIFY changed FINAL)
    // What this step is about, in whole sentences.
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    // Why it cannot go on; empty when it can or is over.
    Q_PROPERTY(QString blockedReason READ blockedReason NOTIFY changed FINAL)
    Q_PROPERTY(bool canGoOn READ canGoOn NOTIFY changed FINAL)
    Q_PROPERTY(bool canReadRuler READ canReadRuler NOTIFY changed FINAL)
    // 0..1 of the bags that this step waits for.
    Q_PROPERTY(double progress READ progress NOTIFY changed FINAL)
    // "3.1 mm, 3.0 mm"; empty before the first.
    Q_PROPERTY(QString measuredText READ measuredText NOTIFY changed FINAL)
    Q_PROPERTY(QString meanText READ meanText NOTIFY changed FINAL)
    Q_PROPERTY(QString offsetText READ offsetText NOTIFY changed FINAL)
    Q_PROPERTY(QString oldText READ oldText NOTIFY changed FINAL)
    Q_PROPERTY(QString newText READ newText NOTIFY changed FINAL)
    // Of a measurement, mm.
    Q_PROPERTY(double mostMm READ mostMm NOTIFY changed FINAL)

public:
    enum class Step { Explain, Cutting, Measure, Confirm, Writing, Watch, Done, Failed };
    Q_ENUM(Step)
    static constexpr int bagsToCut = 5;
    static constexpr int mostMeasured = 5;

    // Machine and fields must outlive it.
    MarkWizard(Machine& machine, PackingFields& fields, QObject* parent);

    // From the beginning; a wizard that is closed waits there too.
    Q_INVOKABLE void restart();
    // To the next step; in Confirm that writes.
    Q_INVOKABLE void goOn();
    // How far a cut lies behind its mark; negative: before it.
    Q_INVOKABLE void addMeasurement(double behindMm);
    Q_INVOKABLE void dropMeasurement();
    // Of the simulated machine; one measurement of its last bag.
    Q_INVOKABLE void readRuler();
    // Why it is no measurement; empty when it is one.
    [[nodiscard]] Q_INVOKABLE QString check(double behindMm) const;

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
    [[nodiscard]] double mostMm() const;
    // mm; NaN while something of it is not known.
    [[nodiscard]] double newDistanceMm() const;
    void retranslate();

signals:
    void changed();

private:
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

    Machine& m_machine;
    PackingFields& m_fields;
    Step m_step = Step::Explain;
    link::SteadyTime m_steppedAt;
    std::optional<std::uint32_t> m_firstBag; // when the step began
    QList<double> m_measuredMm;
    double m_oldMm = unknown;
    double m_offsetMm = unknown;
    double m_newMm = unknown; // when it was written
    QString m_failure;
    QList<double> m_errorsMm; // of the last bags watched
    bool m_isRulerAsked = false;
    std::optional<link::RulerOutcome> m_ruler; // last reading
    bool m_isSameBag = false;
};

} // namespace campanel::machine
