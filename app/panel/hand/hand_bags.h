// SPDX-License-Identifier: Apache-2.0
// `HandBags` in QML: single bags of a packing machine by hand: one bag out of standstill, one cut of the
// knife alone, and the next bag of a run for a person.
#pragma once

#include "app/panel/kit/singleton.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class Controller;
class Parameter;

class HandBags : public QObject, public Singleton<HandBags> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    // True with a packing machine's program in a controller that has these commands.
    Q_PROPERTY(bool offered READ offered NOTIFY changed FINAL)
    // Why each cannot be done now; empty: it can, as far as the panel knows.
    Q_PROPERTY(QString bagReason READ bagReason NOTIFY changed FINAL)
    Q_PROPERTY(QString cutReason READ cutReason NOTIFY changed FINAL)
    Q_PROPERTY(QString takeReason READ takeReason NOTIFY changed FINAL)
    // The answer of the controller against the last command; empty: none.
    Q_PROPERTY(QString message READ message NOTIFY changed FINAL)

public:
    // The controller must outlive the object.
    HandBags(Controller& controller, QObject* parent);

    [[nodiscard]] bool offered() const;
    [[nodiscard]] QString bagReason() const;
    [[nodiscard]] QString cutReason() const;
    [[nodiscard]] QString takeReason() const;
    [[nodiscard]] QString message() const;

    // Starts the machine for one bag. For operators.
    Q_INVOKABLE void makeBag();
    // Starts the knife for one cut. For operators.
    Q_INVOKABLE void cut();
    // Has the next bag rejected. For operators.
    Q_INVOKABLE void take();

signals:
    void changed();

private:
    Controller& m_controller;
    Parameter& m_place; // of the encoder
};

} // namespace campanel::panel
