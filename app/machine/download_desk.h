// SPDX-License-Identifier: Apache-2.0
// The download of the edited recipe to the controller: differences, permission and progress.
#pragma once

#include "app/machine/difference_model.h"
#include "app/machine/program_proof.h"
#include "app/machine/solution.h"

#include <QObject>

namespace campanel::machine {

class Machine;

class DownloadDesk : public QObject {
    Q_OBJECT

public:
    // The states, in the order and with the names of Editor.DownloadState in QML.
    enum class State { NothingToDo, Ready, Blocked, Transferring, Sealing, Armed, Applied, Failed };

    DownloadDesk(Machine& machine, QObject* parent);

    // Sets the image to download; null when the recipe is not feasible.
    void offer(std::shared_ptr<const program::ProgramImage> image);

    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] double progress() const { return m_report.fraction; }
    [[nodiscard]] QString text() const;
    [[nodiscard]] bool canDownload() const { return m_state == State::Ready || m_canRetry; }
    [[nodiscard]] DifferenceModel& differences() { return m_differences; }
    [[nodiscard]] ProgramProof& proof() { return m_proof; }
    [[nodiscard]] QString controllerText() const;
    [[nodiscard]] bool isSaved() const;
    [[nodiscard]] bool canSave() const;

    // Sends the image of this recipe; applied() returns the recipe when it is active.
    void download(const program::ProgramImage& image, const program::Recipe& recipe);
    void cancel();
    void save();
    void update(); // after a change in the controller or of the language

signals:
    void changed();
    void applied(const campanel::program::Recipe& recipe);
    // Emitted for the audit trail: the image about to be sent, and the result.
    void begun(const campanel::program::ProgramImage& image);
    void ended(const campanel::link::DownloadReport& report);

private:
    [[nodiscard]] bool isUnderWay() const;
    [[nodiscard]] QString blockedReason() const; // empty when the download is possible
    [[nodiscard]] bool changesMachineData() const;
    void takeReport(const link::DownloadReport& report);
    void compare();

    Machine& m_machine;
    std::shared_ptr<const program::ProgramImage> m_offer;
    DifferenceModel m_differences;
    ProgramProof m_proof;
    bool m_differs = false;
    State m_state = State::Blocked;
    bool m_canRetry = false;
    std::optional<program::Recipe> m_sent;
    std::vector<std::uint16_t> m_sentRegisters;
    link::DownloadReport m_report;
    bool m_hasEnded = false; // the report belongs to an ended download without edits since then
};

} // namespace campanel::machine
