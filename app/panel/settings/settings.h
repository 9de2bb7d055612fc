// SPDX-License-Identifier: Apache-2.0
// `Settings` in QML: the panel's own settings (language, appearance, connection), stored in a file.
// Connection fields are a draft until applyConnection().
#pragma once

#include "app/link/link_values.h"
#include "app/panel/kit/access_check.h"
#include "app/panel/kit/value.h"
#include "app/panel/settings/port_model.h"
#include "app/store/files/settings_file.h"

#include <QObject>
#include <QPointer>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

class QJSEngine;
class QQmlEngine;

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

// The defaults until another value is set on the panel.
struct StandardSettings {
    ConnectionChoice connection;
    QString language; // empty: the system's language, or English
    QString theme = QStringLiteral("light");
    bool gloves = false;
    double bagToleranceMm = 0.5;
    int autoLogoutMinutes = 5;
    bool operatorsLogIn = false;
    QString holdToStart = QStringLiteral("auto");
};

class Settings : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

    Q_PROPERTY(QString language READ language WRITE setLanguage NOTIFY languageChanged FINAL)
    Q_PROPERTY(QStringList languages READ languages CONSTANT FINAL)
    Q_PROPERTY(QStringList languageNames READ languageNames CONSTANT FINAL)
    Q_PROPERTY(QString theme READ theme WRITE setTheme NOTIFY themeChanged FINAL)
    Q_PROPERTY(QStringList themes READ themes CONSTANT FINAL)
    // True for larger keys, for thick gloves: a quarter larger.
    Q_PROPERTY(bool gloves READ gloves WRITE setGloves NOTIFY glovesChanged FINAL)
    // The tolerance of a bag's length, +- mm; for display only, the controller does not know it.
    Q_PROPERTY(
        double bagToleranceMm READ bagToleranceMm WRITE setBagToleranceMm NOTIFY bagToleranceChanged FINAL)
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
    Q_PROPERTY(
        int autoLogoutMinutes READ autoLogoutMinutes WRITE setAutoLogoutMinutes NOTIFY accessChanged FINAL)
    Q_PROPERTY(QList<int> autoLogoutChoices READ autoLogoutChoices CONSTANT FINAL)
    // True when operating needs a login; viewing and Stop never do.
    Q_PROPERTY(bool operatorsLogIn READ operatorsLogIn WRITE setOperatorsLogIn NOTIFY accessChanged FINAL)
    // "on", "off" or "auto": on with a real controller.
    Q_PROPERTY(QString holdToStart READ holdToStart WRITE setHoldToStart NOTIFY holdToStartChanged FINAL)
    Q_PROPERTY(bool startIsHeld READ startIsHeld NOTIFY holdToStartChanged FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* ports READ ports CONSTANT FINAL)
    // True on a new panel: language, controller, PINs, machine and a first recipe must be set.
    Q_PROPERTY(bool firstStart READ firstStart NOTIFY firstStartChanged FINAL)
    // The notice about damaged settings; empty: none.
    Q_PROPERTY(QString notice READ notice NOTIFY noticeChanged FINAL)

