// SPDX-License-Identifier: Apache-2.0
#include "app/panel/update/software_update.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/package_sentences.h"

#include <QDBusError>
#include <QDBusPendingReply>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

const QString unitName = QStringLiteral("campanel-update.service");
constexpr auto pace = 1s;
constexpr auto patience = 5min; // a large package on a slow disk

QString minuteOf(const QString& utc)
{
    return Format::minute(QDateTime::fromString(utc, Qt::ISODate));
}

} // namespace

SoftwareUpdate::SoftwareUpdate(Controller& controller, const QString& folder, QObject* parent)
    : FileExchange(QDir(folder).filePath(u"packages"_s), parent)
    , m_controller(controller)
    , m_bus{[] { return QDBusConnection::systemBus(); }, u"org.freedesktop.systemd1"_s}
    , m_scanner(&store::exchangePlaces)
    , m_installed(&store::installedPackage)
{
    m_timer.setInterval(pace);
    m_timer.setSingleShot(true);
    m_timer.callOnTimeout(this, &SoftwareUpdate::lookAgain);
    connect(&controller, &Controller::stateChanged, this, &SoftwareUpdate::showRows);
    LanguageNotifier::follow(this, [this] {
        showRows();
        if (m_outcome)
            m_notice = outcomeText(*m_outcome);
    });
}

void SoftwareUpdate::open()
{
    if (!m_places.stagingFolder.isEmpty())
        lookAgain();
}

void SoftwareUpdate::setWatched(bool isWatched)
{
    if (std::exchange(m_isWatched, isWatched) != isWatched && isWatched)
        askForUnit();
    emit changed();
}

void SoftwareUpdate::send(const QString& method, const QVariantList& arguments,
                          const SystemService::Handler& handler)
{
    m_bus.send({u"/org/freedesktop/systemd1"_s, u"org.freedesktop.systemd1.Manager"_s, method, arguments},
               this, handler);
}

void SoftwareUpdate::askForUnit()
{
    const auto take = [this](bool isThere) {
        m_isAsked = true;
        m_isAvailable = isThere;
        emit changed();
    };
    if (m_places.stagingFolder.isEmpty())
        return take(false);
    send(u"GetUnitFileState"_s, {unitName}, [take](const QDBusPendingCall& answer) {
        const QDBusPendingReply<QString> reply(answer);
        take(!reply.isError() && reply.value() != u"masked");
    });
}

QString SoftwareUpdate::stateText() const
{
    return m_isAsked ? tr("Updates are installed by the package manager of this computer.") : QString();
}

std::function<FileExchange::Apply()> SoftwareUpdate::searcher()
{
    return [this, scan = m_scanner, folder = ownFolder(), installed = m_installed, places = m_places,
            checked = m_seen.checked]() -> Apply {
        Seen seen;
        seen.checked = checked;
        seen.installed = installed();
        seen.offers = store::offeredPackages(scan(folder), places.keyFolder, seen.checked);
        seen.back = readUpdateState(places).back;
        return [this, seen] { take(seen); };
    };
}

void SoftwareUpdate::take(const Seen& seen)
{
    m_seen = seen;
    showRows();
}

void SoftwareUpdate::showRows()
{
    QList<OfferRow> rows;
    for (const store::PackageOffer& offer : m_seen.offers)
        rows << row(offer);
    m_found.setRows(rows);
    emit changed();
}

QString SoftwareUpdate::installedVersion() const
{
    return m_seen.installed ? store::shortVersion(m_seen.installed->version) : QString();
}

