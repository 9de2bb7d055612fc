// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/package_sentences.h"

#include <QFileInfo>

using namespace Qt::StringLiterals;

namespace campanel::panel {

QString PackageSentences::fault(const store::PackageFault& fault)
{
    using Kind = store::PackageFault::Kind;
    const QString file = QFileInfo(fault.path).fileName();
    switch (fault.kind) {
    case Kind::NotReadable:
        return tr("%1 cannot be read: %2.").arg(file, fault.detail);
    case Kind::NotAPackage:
        return tr("%1 is not a Debian package.").arg(file);
    case Kind::NotSigned:
        return tr("%1 has no signature. Copy the file %1.sig beside it.").arg(file);
    case Kind::UnknownSigner:
        return tr("%1 is signed by %2, whose key this machine does not have. Install the key first.")
            .arg(file, fault.detail);
    case Kind::WithdrawnSigner:
        return tr("%1 is signed by %2, whose key was withdrawn. Ask for a package signed with a valid key.")
            .arg(file, fault.detail);
    case Kind::WrongSignature:
        return tr("The signature of %1 is not valid. Ask for a new copy of both files.").arg(file);
    case Kind::NewerSignature:
        return tr("The signature of %1 has a newer form than this CamPanel knows. Install a version in "
                  "between first.")
            .arg(file);
    case Kind::Damaged:
        return tr("%1 is damaged or was changed after it was signed. Copy the file again.").arg(file);
    }
    return {};
}

QString PackageSentences::mismatch(const store::PackageId& package, const store::PackageId& installed)
{
    if (package.name != installed.name)
        return tr("This is the package %1; this panel takes %2.").arg(package.name, installed.name);
    if (package.architecture != installed.architecture)
        return tr("This package is for computers of type %1; this panel has %2.")
            .arg(package.architecture, installed.architecture);
    const auto order = store::compareVersions(package.version, installed.version);
    if (order < 0)
        return tr("Version %1 is older than the installed version %2.")
            .arg(package.version, installed.version);
    return order == 0 ? tr("Version %1 is installed.").arg(package.version) : QString();
}

QString PackageSentences::shortFault(store::PackageFault::Kind kind)
{
    using Kind = store::PackageFault::Kind;
    switch (kind) {
    case Kind::NotReadable:
        return tr("not readable");
    case Kind::NotAPackage:
        return tr("no package");
    case Kind::NotSigned:
        return tr("no signature");
    case Kind::UnknownSigner:
        return tr("unknown key");
    case Kind::WithdrawnSigner:
        return tr("withdrawn key");
    case Kind::WrongSignature:
        return tr("wrong signature");
    case Kind::NewerSignature:
        return tr("unknown form of signature");
    case Kind::Damaged:
        return tr("damaged");
    }
    return {};
}

QString PackageSentences::shortMismatch(const store::PackageId& package, const store::PackageId& installed)
{
    if (package.name != installed.name)
        return tr("another package");
    if (package.architecture != installed.architecture)
        return tr("for another type of computer");
    const auto order = store::compareVersions(package.version, installed.version);
    if (order < 0)
        return tr("older version");
    return order == 0 ? tr("installed") : QString();
}

QString PackageSentences::failure(const QString& reason, const QString& detail)
{
    if (reason == u"signature")
        return tr("The package is not signed by a key of this machine.");
    if (reason == u"package")
        return tr("The package is not a newer CamPanel for this machine.");
    if (reason == u"dependencies")
        return tr("The package needs other packages, which the stick cannot bring: %1. Install them by the "
                  "package manager first.")
            .arg(detail);
    if (reason == u"old-package")
        return tr("The package of the installed version %1 is missing, so there would be no way back. Copy "
                  "it and its signature to the stick as well.")
            .arg(detail);
    if (reason == u"space")
        return tr("%1 MB of free space are needed on this panel.").arg(detail);
    if (reason == u"too-large")
        return tr("The system is larger than its place on the card. Make a backup, then write the new image "
                  "to the card.");
    if (reason == u"no-trial")
        return tr("The firmware of this computer cannot start a system once, so there would be no way back. "
                  "Make a backup, then write the new image to the card.");
    if (reason == u"busy")
        return tr("Another installation is under way on this panel. Wait until it has ended.");
    if (reason == u"processes")
        return tr("A program of the panel's user did not end. Switch the panel off and on, then try again.");
    if (reason == u"data")
        return tr("The panel's data could not be copied. Read journalctl -u campanel-update.");
    if (reason == u"no-way-back")
        return tr("The earlier version is not kept on this panel any more.");
    if (reason == u"not-shown")
        return tr("The new version did not open its window.");
    if (reason == u"not-installed")
        return tr("The new version could not be installed.");
    return tr("The files could not be read.");
}

} // namespace campanel::panel
