// SPDX-License-Identifier: Apache-2.0
// campanelctl set: writes one parameter of the controller and proves it by reading it back.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/link_session.h"
#include "app/cli/report.h"
#include "modbus/map/codec.h"

using namespace Qt::StringLiterals;

namespace campanel::cli {

Outcome runSet(const Invocation& call)
{
    const QStringList arguments = call.arguments();
    bool isNumber = false;
    const double value = arguments.value(1).toDouble(&isNumber);
    if (arguments.size() != 2 || !isNumber)
        return fail(ExitCode::Usage, u"Name a parameter and its value, such as parameter.ramp_time 800."_s);
    const modbus::RegisterInfo* info = modbus::findRegister(arguments[0].toStdString());
    if (info == nullptr || !modbus::isWrittenAlone(*info))
        return fail(
            ExitCode::Usage,
            u"\"%1\" is not a parameter. campanelctl registers lists all parameters."_s.arg(arguments[0]));
    auto session = LinkSession::open(call);
    if (!session)
        return tl::unexpected(session.error());
    if (const auto written = session->client().writeParameter(*info, value); !written)
        return fail(written.error());
    return call.deliver(QByteArray(info->name.data()) + " = " + number(value) + '\n');
}

} // namespace campanel::cli
