// SPDX-License-Identifier: Apache-2.0
#include "app/shell/page_memory.h"

#include "app/store/files/files.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cstdio>

namespace campanel::shell {
namespace {

constexpr qsizetype maxName = 20;

bool isLetter(QChar character)
{
    return character >= u'a' && character <= u'z';
}

// Returns an empty text for a damaged file. The frame may not know the name, as one of another version.
QString pageIn(const QString& path)
{
    const QString name = QString::fromLatin1(store::readBytes(path).value_or(QByteArray()).trimmed());
    const bool isName = name.size() <= maxName && std::ranges::all_of(name, &isLetter);
    return isName ? name : QString();
}

} // namespace

PageMemory::PageMemory(const QString& file)
    : m_file(file)
    , m_left(pageIn(file))
{
}

PageMemory::~PageMemory()
{
    if (m_window)
        QFile::remove(m_file);
}

void PageMemory::follow(QQuickWindow& window)
{
    m_window = &window;
    connect(m_window, SIGNAL(pageChanged()), this, SLOT(keep()));
    keep();
}

void PageMemory::keep()
{
    QDir().mkpath(QFileInfo(m_file).path());
    // Replaced in one step, so that killing the process leaves a complete file. It is not flushed: a power
    // cut may lose it.
    const QString fresh = m_file + QStringLiteral(".new");
    QFile file(fresh);
    if (!file.open(QIODevice::WriteOnly))
        return;
    file.write(m_window->property("page").toString().toLatin1() + '\n');
    file.close();
    std::rename(QFile::encodeName(fresh).constData(), QFile::encodeName(m_file).constData());
}

} // namespace campanel::shell
