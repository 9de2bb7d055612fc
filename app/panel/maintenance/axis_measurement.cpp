// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/axis_measurement.h"

#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/connection_sentences.h"
#include "app/panel/words/controller_sentences.h"
#include "app/panel/words/recipe_words.h"

#include <array>
#include <cmath>
#include <string_view>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

using modbus::MeasuredAxis;
using modbus::MeasureState;

constexpr auto measurePeriod = 250ms;
constexpr const char* filmPulsesName = "parameter.film_pulses";
constexpr const char* filmFeedName = "parameter.film_feed";
constexpr const char* mainMotorPulses = "pulses_per_motor_rev";

struct AxisSubject {
    std::string_view name;
    AxisMeasurement::Subject subject;
    MeasuredAxis axis;
};

constexpr std::array axisSubjects{
    AxisSubject{"signal.knife_reversed", AxisMeasurement::Subject::Direction, MeasuredAxis::Knife},
    AxisSubject{"signal.film_reversed", AxisMeasurement::Subject::Direction, MeasuredAxis::Film},
    AxisSubject{"signal.infeed_reversed", AxisMeasurement::Subject::Direction, MeasuredAxis::Infeed},
    AxisSubject{filmPulsesName, AxisMeasurement::Subject::Turns, MeasuredAxis::Film},
    AxisSubject{filmFeedName, AxisMeasurement::Subject::Film, MeasuredAxis::Film},
    AxisSubject{"parameter.flight_pulses", AxisMeasurement::Subject::Turns, MeasuredAxis::Infeed},
};

QString lengthText(double mm)
{
    return Format().measure(mm, 1, u"mm"_s);
}

} // namespace

AxisMeasurement::AxisMeasurement(Controller& controller, QObject* parent)
    : Watched(parent)
    , m_controller(controller)
    , m_fields(controller, this)
    , m_pins(controller, this)
{
    connect(&controller, &Controller::connectionChanged, this, &AxisMeasurement::noteConnection);
    connect(&controller, &Controller::stateChanged, this, &AxisMeasurement::changed);
    connect(&controller, &Controller::commandsChanged, this, &AxisMeasurement::changed);
    connect(&controller, &Controller::commandEnded, this, &AxisMeasurement::takeCommand);
    connect(&m_fields, &AxisFields::changed, this, &AxisMeasurement::changed);
    connect(&m_fields, &AxisFields::written, this, &AxisMeasurement::takeWritten);
    connect(&m_pins, &IoPins::changed, this,
            [this] { m_fields.setReversible(!m_pins.status() || m_pins.status()->canReverse); });
    connect(&m_ruler, &Value::setRequested, this, [this](double lengthMm) {
        if (!m_controller.accessCheck().require(Level::Technician))
            return;
        m_rulerMm = lengthMm;
        setStep(Step::Result);
    });
    connect(this, &AxisMeasurement::changed, this, &AxisMeasurement::updateRuler);
    connect(&controller.link(), &link::Link::rulerRead, this, &AxisMeasurement::takeRuler);
    connect(this, &Watched::watchedChanged, this, [this] {
        if (!watched() && m_step == Step::Moving) // nobody sees the axis turn
            m_controller.send(modbus::Command::StopAtCycleEnd);
    });
    updateEvery(measurePeriod, [this] { read(); });
    LanguageNotifier::follow(this);
}

void AxisMeasurement::follow(Editor& editor)
{
    m_editor = &editor;
    connect(&editor, &Editor::fieldsChanged, this, &AxisMeasurement::changed);
}

void AxisMeasurement::open()
{
    m_fields.read();
    m_pins.read();
}

QString AxisMeasurement::emptyText() const
{
    if (!m_controller.isConnected())
        return tr("No data of the axes. Connect the controller.");
    if (!m_controller.identity() || m_controller.identity()->mapMinor < modbus::measureMapMinor)
        return tr("This controller cannot measure its axes. Update the controller: its register map must be "
                  "1.7 or newer.");
    return {};
}