OfferRow SoftwareUpdate::row(const store::PackageOffer& offer) const
{
    if (!offer.notice.isEmpty())
        return noticeRow(offer.placeName, offer.notice);
    OfferRow row;
    QString obstacle;
    QString word;
    if (!offer.package) {
        obstacle = PackageSentences::fault(offer.package.error());
        word = PackageSentences::shortFault(offer.package.error().kind);
    } else if (m_seen.installed) {
        obstacle = PackageSentences::mismatch(offer.package->package, *m_seen.installed);
        word = PackageSentences::shortMismatch(offer.package->package, *m_seen.installed);
    }
    row.usable = obstacle.isEmpty() && blockedReason().isEmpty();
    row.detail = !obstacle.isEmpty() ? obstacle
                 : row.usable        ? tr("The panel closes, installs this version and comes back.")
                                     : blockedReason();
    row.title = offer.package
                    ? tr("CamPanel %1", "version").arg(store::shortVersion(offer.package->package.version))
                    : QFileInfo(offer.path).fileName();
    if (!obstacle.isEmpty()) {
        row.note = tr("cannot be used: %1 · %2", "reason, place").arg(word, offer.placeName);
        return row;
    }
    const QString date = Format::minute(QDateTime::fromMSecsSinceEpoch(offer.package->signedMs));
    row.note =
        tr("signed by %1, %2 · %3", "person, date, place").arg(offer.package->signer, date, offer.placeName);
    return row;
}

QString SoftwareUpdate::blockedReason() const
{
    if (!m_seen.installed)
        return tr("CamPanel was not installed as a package. Install it once by the package manager.");
    return m_controller.blockedReason(Action::UpdateSoftware);
}

QString SoftwareUpdate::backVersion() const
{
    const bool isValid = m_seen.back && m_seen.installed && m_seen.back->over == m_seen.installed->version;
    return isValid ? store::shortVersion(m_seen.back->version) : QString();
}

QString SoftwareUpdate::actionOf(int row) const
{
    if (row < 0 || row >= m_seen.offers.size() || !m_seen.offers[row].package)
        return tr("Update");
    return tr("Update to %1", "version")
        .arg(store::shortVersion(m_seen.offers[row].package->package.version));
}

bool SoftwareUpdate::require()
{
    return m_controller.accessCheck().require(Level::Service) && !busy() && blockedReason().isEmpty();
}

void SoftwareUpdate::choose(int row)
{
    if (!require() || row < 0 || row >= m_found.count() || !m_found.row(row).usable)
        return;
    Step step{{m_seen.offers[row].path, {}}, m_seen.offers[row].package->package.version};
    for (const store::PackageOffer& offer : m_seen.offers) {
        if (offer.package && offer.package->package == *m_seen.installed)
            step.request.installed = offer.path;
    }
    m_chosen = step;
    emit changed();
    emit chosen();
}

void SoftwareUpdate::chooseBack()
{
    if (!require() || backVersion().isEmpty())
        return;
    m_chosen = Step{{}, m_seen.back->version};
    emit changed();
    emit chosen();
}

QString SoftwareUpdate::actionText() const
{
    if (!m_chosen)
        return {};
    const QString version = store::shortVersion(m_chosen->version);
    return m_chosen->request.package.isEmpty() ? tr("Back to %1", "version").arg(version)
                                               : tr("Update to %1", "version").arg(version);
}

QString SoftwareUpdate::question() const
{
    if (!m_chosen)
        return {};
    if (!m_chosen->request.package.isEmpty())
        return tr("CamPanel %1 is replaced by %2. The panel closes for some minutes; the controller keeps "
                  "its program. If the new version does not start, the panel puts %1 and its data back.")
            .arg(installedVersion(), store::shortVersion(m_chosen->version));
    if (m_seen.back && m_seen.back->schema == store::dataSchema())
        return tr("CamPanel %1 is replaced by %2. The panel closes for some minutes. Recipes and records "
                  "stay.")
            .arg(installedVersion(), store::shortVersion(m_chosen->version));
    return tr("CamPanel %1 is replaced by %2, which cannot read the present data. Recipes, users, settings "
              "and records become those of %3; what was saved since then is put aside on this panel.")
        .arg(installedVersion(), store::shortVersion(m_chosen->version),
             m_seen.back ? minuteOf(m_seen.back->utc) : QString());
}

