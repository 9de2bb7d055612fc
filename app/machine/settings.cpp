// SPDX-License-Identifier: Apache-2.0
#include "app/machine/settings.h"

#include "app/link/port_finder.h"
#include "app/machine/engine_instances.h"

#include <QFile>
#include <QLocale>
#include <QStandardPaths>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::machine {

namespace {

constexpr auto languageKey = "language"_L1;
constexpr auto themeKey = "theme"_L1;
constexpr auto glovesKey = "gloves"_L1;
constexpr auto bagToleranceKey = "bag_tolerance_mm"_L1;
constexpr auto autoLogoutKey = "access/auto_logout_minutes"_L1;
constexpr auto firstStartKey = "first_start"_L1;
constexpr auto firstStartBegun = "begun"_L1;
constexpr auto firstStartDone = "done"_L1;
constexpr auto operatorsLogInKey = "access/operators_log_in"_L1;

QString chosen(const QString& wanted, const QStringList& possible, const QString& otherwise)
{
    return possible.contains(wanted) ? wanted : otherwise;
}

// What was edited by hand into nonsense becomes the standard.
ConnectionChoice storedConnection(const QSettings& storage, const ConnectionChoice& standard)
{
    ConnectionChoice choice;
    choice.simulated = storage.value("connection/simulated"_L1, standard.simulated).toBool();
    choice.portName = storage.value("connection/port"_L1, standard.portName).toString();
    choice.baud = storage.value("connection/baud"_L1, standard.baud).toInt();
    choice.parity = storage.value("connection/parity"_L1, standard.parity).toString();
    choice.stopBits = storage.value("connection/stop_bits"_L1, standard.stopBits).toInt();
    choice.unit = storage.value("connection/unit"_L1, standard.unit).toInt();
    if (!Settings::possibleBauds().contains(choice.baud))
        choice.baud = standard.baud;
    choice.parity = chosen(choice.parity, Settings::possibleParities(), standard.parity);
    choice.stopBits = std::clamp(choice.stopBits, 1, 2);
    choice.unit = std::clamp(choice.unit, 1, 247);
    return choice;
}

ConnectionChoice choiceOf(const link::ConnectionSettings& settings, const ConnectionChoice& before)
{
    ConnectionChoice choice = before; // a simulated one needs no port: the last one stays chosen
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

void store(QSettings& storage, const ConnectionChoice& choice)
{
    storage.setValue("connection/simulated"_L1, choice.simulated);
    storage.setValue("connection/port"_L1, choice.portName);
    storage.setValue("connection/baud"_L1, choice.baud);
    storage.setValue("connection/parity"_L1, choice.parity);
    storage.setValue("connection/stop_bits"_L1, choice.stopBits);
    storage.setValue("connection/unit"_L1, choice.unit);
}

} // namespace

Settings::Settings(const QString& storage, QObject* parent, const StandardSettings& standard)
    : QObject(parent)
    , m_storage(fileName(storage), QSettings::IniFormat)
    , m_gloves(m_storage.value(glovesKey, standard.gloves).toBool())
    , m_standardToleranceMm(standard.bagToleranceMm)
    , m_bagToleranceMm(standard.bagToleranceMm)
    , m_autoLogoutMinutes(standard.autoLogoutMinutes)
    , m_operatorsLogIn(m_storage.value(operatorsLogInKey, standard.operatorsLogIn).toBool())
{
    const bool chineseSystem = QLocale::system().language() == QLocale::Chinese;
    const QString systemLanguage = chineseSystem ? u"zh_CN"_s : u"en"_s;
    m_language = chosen(m_storage.value(languageKey).toString(), languages(),
                        chosen(standard.language, languages(), systemLanguage));
    m_theme = chosen(m_storage.value(themeKey).toString(), themes(), standard.theme);
    const double stored = m_storage.value(bagToleranceKey, m_standardToleranceMm).toDouble();
    if (stored >= leastToleranceMm && stored <= mostToleranceMm)
        m_bagToleranceMm = stored;
    const int minutes = m_storage.value(autoLogoutKey, m_autoLogoutMinutes).toInt();
    if (possibleLogouts().contains(minutes))
        m_autoLogoutMinutes = minutes;
    m_applied = storedConnection(m_storage, standard.connection);
    m_draft = m_applied;
    QLocale::setDefault(QLocale(m_language));
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

QByteArray Settings::contents()
{
    m_storage.sync();
    QFile file(m_storage.fileName());
    return file.open(QIODevice::ReadOnly) ? file.readAll()
                                          : QByteArray(); // not there before the first change
}

void Settings::offerFirstStart()
{
    if (m_storage.allKeys().isEmpty() || m_storage.value(firstStartKey).toString() == firstStartBegun)
        beginFirstStart();
}

void Settings::beginFirstStart()
{
    m_storage.setValue(firstStartKey, firstStartBegun);
    m_isFirstStart = true;
    emit firstStartChanged();
}

void Settings::endFirstStart()
{
    m_storage.setValue(firstStartKey, firstStartDone);
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
    m_storage.setValue(languageKey, m_language);
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
    m_storage.setValue(themeKey, m_theme);
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
    m_storage.setValue(glovesKey, m_gloves);
}

void Settings::setBagToleranceMm(double toleranceMm)
{
    const double taken = std::clamp(toleranceMm, leastToleranceMm, mostToleranceMm);
    if (std::isnan(toleranceMm) || taken == m_bagToleranceMm || !admits(Level::Technician))
        return;
    m_bagToleranceMm = taken;
    m_storage.setValue(bagToleranceKey, m_bagToleranceMm);
    emit bagToleranceChanged();
}

void Settings::setAutoLogoutMinutes(int minutes)
{
    if (minutes == m_autoLogoutMinutes || !possibleLogouts().contains(minutes) || !admits(Level::Service))
        return;
    m_autoLogoutMinutes = minutes;
    m_storage.setValue(autoLogoutKey, minutes);
    emit accessChanged();
}

void Settings::setOperatorsLogIn(bool logIn)
{
    if (logIn == m_operatorsLogIn || !admits(Level::Service))
        return;
    m_operatorsLogIn = logIn;
    m_storage.setValue(operatorsLogInKey, logIn);
    emit accessChanged();
}

void Settings::edit(ConnectionChoice choice)
{
    if (m_draft == choice || !admits(Level::Technician))
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
    choice.unit = std::clamp(unit, 1, 247);
    edit(choice);
}

void Settings::refreshPorts()
{
    QList<PortRow> rows;
    for (const link::PortDescription& port : link::availablePorts()) {
        const QString problem = port.isPermitted
                                    ? QString()
                                    : tr("Not permitted: add the user to the group \"%1\".").arg(port.group);
        rows << PortRow{port.path, port.description, problem};
    }
    m_ports.setRows(rows);
}

void Settings::applyConnection()
{
    if (!admits(Level::Technician))
        return;
    m_applied = m_draft;
    store(m_storage, m_applied);
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
    if (!admits(Level::Technician))
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

} // namespace campanel::machine