public:
    // `storage` is the path of an ini file; empty: the user's standard folder.
    explicit Settings(const QString& storage, QObject* parent, const StandardSettings& standard = {});

    // Return the choices, and the limits of the tolerance.
    [[nodiscard]] static QList<int> possibleBauds();
    [[nodiscard]] static QStringList possibleParities();
    [[nodiscard]] static QStringList possibleLanguages();
    [[nodiscard]] static QStringList possibleThemes();
    [[nodiscard]] static QList<int> possibleLogouts();
    [[nodiscard]] static QStringList possibleHolds();
    static constexpr double minToleranceMm = 0.05;
    static constexpr double maxToleranceMm = 5;

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

    static Settings* create(QQmlEngine* qmlEngine, QJSEngine* jsEngine);

    [[nodiscard]] QString language() const { return m_language; }
    void setLanguage(const QString& language);
    [[nodiscard]] QStringList languages() const { return possibleLanguages(); }
    [[nodiscard]] QStringList languageNames() const; // each in its own language
    [[nodiscard]] QString theme() const { return m_theme; }
    void setTheme(const QString& theme);
    [[nodiscard]] QStringList themes() const { return possibleThemes(); }
    [[nodiscard]] bool gloves() const { return m_gloves; }
    void setGloves(bool gloves);
    [[nodiscard]] double bagToleranceMm() const { return m_bagToleranceMm; }
    void setBagToleranceMm(double toleranceMm); // limited to its range
    [[nodiscard]] Value* bagTolerance() { return &m_bagTolerance; }
    [[nodiscard]] Value* unitNumber() { return &m_unitNumber; }

    [[nodiscard]] bool simulated() const { return m_draft.simulated; }
    void setSimulated(bool simulated);
    [[nodiscard]] QString portName() const { return m_draft.portName; }
    void setPortName(const QString& portName);
    [[nodiscard]] int baud() const { return m_draft.baud; }
    void setBaud(int baud);
    [[nodiscard]] QString parity() const { return m_draft.parity; }
    void setParity(const QString& parity);
    [[nodiscard]] int stopBits() const { return m_draft.stopBits; }
    void setStopBits(int stopBits);
    [[nodiscard]] int unit() const { return m_draft.unit; }
    void setUnit(int unit);
    [[nodiscard]] bool connectionDirty() const { return m_draft != m_applied; }
    [[nodiscard]] QList<int> bauds() const { return possibleBauds(); }
    [[nodiscard]] PortModel* ports() { return &m_ports; }

    [[nodiscard]] int autoLogoutMinutes() const { return m_autoLogoutMinutes; }
    void setAutoLogoutMinutes(int minutes);
    [[nodiscard]] QList<int> autoLogoutChoices() const { return possibleLogouts(); }
    [[nodiscard]] bool operatorsLogIn() const { return m_operatorsLogIn; }
    void setOperatorsLogIn(bool logIn);
    [[nodiscard]] QString holdToStart() const { return m_holdToStart; }
    void setHoldToStart(const QString& hold);
    // Returns true when Start acts only after it has been held.
    [[nodiscard]] bool startIsHeld() const;
    // Sets the access check before changes: connection, tolerance and hold to start need a technician, login
    // settings the level Service, language and appearance nobody.
    void guardBy(AccessCheck& accessCheck) { m_access = &accessCheck; }

    [[nodiscard]] bool firstStart() const { return m_isFirstStart; }
    // Offers the first start when nothing has been set yet, or when the last one was not completed.
    void offerFirstStart();
    void beginFirstStart();
    Q_INVOKABLE void endFirstStart();

    Q_INVOKABLE void refreshPorts();
    Q_INVOKABLE void applyConnection();

    // Return the connection in use, and the same for the link.
    [[nodiscard]] const ConnectionChoice& connection() const { return m_applied; }
    [[nodiscard]] link::ConnectionSettings linkSettings() const;
    // Uses and stores this connection; discards a draft.
    void takeConnection(const link::ConnectionSettings& settings);
    [[nodiscard]] bool isInUse(const link::ConnectionSettings& settings) const;
    // Runs this program as the simulated controller instead of the default one, with its flash in stateDir.
    void overrideSimulator(const QString& program, const QString& stateDir);
    // Uses this connection for the present run only, for the command line; nothing is stored.
    void overrideConnection(const ConnectionChoice& choice);
    void overrideLanguage(const QString& language);
    void overrideTheme(const QString& theme);
    void overrideGloves(bool gloves);

signals:
    void languageChanged();
    void themeChanged();
    void glovesChanged();
    void bagToleranceChanged();
    void connectionChanged();
    void connectionApplied();
    void accessChanged();
    void holdToStartChanged();
    void firstStartChanged();
    void noticeChanged();

private:
    void updateValues();
    void forgetController(ConnectionChoice standard);
    void edit(ConnectionChoice choice);
    [[nodiscard]] bool require(Level needed) const { return !m_access || m_access->require(needed); }

    store::SettingsFile m_file;
    QString m_language;
    QString m_theme;
    bool m_gloves;
    double m_standardToleranceMm;
    double m_bagToleranceMm;
    Value m_bagTolerance;
    Value m_unitNumber;
    int m_autoLogoutMinutes;
    bool m_operatorsLogIn;
    QString m_holdToStart;
    bool m_isNoticed;
    bool m_isFirstStart = false;
    QPointer<AccessCheck> m_access;
    ConnectionChoice m_draft;
    ConnectionChoice m_applied;
    PortModel m_ports;
    QString m_simulatorProgram;
    QString m_simulatorStateDir;
};

} // namespace campanel::panel
