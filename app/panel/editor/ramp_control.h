// SPDX-License-Identifier: Apache-2.0
// `Editor.cutter.ramps` in QML: how the ratios of a rotary cutter came about, what they demand, and the keys
// that let them suit the machine. It displays the Editor's values and sends every change to the Editor.
#pragma once

#include "app/panel/kit/figure_model.h"
#include "app/panel/recipe/solution.h"

#include <QStringList>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

class RampControl : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The ramps belong to the Editor")
    Q_PROPERTY(Mode mode READ mode NOTIFY changed FINAL)
    // The place of the ramps, 0: slowest motor, 50: coolest, 100: gentlest; NaN without a motion.
    Q_PROPERTY(double position READ position NOTIFY changed FINAL)
    Q_PROPERTY(QString stateText READ stateText NOTIFY changed FINAL)
    Q_PROPERTY(QString windowText READ windowText NOTIFY changed FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* figures READ figures CONSTANT FINAL)
    // The peak speed with Slow, the RMS acceleration with Cool, the peak acceleration with Gentle.
    Q_PROPERTY(QStringList presets READ presets NOTIFY changed FINAL)
    // The machine's number that is exceeded, or that sets the highest rate, by its name; empty: none.
    Q_PROPERTY(QString limitField READ limitField NOTIFY changed FINAL)
    // The ramps that allow what the present ones do not; empty when they do not help.
    Q_PROPERTY(QString offerName READ offerName NOTIFY changed FINAL)
    Q_PROPERTY(QString offerRate READ offerRate NOTIFY changed FINAL)

public:
    enum Mode {
        ByHand = static_cast<int>(profile::RatioMode::ByHand),
        Gentle = static_cast<int>(profile::RatioMode::Gentle),
        Cool = static_cast<int>(profile::RatioMode::Cool),
        Slow = static_cast<int>(profile::RatioMode::Slow),
        Between = static_cast<int>(profile::RatioMode::Between),
    };
    Q_ENUM(Mode)

    explicit RampControl(QObject* parent);

    // Shows the recipe and its solution; nothing for other kinds of program.
    void show(const program::Recipe& recipe, const Solution& solution);

    [[nodiscard]] Mode mode() const { return static_cast<Mode>(m_program.ratioMode); }
    [[nodiscard]] double position() const { return m_position; }
    [[nodiscard]] QString stateText() const;
    [[nodiscard]] QString windowText() const;
    [[nodiscard]] FigureModel* figures() { return &m_figures; }
    [[nodiscard]] QStringList presets() const;
    [[nodiscard]] QString limitField() const { return m_limitField; }
    [[nodiscard]] QString offerName() const;
    [[nodiscard]] QString offerRate() const;

    // Sets one of Gentle, Cool and Slow.
    Q_INVOKABLE void choose(int mode);
    // Sets Gentle in a first recipe, which has the default ratios until then.
    Q_INVOKABLE void begin();
    // Moves the ramps during a drag; endDrag() makes it one undo step.
    Q_INVOKABLE void drag(double position);
    Q_INVOKABLE void endDrag();
    // Make the window one per cent of the cycle longer or shorter; the ramps follow unless they were set by
    // hand.
    Q_INVOKABLE void widenWindow();
    Q_INVOKABLE void narrowWindow();
    Q_INVOKABLE void takeOffer();

signals:
    void changed();
    void edited(const campanel::profile::RotaryCutterProgram& program);
    void dragged(const campanel::profile::RotaryCutterProgram& program);
    void dragEnded();

private:
    void showFigures(const Solution& solution);
    void changeWindow(double change);
    [[nodiscard]] double windowShare() const { return 1 / m_program.k[2] - 1 / m_program.k[1]; }

    profile::RotaryCutterProgram m_program;
    profile::Machine m_machine;
    bool m_isCutter = false;
    double m_position = 0;
    std::optional<profile::RampOffer> m_offer;
    QString m_limitField;
    FigureModel m_figures{this};
};

} // namespace campanel::panel
