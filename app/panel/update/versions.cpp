// SPDX-License-Identifier: Apache-2.0
#include "app/panel/update/versions.h"

#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/records/database_service.h"
#include "app/panel/words/recipe_words.h"

#include <QCoreApplication>
#include <QStorageInfo>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

constexpr auto measurePeriod = 6h;
constexpr double bytesPerMegabyte = 1e6;
constexpr double bytesPerGigabyte = 1e9;
constexpr double longYears = 100;

QString versionText(const QString& name, double version)
{
    if (version == 0)
        return Versions::tr("%1, not saved", "recipe").arg(name);
    return Versions::tr("%1, version %2", "recipe, number").arg(name, QString::number(version));
}

// The result from the thread of the database.
struct Measured {
    store::SystemRecord record;
    qint64 freeBytes = 0;
};

} // namespace

Versions::Versions(Controller& controller, Editor& editor, DatabaseService& records, const QString& folder,
                   QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_editor(editor)
    , m_records(records)
    , m_folder(folder)
    , m_freeBytes([](const QString& place) { return QStorageInfo(place).bytesAvailable(); })
{
    m_timer.setInterval(measurePeriod);
    connect(&m_timer, &QTimer::timeout, this, &Versions::measure);
    for (const auto changed :
         {&Controller::connectionChanged, &Controller::programChanged, &Controller::stateChanged})
        connect(&m_controller, changed, this, &Versions::update);
    connect(&m_editor, &Editor::recipeChanged, this, &Versions::update);
    LanguageNotifier::follow(this, &Versions::update);
    update();
}

void Versions::open()
{
    measure();
    m_timer.start();
}

// Waits for the disk in the thread of the database.
void Versions::measure()
{
    const qint64 day = m_wallClock().toUTC().date().toJulianDay() - QDate(1970, 1, 1).toJulianDay();
    m_records.store().run(
        this,
        [folder = m_folder, freeBytes = m_freeBytes, known = m_record, day](store::Database&) {
            Measured measured{known.value_or(store::readSystemRecord(folder)), freeBytes(folder)};
            store::addSample(measured.record, day, store::sizeOfFolder(folder));
            (void)store::writeSystemRecord(folder, measured.record); // it is measured again
            return measured;
        },
        [this](const Measured& measured) {
            if (m_record)
                m_record->samples = measured.record.samples;
            else
                m_record = measured.record;
            m_forecast = store::forecastOf(*m_record, measured.freeBytes);
            update();
        });
}

void Versions::setGateway(const QString& version)
{
    m_gateway = version;
    update();
}

void Versions::setSystem(const QString& version)
{
    m_system = version;
    update();
}

void Versions::noteSoftware(const QString& part, const QString& version)
{
    if (!m_record || version.isEmpty() || m_record->software.value(part) == version)
        return;
    emit noted({.what = u"update.version"_s,
                .object = part + u"_software"_s,
                .before = std::exchange(m_record->software[part], version),
                .after = version});
    m_records.store().run(
        this,
        [folder = m_folder, record = *m_record](store::Database&) {
            return store::writeSystemRecord(folder, record).has_value();
        },
        [](bool) {});
}

QString Versions::controllerText() const
{
    const auto& identity = m_controller.identity();
    if (!identity)
        return {};
    return tr("firmware %1, register map %2.%3, serial number %4")
        .arg(QString::fromStdString(identity->firmwareVersion()), QString::number(identity->mapMajor),
             QString::number(identity->mapMinor), Format::hexDigits(identity->uniqueId, 16));
}

QString Versions::growthText() const
{
    const Format format;
    if (!m_forecast.bytesPerDay)
        return tr("not known yet: measured from the second day on");
    const QString growth =
        tr("%1 MB a day").arg(format.number(*m_forecast.bytesPerDay / bytesPerMegabyte, 1));
    if (!m_forecast.years)
        return growth;
    return *m_forecast.years > longYears ? tr("%1; the disk lasts more than 100 years", "growth").arg(growth)
                                         : tr("%1; the disk lasts %2 years", "growth, number")
                                               .arg(growth, format.number(*m_forecast.years, 1));
}

QString Versions::warning() const
{
    if (!m_forecast.isShort())
        return {};
    return tr("The disk lasts for less than five years. Free some disk space, or use a larger disk.");
}

void Versions::update()
{
    const QString nothing = tr("unknown");
    const auto known = [&nothing](const QString& text) { return text.isEmpty() ? nothing : text; };
    const QString panel = QCoreApplication::applicationVersion();
    noteSoftware(u"panel"_s, panel);
    noteSoftware(u"gateway"_s, m_gateway);
    noteSoftware(u"system"_s, m_system);
    const auto& identity = m_controller.identity();
    if (identity && m_controller.isConnected())
        noteSoftware(u"controller"_s,
                     u"%1, %2.%3, %4"_s.arg(QString::fromStdString(identity->firmwareVersion()),
                                            QString::number(identity->mapMajor),
                                            QString::number(identity->mapMinor),
                                            Format::hexDigits(identity->uniqueId, 16)));
    const ActiveProgramValues active = m_controller.active();
    const auto& status = m_controller.status();
    const QString kind =
        active.isPresent ? RecipeWords::kindName(static_cast<profile::ProgramKind>(active.kind)) : QString();
    const QString program =
        active.isPresent ? kind + u" · "_s + versionText(active.name, active.version) : QString();
    const QString table = status && status->activeCrc ? tr("%1, CRC-32 %2", "number, number")
                                                            .arg(status->generation)
                                                            .arg(Format::hexDigits(*status->activeCrc, 8))
                                                      : QString();
    const Format format;
    const QString freeSpace =
        m_record ? tr("%1 GB free").arg(format.number(double(m_forecast.freeBytes) / bytesPerGigabyte, 1))
                 : QString();
    QList<FigureRow> rows{{tr("Panel"), known(panel.isEmpty() ? QString() : u"CamPanel "_s + panel), false}};
    if (!m_system.isEmpty())
        rows << FigureRow{tr("System"), m_system, false};
    rows << QList<FigureRow>{
        {tr("Gateway"), m_gateway.isEmpty() ? tr("unknown: not connected") : m_gateway, false},
        {tr("Controller"), known(controllerText()), false},
        {tr("Active program"), known(program), false},
        {tr("Generation"), known(table), false},
        {tr("Open recipe"), versionText(m_editor.recipeName(), m_editor.recipeVersion()), false},
        {tr("Disk"), known(freeSpace), m_forecast.isShort()},
        {tr("Growth"), growthText(), m_forecast.isShort()}};
    m_rows.setRows(rows);
    emit changed();
}

} // namespace campanel::panel
