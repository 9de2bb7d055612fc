// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/master_watch.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/kit/numbers.h"
#include "app/panel/words/controller_sentences.h"

#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

using modbus::MasterState;

constexpr auto masterPeriod = 250ms;

} // namespace

MasterWatch::MasterWatch(Controller& controller, QObject* parent)
    : Watched(parent)
    , m_controller(controller)
    , m_fields(controller, this)
{
    connect(&controller, &Controller::connectionChanged, this, &MasterWatch::noteConnection);
    connect(&m_fields, &ParameterFields::changed, this, &MasterWatch::noteFields);
    connect(this, &Watched::watchedChanged, this, [this] {
        m_bag.reset(); // the lag of a cut that nobody saw belongs to an unknown speed
        if (watched() && isReported())
            m_fields.read();
    });
    connect(controller.masterSetting(), &MasterSetting::lineChanged, this, &MasterWatch::takeLine);
    updateEvery(masterPeriod, [this] {
        if (isReported())
            m_controller.masterSetting()->readLine();
    });
    LanguageNotifier::follow(this, [this] { show(); });
}

bool MasterWatch::isReported() const
{
    return m_controller.isConnected() && m_controller.identity() &&
           m_controller.identity()->mapMinor >= modbus::masterMapMinor;
}

void MasterWatch::noteConnection()
{
    if (!m_controller.isConnected()) {
        m_delay = {};
        m_bag.reset();
    } else if (watched() && isReported())
        m_fields.read();
    show();
}

// Cuts with another delay are another measurement.
void MasterWatch::noteFields()
{
    const double presentMs = m_fields.value("master.delay");
    if (!std::isnan(presentMs) && std::exchange(m_presentMs, presentMs) != presentMs) {
        m_delay = {};
        m_fields.update(available(), line() ? line()->smoothingMs : unknown, m_delay);
    }
    emit changed();
}

void MasterWatch::takeLine()
{
    if (!watched() || !line())
        return;
    takeCut();
    m_fields.update(available(), line()->smoothingMs, m_delay);
    show();
}

void MasterWatch::takeCut()
{
    const auto& status = m_controller.status();
    if (!status || line()->state != MasterState::Engaged) {
        m_bag.reset();
        return;
    }
    const auto before = std::exchange(m_bag, status->bagCount);
    if (before && before != m_bag)
        m_delay.add(line()->speedMmPerS, line()->lagMm);
}

const std::optional<modbus::MasterStatus>& MasterWatch::line() const
{
    return m_controller.masterSetting()->line();
}

double MasterWatch::angleDeg() const
{
    return available() ? line()->angleDeg : unknown;
}

void MasterWatch::show()
{
    QList<MasterRow> rows;
    if (available()) {
        const Format format;
        const auto mm = [&format](double value) { return format.measure(value, 3, u"mm"_s); };
        const modbus::MasterStatus& status = *line();
        rows = {
            {tr("Counts since power-up"), format.grouped(status.counts, 0)},
            {tr("Speed"), format.measure(status.speedMmPerS, 1, u"mm/s"_s)},
            {tr("Ripple of the speed"), format.measure(status.ripplePercent, 2, u"%"_s)},
            {tr("Phase in use"), format.measure(status.phaseDeg, 2, u"°"_s)},
            {tr("Error of the measured position"), mm(status.errorMm)},
            {tr("Lead of the axes"), mm(status.leadMm)},
            {tr("Lag at the last cut"), mm(status.lagMm)},
            {tr("Line waits for the master"), mm(status.heldMm)},
            {tr("Film until engaged"), mm(status.toEngagedMm)},
            {tr("Error of the index mark"), tr("%1 counts").arg(format.number(status.indexErrorCounts, 0))},
            {tr("Slip between two marks"), mm(status.slipMm)},
            {tr("Input errors"), QString::number(status.inputErrors)}};
        if (wheel())
            rows << MasterRow{tr("Film passed uncut"), format.measure(status.passedM, 2, u"m"_s)};
    }
    m_rows.setRows(rows);
    emit changed();
}

QString MasterWatch::countsText() const
{
    const double counts = m_fields.value("master.counts");
    return std::isnan(counts) ? Format::unknownText() : tr("%1 counts").arg(Format().grouped(counts, 0));
}

QString MasterWatch::revolutionText() const
{
    const double lengthMm = m_fields.value("master.revolution");
    return std::isnan(lengthMm) ? Format::unknownText()
                                : tr("%1 / turn").arg(Format().compactMeasure(lengthMm, 0, 3, u"mm"_s));
}

QString MasterWatch::stateText() const
{
    if (!line() || std::isnan(m_fields.value("master.source")))
        return Format::unknownText();
    if (!leads())
        return tr("The line follows the clock of the controller.");
    if (!line()->isAvailable)
        return ControllerSentences::refusal(modbus::Refusal::NoMasterInput);
    if (!line()->state)
        return Format::unknownText();
    const QString state = ControllerSentences::text(*line()->state);
    return line()->state == MasterState::Engaging
               ? tr("%1: %2 of film until engaged", "%1: the state, Engaging")
                     .arg(state, Format().measure(line()->toEngagedMm, 0, u"mm"_s))
               : state;
}

QString MasterWatch::delayText() const
{
    if (std::isnan(m_fields.value("master.source")))
        return {};
    if (!leads())
        return tr("Delay: measured only while an encoder leads the line.");
    const auto measured = m_delay.measured();
    if (!measured)
        return m_delay.hasOneSpeed()
                   ? tr("Delay: %1 cuts measured. Let the line run at least a fifth faster or slower.")
                         .arg(m_delay.cuts())
                   : tr("Delay: %1 cuts measured. Let the line cut bags at a constant speed.")
                         .arg(m_delay.cuts());
    const Format format;
    const QString found = format.measure(measured->ms, 3, u"ms"_s);
    const QString margin = format.measure(measured->marginMs, 3, u"ms"_s);
    if (measured->marginMs > program::MasterDelay::maxMarginMs)
        return tr("Delay: off by %1 ±%2, too uncertain. Let the line run longer at two speeds.")
            .arg(found, margin);
    if (m_delay.offered(m_presentMs))
        return tr("Delay: off by %1 ±%2. Set up offers the corrected delay.").arg(found, margin);
    return tr("Delay: off by %1 ±%2. No correction is needed.").arg(found, margin);
}

QString MasterWatch::emptyText() const
{
    if (!m_controller.isConnected())
        return tr("No data of the master. Connect the controller.");
    if (!isReported())
        return tr("This controller cannot follow an encoder. Update the controller: its register map must be "
                  "1.6 or newer.");
    // An encoder that leads nevertheless is set back here.
    if (line() && !line()->isAvailable && !leads())
        return tr(
            "This controller has no input for an encoder. The line follows the clock of the controller.");
    return {};
}

} // namespace campanel::panel
