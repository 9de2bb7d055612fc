// SPDX-License-Identifier: Apache-2.0
#include "app/panel/settings/settings.h"

#include "app/link/port_finder.h"
#include "app/panel/kit/engine_instances.h"
#include "app/panel/kit/format.h"

#include <QLocale>
#include <QSettings>
#include <QStandardPaths>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

// Modbus: 0 is broadcast, numbers above 247 are reserved.
constexpr int minUnit = 1;
constexpr int maxUnit = 247;

const QString languageKey = u"language"_s;
const QString themeKey = u"theme"_s;
const QString glovesKey = u"gloves"_s;
const QString bagToleranceKey = u"bag_tolerance_mm"_s;
const QString autoLogoutKey = u"access/auto_logout_minutes"_s;
const QString firstStartKey = u"first_start"_s;
const QString firstStartBegun = u"begun"_s;
const QString firstStartDone = u"done"_s;
const QString operatorsLogInKey = u"access/operators_log_in"_s;
const QString holdToStartKey = u"access/hold_to_start"_s;
const QString simulatedKey = u"connection/simulated"_s;
const QString portKey = u"connection/port"_s;
const QString baudKey = u"connection/baud"_s;
const QString parityKey = u"connection/parity"_s;
const QString stopBitsKey = u"connection/stop_bits"_s;
const QString unitKey = u"connection/unit"_s;
const QStringList connectionKeys{simulatedKey, portKey, baudKey, parityKey, stopBitsKey, unitKey};

QString textOf(bool truth)
{
    return truth ? u"true"_s : u"false"_s;
}

bool truthOf(const QString& text, bool otherwise)
{
    return text == textOf(true) || (otherwise && text != textOf(false));
}

QString chosen(const QString& wanted, const QStringList& possible, const QString& otherwise)
{
    return possible.contains(wanted) ? wanted : otherwise;
}

// Returns the stored connection. Invalid values become the default, but never select the simulated
// controller.
ConnectionChoice storedConnection(const store::SettingsFile& file, const ConnectionChoice& standard)
{
    if (std::none_of(connectionKeys.begin(), connectionKeys.end(),
                     [&file](const QString& key) { return file.contains(key); }))
        return standard;
    ConnectionChoice choice;
    choice.simulated = truthOf(file.value(simulatedKey), false);
    choice.portName = file.value(portKey, standard.portName);
    choice.baud = file.value(baudKey).toInt();
    if (!Settings::possibleBauds().contains(choice.baud))
        choice.baud = standard.baud;
    choice.parity = chosen(file.value(parityKey), Settings::possibleParities(), standard.parity);
    choice.stopBits = std::clamp(file.value(stopBitsKey, QString::number(standard.stopBits)).toInt(), 1, 2);
    choice.unit = std::clamp(file.value(unitKey, QString::number(standard.unit)).toInt(), 1, 247);
    return choice;
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

store::SettingsFile::Values valuesOf(const ConnectionChoice& choice)
{
    return {{simulatedKey, textOf(choice.simulated)},        {portKey, choice.portName},
            {baudKey, QString::number(choice.baud)},         {parityKey, choice.parity},
            {stopBitsKey, QString::number(choice.stopBits)}, {unitKey, QString::number(choice.unit)}};
}

} // namespace

Settings::Settings(const QString& storage, QObject* parent, const StandardSettings& standard)
    : QObject(parent)
    , m_file(fileName(storage), fileKeys())
    , m_gloves(truthOf(m_file.value(glovesKey), standard.gloves))
    , m_standardToleranceMm(standard.bagToleranceMm)
    , m_bagToleranceMm(standard.bagToleranceMm)
    , m_autoLogoutMinutes(standard.autoLogoutMinutes)
    , m_operatorsLogIn(truthOf(m_file.value(operatorsLogInKey), standard.operatorsLogIn))
    , m_isNoticed(m_file.origin() == store::SettingsFile::Origin::Copy ||
                  m_file.origin() == store::SettingsFile::Origin::Defaults)
{
    const bool chineseSystem = QLocale::system().language() == QLocale::Chinese;
    const QString systemLanguage = chineseSystem ? u"zh_CN"_s : u"en"_s;
    m_language = chosen(m_file.value(languageKey), languages(),
                        chosen(standard.language, languages(), systemLanguage));
    m_theme = chosen(m_file.value(themeKey), themes(), standard.theme);
    m_holdToStart = chosen(m_file.value(holdToStartKey), possibleHolds(), standard.holdToStart);
    const double stored = m_file.value(bagToleranceKey).toDouble();
    if (stored >= minToleranceMm && stored <= maxToleranceMm)
        m_bagToleranceMm = stored;
    const int minutes = m_file.value(autoLogoutKey).toInt();
    if (possibleLogouts().contains(minutes))
        m_autoLogoutMinutes = minutes;
    if (m_file.origin() == store::SettingsFile::Origin::Defaults)
        forgetController(standard.connection);
    m_applied = storedConnection(m_file, standard.connection);
    m_draft = m_applied;
    QLocale::setDefault(QLocale(m_language));
    // Queued until the texts of the new language are available.
    connect(this, &Settings::languageChanged, this, &Settings::noticeChanged, Qt::QueuedConnection);
    connect(this, &Settings::languageChanged, this, &Settings::updateValues, Qt::QueuedConnection);
    connect(this, &Settings::bagToleranceChanged, this, &Settings::updateValues);
    connect(this, &Settings::connectionApplied, this, &Settings::holdToStartChanged);
    connect(this, &Settings::connectionChanged, this, &Settings::updateValues);
    connect(&m_bagTolerance, &Value::setRequested, this, &Settings::setBagToleranceMm);
    connect(&m_unitNumber, &Value::setRequested, this,
            [this](double unit) { setUnit(static_cast<int>(std::lround(unit))); });
    updateValues();
}

