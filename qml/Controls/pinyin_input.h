// SPDX-License-Identifier: Apache-2.0
// Chinese by pinyin: letters become candidates, a chosen candidate becomes text. What the letters mean knows
// libgooglepinyin with its dictionary; it has one search at a time: for the GUI thread
// only.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

namespace campanel::controls {

class PinyinInput : public QObject {
    Q_OBJECT
    QML_ELEMENT
    // Its dictionary is there. Opens it the first time that it is asked.
    Q_PROPERTY(bool available READ available CONSTANT FINAL)
    // The letters that are not text yet, in their syllables: "bing'gan".
    Q_PROPERTY(QString spelling READ spelling NOTIFY changed FINAL)
    // The likeliest first.
    Q_PROPERTY(QStringList candidates READ candidates NOTIFY changed FINAL)

public:
    static constexpr int mostCandidates = 60;
    static constexpr int mostLetters = 20; // from 27 on the library may abort

    using QObject::QObject;

    [[nodiscard]] bool available() const;
    [[nodiscard]] QString spelling() const { return m_syllables.join(u'\''); }
    [[nodiscard]] QStringList candidates() const { return m_candidates; }

    // 'a' to 'z'; others are ignored.
    Q_INVOKABLE void add(const QString& letter);
    // Takes the last letter back.
    Q_INVOKABLE void erase();
    // Its text is committed(); letters that it does not stand for are left over for the next choice.
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
