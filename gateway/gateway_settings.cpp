// SPDX-License-Identifier: Apache-2.0
#include "gateway/gateway_settings.h"

#include "app/store/files/files.h"

#include <QFileInfo>
#include <QRegularExpression>

using namespace Qt::StringLiterals;

namespace campanel::gateway {

namespace {

// Returns true for an error about a key of another section, as configuration.cpp words it.
bool isOfOtherSection(const QString& complaint)
{
    static const QRegularExpression otherKey(
        u":\\d+: (?:there is no key )?(?!gateway\\.)[a-z_]+\\.[a-z_]+\\b"_s);
    return otherKey.match(complaint).hasMatch();
}

// Reads the first line of the file. A password that everybody on this computer can read is none.
void readPassword(GatewaySettings& settings, const QString& path, QStringList& errors)
{
    if (settings.user.isEmpty() != path.isEmpty())
        errors << u"gateway.user and gateway.password_file belong together. Set both, or neither."_s;
    if (path.isEmpty())
        return;
    const auto bytes = store::readBytes(path);
    if (!bytes) {
        errors << u"gateway.password_file: %1 cannot be read."_s.arg(path);
        return;
    }
    if (QFileInfo(path).permissions() & (QFile::ReadOther | QFile::WriteOther))
        errors << u"gateway.password_file: everybody can open %1. Run chmod o= on it."_s.arg(path);
    settings.password = QString::fromUtf8(*bytes).section(u'\n', 0, 0).trimmed();
    if (settings.password.isEmpty())
        errors << u"gateway.password_file: the first line of %1 is empty."_s.arg(path);
}

} // namespace

ReadGatewaySettings gatewaySettings(const shell::ReadConfiguration& read, const QString& computer)
{
    const panel::SettingValues& values = read.values;
    ReadGatewaySettings result;
    GatewaySettings& settings = result.settings;
    settings = {values.text("gateway.host"), values.whole("gateway.port"),
                values.text("gateway.ca"),   values.text("gateway.certificate"),
                values.text("gateway.key"),  values.text("gateway.group"),
                values.text("gateway.node"), values.text("gateway.primary_host"),
                values.text("gateway.user"), {}};
    readPassword(settings, values.text("gateway.password_file"), result.errors);
    if (settings.node.isEmpty())
        settings.node = computer;
    for (const QString& complaint : read.complaints)
        (isOfOtherSection(complaint) ? result.warnings : result.errors) << complaint;
    if (settings.group.isEmpty())
        result.errors << u"gateway.group is empty. Name the group."_s;
    if (settings.node.isEmpty())
        result.errors << u"gateway.node is empty and the computer has no name. Name the node."_s;
    if (settings.certificate.isEmpty() != settings.key.isEmpty())
        result.errors << u"gateway.certificate and gateway.key belong together. Set both, or neither."_s;
    if (!settings.certificate.isEmpty() && settings.ca.isEmpty())
        result.errors << u"gateway.certificate needs gateway.ca: without it the connection has no TLS."_s;
    for (const auto& [key, path] :
         {std::pair(u"ca"_s, settings.ca), std::pair(u"certificate"_s, settings.certificate),
          std::pair(u"key"_s, settings.key)}) {
        if (!path.isEmpty() && !(QFileInfo(path).isFile() && QFileInfo(path).isReadable()))
            result.errors << u"gateway.%1: %2 cannot be read."_s.arg(key, path);
    }
    if (!settings.host.isEmpty() && !settings.isEncrypted())
        result.warnings << u"The connection to %1 is not encrypted: gateway.ca is not set."_s.arg(
            settings.host);
    if (!settings.host.isEmpty() && !settings.isEncrypted() && !settings.password.isEmpty())
        result.warnings << u"The password is sent unencrypted: gateway.ca is not set."_s;
    return result;
}

} // namespace campanel::gateway
