// SPDX-License-Identifier: Apache-2.0
#include "app/panel/download/program_download.h"

#include "app/panel/controller/controller.h"
#include "app/panel/download/differences_text.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/cam_sentences.h"
#include "app/panel/words/connection_sentences.h"
#include "app/panel/words/controller_sentences.h"
#include "app/program/cam_advance.h"

#include <algorithm>
#include <array>

namespace campanel::panel {

using link::DownloadStage;

ProgramDownload::ProgramDownload(Controller& controller, const QString& folder, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_differences(this)
    , m_proof(controller, this)
    , m_windowReason(controller, folder, this)
    , m_forecast(controller, this)
{
    connect(&controller.link(), &link::Link::downloadReported, this, &ProgramDownload::takeReport);
    connect(&m_forecast, &ChangeForecast::changed, this, &ProgramDownload::update);
    connect(&controller, &Controller::programChanged, this, &ProgramDownload::update);
    connect(&controller, &Controller::savedChanged, this, &ProgramDownload::update);
    connect(&controller, &Controller::commandsChanged, this, &ProgramDownload::update);
    connect(&m_windowReason, &WindowReason::given, this, &ProgramDownload::update);
    LanguageNotifier::follow(this, &ProgramDownload::update);
}

void ProgramDownload::offer(std::shared_ptr<const program::ProgramImage> image)
{
    m_offer = std::move(image);
    if (!m_offer || m_offer->crc != m_report.crc)
        m_hasEnded = false;
    m_windowReason.setWanted(m_offer ? &m_offer->recipe : nullptr);
    update();
}

bool ProgramDownload::isUnderWay() const
{
    return m_sent.has_value();
}

void ProgramDownload::compare()
{
    const ControllerProgram* active = m_controller.program().get();
    // The status arrives before the header has been read again.
    const bool isActive =
        m_offer && m_controller.status() && m_controller.status()->activeCrc == m_offer->crc;
    const auto rows =
        m_offer && active && !isActive ? DifferencesText::rows(*active, *m_offer) : QList<DifferenceRow>();
    m_differs = m_offer && !isActive && (!active || !rows.isEmpty());
    m_differences.setRows(rows);
}

bool ProgramDownload::changesMachineData() const
{
    if (!m_offer || !m_controller.program())
        return false;
    const program::Recipe& active = m_controller.program()->recipe;
    const program::Recipe& wanted = m_offer->recipe;
    return active.kind() != wanted.kind() ||
           !profile::isSameScale(active.machine, wanted.machine,
                                 program::kindInfo(wanted.kind()).machineFields);
}

QString ProgramDownload::blockedReason() const
{
    if (const QString reason = m_controller.blockedReason(Action::Download); !reason.isEmpty())
        return reason;
    if (m_isDataLost)
        return tr("Not possible: the disk with the data of this machine is missing. The controller keeps its "
                  "program.");
    if (!m_offer)
        return tr("Not possible: the machine cannot execute this recipe.");
    if (!m_controller.identity()->supports(static_cast<modbus::ProgramKind>(m_offer->recipe.kind())))
        return tr("Not possible: this controller cannot execute this kind of program.");
    if (const QString reason = m_controller.masterSetting()->refusal(m_offer->recipe); !reason.isEmpty())
        return reason;
    const QString reason =
        changesMachineData() ? m_controller.blockedReason(Action::ChangeMachineData) : QString();
    return reason.isEmpty() ? m_forecast.refusal() : reason;
}

ProgramDownload::State ProgramDownload::stateOfOffer() const
{
    if (!program::isAdvanceConfirmed(m_offer->recipe.program))
        return State::Unconfirmed;
    return m_windowReason.isMissing() ? State::Unapproved : State::Ready;
}

void ProgramDownload::update()
{
    compare();
    m_windowReason.setRunning(m_offer && m_controller.program() && !m_differs);
    m_proof.update();
    m_forecast.update(m_differs ? m_offer.get() : nullptr);
    m_canRetry = false;
    if (isUnderWay()) {
        m_state = m_report.stage == DownloadStage::Armed     ? State::Armed
                  : m_report.stage == DownloadStage::Sealing ? State::Sealing
                                                             : State::Transferring;
    } else if (m_hasEnded && m_report.stage == DownloadStage::Failed) {
        m_state = State::Failed;
        m_canRetry = m_differs && blockedReason().isEmpty() && stateOfOffer() == State::Ready;
    } else if (!blockedReason().isEmpty()) {
        m_state = State::Blocked;
    } else if (m_hasEnded && m_report.stage == DownloadStage::Active && !m_differs) {
        m_state = State::Applied;
    } else {
        m_state = m_differs ? stateOfOffer() : State::NothingToDo;
    }
    emit changed();
}

QString ProgramDownload::readyText() const
{
    const double advanceMm = program::advanceMm(m_offer->recipe.program);
    const QString use = m_controller.state() == Controller::State::Running
                            ? m_forecast.text()
                            : tr("The new recipe is used from the next start.");
    return advanceMm == 0 ? use : QStringLiteral("%1 %2").arg(CamSentences::advance(advanceMm), use);
}

QString ProgramDownload::text() const
{
    switch (m_state) {
    case State::NothingToDo:
        return tr("The controller already has this program.");
    case State::Ready:
        return readyText();
    case State::Unconfirmed:
        return tr("%1 Confirm the advance, or close the cam.", "%1: whole sentence")
            .arg(CamSentences::unconfirmed(program::advanceMm(m_offer->recipe.program)));
    case State::Unapproved:
        return m_windowReason.question();
    case State::Blocked:
        return blockedReason();
    case State::Transferring:
    case State::Sealing:
    case State::Armed:
    case State::Failed:
        break;
    case State::Applied:
        return m_controller.run()->downloaded();
    }
    return ConnectionSentences::download(m_report);
}

QString ProgramDownload::controllerText() const
{
    if (!m_controller.status() || !m_controller.identity())
        return tr("Controller: unknown");
    if (!m_controller.program())
        return m_controller.status()->activeCrc ? tr("Controller: reading the program …")
                                                : tr("The controller has no program");
    const QString generation = QString::number(m_controller.program()->generation);
    if (!m_controller.isConnected() || !m_controller.fresh())
        return tr("No connection. Last known program in the controller: generation %1").arg(generation);
    if (!m_offer)
        return tr("Active in controller: generation %1").arg(generation);
    if (m_offer->recipe.kind() != m_controller.program()->recipe.kind())
        return tr("Active in controller: generation %1 · another kind of program").arg(generation);
    switch (m_differences.count()) {
    case 0:
        return tr("Active in controller: generation %1 · identical").arg(generation);
    case 1:
        return tr("Active in controller: generation %1 · 1 value differs").arg(generation);
    default:
        return tr("Active in controller: generation %1 · %2 values differ")
            .arg(generation)
            .arg(m_differences.count());
    }
}

QList<QPointF> ProgramDownload::changeCuts() const
{
    return m_forecast.price() ? PackingLine::drawn(program::cutsOfChange(m_forecast.film()))
                              : QList<QPointF>();
}

QString ProgramDownload::changeLength() const
{
    return m_forecast.price() ? ControllerSentences::nextLength(m_forecast.film()) : QString();
}

bool ProgramDownload::isSaved() const
{
    const auto& status = m_controller.status();
    return status && status->activeCrc && status->activeCrc == status->savedCrc;
}

bool ProgramDownload::canSave() const
{
    return m_controller.isConnected() && m_controller.fresh() && m_controller.status()->activeCrc &&
           !isSaved();
}

void ProgramDownload::download(const program::ProgramImage& image, const program::Recipe& recipe)
{
    m_sent = recipe;
    m_sentRegisters = image.registers;
    m_report = {};
    m_hasEnded = false;
    m_windowReason.begin(image.crc);
    emit begun(image);
    if (m_forecast.price())
        m_controller.run()->announceChange(*m_forecast.price(), m_forecast.film());
    sendTrims(recipe);
    m_controller.link().download(image.registers);
    update();
}

// They reach the controller before the program does, and come into force with it.
void ProgramDownload::sendTrims(const program::Recipe& recipe)
{
    const auto& identity = m_controller.identity();
    for (std::size_t i = 0; recipe.isCutter() && identity && i < program::trimCount; ++i) {
        const std::string name(program::trimTable[i].nextName);
        if (identity->hasRegister(name))
            m_controller.link().exchange({0, name, recipe.trims[i]}, {});
    }
}

void ProgramDownload::cancel()
{
    if (isUnderWay())
        m_controller.link().cancelDownload();
}

void ProgramDownload::save()
{
    if (canSave())
        m_controller.send(modbus::Command::SaveToFlash, {0, 0, *m_controller.status()->activeCrc});
}

void ProgramDownload::takeReport(const link::DownloadReport& report)
{
    if (!isUnderWay())
        return;
    m_report = report;
    const bool isOver = report.stage == DownloadStage::Active || report.stage == DownloadStage::Failed ||
                        report.stage == DownloadStage::Canceled;
    std::optional<program::Recipe> sent;
    if (isOver) {
        m_hasEnded = true;
        sent = std::exchange(m_sent, std::nullopt);
    }
    if (report.stage == DownloadStage::Active) {
        m_windowReason.end(report.crc);
        m_proof.noteDownloaded(std::move(m_sentRegisters), report.crc);
    }
    if (isOver)
        emit ended(report);
    if (sent && report.stage == DownloadStage::Active)
        emit applied(*sent);
    update();
}

} // namespace campanel::panel
