// SPDX-License-Identifier: Apache-2.0
// `Settings` in QML: the panel's own settings (language, appearance, connection), stored in a file.
// Connection fields are a draft until applyConnection().
#pragma once

#include "app/link/link_values.h"
#include "app/panel/kit/singleton.h"
#include "app/panel/settings/languages.h"
#include "app/panel/settings/port_model.h"
#include "app/panel/settings/setting_field.h"
#include "app/store/files/settings_file.h"

#include <QDateTime>
#include <QMap>
#include <QObject>
#include <QPointer>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

// The connection to the controller.
struct ConnectionChoice {
    bool simulated = true;
    QString portName; // "/dev/ttyUSB0"
    int baud = 115200;
    QString parity = QStringLiteral("N"); // N, E, O
    int stopBits = 1;
    int unit = 1;

    bool operator==(const ConnectionChoice&) const = default;
};

class Settings : public QObject, public Singleton<Settings> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

    Q_PROPERTY(bool simulated READ simulated WRITE setSimulated NOTIFY connectionChanged FINAL)
    Q_PROPERTY(QString portName READ portName WRITE setPortName NOTIFY connectionChanged FINAL)
    Q_PROPERTY(QString parity READ parity WRITE setParity NOTIFY connectionChanged FINAL)
    Q_PROPERTY(int stopBits READ stopBits WRITE setStopBits NOTIFY connectionChanged FINAL)
    Q_PROPERTY(bool connectionDirty READ connectionDirty NOTIFY connectionChanged FINAL)

    // True when Start acts only after it has been held.
    Q_PROPERTY(bool startIsHeld READ startIsHeld NOTIFY changed FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* ports READ ports CONSTANT FINAL)
    // True on a new panel: language, controller, PINs, machine and a first recipe must be set.
    Q_PROPERTY(bool firstStart READ firstStart NOTIFY firstStartChanged FINAL)
    // The units that the screen shows instead of metric ones, see Units::rows().
    Q_PROPERTY(QVariantMap units READ units NOTIFY languageChanged FINAL)
    // The notice about damaged settings; empty: none.
    Q_PROPERTY(QString notice READ notice NOTIFY textsChanged FINAL)

