// SPDX-License-Identifier: Apache-2.0
#include "app/panel/settings/settings.h"

#include "app/link/port_finder.h"
#include "app/panel/kit/language_notifier.h"

#include <QLocale>
#include <QSettings>
#include <QStandardPaths>

#include <algorithm>
#include <ranges>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

const QString firstStartKey = u"first_start"_s;
const QString firstStartBegun = u"begun"_s;
const QString firstStartDone = u"done"_s;
const QString programKey = u"program_in"_s; // serial number of a controller

bool isOfConnection(Setting setting)
{
    return setting->name.starts_with("connection.");
}

ConnectionChoice connectionOf(const SettingValues& values)
{
    return {values.isTrue("connection.simulated"), values.text("connection.port"),
            values.whole("connection.baud"),       values.text("connection.parity"),
            values.whole("connection.stop_bits"),  values.whole("connection.unit")};
}

SettingValues valuesOf(const ConnectionChoice& choice)
{
    return {{"connection.simulated", settingText(choice.simulated)},
            {"connection.port", choice.portName},
            {"connection.baud", settingText(choice.baud)},
            {"connection.parity", choice.parity},
            {"connection.stop_bits", settingText(choice.stopBits)},
            {"connection.unit", settingText(choice.unit)}};
}

// Returns the connection in the form of the settings file.
store::SettingsFile::Values storedForm(const ConnectionChoice& choice)
{
    const SettingValues values = valuesOf(choice);
    store::SettingsFile::Values stored;
    for (const SettingRow& row : settingTable) {
        if (isOfConnection(row))
            stored.insert(keyOf(row), values.text(row));
    }
    return stored;
}

ConnectionChoice choiceOf(const link::ConnectionSettings& settings, const ConnectionChoice& before)
{
    ConnectionChoice choice = before; // a simulated one needs no port: the last one stays selected
    choice.simulated = settings.simulated;
    if (settings.simulated)
        return choice;
    choice.portName = settings.port;
    choice.baud = static_cast<int>(settings.line.baud);
    choice.parity = QString(QChar::fromLatin1(static_cast<char>(settings.line.parity)));
    choice.stopBits = settings.line.stopBits;
    choice.unit = settings.unit;
    return choice;
}

} // namespace

Settings::Settings(const QString& storage, QObject* parent, const SettingValues& standard)
    : QObject(parent)
    , m_file(fileName(storage), fileKeys())
    , m_standard(standard)
    , m_isNoticed(m_file.origin() == store::SettingsFile::Origin::Copy ||
                  m_file.origin() == store::SettingsFile::Origin::Defaults)
{
    if (m_file.origin() == store::SettingsFile::Origin::Defaults)
        forgetController();
    load();
    m_draft = connection();
    QLocale::setDefault(QLocale(language()));
    Units::setInch(isInch());
    LanguageNotifier::follow(this, &Settings::updateFields);
    connect(this, &Settings::changed, this, &Settings::updateFields);
    connect(this, &Settings::connectionChanged, this, &Settings::updateFields);
    connect(this, &Settings::connectionApplied, this, &Settings::changed);
}

QString Settings::fileStamp(const QDateTime& time) const
{
    const QString minute = time.toString(u"yyyy-MM-dd HH-mm"_s);
    return machineName().isEmpty() ? minute : machineName() + u' ' + minute;
}

// Reads the stored values over the defaults. A damaged connection never selects the simulated controller.
void Settings::load()
{
    m_values = m_standard;
    const auto isInFile = [this](const SettingRow& row) { return isStored(row); };
    if (std::ranges::any_of(settingTable | std::views::filter(&isOfConnection), isInFile))
        m_values.set("connection.simulated", settingText(false));
    for (const SettingRow& row : settingTable | std::views::filter(isInFile))
        m_values.set(row, m_file.value(keyOf(row)));
    const QString wanted = m_values.text("display.language");
    m_values.set("display.language",
                 nearestLanguage(m_languages, wanted.isEmpty() ? QLocale::system().name() : wanted));
}

ConnectionChoice Settings::withoutController() const
{
    ConnectionChoice none = connectionOf(m_standard);
    none.simulated = false;
    none.portName.clear();
    return none;
}

// Removes the connection when the panel's controller is unknown. The panel is not new either: it has no
// controller until somebody chooses one, also after the next start.
void Settings::forgetController()
{
    store::SettingsFile::Values stored = storedForm(withoutController());
    stored.insert(firstStartKey, firstStartDone);
    m_file.set(stored);
}

QString Settings::notice() const
{
    if (!m_isNoticed)
        return {};
    return m_file.origin() == store::SettingsFile::Origin::Copy
               ? tr("The settings file was damaged or missing. The last good copy is used; check the "
                    "settings.")
               : tr("The settings file was damaged or missing and has no good copy. No controller is "
                    "selected: select "
                    "one on the Settings page, under Connection.");
}

void Settings::dismissNotice()
{
    m_isNoticed = false;
    emit textsChanged();
}

QStringList Settings::fileKeys()
{
    QStringList keys{firstStartKey, programKey};
    for (const SettingRow& row : settingTable) {
        if (!row.key.empty())
            keys << keyOf(row);
    }
    return keys;
}

QString Settings::fileName(const QString& storage)
{
    return storage.isEmpty() ? QSettings().fileName() : storage;
}

