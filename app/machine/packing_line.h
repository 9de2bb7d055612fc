// SPDX-License-Identifier: Apache-2.0
// Film, marks, products and bags of a packing machine, as its controller tells them; asked for a few times a
// second while a cutter's program is active. Every number is NaN and every text empty while it is not known.
#pragma once

#include "app/link/link.h"

#include <QList>
#include <QObject>
#include <QTimer>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

#include <limits>
#include <optional>

namespace campanel::machine {

class Machine;

// What lies on the film, for the plot that draws it. Distances to the knife in mm at the time `at`.
struct FilmView {
    link::SteadyTime at;
    double filmMm = 0;      // film motor's position, to tell one view from the next
    double bagMm = 0;       // set length
    double speedMmPerS = 0; // of the film, 0 at standstill
    double windowMm = 0;    // to both sides of where a mark is expected; 0 while it is not known
    double sensorMm = 0;    // mark sensor before the knife; 0 while it is not known
    std::vector<modbus::FilmCut> cuts;
    std::vector<modbus::FilmMark> marks;
    std::vector<modbus::FilmProduct> products;
};

class PackingLine : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The packing line belongs to the Machine")
    // The controller has told, and not longer than a second ago.
    Q_PROPERTY(bool known READ known NOTIFY changed FINAL)
    Q_PROPERTY(bool fresh READ fresh NOTIFY changed FINAL)

    Q_PROPERTY(MarkState markState READ markState NOTIFY changed FINAL)
    Q_PROPERTY(QString markStateText READ markStateText NOTIFY changed FINAL)
    Q_PROPERTY(double markErrorMm READ markErrorMm NOTIFY changed FINAL)
    Q_PROPERTY(double markPitchMm READ markPitchMm NOTIFY changed FINAL)
    Q_PROPERTY(double phaseCorrectionMm READ phaseCorrectionMm NOTIFY changed FINAL)
    Q_PROPERTY(double lengthCorrectionMm READ lengthCorrectionMm NOTIFY changed FINAL)
    Q_PROPERTY(double filmFollowingErrorMm READ filmFollowingErrorMm NOTIFY changed FINAL)
    Q_PROPERTY(double marks READ marks NOTIFY changed FINAL)
    Q_PROPERTY(double marksMissing READ marksMissing NOTIFY changed FINAL)
    Q_PROPERTY(double marksFalse READ marksFalse NOTIFY changed FINAL)
    Q_PROPERTY(double products READ products NOTIFY changed FINAL)
    Q_PROPERTY(double cutsSkipped READ cutsSkipped NOTIFY changed FINAL)
    Q_PROPERTY(double emptyBags READ emptyBags NOTIFY changed FINAL)
    Q_PROPERTY(double filmSavedM READ filmSavedM NOTIFY changed FINAL)
    Q_PROPERTY(QString lastSkipText READ lastSkipText NOTIFY changed FINAL)
    Q_PROPERTY(double correctionsLimited READ correctionsLimited NOTIFY changed FINAL)
    // What knife and film are doing when they do not simply run: "Knife waits", ...; empty while they do.
    Q_PROPERTY(QString gateText READ gateText NOTIFY changed FINAL)
    Q_PROPERTY(int teachMarks READ teachMarks NOTIFY changed FINAL)
    Q_PROPERTY(double teachPitchMm READ teachPitchMm NOTIFY changed FINAL)
    Q_PROPERTY(double teachScatterMm READ teachScatterMm NOTIFY changed FINAL)
    // A campanel::machine::FilmView for the plot; empty while nothing is known.
    Q_PROPERTY(QVariant film READ film NOTIFY changed FINAL)

public:
    enum class MarkState { Unknown, Off, Searching, Aligning, Tracking };
    Q_ENUM(MarkState)

    // The machine must outlive it.
    explicit PackingLine(Machine& machine);

    [[nodiscard]] bool known() const { return m_status.has_value(); }
    [[nodiscard]] bool fresh() const;
    [[nodiscard]] MarkState markState() const;
    [[nodiscard]] QString markStateText() const;
    [[nodiscard]] double markErrorMm() const { return number(&modbus::PackerStatus::markErrorMm); }
    [[nodiscard]] double markPitchMm() const { return number(&modbus::PackerStatus::markPitchMm); }
    [[nodiscard]] double phaseCorrectionMm() const
    {
        return number(&modbus::PackerStatus::phaseCorrectionMm);
    }
    [[nodiscard]] double lengthCorrectionMm() const
    {
        return number(&modbus::PackerStatus::lengthCorrectionMm);
    }
    [[nodiscard]] double filmFollowingErrorMm() const
    {
        return number(&modbus::PackerStatus::filmFollowingErrorMm);
    }
    [[nodiscard]] double marks() const { return number(&modbus::PackerStatus::marks); }
    [[nodiscard]] double marksMissing() const { return number(&modbus::PackerStatus::marksMissing); }
    [[nodiscard]] double marksFalse() const { return number(&modbus::PackerStatus::marksFalse); }
    [[nodiscard]] double products() const { return number(&modbus::PackerStatus::products); }
    [[nodiscard]] double cutsSkipped() const { return number(&modbus::PackerStatus::cutsSkipped); }
    [[nodiscard]] double emptyBags() const { return number(&modbus::PackerStatus::emptyBags); }
    [[nodiscard]] double filmSavedM() const { return number(&modbus::PackerStatus::filmSavedM); }
    [[nodiscard]] QString lastSkipText() const;
    [[nodiscard]] double correctionsLimited() const
    {
        return number(&modbus::PackerStatus::correctionsLimited);
    }
    [[nodiscard]] QString gateText() const;
    [[nodiscard]] int teachMarks() const { return m_status ? m_status->teachMarks : 0; }
    [[nodiscard]] double teachPitchMm() const;
    [[nodiscard]] double teachScatterMm() const;
    [[nodiscard]] QVariant film() const;

    // Measures the distances between the next marks; teachMarks counts up to that number.
    Q_INVOKABLE void teach(int marks);

    // For the Machine and for who shows single bags.
    [[nodiscard]] const std::optional<modbus::PackerStatus>& status() const { return m_status; }
    void noteConnection();
    void noteProgram();
    void retranslate() { emit changed(); }

signals:
    void changed();
    // A bag not told before, oldest first.
    void bagRecorded(const campanel::modbus::BagRecord& bag);

private:
    [[nodiscard]] bool isWanted() const;
    void ask();
    void takeRead(const link::ReadOutcome& outcome);
    void tellBags();
    void forget();
    template <typename T> [[nodiscard]] double number(T modbus::PackerStatus::*member) const
    {
        return m_status ? static_cast<double>((*m_status).*member) : std::numeric_limits<double>::quiet_NaN();
    }

    Machine& m_machine;
    QTimer m_timer;
    std::optional<modbus::PackerStatus> m_status;
    link::SteadyTime m_receivedAt;
    link::SteadyTime m_askedAt;
    bool m_isAsked = false;
    bool m_wasFresh = false;
    std::optional<std::uint32_t> m_toldBag;
};

} // namespace campanel::machine

Q_DECLARE_METATYPE(campanel::machine::FilmView)
