// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/io_list.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/alarm_catalogue.h"
#include "app/panel/words/controller_sentences.h"

#include <algorithm>
#include <utility>

using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

// The minimum time of a lamp for a short event, so that it can be seen.
constexpr auto lampPeriod = 300ms;

using modbus::FaultBit;
using modbus::WarningBit;

IoList::Lamp lampOf(bool isOn)
{
    return isOn ? IoList::Lamp::On : IoList::Lamp::Off;
}

// A condition has one color wherever it is shown.
IoList::Lamp lampOf(AlarmSeverity severity)
{
    return severity == AlarmSeverity::Fault     ? IoList::Lamp::Bad
           : severity == AlarmSeverity::Warning ? IoList::Lamp::Warning
                                                : IoList::Lamp::On;
}

IoList::Lamp lampOf(modbus::InputBit bit)
{
    switch (bit) {
    case modbus::InputBit::DriveAlarm:
        return lampOf(AlarmCatalogue::of(FaultBit::DriveAlarm).severity);
    case modbus::InputBit::EmergencyStop:
        return lampOf(AlarmCatalogue::of(WarningBit::EmergencyStop).severity);
    default:
        return IoList::Lamp::On;
    }
}

} // namespace

IoList::IoList(Controller& controller, QObject* parent)
    : Watched(parent)
    , m_controller(controller)
    , m_pins(controller, this)
{
    updateEvery(lampPeriod, [this] { refresh(); });
    connect(&m_pins, &IoPins::changed, this, [this] {
        emit hasPinsChanged();
        if (watched())
            showRows();
    });
    for (const auto trigger : {&Controller::freshChanged, &Controller::connectionChanged})
        connect(&controller, trigger, this, [this] {
            if (watched())
                refresh();
        });
    LanguageNotifier::follow(this, &IoList::retranslate);
}

void IoList::refresh()
{
    m_pins.read();
    showRows();
}

void IoList::showRows()
{
    QList<Row> rows;
    const auto& status = m_controller.status();
    if (status) {
        addAxis(rows, *status);
        addLine(rows);
        if (m_pins.status()) {
            addPins(rows, *m_pins.status());
            addDrives(rows, *m_pins.status());
        }
        addBits(rows, *status);
    }
    std::ranges::stable_sort(rows, {}, &Row::side);
    const bool isStale = !m_controller.isConnected() || !m_controller.fresh();
    if (std::exchange(m_isStale, isStale) != isStale)
        emit staleChanged();
    m_rows.setRows(rows);
}

void IoList::addAxis(QList<Row>& rows, const modbus::StatusBlock& status) const
{
    const Format format;
    const auto pulses = [&format](std::int64_t count) {
        return tr("%1 pulses").arg(format.grouped(static_cast<double>(count), 0));
    };
    const AxisPosition& position = m_controller.axisPosition();
    const auto hertz = [&format](double frequency) { return tr("%1 Hz").arg(format.grouped(frequency, 0)); };
    rows << Row{Side::Input, tr("Encoder of the axis"), pulses(position.actualPulses().value_or(0)),
                Lamp::None}
         << Row{Side::Input, tr("Encoder, speed"), hertz(status.actualFrequencyHz),
                lampOf(status.actualFrequencyHz != 0)};
    const bool isPress = status.press.has_value();
    if (isPress)
        rows << Row{Side::Input, tr("Force"), tr("%1 N").arg(format.grouped(status.press->forceN, 0)),
                    Lamp::None};
    else
        rows << Row{Side::Input, ControllerSentences::text(modbus::InputBit::IndexMark),
                    status.has(WarningBit::NotHomed) ? tr("not found yet") : tr("found or not required"),
                    m_pins.status() ? Lamp::None : lampOf(!status.has(WarningBit::NotHomed))};
    rows << Row{Side::Input, tr("Heartbeat of the panel"),
                tr("no. %1", "of a heartbeat").arg(status.heartbeat),
                lampOf(!status.has(WarningBit::HeartbeatLost))}
         << Row{Side::Output, tr("Pulses to the axis"), hertz(status.commandedFrequencyHz),
                lampOf(status.commandedFrequencyHz != 0)}
         << Row{Side::Output, tr("Pulses sent"), pulses(position.commandedPulses().value_or(0)), Lamp::None}
         << Row{Side::Output, tr("Sent minus encoder"), pulses(status.followingErrorPulses), Lamp::None};
}

