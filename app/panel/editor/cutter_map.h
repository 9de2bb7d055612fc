// SPDX-License-Identifier: Apache-2.0
// `Editor.cutter.map` in QML: the regime map of the edited cutter, and its recipe as a dot that a finger
// drags. The map is computed only while it is watched. Where an encoder leads, its axis is the speed of the
// line.
#pragma once

#include "app/panel/kit/watched.h"
#include "app/panel/recipe/solution.h"
#include "profile/cutter/regime_map.h"

#include <QList>
#include <QStringList>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

#include <memory>
#include <optional>

namespace campanel::panel {

class CutterMap : public campanel::panel::Watched {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The map belongs to the Editor")

    // The map as RegimePlot takes it; invalid when the recipe has none.
    Q_PROPERTY(QVariant map READ map NOTIFY mapChanged FINAL)
    Q_PROPERTY(QStringList limitNames READ limitNames NOTIFY changed FINAL)
    Q_PROPERTY(QList<double> paperLengths READ paperLengths CONSTANT FINAL)
    // The recipe: length in mm, rate in the unit of the axis, NaN while unknown.
    Q_PROPERTY(double lengthMm READ lengthMm NOTIFY changed FINAL)
    Q_PROPERTY(double onAxis READ onAxis NOTIFY changed FINAL)
    Q_PROPERTY(QString axisUnit READ axisUnit NOTIFY changed FINAL)
    Q_PROPERTY(QString title READ title NOTIFY changed FINAL)
    // The fastest rate of this length, with the limit in words.
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    // The meaning of the lines on the map.
    Q_PROPERTY(QString linesText READ linesText NOTIFY changed FINAL)

public:
    explicit CutterMap(QObject* parent);

    [[nodiscard]] QVariant map() const;
    [[nodiscard]] QStringList limitNames() const;
    [[nodiscard]] QList<double> paperLengths() const;
    [[nodiscard]] double lengthMm() const;
    [[nodiscard]] double rateBagsPerMin() const;
    [[nodiscard]] double onAxis() const;
    [[nodiscard]] QString axisUnit() const;
    [[nodiscard]] QString title() const;
    [[nodiscard]] QString text() const;
    [[nodiscard]] QString linesText() const;

    // Moves the recipe to whole mm and bags/min; endDrag() makes the whole drag one undo step.
    Q_INVOKABLE void drag(double lengthMm, double onAxis);
    Q_INVOKABLE void endDrag();

    // Updates the map; called by the Editor. `maxSpeedShare`: where an encoder leads, the maximum speed of
    // the master as a share of the rate.
    void show(const program::Recipe& recipe, const Solution& solution,
              const std::optional<modbus::Identity>& controller, std::optional<double> maxSpeedShare = {});

signals:
    void mapChanged();
    void changed(); // the recipe or the map
    void dragged(double lengthMm, double rateBagsPerMin);
    void dragEnded();

private:
    void updateMap();
    void setMap(std::shared_ptr<const profile::RegimeMap> map);
    [[nodiscard]] double toAxis(double lengthMm, double rateBagsPerMin) const;
    [[nodiscard]] QString lineSpeedText(double lengthMm, double rateBagsPerMin) const;

    program::Recipe m_recipe;
    bool m_isKnown = false;     // the recipe is a cutter with a motion
    profile::Machine m_machine; // with the controller's limits
    std::optional<double> m_maxSpeedShare;
    std::optional<program::Recipe> m_mapOf; // recipe of the map, without its length and rate
    std::shared_ptr<const profile::RegimeMap> m_map;
};

} // namespace campanel::panel