void Settings::offerFirstStart(bool wasSetUp)
{
    if (m_file.isEmpty() && wasSetUp) {
        const bool isOverridden = connection() != connectionOf(m_standard); // by an option of this run
        forgetController();
        if (!isOverridden)
            overrideConnection(withoutController());
        m_isNoticed = true;
        emit textsChanged();
        return;
    }
    if (m_file.isEmpty() || m_file.value(firstStartKey) == firstStartBegun)
        beginFirstStart();
}

void Settings::beginFirstStart()
{
    m_file.set(firstStartKey, firstStartBegun);
    m_isFirstStart = true;
    emit firstStartChanged();
}

void Settings::endFirstStart()
{
    m_file.set(firstStartKey, firstStartDone);
    m_isFirstStart = false;
    emit firstStartChanged();
}

SettingField* Settings::setting(const QString& name)
{
    const auto row = std::ranges::find_if(settingTable, [&](const SettingRow& each) {
        return QLatin1StringView(each.name.data(), static_cast<qsizetype>(each.name.size())) == name;
    });
    if (row == settingTable.end())
        return nullptr;
    SettingField*& field = m_fields[row->name];
    if (!field) {
        field = new SettingField(*row, this);
        connect(field, &SettingField::chosen, this, [this, row](const QString& text) {
            if (isOfConnection(*row))
                edit(*row, text);
            else
                set(*row, text);
        });
        updateField(*field);
    }
    return field;
}

bool Settings::isStored(Setting setting) const
{
    return !setting->key.empty() && m_file.contains(keyOf(setting));
}

void Settings::set(Setting setting, const QString& text)
{
    const QString value = m_values.nearest(setting, text);
    // A choice that everybody may make is stored also when it is the default.
    const bool isWanted = value != m_values.text(setting) || setting->level == Level::Viewer;
    if (!require(setting->level) || !isWanted)
        return;
    m_file.set(keyOf(setting), value);
    overrideValue(setting, value);
}

void Settings::overrideValue(Setting setting, const QString& text)
{
    const auto locale = [this] { return language() + m_values.text("display.units"); };
    const QString before = locale();
    m_values.set(setting, text);
    if (locale() != before) {
        QLocale::setDefault(QLocale(language()));
        Units::setInch(isInch());
        emit languageChanged();
    }
    emit changed();
}

void Settings::updateFields()
{
    for (SettingField* field : m_fields)
        updateField(*field);
}

void Settings::updateField(SettingField& field) const
{
    const Setting setting = field.setting();
    const SettingValues& values = isOfConnection(setting) ? valuesOf(m_draft) : m_values;
    field.show(viewOf(setting, values.text(setting), m_standard, m_languages));
}

bool Settings::startIsHeld() const
{
    const QString hold = m_values.text("access.hold_to_start");
    return hold == u"on"_s || (hold == u"auto"_s && !connection().simulated);
}

void Settings::noteProgramIn(quint64 controller)
{
    if (!hadProgram(controller))
        m_file.set(programKey, QString::number(controller, 16));
}

bool Settings::hadProgram(quint64 controller) const
{
    return m_file.value(programKey) == QString::number(controller, 16);
}

void Settings::edit(Setting setting, const QString& text)
{
    SettingValues values = valuesOf(m_draft);
    if (!require(setting->level) || !values.set(setting, text))
        return;
    m_draft = connectionOf(values);
    emit connectionChanged();
}

void Settings::refreshPorts()
{
    QList<PortRow> rows;
    for (const link::PortDescription& port : link::availablePorts()) {
        const QString problem =
            port.isPermitted ? QString()
                             : tr("Permission denied: add the user to the group \"%1\".").arg(port.group);
        rows << PortRow{port.path, port.description, problem};
    }
    m_ports.setRows(rows);
}

void Settings::applyConnection()
{
    if (!require(Level::Technician))
        return;
    m_file.set(storedForm(m_draft));
    overrideConnection(m_draft);
}

ConnectionChoice Settings::connection() const
{
    return connectionOf(m_values);
}

link::ConnectionSettings Settings::linkSettings() const
{
    const ConnectionChoice applied = connection();
    link::ConnectionSettings settings;
    settings.simulated = applied.simulated;
    settings.port = applied.portName;
    settings.line.baud = static_cast<std::uint32_t>(applied.baud);
    settings.line.parity = applied.parity == u"E"_s   ? modbus::Parity::Even
                           : applied.parity == u"O"_s ? modbus::Parity::Odd
                                                      : modbus::Parity::None;
    settings.line.stopBits = static_cast<std::uint8_t>(applied.stopBits);
    settings.unit = applied.unit;
    settings.simulatorProgram = m_simulatorProgram;
    settings.simulatorArguments = m_simulatorArguments;
    settings.simulatorStateDir =
        m_simulatorStateDir.isEmpty()
            ? QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + u"/controller"_s
            : m_simulatorStateDir;
    return settings;
}

void Settings::takeConnection(const link::ConnectionSettings& settings)
{
    if (!require(Level::Technician))
        return;
    m_draft = choiceOf(settings, connection());
    applyConnection();
}

bool Settings::isInUse(const link::ConnectionSettings& settings) const
{
    return choiceOf(settings, connection()) == connection();
}

void Settings::overrideSimulator(const QString& program, const QString& stateDir)
{
    m_simulatorProgram = program;
    m_simulatorStateDir = stateDir;
}

void Settings::overrideConnection(const ConnectionChoice& choice)
{
    m_draft = choice;
    m_values.assign(valuesOf(choice));
    emit connectionChanged();
    emit connectionApplied();
}

} // namespace campanel::panel
