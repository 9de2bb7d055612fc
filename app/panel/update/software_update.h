// SPDX-License-Identifier: Apache-2.0
// `SoftwareUpdate` in QML: installs another version of CamPanel from a signed package on a stick, at
// standstill, and puts the version before back. For the level Service. A unit of systemd does the work as
// root; the panel ends meanwhile and reports the outcome when it is back.
#pragma once

#include "app/panel/kit/file_exchange.h"
#include "app/panel/kit/offer_model.h"
#include "app/panel/kit/singleton.h"
#include "app/panel/settings/system_service.h"
#include "app/panel/update/update_state.h"
#include "app/store/update/package_offers.h"

#include <QTimer>
#include <QtQml/qqmlregistration.h>

#include <chrono>

namespace campanel::panel {

class Controller;

class SoftwareUpdate : public campanel::panel::FileExchange, public Singleton<SoftwareUpdate> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    // True while it is on the screen; then it is asked whether the unit is there.
    Q_PROPERTY(bool watched READ watched WRITE setWatched NOTIFY changed FINAL)
    Q_PROPERTY(bool available READ available NOTIFY changed FINAL)
    // The sentence that says how updates come here, while they are not available.
    Q_PROPERTY(QString stateText READ stateText NOTIFY changed FINAL)
    // The packages on a stick or in the panel's own folder.
    Q_PROPERTY(campanel::panel::RowModelBase* found READ found CONSTANT FINAL)
    // The version on this panel; empty: not searched yet, or not installed as a package.
    Q_PROPERTY(QString installedVersion READ installedVersion NOTIFY changed FINAL)
    // The version that can be put back; empty: none.
    Q_PROPERTY(QString backVersion READ backVersion NOTIFY changed FINAL)
    // Why nothing can be installed now; empty: it can.
    Q_PROPERTY(QString blockedReason READ blockedReason NOTIFY changed FINAL)
    // The consequence of the chosen step, and its name.
    Q_PROPERTY(QString question READ question NOTIFY changed FINAL)
    Q_PROPERTY(QString actionText READ actionText NOTIFY changed FINAL)
    // How the last installation ended, until it is dismissed; empty: nothing to report.
    Q_PROPERTY(QString notice READ notice NOTIFY noticeChanged FINAL)

public:
    using Bus = SystemService::Bus;
    using Installed = std::function<std::optional<store::PackageId>()>; // called in another thread

    // The controller must outlive the object. Packages may also lie in a folder below `folder`.
    SoftwareUpdate(Controller& controller, const QString& folder, QObject* parent);

    void setPlaces(const UpdatePlaces& places) { m_places = places; }
    // Replace the system bus, the search of this computer's disks, dpkg and the pace, for tests and captures.
    void setBus(const Bus& bus) { m_bus = bus; }
    void setScanner(Scanner scanner) { m_scanner = std::move(scanner); }
    void setInstalled(Installed installed) { m_installed = std::move(installed); }
    void setPace(std::chrono::milliseconds pace) { m_timer.setInterval(pace); }

    // Reports the outcome of an installation, once it has ended.
    void open();

    [[nodiscard]] bool watched() const { return m_isWatched; }
    void setWatched(bool isWatched);
    [[nodiscard]] bool available() const { return m_isAvailable; }
    [[nodiscard]] QString stateText() const;
    [[nodiscard]] OfferModel* found() { return &m_found; }
    [[nodiscard]] QString installedVersion() const;
    [[nodiscard]] QString backVersion() const;
    [[nodiscard]] QString blockedReason() const;
    [[nodiscard]] QString question() const;
    [[nodiscard]] QString actionText() const;
    [[nodiscard]] QString notice() const { return m_notice; }

    // Returns the name of the step that installs the package; row -1: of any.
    Q_INVOKABLE QString actionOf(int row) const;
    // Choose a step; `question` tells its consequence.
    Q_INVOKABLE void choose(int row);
    Q_INVOKABLE void chooseBack();
    // Carries out the chosen step.
    Q_INVOKABLE void confirm();
    Q_INVOKABLE void dismissNotice();

signals:
    void chosen();
    void noticeChanged();
    // Emitted for the audit trail: a step that a person has confirmed, and the outcome of one.
    void noted(const campanel::store::AuditEntry& entry);
    void ended(const campanel::store::AuditEntry& entry);

private:
    struct Seen {
        QList<store::PackageOffer> offers;
        store::CheckedPackages checked;
        std::optional<store::PackageId> installed;
        std::optional<WayBack> back;
    };
    struct Step {
        UpdateRequest request;
        QString version;
    };

    [[nodiscard]] std::function<Apply()> searcher() override;
    void take(const Seen& seen);
    void showRows();
    [[nodiscard]] OfferRow row(const store::PackageOffer& offer) const;
    [[nodiscard]] bool require();
    void send(const QString& method, const QVariantList& arguments, const SystemService::Handler& handler);
    void askForUnit();
    void startUnit();
    void lookAgain();
    void take(const UpdateOutcome& outcome);
    [[nodiscard]] static QString outcomeText(const UpdateOutcome& outcome);
    void endWork(const QString& problem);

    Controller& m_controller;
    UpdatePlaces m_places;
    Bus m_bus;
    Scanner m_scanner;
    Installed m_installed;
    OfferModel m_found{this};
    Seen m_seen;
    std::optional<Step> m_chosen;
    QTimer m_timer;                                                   // until the outcome is there
    std::optional<std::chrono::steady_clock::time_point> m_startedAt; // the unit was started
    bool m_isWatched = false;
    bool m_isAsked = false;
    bool m_isAvailable = false;
    std::optional<UpdateOutcome> m_outcome; // until its notice is dismissed
    QString m_notice;
};

} // namespace campanel::panel
