// SPDX-License-Identifier: Apache-2.0
// `Explanations` in QML: explains the derived numbers of Run, of the Motion verdict, of the link figures and
// of the trends with their present values. A field of the recipe is explained by its EditorField.
#pragma once

#include "app/panel/explain/explanation.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/singleton.h"
#include "app/panel/kit/units.h"

#include <QObject>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class Editor;
class LineFigures;
class MarkEdgeList;
class Controller;
class Stops;
class Trends;

class Explanations : public QObject, public Singleton<Explanations> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

public:
    enum Topic {
        Rate,
        BagMean,
        BagScatter,
        BagsWithin,
        BagDeviation,
        MarkError,
        MarkDistance,
        FilmSaved,
        FollowingError,
        Torque,
        GoodStrokes,
        FastestRate,
        PeakMotorSpeed,
        PeakAcceleration,
        PeakFrequency,
        PeakTorque,
        RmsTorque,
        SealError,
        WireShare,
        AnswersHalf,
        Answers95,
        Answers99,
        AnswersLongest,
        AnswerAllowance,
        SyncWindow,
        SealTime,
        LiveSealTime,
        RmsAcceleration,
        SpeedRatio,
        BaseCircleSpeed,
        Coefficients,
        ShaftVibration,
        Availability,
        Performance,
        Quality,
        Oee
    };
    Q_ENUM(Topic)

    struct Sources {
        Controller& controller;
        Editor& editor;
        LineFigures& figures;
        Trends& trends;
        Stops& stops;
        MarkEdgeList& edges;
    };

    // All arguments must outlive the object.
    Explanations(const Sources& sources, QObject* parent);

    // Explains a value of Topic. Packing line and press use the controller's values; FastestRate, the peaks,
    // SyncWindow and SealTime use the recipe in the editor; Availability to Oee use the displayed shift.
    [[nodiscard]] Q_INVOKABLE campanel::panel::Explanation of(int quantity) const;
    // Returns the explainable quantities of the recipe's verdict: the known ones of FastestRate, the peaks
    // and the figures that the papers name; Coefficients for a move by one polynomial, ShaftVibration of
    // moves and cams.
    [[nodiscard]] Q_INVOKABLE QList<int> ofVerdict() const;
    // Explains the statistics of a trend curve, counted from the top. Returns a list of Explanation, empty
    // when nothing was recorded in the window.
    [[nodiscard]] Q_INVOKABLE QVariantList ofTrend(int lane) const;
    // Explains the values at the cursor, {lowest, mean, highest}. Returns one Explanation, or none when
    // nothing was recorded.
    [[nodiscard]] Q_INVOKABLE QVariantList ofTrendCursor(int lane, const QList<double>& values) const;

private:
    [[nodiscard]] Explanation rate() const;
    [[nodiscard]] Explanation bags(Topic quantity) const;
    [[nodiscard]] Explanation packing(Topic quantity) const;
    [[nodiscard]] Explanation markDistance() const;
    [[nodiscard]] Explanation followingError() const;
    [[nodiscard]] Explanation torque() const;
    [[nodiscard]] Explanation goodStrokes() const;
    [[nodiscard]] Explanation fastestRate() const;
    [[nodiscard]] Explanation peak(Topic quantity) const;
    [[nodiscard]] Explanation liveSealTime() const;
    [[nodiscard]] Explanation coefficients() const;
    [[nodiscard]] Explanation shaftVibration() const;
    [[nodiscard]] Explanation wireShare() const;
    [[nodiscard]] Explanation answers(Topic quantity) const;
    [[nodiscard]] Explanation answerAllowance() const;
    [[nodiscard]] Explanation effectiveness(Topic quantity) const;
    [[nodiscard]] static QString trendUnit(int quantity); // for a Trends.Quantity

    Controller& m_controller;
    Editor& m_editor;
    LineFigures& m_figures;
    Trends& m_trends;
    Stops& m_stops;
    MarkEdgeList& m_edges;
};

} // namespace campanel::panel