void AxisMeasurement::prepare(Subject subject, MeasuredAxis axis, const char* name)
{
    m_subject = subject;
    m_axis = axis;
    m_name = name;
    m_rulerMm = unknown;
    m_isTurning = false;
    m_sentence.clear();
    open();
    setStep(Step::Ready);
    read();
}

void AxisMeasurement::begin(int row)
{
    if (row < 0 || row >= m_fields.rowCount())
        return;
    const char* name = m_fields.nameOf(row);
    for (const AxisSubject& each : axisSubjects) {
        if (each.name == name)
            prepare(each.subject, each.axis, name);
    }
}

void AxisMeasurement::beginMainMotor()
{
    prepare(Subject::Turns, MeasuredAxis::Knife, nullptr);
}

void AxisMeasurement::setStep(Step step)
{
    m_step = step;
    emit changed();
}

void AxisMeasurement::fail(const QString& sentence)
{
    m_isTurning = false;
    m_sentence = tr("%1 Nothing was changed.").arg(sentence);
    setStep(Step::Failed);
}

QString AxisMeasurement::title() const
{
    return isMainMotor() ? tr("Pulses per turn of the main motor")
                         : AxisFields::words(QLatin1StringView(m_name));
}

QString AxisMeasurement::blockedReason() const
{
    if (m_step == Step::Moving || m_step == Step::Writing)
        return {};
    if (const QString empty = emptyText(); !empty.isEmpty())
        return empty;
    return m_subject == Subject::Film ? QString() : m_controller.blockedReason(Action::Measure);
}

void AxisMeasurement::start()
{
    if (!m_controller.accessCheck().require(Level::Technician) || !blockedReason().isEmpty() ||
        m_subject == Subject::Film || m_step == Step::Moving || m_step == Step::Writing)
        return;
    const std::uint16_t turns = m_subject == Subject::Turns ? modbus::measuredTurns : std::uint16_t{0};
    m_isTurning = false;
    m_status.reset();
    setStep(Step::Moving);
    m_controller.startBy(modbus::Command::Measure, {static_cast<std::uint16_t>(m_axis), turns, 0});
}

void AxisMeasurement::takeCommand(const link::CommandOutcome& outcome)
{
    if (outcome.command != modbus::Command::Measure || m_step != Step::Moving)
        return;
    m_isTurning = outcome.end == link::CommandEnd::Done;
    if (m_isTurning)
        read();
    else
        fail(ConnectionSentences::command(outcome));
}

void AxisMeasurement::read()
{
    if (m_isAsked || !emptyText().isEmpty())
        return;
    m_isAsked = true;
    m_controller.link().readRegisters(
        {0, modbus::measureAddress, modbus::measureRegisters},
        {this, [this](const link::ReadOutcome& outcome) { takeRead(outcome); }});
}

void AxisMeasurement::takeRead(const link::ReadOutcome& outcome)
{
    m_isAsked = false;
    if (outcome.end != link::ReadEnd::Done || outcome.registers.size() != modbus::measureRegisters)
        return;
    m_status = modbus::decodeMeasure(outcome.registers);
    if (m_step == Step::Moving && m_isTurning && m_status->state == MeasureState::Done) {
        m_isTurning = false;
        setStep(m_subject == Subject::Direction ? Step::Question : Step::Result);
        note(u"done"_s);
    } else if (m_step == Step::Moving && m_isTurning && m_status->state == MeasureState::Ended) {
        const QString reason = ControllerSentences::refusal(m_status->reason);
        fail(reason.isEmpty() ? tr("The measurement was stopped.") : reason);
        note(m_status->reason == modbus::Refusal::None ? u"stopped"_s : u"failed"_s);
    }
    emit changed();
}

void AxisMeasurement::note(const QString& outcome)
{
    const bool isCounted = m_subject == Subject::Turns && m_step == Step::Result;
    emit ended(QLatin1StringView(m_name ? m_name : mainMotorPulses),
               isCounted ? QLocale::c().toString(measured(), 'f', 0) : QString(), outcome);
}

void AxisMeasurement::noteConnection()
{
    m_isAsked = false;
    m_isRulerAsked = false;
    if (!m_controller.isConnected()) {
        m_status.reset();
        if (m_step == Step::Moving) {
            fail(tr("The connection was lost during the measurement. The controller stops the axis."));
            note(u"unknown"_s);
        }
    } else if (watched()) {
        open();
    }
    emit changed();
}

