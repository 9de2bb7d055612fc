// SPDX-License-Identifier: Apache-2.0
// The download of the edited recipe to the controller: differences, permission and progress.
#pragma once

#include "app/panel/download/change_forecast.h"
#include "app/panel/download/program_proof.h"
#include "app/panel/download/window_reason.h"
#include "app/panel/kit/difference_model.h"
#include "app/panel/recipe/solution.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class Controller;

class ProgramDownload : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Editor.programDownload is the only one")

    Q_PROPERTY(State state READ state NOTIFY changed FINAL)
    Q_PROPERTY(double progress READ progress NOTIFY changed FINAL)
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    // The speed of film or cam while the running machine changes: corners of a line in seconds and per cent
    // of the speed before; empty when it goes on.
    Q_PROPERTY(QList<QPointF> changeSpeeds READ changeSpeeds NOTIFY changed FINAL)
    // The cuts over the change as FilmPicture draws them, with the last one at the knife; empty: no forecast.
    Q_PROPERTY(QList<QPointF> changeCuts READ changeCuts NOTIFY changed FINAL)
    Q_PROPERTY(QString changeLength READ changeLength NOTIFY changed FINAL) // of its bags; empty: it stays
    Q_PROPERTY(bool canDownload READ canDownload NOTIFY changed FINAL)
    Q_PROPERTY(bool busy READ isUnderWay NOTIFY changed FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* differences READ differences CONSTANT FINAL)
    Q_PROPERTY(int differenceCount READ differenceCount NOTIFY changed FINAL)
    Q_PROPERTY(QString controllerText READ controllerText NOTIFY changed FINAL)
    Q_PROPERTY(campanel::panel::ProgramProof* proof READ proof CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::WindowReason* windowReason READ windowReason CONSTANT FINAL)
    Q_PROPERTY(bool saved READ isSaved NOTIFY changed FINAL)
    Q_PROPERTY(bool canSave READ canSave NOTIFY changed FINAL)

public:
    // The states, in the order and with the names of Editor.DownloadState in QML.
    // Unconfirmed: the axis would advance in every cycle, and nobody has confirmed that. Unapproved: a value
    // is outside its approved window, and nobody has given a reason.
    enum class State {
        NothingToDo,
        Ready,
        Unconfirmed,
        Unapproved,
        Blocked,
        Transferring,
        Sealing,
        Armed,
        Applied,
        Failed
    };
    Q_ENUM(State)

    ProgramDownload(Controller& controller, const QString& folder, QObject* parent);

    // Refuses every download from now on: the machine data are not those of this machine.
    void noteDataLost()
    {
        m_isDataLost = true;
        update();
    }
    // Sets the image to download; null when the recipe is not feasible.
    void offer(std::shared_ptr<const program::ProgramImage> image);

    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] double progress() const { return m_report.fraction; }
    [[nodiscard]] QString text() const;
    [[nodiscard]] QList<QPointF> changeSpeeds() const { return m_forecast.speeds(); }
    [[nodiscard]] QList<QPointF> changeCuts() const;
    [[nodiscard]] QString changeLength() const;
    [[nodiscard]] bool isUnderWay() const;
    [[nodiscard]] bool canDownload() const { return m_state == State::Ready || m_canRetry; }
    [[nodiscard]] DifferenceModel* differences() { return &m_differences; }
    [[nodiscard]] int differenceCount() const { return m_differences.count(); }
    [[nodiscard]] ProgramProof* proof() { return &m_proof; }
    [[nodiscard]] WindowReason* windowReason() { return &m_windowReason; }
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
    void sendTrims(const program::Recipe& recipe);
    [[nodiscard]] QString blockedReason() const; // empty when the download is possible
    [[nodiscard]] QString readyText() const;
    [[nodiscard]] bool changesMachineData() const;
    void takeReport(const link::DownloadReport& report);
    void compare();
    // Returns Ready, or what a person has to decide first.
    [[nodiscard]] State stateOfOffer() const;

    Controller& m_controller;
    std::shared_ptr<const program::ProgramImage> m_offer;
    DifferenceModel m_differences;
    ProgramProof m_proof;
    WindowReason m_windowReason;
    ChangeForecast m_forecast;
    bool m_differs = false;
    State m_state = State::Blocked;
    bool m_canRetry = false;
    std::optional<program::Recipe> m_sent;
    std::vector<std::uint16_t> m_sentRegisters;
    link::DownloadReport m_report;
    bool m_isDataLost = false;
    bool m_hasEnded = false; // the report belongs to an ended download without edits since then
};

} // namespace campanel::panel
