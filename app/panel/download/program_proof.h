// SPDX-License-Identifier: Apache-2.0
// `Editor.proof` in QML: the edited, the active and the saved program, and the proof that the controller runs
// the right one. On demand its table is read back and compared.
#pragma once

#include "app/link/link.h"
#include "app/program/program_image.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

class Controller;

class ProgramProof : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The proof belongs to the Editor")

    Q_PROPERTY(Result result READ result NOTIFY changed FINAL)
    Q_PROPERTY(bool running READ running NOTIFY changed FINAL)
    Q_PROPERTY(double progress READ progress NOTIFY changed FINAL) // 0..1
    // The result, or the progress, as text; before the first comparison its purpose.
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    Q_PROPERTY(bool canCompare READ canCompare NOTIFY changed FINAL)
    // Name, version, generation and CRC-32; "--" while unknown.
    Q_PROPERTY(QString activeText READ activeText NOTIFY changed FINAL)
    Q_PROPERTY(QString savedText READ savedText NOTIFY changed FINAL)

public:
    enum class Result { None, Equal, Different, Undecided };
    Q_ENUM(Result)

    // The controller must outlive the object.
    ProgramProof(Controller& controller, QObject* parent);

    // Stores what this panel downloaded and the controller activated.
    void noteDownloaded(std::vector<std::uint16_t> registers, std::uint32_t crc);
    void update(); // after a change in the controller or of the language

    Q_INVOKABLE void compare();
    Q_INVOKABLE void cancel();

    [[nodiscard]] Result result() const;
    [[nodiscard]] bool running() const { return m_isRunning; }
    [[nodiscard]] double progress() const { return m_report.fraction; }
    [[nodiscard]] QString text() const;
    [[nodiscard]] bool canCompare() const { return !m_isRunning && blockedReason().isEmpty(); }
    [[nodiscard]] QString activeText() const;
    [[nodiscard]] QString savedText() const;

signals:
    void changed();

private:
    // The reference of the comparison.
    enum class Basis { Downloaded, Rebuilt, OwnChecksum };

    [[nodiscard]] QString blockedReason() const; // empty when a comparison is possible
    [[nodiscard]] QString basisText() const;
    [[nodiscard]] QString resultText() const;
    [[nodiscard]] QString differentText() const;
    [[nodiscard]] QString failureText() const;
    [[nodiscard]] QString nameOf(quint16 offset) const;
    void takeReport(const link::ComparisonReport& report);

    Controller& m_controller;
    std::vector<std::uint16_t> m_downloaded;
    std::uint32_t m_downloadedCrc = 0;
    std::vector<std::uint16_t> m_expected; // for the pending or last comparison
    Basis m_basis = Basis::OwnChecksum;
    bool m_isRunning = false;
    bool m_hasResult = false;
    link::ComparisonReport m_report;
};

} // namespace campanel::panel