double AxisMeasurement::progress() const
{
    const bool isMoving = m_step == Step::Moving && m_status && m_isTurning;
    return isMoving ? static_cast<double>(m_status->turns) / modbus::measuredTurns : 0.0;
}

double AxisMeasurement::present() const
{
    if (m_name)
        return m_fields.value(m_name);
    return m_editor ? m_editor->field(QLatin1StringView(mainMotorPulses))->value() : unknown;
}

// The index mark of a cutter is on the shaft, of another axis on the motor.
double AxisMeasurement::motorTurns() const
{
    if (!isMainMotor() || !m_editor ||
        m_controller.active().kind != static_cast<int>(profile::ProgramKind::RotaryCutter))
        return 1.0;
    return m_editor->field(u"gear_numerator"_s)->value() / m_editor->field(u"gear_denominator"_s)->value();
}

double AxisMeasurement::bagMm() const
{
    return m_status && m_status->bagPulses
               ? *m_status->bagPulses / m_fields.value(filmPulsesName) * m_fields.value(filmFeedName)
               : unknown;
}

double AxisMeasurement::measured() const
{
    if (!m_status || (m_step != Step::Result && m_step != Step::Writing))
        return unknown;
    if (m_subject == Subject::Film)
        return m_rulerMm / bagMm() * m_fields.value(filmFeedName);
    return m_subject == Subject::Turns ? std::round(m_status->pulses / motorTurns()) : unknown;
}

bool AxisMeasurement::areTurnsEven() const
{
    return m_subject != Subject::Turns || m_status->areTurnsEven();
}

bool AxisMeasurement::canTake() const
{
    if (m_step != Step::Result || !std::isfinite(measured()) || !areTurnsEven())
        return false;
    if (!m_name)
        return m_editor && m_editor->field(QLatin1StringView(mainMotorPulses))->isInRange(measured());
    const modbus::RegisterInfo* info = modbus::findRegister(m_name);
    return info && measured() >= info->minimum && measured() <= info->maximum;
}

void AxisMeasurement::updateRuler()
{
    const double setMm = bagMm();
    if (!(setMm > 0))
        return;
    m_ruler.show({tr("Length of the last bag by the ruler"), u"mm"_s,
                  std::isfinite(m_rulerMm) ? Format().amount(m_rulerMm, 1, u"mm"_s) : Format::unknownText(),
                  (1 - modbus::maxBagDeviation) * setMm, (1 + modbus::maxBagDeviation) * setMm, setMm, 1,
                  m_rulerMm});
}

void AxisMeasurement::measureSimulatedBag()
{
    m_isRulerAsked = true;
    m_controller.link().measureSimulatedBag();
}

void AxisMeasurement::takeRuler(const link::RulerOutcome& outcome)
{
    if (!std::exchange(m_isRulerAsked, false) || outcome.end != link::RulerEnd::Read)
        return;
    if (m_ruler.isInRange(outcome.lengthMm))
        m_ruler.set(outcome.lengthMm * m_ruler.shown().factor);
}

void AxisMeasurement::write(double value)
{
    m_before = present();
    setStep(Step::Writing);
    m_fields.write(m_name, value);
}

void AxisMeasurement::take()
{
    if (!m_controller.accessCheck().require(Level::Technician) || !canTake())
        return;
    if (m_name) {
        write(measured());
        return;
    }
    const double before = present();
    const double after = measured();
    EditorField* field = m_editor->field(QLatin1StringView(mainMotorPulses));
    field->set(after);
    if (field->value() != after) {
        fail(tr("The machine data could not be changed now."));
        return;
    }
    m_sentence = tr("%1 instead of %2 is in the machine data now. Download the recipe to use it.")
                     .arg(amount(after), amount(before));
    setStep(Step::Done);
    emit taken(QLatin1StringView(mainMotorPulses), before, after);
}

