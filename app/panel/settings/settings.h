// SPDX-License-Identifier: Apache-2.0
// `Settings` in QML: the panel's own settings (language, appearance, connection), stored in a file.
// Connection fields are a draft until applyConnection().
#pragma once

#include "app/link/link_values.h"
#include "app/panel/kit/singleton.h"
#include "app/panel/kit/value.h"
#include "app/panel/settings/languages.h"
#include "app/panel/settings/port_model.h"
#include "app/panel/settings/setting_values.h"
#include "app/store/files/settings_file.h"

#include <QObject>
#include <QPointer>
#include <QStringList>
#include <QVariantMap>
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

    Q_PROPERTY(QString language READ language WRITE setLanguage NOTIFY languageChanged FINAL)
    // The labels of the settings that have one, by the setting's key.
    Q_PROPERTY(QVariantMap labels READ labels NOTIFY textsChanged FINAL)
    Q_PROPERTY(QStringList languages READ languages CONSTANT FINAL)
    Q_PROPERTY(QStringList languageNames READ languageNames CONSTANT FINAL)
    Q_PROPERTY(QString theme READ theme WRITE setTheme NOTIFY changed FINAL)
    Q_PROPERTY(QStringList themes READ themes CONSTANT FINAL)
    // True for larger keys, for thick gloves: a quarter larger.
    Q_PROPERTY(bool gloves READ gloves WRITE setGloves NOTIFY changed FINAL)
    // The tolerance of a bag's length, +- mm; for display only, the controller does not know it.
    Q_PROPERTY(double bagToleranceMm READ bagToleranceMm WRITE setBagToleranceMm NOTIFY changed FINAL)
    // The same and the unit number, for the keypad.
    Q_PROPERTY(campanel::panel::Value* bagTolerance READ bagTolerance CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::Value* unitNumber READ unitNumber CONSTANT FINAL)

    Q_PROPERTY(bool simulated READ simulated WRITE setSimulated NOTIFY connectionChanged FINAL)
    Q_PROPERTY(QString portName READ portName WRITE setPortName NOTIFY connectionChanged FINAL)
    Q_PROPERTY(int baud READ baud WRITE setBaud NOTIFY connectionChanged FINAL)
    Q_PROPERTY(QString parity READ parity WRITE setParity NOTIFY connectionChanged FINAL)
    Q_PROPERTY(int stopBits READ stopBits WRITE setStopBits NOTIFY connectionChanged FINAL)
    Q_PROPERTY(int unit READ unit WRITE setUnit NOTIFY connectionChanged FINAL)
    Q_PROPERTY(bool connectionDirty READ connectionDirty NOTIFY connectionChanged FINAL)
    Q_PROPERTY(QList<int> bauds READ bauds CONSTANT FINAL)

    // The minutes without a touch until the automatic logout.
    Q_PROPERTY(int autoLogoutMinutes READ autoLogoutMinutes WRITE setAutoLogoutMinutes NOTIFY changed FINAL)
    Q_PROPERTY(QList<int> autoLogoutChoices READ autoLogoutChoices CONSTANT FINAL)
    // True when operating needs a login; viewing and Stop never do.
    Q_PROPERTY(bool operatorsLogIn READ operatorsLogIn WRITE setOperatorsLogIn NOTIFY changed FINAL)
    // "on", "off" or "auto": on with a real controller.
    Q_PROPERTY(QString holdToStart READ holdToStart WRITE setHoldToStart NOTIFY changed FINAL)
    Q_PROPERTY(bool startIsHeld READ startIsHeld NOTIFY changed FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* ports READ ports CONSTANT FINAL)
    // True on a new panel: language, controller, PINs, machine and a first recipe must be set.
    Q_PROPERTY(bool firstStart READ firstStart NOTIFY firstStartChanged FINAL)
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
    // Sets the value for the present run only; nothing is stored.
    void overrideValue(Setting setting, const QString& text);

    [[nodiscard]] QVariantMap labels() const;
    [[nodiscard]] QString language() const { return m_values.text("display.language"); }
    void setLanguage(const QString& language) { set("display.language", language); }
    [[nodiscard]] const QList<Language>& installedLanguages() const { return m_languages; }
    [[nodiscard]] QStringList languages() const { return languageCodes(m_languages); }
    [[nodiscard]] QStringList languageNames() const; // each in its own language
    [[nodiscard]] QString theme() const { return m_values.text("display.theme"); }
    void setTheme(const QString& theme) { set("display.theme", theme); }
    [[nodiscard]] QStringList themes() const { return choicesOf("display.theme"); }
    [[nodiscard]] bool gloves() const { return m_values.isTrue("display.gloves"); }
    void setGloves(bool gloves) { set("display.gloves", settingText(gloves)); }
    [[nodiscard]] double bagToleranceMm() const { return m_values.number("bags.tolerance_mm"); }
    void setBagToleranceMm(double toleranceMm) { set("bags.tolerance_mm", settingText(toleranceMm)); }
    [[nodiscard]] Value* bagTolerance() { return &m_bagTolerance; }
    [[nodiscard]] Value* unitNumber() { return &m_unitNumber; }

    [[nodiscard]] bool simulated() const { return m_draft.simulated; }
    void setSimulated(bool simulated) { edit("connection.simulated", settingText(simulated)); }
    [[nodiscard]] QString portName() const { return m_draft.portName; }
    void setPortName(const QString& portName) { edit("connection.port", portName); }
    [[nodiscard]] int baud() const { return m_draft.baud; }
    void setBaud(int baud) { edit("connection.baud", settingText(baud)); }
    [[nodiscard]] QString parity() const { return m_draft.parity; }
    void setParity(const QString& parity) { edit("connection.parity", parity); }
    [[nodiscard]] int stopBits() const { return m_draft.stopBits; }
    void setStopBits(int stopBits) { edit("connection.stop_bits", settingText(stopBits)); }
    [[nodiscard]] int unit() const { return m_draft.unit; }
    void setUnit(int unit) { edit("connection.unit", settingText(unit)); }
    [[nodiscard]] bool connectionDirty() const { return m_draft != connection(); }
    [[nodiscard]] QList<int> bauds() const { return numbersOf("connection.baud"); }
    [[nodiscard]] PortModel* ports() { return &m_ports; }

    [[nodiscard]] int autoLogoutMinutes() const { return m_values.whole("access.auto_logout_minutes"); }
    void setAutoLogoutMinutes(int minutes) { set("access.auto_logout_minutes", settingText(minutes)); }
    [[nodiscard]] QList<int> autoLogoutChoices() const { return numbersOf("access.auto_logout_minutes"); }
    [[nodiscard]] bool operatorsLogIn() const { return m_values.isTrue("access.operators_log_in"); }
    void setOperatorsLogIn(bool logIn) { set("access.operators_log_in", settingText(logIn)); }
    [[nodiscard]] QString holdToStart() const { return m_values.text("access.hold_to_start"); }
    void setHoldToStart(const QString& hold) { set("access.hold_to_start", hold); }
    // Returns true when Start acts only after it has been held.
    [[nodiscard]] bool startIsHeld() const;
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
    // Uses this connection for the present run only, for the command line; nothing is stored.
    void overrideConnection(const ConnectionChoice& choice);

signals:
    void changed(); // a value without a signal of its own
    void languageChanged();
    void textsChanged();
    void connectionChanged();
    void connectionApplied();
    void firstStartChanged();

private:
    void load();
    void updateValues();
    void forgetController();
    [[nodiscard]] ConnectionChoice withoutController() const;
    void edit(Setting setting, const QString& text);
    [[nodiscard]] bool require(Level needed) const { return !m_access || m_access->require(needed); }

    store::SettingsFile m_file;
    QList<Language> m_languages = languagesIn(languageFolders());
    SettingValues m_standard;
    SettingValues m_values;
    Value m_bagTolerance;
    Value m_unitNumber;
    bool m_isNoticed;
    bool m_isFirstStart = false;
    QPointer<AccessCheck> m_access;
    ConnectionChoice m_draft;
    PortModel m_ports;
    QString m_simulatorProgram;
    QString m_simulatorStateDir;
};

} // namespace campanel::panel
