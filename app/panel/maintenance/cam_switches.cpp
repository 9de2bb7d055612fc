// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/cam_switches.h"

#include "app/panel/controller/controller.h"
#include "app/panel/words/controller_sentences.h"
#include "app/panel/words/register_words.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <vector>

namespace campanel::panel {

namespace {

constexpr auto driveEnable = "parameter.drive_enable";

struct SwitchParameter {
    const char* suffix;
    const char* words;
    bool hasChoices;
};

constexpr std::array switchParameters{
    SwitchParameter{"_mode", QT_TRANSLATE_NOOP("campanel::panel::CamSwitches", "Cam switch %1: mode"), true},
    SwitchParameter{"_on_angle", QT_TRANSLATE_NOOP("campanel::panel::CamSwitches", "Cam switch %1: on angle"),
                    false},
    SwitchParameter{"_off_angle",
                    QT_TRANSLATE_NOOP("campanel::panel::CamSwitches", "Cam switch %1: off angle"), false},
    SwitchParameter{"_lead", QT_TRANSLATE_NOOP("campanel::panel::CamSwitches", "Cam switch %1: lead time"),
                    false},
    SwitchParameter{
        "_every", QT_TRANSLATE_NOOP("campanel::panel::CamSwitches", "Cam switch %1: on in every n-th cycle"),
        false},
};

constexpr std::array contactParameters{
    SwitchParameter{"_contact", QT_TRANSLATE_NOOP("campanel::panel::CamSwitches", "%1: contact"), true},
    SwitchParameter{"_filter", QT_TRANSLATE_NOOP("campanel::panel::CamSwitches", "%1: filter time"), false},
};

constexpr std::array coderParameters{
    SwitchParameter{"signal.coder_place",
                    QT_TRANSLATE_NOOP("campanel::panel::CamSwitches", "Date coder pulse: film to the cut"),
                    false},
    SwitchParameter{"signal.coder_pulse",
                    QT_TRANSLATE_NOOP("campanel::panel::CamSwitches", "Date coder pulse: length"), false},
};

std::vector<modbus::InputRow> contactRows()
{
    std::vector<modbus::InputRow> rows;
    std::ranges::copy_if(modbus::inputRows, std::back_inserter(rows), [](const modbus::InputRow& row) {
        return row.source == modbus::InputSource::Contact;
    });
    return rows;
}

std::string nameOf(const modbus::InputRow& row, const SwitchParameter& parameter)
{
    return modbus::contactName(row) + parameter.suffix;
}

std::string nameOf(int number, const SwitchParameter& parameter)
{
    return "parameter.switch" + std::to_string(number) + parameter.suffix;
}

} // namespace

CamSwitches::CamSwitches(Controller& controller, QObject* parent)
    : ParameterFields(controller, parent)
{
}

int CamSwitches::drives()
{
    return modbus::switchCount + 1;
}

QStringList CamSwitches::names() const
{
    QStringList names;
    for (int number = 1; number <= modbus::switchCount; ++number)
        names << tr("Cam switch %1").arg(number);
    names << tr("Drive");
    for (const modbus::InputRow& row : contactRows())
        names << ControllerSentences::text(static_cast<modbus::InputBit>(row.value.value));
    names << ControllerSentences::text(modbus::OutputBit::CoderPulse);
    return names;
}

void CamSwitches::choose(int current)
{
    const auto inputs = contactRows();
    m_current = std::clamp(current, 1, drives() + static_cast<int>(inputs.size()) + 1);
    std::vector<Field> fields;
    if (m_current > drives() + static_cast<int>(inputs.size())) {
        for (const SwitchParameter& parameter : coderParameters)
            fields.push_back(
                {&controller().parameter(parameter.suffix), parameter.words, parameter.hasChoices});
    } else if (m_current > drives()) {
        const modbus::InputRow& row = inputs[static_cast<std::size_t>(m_current - drives() - 1)];
        for (const SwitchParameter& parameter : contactParameters)
            fields.push_back(
                {&controller().parameter(nameOf(row, parameter)), parameter.words, parameter.hasChoices});
    } else if (m_current == drives()) {
        fields.push_back({&controller().parameter(driveEnable), nullptr, true});
    } else {
        for (const SwitchParameter& parameter : switchParameters)
            fields.push_back({&controller().parameter(nameOf(m_current, parameter)), parameter.words,
                              parameter.hasChoices});
    }
    setFields(std::move(fields));
    read();
    emit currentChanged();
}

QString CamSwitches::words(const QString& name)
{
    if (name == QLatin1String(driveEnable))
        return tr("Drive enable");
    for (int number = 1; number <= modbus::switchCount; ++number) {
        for (const SwitchParameter& parameter : switchParameters) {
            if (name.toStdString() == nameOf(number, parameter))
                return tr(parameter.words).arg(number);
        }
    }
    for (const modbus::InputRow& row : contactRows()) {
        for (const SwitchParameter& parameter : contactParameters) {
            if (name.toStdString() == nameOf(row, parameter))
                return tr(parameter.words)
                    .arg(ControllerSentences::text(static_cast<modbus::InputBit>(row.value.value)));
        }
    }
    for (const SwitchParameter& parameter : coderParameters) {
        if (name == QLatin1String(parameter.suffix))
            return tr(parameter.words);
    }
    return {};
}

QString CamSwitches::label(const Field& field) const
{
    return words(RegisterWords::name(field.info()));
}

} // namespace campanel::panel