// Adds the rows of a packing machine whose controller reports film, marks and products.
void IoList::addLine(QList<Row>& rows)
{
    const PackingLine& line = *m_controller.packing();
    if (!line.known())
        return;
    const Format format;
    const auto& packer = *line.status();
    const double marks = packer.marks + packer.marksFalse;
    const double products = packer.products;
    rows << Row{Side::Input, ControllerSentences::text(modbus::InputBit::MarkSensor),
                tr("%1 marks").arg(format.grouped(marks, 0)), lampOf(std::exchange(m_marks, marks) < marks)}
         << Row{Side::Input, ControllerSentences::text(modbus::InputBit::ProductEye),
                tr("%1 products placed").arg(format.grouped(products, 0)),
                lampOf(std::exchange(m_products, products) < products)}
         << Row{Side::Input, tr("Encoder of the film"),
                format.measure(line.filmTravelMm(), 1, QStringLiteral("mm")), Lamp::None};
    const auto gate = [](modbus::GateState state) {
        return modbus::findValue(state) ? ControllerSentences::text(state) : Format::unknownText();
    };
    rows << Row{Side::Output, tr("Pulses to the film"), gate(packer.filmGate),
                lampOf(packer.filmGate != modbus::GateState::Standing && line.filmSpeedMmPerS() != 0)}
         << Row{Side::Output, tr("Knife synchronous with film"), gate(packer.knifeGate),
                lampOf(packer.knifeGate == modbus::GateState::Running)}
         << Row{Side::Output, tr("Film, sent minus encoder"),
                format.measure(packer.filmFollowingErrorMm, 2, QStringLiteral("mm")), Lamp::None};
}

// Adds what this machine has of the pins. The row of a sensor may be there with its count.
void IoList::addPins(QList<Row>& rows, const modbus::IoStatus& pins) const
{
    for (const modbus::InputRow& row : modbus::inputRows) {
        const auto bit = static_cast<modbus::InputBit>(row.value.value);
        addPin(rows, {.side = Side::Input, .name = ControllerSentences::text(bit)}, pins.level(bit),
               ControllerSentences::purpose(bit), lampOf(bit));
    }
    for (const modbus::EnumValue& row : modbus::outputRows) {
        const auto bit = static_cast<modbus::OutputBit>(row.value);
        addPin(rows, {.side = Side::Output, .name = ControllerSentences::text(bit), .output = row.value},
               pins.level(bit), ControllerSentences::purpose(bit), Lamp::On);
    }
}

void IoList::addPin(QList<Row>& rows, const Row& pin, std::optional<bool> level, const QString& purpose,
                    Lamp lit)
{
    if (!level)
        return;
    auto row = std::ranges::find(rows, pin.name, &Row::name);
    if (row == rows.end()) {
        rows << pin;
        row = std::prev(rows.end());
    }
    row->purpose = purpose;
    if (*level)
        row->lamp = lit;
    else if (row->lamp == Lamp::None) // a sensor that was on for a moment stays lit
        row->lamp = Lamp::Off;
}

// Adds what the drives report beside the pins.
void IoList::addDrives(QList<Row>& rows, const modbus::IoStatus& pins) const
{
    const Format format;
    const auto add = [&rows](Side side, const QString& name, const QString& value) {
        rows << Row{side, name, value, Lamp::None};
    };
    if (pins.torquePercent)
        add(Side::Input, tr("Torque of the axis, of rated"),
            tr("%1 %", "percent").arg(format.number(*pins.torquePercent, 1)));
    if (m_pins.infeedTravelMm() && pins.infeedFollowingErrorMm) {
        add(Side::Input, tr("Encoder of the infeed"),
            format.measure(*m_pins.infeedTravelMm(), 1, QStringLiteral("mm")));
        add(Side::Output, tr("Infeed, sent minus encoder"),
            format.measure(*pins.infeedFollowingErrorMm, 2, QStringLiteral("mm")));
    }
    QStringList kept;
    if (pins.isAxisKept)
        kept << tr("axis", "kept position");
    if (pins.isFilmKept)
        kept << tr("film", "kept position");
    if (pins.isInfeedKept)
        kept << tr("infeed", "kept position");
    add(Side::Input, tr("Positions kept without power"),
        kept.isEmpty() ? tr("none", "kept positions") : kept.join(u", "));
}

void IoList::addBits(QList<Row>& rows, const modbus::StatusBlock& status) const
{
    const auto add = [&](Side side, const auto& bits, auto which) {
        for (const modbus::EnumValue& row : bits) {
            const auto bit = static_cast<decltype(which)>(row.value);
            const AlarmKind& kind = AlarmCatalogue::of(bit);
            rows << Row{side, kind.title(), {}, status.has(bit) ? lampOf(kind.severity) : Lamp::Off};
        }
    };
    add(Side::Fault, modbus::faultBits, FaultBit());
    add(Side::Warning, modbus::warningBits, WarningBit());
}

} // namespace campanel::panel