// Removes the connection when the panel's controller is unknown. The panel is not new either: it has no
// controller until somebody chooses one, also after the next start.
void Settings::forgetController(ConnectionChoice standard)
{
    standard.simulated = false;
    standard.portName.clear();
    store::SettingsFile::Values values = valuesOf(standard);
    values.insert(firstStartKey, firstStartDone);
    m_file.set(values);
}

QString Settings::notice() const
{
    if (!m_isNoticed)
        return {};
    return m_file.origin() == store::SettingsFile::Origin::Copy
               ? tr("The settings file was damaged or missing. The last good copy is used; check the "
                    "settings.")
               : tr("The settings file was damaged and has no good copy. No controller is selected: select "
                    "one on the Settings page, under Connection.");
}

void Settings::dismissNotice()
{
    m_isNoticed = false;
    emit noticeChanged();
}

QStringList Settings::fileKeys()
{
    // Display writes brightness and screen-off time.
    return QStringList{languageKey,
                       themeKey,
                       glovesKey,
                       bagToleranceKey,
                       autoLogoutKey,
                       firstStartKey,
                       operatorsLogInKey,
                       holdToStartKey,
                       u"display/brightness"_s,
                       u"display/dark_after_minutes"_s} +
           connectionKeys;
}

QList<int> Settings::possibleBauds()
{
    return {9600, 19200, 38400, 57600, 115200};
}

QStringList Settings::possibleParities()
{
    return {u"N"_s, u"E"_s, u"O"_s};
}

QStringList Settings::possibleLanguages()
{
    return {u"en"_s, u"zh_CN"_s};
}

QStringList Settings::possibleThemes()
{
    return {u"light"_s, u"dark"_s, u"contrast"_s};
}

QList<int> Settings::possibleLogouts()
{
    return {1, 2, 5, 10, 30};
}

QString Settings::fileName(const QString& storage)
{
    return storage.isEmpty() ? QSettings().fileName() : storage;
}

