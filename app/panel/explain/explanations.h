// SPDX-License-Identifier: Apache-2.0
// `Explanations` in QML: the derived numbers of Run, of the Motion verdict, of the line's figures and of the
// trends explained, each as it is at that moment. What a field of the recipe follows from is told by its
// EditorField.
#pragma once

#include "app/panel/explain/explanation.h"
#include "app/panel/kit/format.h"

#include <QObject>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

class QJSEngine;
class QQmlEngine;

namespace campanel::machine {

class Editor;
class LineFigures;
class Machine;
class Trends;

class Explanations : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

public:
    enum Quantity {
        Rate,
        BagMean,
        BagScatter,
        BagsWithin,
        BagDeviation,
        MarkError,
        FilmSaved,
        FollowingError,
        GoodStrokes,
        FastestRate,
        PeakMotorSpeed,
        PeakAcceleration,
        PeakFrequency,
        WireShare,
        AnswersHalf,
        Answers95,
        Answers99,
        AnswersLongest,
        AnswerAllowance
    };
    Q_ENUM(Quantity)

    struct Sources {
        Machine& machine;
        Editor& editor;
        LineFigures& figures;
        Trends& trends;
    };

    // All must outlive it.
    Explanations(const Sources& sources, QObject* parent);

    // The instance that attachToEngine() gave to this engine.
    static Explanations* create(QQmlEngine* qmlEngine, QJSEngine* jsEngine);

    // `quantity` is one of Quantity; of the packing line and the press those of the controller, FastestRate
    // and the peaks those of the recipe in the editor.
    [[nodiscard]] Q_INVOKABLE campanel::machine::Explanation of(int quantity) const;
    // What can be told of the recipe's verdict: of FastestRate and the peaks those that are known. A list of
    // quantities.
    [[nodiscard]] Q_INVOKABLE QList<int> ofVerdict() const;
    // The statistics of a curve of the trends, counted from the top; a list of Explanation, empty while
    // nothing was recorded in the window.
    [[nodiscard]] Q_INVOKABLE QVariantList ofTrend(int lane) const;
    // What its cursor reads, {lowest, mean, highest}: one Explanation, none where nothing was recorded.
    [[nodiscard]] Q_INVOKABLE QVariantList ofTrendCursor(int lane, const QList<double>& values) const;

private:
    [[nodiscard]] Explanation rate() const;
    [[nodiscard]] Explanation bags(Quantity quantity) const;
    [[nodiscard]] Explanation packing(Quantity quantity) const;
    [[nodiscard]] Explanation followingError() const;
    [[nodiscard]] Explanation goodStrokes() const;
    [[nodiscard]] Explanation fastestRate() const;
    [[nodiscard]] Explanation peak(Quantity quantity) const;
    [[nodiscard]] Explanation wireShare() const;
    [[nodiscard]] Explanation answers(Quantity quantity) const;
    [[nodiscard]] Explanation answerAllowance() const;
    [[nodiscard]] static QString trendUnit(int quantity); // of Trends.Quantity

    Machine& m_machine;
    Editor& m_editor;
    LineFigures& m_figures;
    Trends& m_trends;
};

} // namespace campanel::machine
