// SPDX-License-Identifier: Apache-2.0
// Finds out why there is no connection and where the controller is: diagnosis, search, their findings as
// text, and the use of the connection found. Never starts while something moves: a scan closes the
// connection.
#pragma once

#include "app/link/link.h"
#include "app/panel/kit/offer_model.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

class Controller;
class Settings;

class LinkDoctor : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The doctor belongs to Maintenance")
    Q_PROPERTY(bool running READ running NOTIFY changed FINAL)
    // The reason why it cannot start now; empty when it can.
    Q_PROPERTY(QString blockedReason READ blockedReason NOTIFY changed FINAL)
    Q_PROPERTY(bool canBegin READ canBegin NOTIFY changed FINAL)
    // The progress of a run: the present trial, the number of trials, and their share 0..1.
    Q_PROPERTY(QString triedText READ triedText NOTIFY changed FINAL)
    Q_PROPERTY(QString progressText READ progressText NOTIFY changed FINAL)
    Q_PROPERTY(double progress READ progress NOTIFY changed FINAL)
    // The result, or the purpose before the first run.
    Q_PROPERTY(QString resultText READ resultText NOTIFY changed FINAL)
    // True when a controller answers on a connection other than the present one.
    Q_PROPERTY(bool canTake READ canTake NOTIFY changed FINAL)
    Q_PROPERTY(QString foundText READ foundText NOTIFY changed FINAL)
    // True when a search of the usual settings has found no controller.
    Q_PROPERTY(bool offersSearch READ offersSearch NOTIFY changed FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* findings READ findings CONSTANT FINAL)

public:
    // Both arguments must outlive the object.
    LinkDoctor(Controller& controller, Settings& settings, QObject* parent);

    [[nodiscard]] bool running() const { return m_report && m_report->isRunning; }
    [[nodiscard]] QString blockedReason() const;
    [[nodiscard]] bool canBegin() const { return !running() && blockedReason().isEmpty(); }
    [[nodiscard]] QString triedText() const;
    [[nodiscard]] QString progressText() const;
    [[nodiscard]] double progress() const;
    [[nodiscard]] QString resultText() const;
    [[nodiscard]] bool canTake() const;
    [[nodiscard]] QString foundText() const;
    [[nodiscard]] bool offersSearch() const;
    [[nodiscard]] OfferModel* findings() { return &m_findings; }

    // Checks the port in use with a few questions.
    Q_INVOKABLE void diagnose();
    // Searches every port with the usual settings, which takes seconds.
    Q_INVOKABLE void searchUsual();
    // Searches every port with every setting, up to the first controller.
    Q_INVOKABLE void search();
    Q_INVOKABLE void cancel();
    // Uses the connection found, now and in future.
    Q_INVOKABLE void take();

signals:
    void changed();
    void begun(bool isSearch); // by a person

private:
    void begin(modbus::ScanPlan::Depth depth);
    void takeLinkReport(const link::LinkReport& report);
    void takeDownload(const link::DownloadReport& report);
    void takeScan(const link::ScanReport& report);
    void showFindings();

    Controller& m_controller;
    Settings& m_settings;
    std::optional<link::ScanReport> m_report; // the last one
    OfferModel m_findings{this};
    bool m_isStopWaiting = false;
    bool m_isDownloading = false;
};

} // namespace campanel::panel
