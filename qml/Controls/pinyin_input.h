// SPDX-License-Identifier: Apache-2.0
// Chinese input by pinyin: letters become candidates, a chosen candidate becomes text. libgooglepinyin and
// its dictionary convert the letters; the library has one search at a time: for the GUI thread only.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

namespace campanel::controls {

class PinyinInput : public QObject {
    Q_OBJECT
    QML_ELEMENT
    // True when its dictionary exists. The first call opens it.
    Q_PROPERTY(bool available READ available CONSTANT FINAL)
    // The letters that are not text yet, in syllables: "bing'gan".
    Q_PROPERTY(QString spelling READ spelling NOTIFY changed FINAL)
    // The candidates, the most likely first.
    Q_PROPERTY(QStringList candidates READ candidates NOTIFY changed FINAL)

public:
    static constexpr int maxCandidates = 60;
    static constexpr int maxLetters = 20; // from 27 on the library may abort

    using QObject::QObject;

    [[nodiscard]] bool available() const;
    [[nodiscard]] QString spelling() const { return m_syllables.join(u'\''); }
    [[nodiscard]] QStringList candidates() const { return m_candidates; }

    // Adds a letter 'a' to 'z'; ignores others.
    Q_INVOKABLE void add(const QString& letter);
    // Deletes the last letter.
    Q_INVOKABLE void erase();
    // Commits the text of a candidate with committed(); the remaining letters stay for the next choice.
    Q_INVOKABLE void choose(int candidate);
    Q_INVOKABLE void clear();

signals:
    void changed();
    void committed(const QString& text);

private:
    void search();

    QByteArray m_letters;
    QStringList m_syllables;
    QStringList m_candidates;
};

} // namespace campanel::controls