void Settings::offerFirstStart()
{
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

Settings* Settings::create(QQmlEngine* qmlEngine, QJSEngine*)
{
    return attachedInstance<Settings>(qmlEngine);
}

QStringList Settings::languageNames() const
{
    return {u"English"_s, u"简体中文"_s};
}

void Settings::overrideLanguage(const QString& language)
{
    if (m_language == language || !languages().contains(language))
        return;
    m_language = language;
    QLocale::setDefault(QLocale(m_language));
    emit languageChanged();
}

void Settings::setLanguage(const QString& language)
{
    overrideLanguage(language);
    m_file.set(languageKey, m_language);
}

void Settings::overrideTheme(const QString& theme)
{
    if (m_theme == theme || !themes().contains(theme))
        return;
    m_theme = theme;
    emit themeChanged();
}

void Settings::setTheme(const QString& theme)
{
    overrideTheme(theme);
    m_file.set(themeKey, m_theme);
}

void Settings::overrideGloves(bool gloves)
{
    if (m_gloves == gloves)
        return;
    m_gloves = gloves;
    emit glovesChanged();
}

void Settings::setGloves(bool gloves)
{
    overrideGloves(gloves);
    m_file.set(glovesKey, textOf(m_gloves));
}

void Settings::setBagToleranceMm(double toleranceMm)
{
    const double taken = std::clamp(toleranceMm, minToleranceMm, maxToleranceMm);
    if (std::isnan(toleranceMm) || taken == m_bagToleranceMm || !require(Level::Technician))
        return;
    m_bagToleranceMm = taken;
    m_file.set(bagToleranceKey, QString::number(m_bagToleranceMm, 'g', QLocale::FloatingPointShortest));
    emit bagToleranceChanged();
}

void Settings::updateValues()
{
    constexpr int decimals = 2;
    const Format format;
    m_bagTolerance.show({tr("Bag tolerance ±"), u"mm"_s, format.number(m_bagToleranceMm, decimals),
                         minToleranceMm, maxToleranceMm, m_standardToleranceMm, decimals});
    m_unitNumber.show({tr("Unit number"), {}, QString::number(m_draft.unit), minUnit, maxUnit, minUnit, 0});
}

void Settings::setAutoLogoutMinutes(int minutes)
{
    if (minutes == m_autoLogoutMinutes || !possibleLogouts().contains(minutes) || !require(Level::Service))
        return;
    m_autoLogoutMinutes = minutes;
    m_file.set(autoLogoutKey, QString::number(minutes));
    emit accessChanged();
}

void Settings::setOperatorsLogIn(bool logIn)
{
    if (logIn == m_operatorsLogIn || !require(Level::Service))
        return;
    m_operatorsLogIn = logIn;
    m_file.set(operatorsLogInKey, textOf(logIn));
    emit accessChanged();
}

QStringList Settings::possibleHolds()
{
    return {u"auto"_s, u"on"_s, u"off"_s};
}

void Settings::setHoldToStart(const QString& hold)
{
    if (hold == m_holdToStart || !possibleHolds().contains(hold) || !require(Level::Technician))
        return;
    m_holdToStart = hold;
    m_file.set(holdToStartKey, hold);
    emit holdToStartChanged();
}

bool Settings::startIsHeld() const
{
    return m_holdToStart == u"on"_s || (m_holdToStart == u"auto"_s && !m_applied.simulated);
}

void Settings::edit(ConnectionChoice choice)
{
    if (m_draft == choice || !require(Level::Technician))
        return;
    m_draft = std::move(choice);
    emit connectionChanged();
}

void Settings::setSimulated(bool simulated)
{
    ConnectionChoice choice = m_draft;
    choice.simulated = simulated;
    edit(choice);
}

void Settings::setPortName(const QString& portName)
{
    ConnectionChoice choice = m_draft;
    choice.portName = portName;
    edit(choice);
}

void Settings::setBaud(int baud)
{
    ConnectionChoice choice = m_draft;
    choice.baud = bauds().contains(baud) ? baud : choice.baud;
    edit(choice);
}

void Settings::setParity(const QString& parity)
{
    ConnectionChoice choice = m_draft;
    choice.parity = chosen(parity, possibleParities(), choice.parity);
    edit(choice);
}

void Settings::setStopBits(int stopBits)
{
    ConnectionChoice choice = m_draft;
    choice.stopBits = std::clamp(stopBits, 1, 2);
    edit(choice);
}

void Settings::setUnit(int unit)
{
    ConnectionChoice choice = m_draft;
    choice.unit = std::clamp(unit, minUnit, maxUnit);
    edit(choice);
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
    m_applied = m_draft;
    m_file.set(valuesOf(m_applied));
    emit connectionChanged();
    emit connectionApplied();
}

link::ConnectionSettings Settings::linkSettings() const
{
    link::ConnectionSettings settings;
    settings.simulated = m_applied.simulated;
    settings.port = m_applied.portName;
    settings.line.baud = static_cast<std::uint32_t>(m_applied.baud);
    settings.line.parity = m_applied.parity == u"E"_s   ? modbus::Parity::Even
                           : m_applied.parity == u"O"_s ? modbus::Parity::Odd
                                                        : modbus::Parity::None;
    settings.line.stopBits = static_cast<std::uint8_t>(m_applied.stopBits);
    settings.unit = m_applied.unit;
    settings.simulatorProgram = m_simulatorProgram;
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
    m_draft = choiceOf(settings, m_applied);
    applyConnection();
}

bool Settings::isInUse(const link::ConnectionSettings& settings) const
{
    return choiceOf(settings, m_applied) == m_applied;
}

void Settings::overrideSimulator(const QString& program, const QString& stateDir)
{
    m_simulatorProgram = program;
    m_simulatorStateDir = stateDir;
}

void Settings::overrideConnection(const ConnectionChoice& choice)
{
    m_applied = choice;
    m_draft = choice;
    emit connectionChanged();
    emit connectionApplied();
}

} // namespace campanel::panel