void AxisMeasurement::keepDirection()
{
    if (!m_controller.accessCheck().require(Level::Technician) || m_step != Step::Question)
        return;
    m_sentence = tr("The direction is right. Nothing was changed.");
    setStep(Step::Done);
}

void AxisMeasurement::turnAround()
{
    if (!m_controller.accessCheck().require(Level::Technician) || m_step != Step::Question ||
        !std::isfinite(present()))
        return;
    write(present() > 0 ? 0 : 1);
}

void AxisMeasurement::takeWritten(const QString& name, bool isDone, const QString& sentence)
{
    if (m_step != Step::Writing || name != QLatin1StringView(m_name))
        return;
    if (!isDone) {
        m_sentence = sentence;
        setStep(Step::Failed);
        return;
    }
    m_sentence = m_subject == Subject::Direction
                     ? tr("The motor turns the other way now. Measure its direction again, then save.")
                     : tr("%1 instead of %2 is in the controller now. Save it there.")
                           .arg(amount(present()), amount(m_before));
    setStep(Step::Done);
}

QString AxisMeasurement::amount(double value) const
{
    if (!std::isfinite(value))
        return Format::unknownText();
    if (m_subject == Subject::Direction)
        return value > 0 ? tr("Reversed") : tr("As wired");
    return m_subject == Subject::Film ? Format().measure(value, 3, u"mm"_s)
                                      : tr("%1 pulses").arg(Format().grouped(value, 0));
}

QString AxisMeasurement::presentText() const
{
    return amount(present());
}

QString AxisMeasurement::measuredText() const
{
    return amount(measured());
}

QString AxisMeasurement::readyText() const
{
    if (m_subject == Subject::Film && !hasBag())
        return tr("The controller knows no bag yet. Make one bag twice, or let the machine run, then measure "
                  "the last bag with a ruler.");
    if (m_subject == Subject::Film)
        return tr("By the present setting bag %1 is %2 long. Measure it with a ruler and enter its length, "
                  "%3 "
                  "to %4: a bag that is farther off is another one.")
            .arg(QString::number(m_status->bag), lengthText(bagMm()),
                 lengthText((1 - modbus::maxBagDeviation) * bagMm()),
                 lengthText((1 + modbus::maxBagDeviation) * bagMm()));
    if (m_subject == Subject::Direction)
        return tr("Keep hands away: the axis turns slowly by a quarter of a turn, forward. Watch which way.");
    if (m_axis == MeasuredAxis::Knife)
        return tr(
            "Keep hands away and take the film out of the jaws: the axis turns slowly forward, past five "
            "index marks. The controller counts its pulses.");
    return m_axis == MeasuredAxis::Film
               ? tr("Keep hands away: the film motor turns slowly forward, past five index marks. The "
                    "controller counts its pulses.")
               : tr("Keep hands away: the infeed moves slowly forward by five products. The controller "
                    "counts "
                    "its pulses.");
}

QString AxisMeasurement::resultText() const
{
    if (!areTurnsEven())
        return tr("The turns differ by %1 pulses, too much. Check the index sensor, then measure again.")
            .arg(Format().grouped(m_status->spread, 1));
    if (!canTake())
        return tr("The measured value is outside the range of the setting. Check the sensor and the bag.");
    return m_subject == Subject::Film
               ? tr("The bag is %1 by the ruler and %2 by the setting.")
                     .arg(lengthText(m_rulerMm), lengthText(bagMm()))
               : tr("Five turns, which differ by %1 pulses.").arg(Format().grouped(m_status->spread, 1));
}

QString AxisMeasurement::text() const
{
    switch (m_step) {
    case Step::Ready:
        return readyText();
    case Step::Moving:
        return m_subject == Subject::Turns && m_status && m_isTurning
                   ? tr("Turning: %1 of %2 turns counted.")
                         .arg(QString::number(m_status->turns), QString::number(modbus::measuredTurns))
                   : tr("Turning …");
    case Step::Question:
        return tr("Which way did it go?");
    case Step::Result:
        return m_status ? resultText() : Format::unknownText();
    case Step::Writing:
        return tr("Writing …");
    case Step::Done:
    case Step::Failed:
        break;
    }
    return m_sentence;
}

} // namespace campanel::panel
