// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/cam_switches.h"

#include "app/panel/controller/controller.h"
#include "app/panel/words/register_words.h"

#include <algorithm>
#include <array>
#include <string>

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

void CamSwitches::choose(int current)
{
    m_current = std::clamp(current, 1, drives());
    std::vector<Field> fields;
    if (m_current == drives()) {
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
    return {};
}

QString CamSwitches::label(const Field& field) const
{
    return words(RegisterWords::name(field.info()));
}

} // namespace campanel::panel
