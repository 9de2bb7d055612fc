// SPDX-License-Identifier: Apache-2.0
// Reads QR codes with a program that is not ours.
#pragma once

#include <QProcess>
#include <QStringList>

namespace campanel::test {

// Runs a program of Debian's and returns its output. The test ends when it is missing.
inline QByteArray outputOf(const QString& program, const QStringList& arguments)
{
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForFinished() || process.exitStatus() != QProcess::NormalExit)
        qFatal("%s does not run: %s (its package is in packaging/dependencies)", qPrintable(program),
               qPrintable(process.errorString()));
    return process.readAllStandardOutput();
}

// Returns the texts of the QR codes in these pictures, by zbarimg. They must have no line breaks.
inline QStringList readQrCodes(const QStringList& pictures)
{
    const QStringList options{QStringLiteral("--quiet"), QStringLiteral("--raw"), QStringLiteral("-Sdisable"),
                              QStringLiteral("-Sqrcode.enable")};
    return QString::fromUtf8(outputOf(QStringLiteral("zbarimg"), options + pictures))
        .split(u'\n', Qt::SkipEmptyParts);
}

} // namespace campanel::test
