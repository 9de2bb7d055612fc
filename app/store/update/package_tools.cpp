// SPDX-License-Identifier: Apache-2.0
#include "app/store/update/package_tools.h"

#include "app/store/database/database.h"
#include "app/store/files/files.h"
#include "app/store/logs/trend_schema.h"

#include <QHash>
#include <QProcess>
#include <QStringList>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

constexpr int patienceMs = 10'000;
const QString systemPackage = u"campanel-system"_s; // of packaging/image

// Returns the lines "name", "version", "architecture" that a program of dpkg prints.
std::optional<PackageId> idFrom(const QString& program, const QStringList& arguments)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::SeparateChannels);
    process.start(program, arguments, QIODevice::ReadOnly);
    if (!process.waitForFinished(patienceMs) || process.exitStatus() != QProcess::NormalExit ||
        process.exitCode() != 0)
        return std::nullopt;
    const QStringList lines = QString::fromUtf8(process.readAllStandardOutput()).trimmed().split(u'\n');
    constexpr qsizetype count = 3;
    return lines.size() == count ? std::optional(PackageId{lines[0], lines[1], lines[2]}) : std::nullopt;
}

// Returns the place of a character in the order of dpkg: "~" before the end (0), letters, then the others.
int rank(QChar character)
{
    constexpr int beforeAll = -1;
    constexpr int afterLetters = 256;
    if (character == u'~')
        return beforeAll;
    if (character.isDigit())
        return 0;
    const int code = character.unicode();
    return character.isLetter() ? code : code + afterLetters;
}

int rankAt(QStringView text, qsizetype at)
{
    return at < text.size() ? rank(text[at]) : 0;
}

// Removes the digits at the beginning and returns them without leading zeros.
QStringView takeNumber(QStringView& text)
{
    const auto isDigit = [](QChar character) { return character.isDigit(); };
    const auto end = std::ranges::find_if_not(text, isDigit);
    QStringView number = text.first(end - text.begin());
    text = text.sliced(number.size());
    while (number.startsWith(u'0'))
        number = number.sliced(1);
    return number;
}

// Compares parts by turns: characters other than digits by their ranks, digits as a number.
std::strong_ordering comparePart(QStringView left, QStringView right)
{
    while (!left.isEmpty() || !right.isEmpty()) {
        qsizetype at = 0;
        for (; (at < left.size() && !left[at].isDigit()) || (at < right.size() && !right[at].isDigit());
             ++at) {
            if (rankAt(left, at) != rankAt(right, at))
                return rankAt(left, at) <=> rankAt(right, at);
        }
        left = left.sliced(std::min(at, left.size()));
        right = right.sliced(std::min(at, right.size()));
        const QStringView leftNumber = takeNumber(left);
        const QStringView rightNumber = takeNumber(right);
        if (leftNumber.size() != rightNumber.size())
            return leftNumber.size() <=> rightNumber.size();
        if (const int order = leftNumber.compare(rightNumber); order != 0)
            return order <=> 0;
    }
    return std::strong_ordering::equal;
}

struct VersionParts {
    QStringView epoch;
    QStringView upstream;
    QStringView revision;
};

VersionParts partsOf(QStringView version)
{
    const qsizetype colon = version.indexOf(u':');
    const QStringView epoch = colon < 0 ? QStringView() : version.first(colon);
    const QStringView rest = version.sliced(colon + 1);
    const qsizetype dash = rest.lastIndexOf(u'-');
    return {epoch, dash < 0 ? rest : rest.first(dash), dash < 0 ? QStringView() : rest.sliced(dash + 1)};
}

} // namespace

std::optional<PackageId> packageIn(const QString& path)
{
    return idFrom(u"dpkg-deb"_s, {u"--show"_s, u"--showformat=${Package}\\n${Version}\\n${Architecture}\\n"_s,
                                  u"--"_s, path});
}

std::optional<PackageId> installedPackage()
{
    auto id =
        idFrom(u"dpkg-query"_s,
               {u"--show"_s, u"--showformat=${Package}\\n${Version}\\n${Architecture}\\n"_s, u"campanel"_s});
    const QString image = imageVersion();
    if (id && !image.isEmpty())
        id = PackageId{systemPackage, image, id->architecture};
    return id;
}

QString imageVersion(const QString& osRelease)
{
    QHash<QString, QString> values;
    for (const QString& line : QString::fromUtf8(readBytes(osRelease).value_or(QByteArray())).split(u'\n'))
        values.insert(line.section(u'=', 0, 0), line.section(u'=', 1));
    return values.value(u"IMAGE_ID"_s) == systemPackage ? values.value(u"IMAGE_VERSION"_s) : QString();
}

std::strong_ordering compareVersions(QStringView left, QStringView right)
{
    const VersionParts one = partsOf(left);
    const VersionParts other = partsOf(right);
    if (const auto order = comparePart(one.epoch, other.epoch); order != std::strong_ordering::equal)
        return order;
    if (const auto order = comparePart(one.upstream, other.upstream); order != std::strong_ordering::equal)
        return order;
    return comparePart(one.revision, other.revision);
}

QString shortVersion(const QString& version)
{
    return version.section(u"+deb"_s, 0, 0);
}

QString dataSchema()
{
    return u"%1.%2"_s.arg(QString::number(schemaVersion()), QString::number(trendDatabase().steps().size()));
}

} // namespace campanel::store
