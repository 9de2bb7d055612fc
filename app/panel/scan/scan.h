// SPDX-License-Identifier: Apache-2.0
// `Scan` in QML: a code scanner at the panel. A code selects a recipe, whose difference to the active program
// is then shown; it is downloaded by a person. The keys of a code reach no field.
#pragma once

#include "app/panel/kit/singleton.h"
#include "app/panel/kit/value.h"
#include "app/panel/scan/code_reader.h"
#include "app/panel/scan/film_check.h"

#include <QEvent>
#include <QObject>
#include <QPointer>
#include <QSet>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

#include <memory>
#include <vector>

class QKeyEvent;

namespace campanel::panel {

class Controller;
class Editor;
class Recipes;
class Settings;

class Scan : public QObject, public Singleton<Scan> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

    Q_PROPERTY(campanel::panel::FilmCheck* film READ film CONSTANT FINAL)
    // True when a scanner is set up.
    Q_PROPERTY(bool enabled READ isEnabled NOTIFY settingsChanged FINAL)
    Q_PROPERTY(QString prefix READ prefix NOTIFY settingsChanged FINAL)
    // The answer to a code that opens nothing; empty: none.
    Q_PROPERTY(QString notice READ notice NOTIFY noticeChanged FINAL)
    Q_PROPERTY(QString lastCode READ lastCode NOTIFY codeRead FINAL)
    // True while something is typed and not confirmed: a code opens nothing then.
    Q_PROPERTY(bool typing MEMBER m_isTyping NOTIFY typingChanged FINAL)

public:
    struct Parts {
        Controller& controller;
        Editor& editor;
        Recipes& recipes;
        Settings& settings;
    };

    // All parts must outlive the object. The scanned film reel is kept in `folder`. Filters the keys of the
    // application.
    Scan(const Parts& parts, const QString& folder, QObject* parent);

    [[nodiscard]] FilmCheck* film() { return &m_film; }
    [[nodiscard]] bool isEnabled() const { return !m_keys.prefix.isEmpty(); }
    [[nodiscard]] QString prefix() const { return m_keys.prefix; }
    [[nodiscard]] QString notice() const { return m_notice; }
    [[nodiscard]] QString lastCode() const { return m_lastCode; }

    // Returns why this text cannot be the prefix; empty when it can.
    Q_INVOKABLE QString prefixProblem(const QString& prefix) const;
    Q_INVOKABLE void setPrefix(const QString& prefix);

    // Between these calls a code opens nothing: who called shows it.
    Q_INVOKABLE void beginEntry();
    Q_INVOKABLE void endEntry();
    // Opens the scanned recipe after the decision on the edits of the open one.
    Q_INVOKABLE void openScanned(bool savesEdits);
    Q_INVOKABLE void dismissNotice();

    // Acts on a code as if it had been scanned.
    void takeCode(const QString& code);

signals:
    void settingsChanged();
    void noticeChanged();
    void codeRead(const QString& code);
    // Requests the decision on the edits of the open recipe.
    void editsFound();
    // Requests the difference to the active program.
    void recipeOpened();
    // Requests the sentence and the override: a wrong film reel was scanned.
    void wrongFilmScanned();
    void typingChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct HeldKey {
        QPointer<QObject> window;
        std::unique_ptr<QEvent> event; // a key press
    };

    void updateSettings();
    [[nodiscard]] bool takeKey(QObject* window, const QKeyEvent& event);
    [[nodiscard]] bool isPressOfBurst(QObject* window, const QKeyEvent& event);
    void carryOut(const CodeReader::Step& step);
    void release(int count);
    void checkFilm(const QString& code);
    void openRecipe(qint64 recipeId);
    [[nodiscard]] QString refusal() const;
    void showNotice(const QString& text);

    Parts m_parts;
    FilmCheck m_film;
    ScannerKeys m_keys;
    CodeReader m_reader;
    std::vector<HeldKey> m_held;
    QSet<int> m_takenKeys;                     // pressed and not let go
    std::optional<link::SteadyTime> m_typedAt; // the last printable key
    QTimer m_timer;
    QString m_notice;
    QString m_lastCode;
    int m_entries = 0;
    bool m_isTyping = false;
    bool m_isReleasing = false;
};

} // namespace campanel::panel
