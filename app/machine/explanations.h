// SPDX-License-Identifier: Apache-2.0
// `Explanations` in QML: the derived numbers of Run and of the Motion verdict explained, each as it is at
// that moment. What a field of the recipe follows from is told by its EditorField.
#pragma once

#include "app/machine/explanation.h"
#include "app/machine/format.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

class QJSEngine;
class QQmlEngine;

namespace campanel::machine {

class Editor;
class Machine;

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
        PeakFrequency
    };
    Q_ENUM(Quantity)

    // Both must outlive it.
    Explanations(Machine& machine, Editor& editor, QObject* parent);

    // The instance that attachToEngine() gave to this engine.
    static Explanations* create(QQmlEngine* qmlEngine, QJSEngine* jsEngine);

    // `quantity` is one of Quantity; of the packing line and the press those of the controller, of the last
    // four those of the recipe in the editor.
    [[nodiscard]] Q_INVOKABLE campanel::machine::Explanation of(int quantity) const;
    // What can be told of the recipe's verdict: of FastestRate and the peaks those that are known. A list of
    // quantities.
    [[nodiscard]] Q_INVOKABLE QList<int> ofVerdict() const;

private:
    [[nodiscard]] Explanation rate() const;
    [[nodiscard]] Explanation bags(Quantity quantity) const;
    [[nodiscard]] Explanation packing(Quantity quantity) const;
    [[nodiscard]] Explanation followingError() const;
    [[nodiscard]] Explanation goodStrokes() const;
    [[nodiscard]] Explanation fastestRate() const;
    [[nodiscard]] Explanation peak(Quantity quantity) const;

    Machine& m_machine;
    Editor& m_editor;
};

} // namespace campanel::machine
