// SPDX-License-Identifier: Apache-2.0
// campanelctl audit verify: checks the chain of an audit trail. The file is not written.
#include "app/cli/commands.h"
#include "app/cli/database_file.h"
#include "app/cli/invocation.h"
#include "app/cli/report.h"
#include "app/store/logs/audit_log.h"

#include <QTemporaryDir>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

using Fault = store::ChainCheck::Fault;

QString verdictKey(Fault fault)
{
    switch (fault) {
    case Fault::None:
        return u"unbroken"_s;
    case Fault::Altered:
        return u"altered"_s;
    case Fault::Missing:
        return u"missing"_s;
    case Fault::MissingAtEnd:
        return u"missing_at_end"_s;
    case Fault::EndUnknown:
        break;
    }
    return u"end_unknown"_s;
}

QString sentence(const store::ChainCheck& check, const QString& path)
{
    const QString row = QString::number(check.brokenSequence());
    switch (check.fault()) {
    case Fault::None:
        return {};
    case Fault::Altered:
        return u"%1: row %2 of the audit trail was altered."_s.arg(path, row);
    case Fault::Missing:
        return u"%1: rows of the audit trail are missing, row %2 is the first."_s.arg(path, row);
    case Fault::MissingAtEnd:
        return u"%1: the newest rows of the audit trail are missing, row %2 is the first."_s.arg(path, row);
    case Fault::EndUnknown:
        break;
    }
    return u"%1: the rows before %2 are intact. Newer rows may be missing: the file %1.audit, which names the newest row, is missing or damaged."_s
        .arg(path, row);
}

} // namespace

Outcome runAudit(const Invocation& call)
{
    const QStringList words = call.arguments();
    if (words.size() != 2 || words.first() != u"verify")
        return fail(ExitCode::Usage, u"Name the file to check: campanelctl audit verify FILE."_s);
    const QTemporaryDir unpacked;
    const auto database = openDatabaseFile(words.last(), unpacked);
    if (!database)
        return tl::unexpected(database.error());
    const auto check = store::verifyChain(**database);
    if (!check)
        return fail(ExitCode::File,
                    u"The audit trail of %1 cannot be read: %2."_s.arg(words.last(), check.error().detail));
    const bool isUnbroken = check->fault() == Fault::None;
    QJsonObject result{{u"verdict"_s, verdictKey(check->fault())},
                       {u"rows"_s, check->rows()},
                       {u"recorded_losses"_s, check->losses()},
                       {u"last_hash"_s, QString::fromLatin1(check->lastHash().toHex())},
                       {u"broken_row"_s, isUnbroken ? QJsonValue() : QJsonValue(check->brokenSequence())}};
    if (const Outcome printed = call.deliver(formatted(result, call.format())); !printed)
        return printed;
    return isUnbroken ? Outcome() : fail(ExitCode::Refused, sentence(*check, words.last()));
}

} // namespace campanel::cli
