// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/master_setting.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/controller_sentences.h"
#include "app/panel/words/master_sentences.h"

#include <chrono>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

constexpr auto linePeriod = 500ms;

} // namespace

MasterSetting::MasterSetting(Controller& controller)
    : Watched(&controller)
    , m_controller(controller)
    , m_source(controller.parameter("master.source"))
    , m_available(controller.parameter("master_status.available"))
    , m_speedMax(controller.parameter("master.speed_max"))
    , m_revolution(controller.parameter("master.revolution"))
{
    for (const modbus::RegisterInfo& info : modbus::registers()) {
        if (!info.name.starts_with("master.") || info.name == m_source.info().name)
            continue;
        m_ofEncoder << &controller.parameter(info.name);
        connect(m_ofEncoder.last(), &Parameter::changed, this, &MasterSetting::changed);
    }
    connect(&m_available, &Parameter::changed, this, &MasterSetting::changed);
    connect(&m_source, &Parameter::changed, this, &MasterSetting::changed);
    connect(&m_source, &Parameter::changed, this, &MasterSetting::read);
    connect(&controller, &Controller::connectionChanged, this, &MasterSetting::read);
    // A value that was not certain when it was read is read again.
    connect(&controller, &Controller::stateChanged, this, &MasterSetting::read);
    connect(&controller, &Controller::programChanged, this, &MasterSetting::changed);
    updateEvery(linePeriod, [this] {
        if (leads())
            readLine();
    });
    LanguageNotifier::follow(this);
}

void MasterSetting::read()
{
    const auto& identity = m_controller.identity();
    if (!m_controller.isConnected()) {
        m_isAsked = false;
        if (std::exchange(m_line, std::nullopt))
            emit lineChanged();
        return;
    }
    if (!identity || !identity->hasRegister(m_source.info().name))
        return;
    m_source.readIfUncertain();
    m_available.readIfUncertain();
    if (!followsEncoder())
        return;
    for (Parameter* each : m_ofEncoder)
        each->readIfUncertain();
}

void MasterSetting::readLine()
{
    if (m_isAsked || !m_controller.isConnected())
        return;
    m_isAsked = true;
    m_controller.link().readRegisters(
        {0, modbus::masterStatusAddress, modbus::masterStatusRegisters},
        {this, [this](const link::ReadOutcome& outcome) { takeLine(outcome); }});
}

void MasterSetting::takeLine(const link::ReadOutcome& outcome)
{
    m_isAsked = false;
    if (outcome.end != link::ReadEnd::Done || outcome.registers.size() != modbus::masterStatusRegisters)
        return;
    m_line = modbus::decodeMasterStatus(outcome.registers);
    emit lineChanged();
}

// Without the setting in its map a controller follows its clock.
QString MasterSetting::text() const
{
    const auto& identity = m_controller.identity();
    const bool hasSetting = identity && identity->hasRegister(m_source.info().name);
    if (!m_controller.isConnected() || (hasSetting && std::isnan(m_source.lastValue())))
        return Format::unknownText();
    if (!followsEncoder())
        return MasterSentences::name(program::RecipeMaster::Clock);
    const auto valueOf = [this](const char* name) {
        const Parameter& parameter = m_controller.parameter(name);
        return MasterSentences::value(parameter.info(), parameter.lastValue());
    };
    return u"%1 · %2 · %3"_s.arg(valueOf("master.source"), valueOf("master.place"), valueOf("master.counts"));
}

QString MasterSetting::lineText() const
{
    if (!leads() || !m_line)
        return {};
    return u"%1 · %2"_s.arg(m_line->state ? ControllerSentences::text(*m_line->state) : Format::unknownText(),
                            Format().measure(m_line->speedMmPerS, 0, u"mm/s"_s));
}

QList<const Parameter*> MasterSetting::parameters() const
{
    QList<const Parameter*> all(m_ofEncoder.begin(), m_ofEncoder.end());
    all.prepend(&m_source);
    return all;
}

bool MasterSetting::followsEncoder() const
{
    return m_source.lastValue() == static_cast<double>(modbus::MasterSource::Encoder);
}

bool MasterSetting::hasInput() const
{
    return m_available.lastValue() == 1.0;
}

bool MasterSetting::leads() const
{
    const auto& program = m_controller.program();
    return followsEncoder() && program && program::hasMaster(program->recipe);
}

QString MasterSetting::rateText() const
{
    return leads() ? MasterSentences::rateOfLine() : QString();
}

std::optional<program::MachineMaster> MasterSetting::machine() const
{
    if (std::isnan(m_source.lastValue()) || std::isnan(m_available.lastValue()))
        return std::nullopt;
    return program::MachineMaster{followsEncoder(), hasInput()};
}

double MasterSetting::maxSpeedShare() const
{
    constexpr double percent = 100;
    const double value = m_speedMax.lastValue();
    return (std::isnan(value) ? m_speedMax.info().defaultValue : value) / percent;
}

double MasterSetting::revolutionMm() const
{
    const double value = m_revolution.lastValue();
    return std::isnan(value) ? m_revolution.info().defaultValue : value;
}

QString MasterSetting::refusal(const program::Recipe& recipe) const
{
    const auto known = machine();
    return known ? MasterSentences::refusal(program::masterRefusal(recipe, *known)) : QString();
}

void MasterSetting::explainRate()
{
    const QString sentence = rateText();
    if (sentence.isEmpty())
        return;
    if (!m_line) {
        emit explained(sentence);
        return;
    }
    const Format format;
    emit explained(sentence + u'\n' +
                   tr("%1. Encoder at %2, phase %3.")
                       .arg(lineText(), format.measure(m_line->angleDeg, 0, u"°"_s),
                            format.measure(m_line->phaseDeg, 2, u"°"_s)));
}

} // namespace campanel::panel