public:
    // `storage` is the path of an ini file; empty: the user's standard folder. The values of `standard` hold
    // until others are set on the panel.
    explicit Settings(const QString& storage, QObject* parent, const SettingValues& standard = {});

    // Returns the path of the file for that `storage`.
    [[nodiscard]] static QString fileName(const QString& storage);
    [[nodiscard]] static QStringList fileKeys();
    // Returns the present contents of the file, including the screen's own settings.
    [[nodiscard]] QByteArray contents() const { return m_file.contents(); }
    [[nodiscard]] store::SettingsFile& file() { return m_file; }

    // Returns true when the last change has been written.
    [[nodiscard]] bool areKept() const { return m_file.isKept(); }

    [[nodiscard]] QString notice() const;
    Q_INVOKABLE void dismissNotice();

    // Returns the values of all settings; a draft of the connection is not among them.
    [[nodiscard]] const SettingValues& values() const { return m_values; }
    // Returns true when the setting has been set on this panel.
    [[nodiscard]] bool isStored(Setting setting) const;
    // Sets and stores the nearest valid value, for a person with the level of the setting.
    void set(Setting setting, const QString& text);
    // Sets a value of the connection's draft.
    void edit(Setting setting, const QString& text);
    // Sets the value for the present run only; nothing is stored.
    void overrideValue(Setting setting, const QString& text);

    // Returns the setting with that name of the table, for QML.
    [[nodiscard]] Q_INVOKABLE campanel::panel::SettingField* setting(const QString& name);
    [[nodiscard]] QString language() const { return m_values.text("display.language"); }
    [[nodiscard]] bool isInch() const { return m_values.text("display.units") == u"inch"; }
    [[nodiscard]] QVariantMap units() const { return Units::rows(isInch()); }
    [[nodiscard]] const QList<Language>& installedLanguages() const { return m_languages; }
    [[nodiscard]] QString machineName() const { return m_values.text("machine.name"); }
    // Returns the machine's name, if it has one, and the minute, for the name of a file.
    [[nodiscard]] QString fileStamp(const QDateTime& time) const;
    [[nodiscard]] double bagToleranceMm() const { return m_values.number("bags.tolerance_mm"); }

    [[nodiscard]] bool simulated() const { return m_draft.simulated; }
    void setSimulated(bool simulated) { edit("connection.simulated", settingText(simulated)); }
    [[nodiscard]] QString portName() const { return m_draft.portName; }
    void setPortName(const QString& portName) { edit("connection.port", portName); }
    [[nodiscard]] QString parity() const { return m_draft.parity; }
    void setParity(const QString& parity) { edit("connection.parity", parity); }
    [[nodiscard]] int stopBits() const { return m_draft.stopBits; }
    void setStopBits(int stopBits) { edit("connection.stop_bits", settingText(stopBits)); }
    [[nodiscard]] bool connectionDirty() const { return m_draft != connection(); }
    [[nodiscard]] PortModel* ports() { return &m_ports; }

    // Returns true when Start acts only after it has been held.
    [[nodiscard]] bool startIsHeld() const;
    // Remember the controller that had a program last, by its serial number, also over a restart of the
    // panel.
    void noteProgramIn(quint64 controller);
    [[nodiscard]] bool hadProgram(quint64 controller) const;
    // Sets the access check that is asked before a change.
    void guardBy(AccessCheck& accessCheck) { m_access = &accessCheck; }

    [[nodiscard]] bool firstStart() const { return m_isFirstStart; }
    // Offers the first start when nothing has been set yet, or when the last one was not completed.
    // On a panel that was set up before, missing settings are a loss: this is said, and no controller is
    // selected.
    void offerFirstStart(bool wasSetUp = false);
    void beginFirstStart();
    Q_INVOKABLE void endFirstStart();

    Q_INVOKABLE void refreshPorts();
    Q_INVOKABLE void applyConnection();

    // Return the connection in use, and the same for the link.
    [[nodiscard]] ConnectionChoice connection() const;
    [[nodiscard]] link::ConnectionSettings linkSettings() const;
    // Uses and stores this connection; discards a draft.
    void takeConnection(const link::ConnectionSettings& settings);
    [[nodiscard]] bool isInUse(const link::ConnectionSettings& settings) const;
    // Runs this program as the simulated controller instead of the default one, with its flash in stateDir.
    void overrideSimulator(const QString& program, const QString& stateDir);
    // Passes further options to the simulated controller; call it before the link opens.
    void setSimulatorArguments(const QStringList& arguments) { m_simulatorArguments = arguments; }
    // Uses this connection for the present run only, for the command line; nothing is stored.
    void overrideConnection(const ConnectionChoice& choice);

signals:
    void changed();         // a value without a signal of its own
    void languageChanged(); // the language or the units
    void textsChanged();
    void connectionChanged();
    void connectionApplied();
    void firstStartChanged();

private:
    void load();
    void updateFields();
    void updateField(SettingField& field) const;
    void forgetController();
    [[nodiscard]] ConnectionChoice withoutController() const;
    [[nodiscard]] bool require(Level needed) const { return !m_access || m_access->require(needed); }

    store::SettingsFile m_file;
    QList<Language> m_languages = languagesIn(languageFolders());
    SettingValues m_standard;
    SettingValues m_values;
    QMap<std::string_view, SettingField*> m_fields; // children, by name
    bool m_isNoticed;
    bool m_isFirstStart = false;
    QPointer<AccessCheck> m_access;
    ConnectionChoice m_draft;
    PortModel m_ports;
    QString m_simulatorProgram;
    QString m_simulatorStateDir;
    QStringList m_simulatorArguments;
};

} // namespace campanel::panel