void SoftwareUpdate::confirm()
{
    if (!require() || !m_chosen)
        return;
    const Step step = *std::exchange(m_chosen, std::nullopt);
    const bool isBack = step.request.package.isEmpty();
    emit noted({.what = isBack ? u"update.back"_s : u"update.start"_s,
                .object = isBack ? u"campanel"_s : QFileInfo(step.request.package).fileName(),
                .before = m_seen.installed->version,
                .after = step.version,
                .outcome = u"requested"_s});
    showMessage(tr("Preparing … The panel closes soon and comes back."), false);
    begin(); // until the panel is ended, or the unit has refused
    run([places = m_places, request = step.request] { return writeRequest(places, request); },
        [this](const QString& problem) {
            if (problem.isEmpty())
                startUnit();
            else
                endWork(tr("Not updated: %1").arg(problem));
        });
}

void SoftwareUpdate::startUnit()
{
    send(u"StartUnit"_s, {unitName, u"replace"_s}, [this](const QDBusPendingCall& answer) {
        if (!answer.isError()) {
            m_startedAt = std::chrono::steady_clock::now();
            m_timer.start();
            return;
        }
        const QString forbidden = SystemService::forbiddenText(answer.error());
        endWork(forbidden.isEmpty() ? tr("Not updated: %1").arg(answer.error().message()) : forbidden);
    });
}

void SoftwareUpdate::endWork(const QString& problem)
{
    withdrawRequest(m_places);
    m_startedAt.reset();
    m_timer.stop();
    showMessage(problem, true);
    end();
}

void SoftwareUpdate::lookAgain()
{
    run([places = m_places] { return readUpdateState(places); },
        [this](const UpdateState& state) {
            const bool isLate = m_startedAt && std::chrono::steady_clock::now() - *m_startedAt > patience;
            if (state.outcome)
                take(*state.outcome);
            else if (isLate && !state.isUnfinished)
                endWork(tr("The update did not begin. Read journalctl -u campanel-update."));
            else if (m_startedAt || state.isUnfinished)
                m_timer.start();
        });
}

void SoftwareUpdate::take(const UpdateOutcome& outcome)
{
    const bool isDone = outcome.result == u"done";
    emit ended({.what = u"update.end"_s,
                .object = u"campanel"_s,
                .before = outcome.from,
                .after = isDone ? outcome.to : outcome.from,
                .outcome = isDone || outcome.result == u"refused" ? outcome.result : u"failed"_s});
    run(
        [places = m_places, outcome] {
            noteReported(places, outcome);
            return true;
        },
        [](bool) {});
    if (m_startedAt)
        return endWork(outcomeText(outcome));
    m_outcome = outcome;
    m_notice = outcomeText(outcome);
    emit noticeChanged();
}

QString SoftwareUpdate::outcomeText(const UpdateOutcome& outcome)
{
    const QString from = store::shortVersion(outcome.from);
    const QString to = store::shortVersion(outcome.to);
    const QString reason = PackageSentences::failure(outcome.reason, outcome.detail);
    if (outcome.result == u"refused")
        return tr("Nothing was installed. %1", "%1: whole sentences").arg(reason);
    if (outcome.result == u"returned")
        return tr("CamPanel %1 could not be used. %2 The panel has put %3 and its data back.",
                  "version, whole sentences, version")
            .arg(to, reason, from);
    if (outcome.result != u"done")
        return tr("CamPanel %1 could not be installed, and %2 could not be put back completely. Install "
                  "CamPanel by the package manager. %3",
                  "version, version, whole sentences")
            .arg(to, from, reason);
    if (outcome.kind == u"update")
        return tr("Updated from %1 to %2.").arg(from, to);
    return outcome.data == u"restored"
               ? tr("Back from %1 to %2, with the data from before the update.").arg(from, to)
               : tr("Back from %1 to %2.").arg(from, to);
}

void SoftwareUpdate::dismissNotice()
{
    m_outcome.reset();
    m_notice.clear();
    emit noticeChanged();
}

} // namespace campanel::panel
