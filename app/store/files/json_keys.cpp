// SPDX-License-Identifier: Apache-2.0
#include "app/store/files/json_keys.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QSet>
#include <QStringList>

namespace campanel::store {
namespace {

// Returns the position of the closing quotation mark of the text that begins at `begin`.
qsizetype endOfText(const QByteArray& json, qsizetype begin)
{
    qsizetype i = begin + 1;
    while (i < json.size() && json[i] != '"')
        i += json[i] == '\\' ? 2 : 1;
    return i;
}

// Reads a text with its quotation marks: "a" and "\u0061" are one key.
QString keyOf(const QByteArray& text)
{
    return QJsonDocument::fromJson('[' + text + ']').array().at(0).toString();
}

} // namespace

std::optional<QString> repeatedKey(const QByteArray& json)
{
    QList<QSet<QString>> objects; // empty for an array
    QStringList path;             // present key in each of them
    QByteArray text;
    for (qsizetype i = 0; i < json.size(); ++i) {
        switch (json[i]) {
        case '{':
        case '[':
            objects.append(QSet<QString>());
            path.append(QString());
            break;
        case '}':
        case ']':
            objects.removeLast();
            path.removeLast();
            break;
        case '"': {
            const qsizetype end = endOfText(json, i);
            text = json.mid(i, end - i + 1);
            i = end;
            break;
        }
        case ':':
            path.last() = keyOf(text);
            if (objects.last().contains(path.last())) {
                path.removeAll(QString());
                return path.join(u'.');
            }
            objects.last().insert(path.last());
            break;
        default:
            break;
        }
    }
    return std::nullopt;
}

} // namespace campanel::store
