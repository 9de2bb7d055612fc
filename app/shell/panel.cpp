// SPDX-License-Identifier: Apache-2.0
// The complete panel; see panel.h.
#include "app/shell/panel.h"

#include "app/shell/fonts.h"

#include "app/panel/kit/singleton.h"
#include "app/plant/socket_path.h"
#include "app/report/commissioning_pdf.h"
#include "app/store/database/setup_marker.h"
#include "app/store/files/private_files.h"
#include "app/store/update/package_tools.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QDir>
#include <QEventLoop>
#include <QInputDevice>
#include <QLibraryInfo>
#include <QLocale>
#include <QLoggingCategory>
#include <QStandardPaths>
#include <QTransform>

#include <algorithm>

namespace campanel::shell {
namespace {

Q_LOGGING_CATEGORY(uiLog, "campanel.ui")

QString recipeFolder(const Storage& storage)
{
    return storage.recipeFolder.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)
                                          : storage.recipeFolder;
}

// Creates the folder; removes the permissions of others that an older version has left.
QString privateDataFolder(const Storage& storage)
{
    const QString folder = recipeFolder(storage);
    (void)store::makePrivateFolder(folder); // a failure is reported when the database is opened
    store::makePrivate(folder);
    return folder;
}

int countTouchscreens()
{
    return static_cast<int>(std::ranges::count(QInputDevice::devices(), QInputDevice::DeviceType::TouchScreen,
                                               &QInputDevice::type));
}

} // namespace

Panel::Qml::Qml()
{
    engine.addImportPath(QStringLiteral("qrc:/qt/qml"));
    component.loadUrl(QUrl(QStringLiteral("qrc:/qt/qml/CamPanel/Frame/Main.qml")),
                      QQmlComponent::Asynchronous);
}

Panel::Panel(link::Link& link, const Storage& storage)
    : m_storage(storage)
    , m_restore(
          store::finishRestore(privateDataFolder(storage), panel::Settings::fileName(storage.settingsFile)))
    , m_wasSetUp(store::wasSetUp(QDir(recipeFolder(storage)).filePath(QStringLiteral("campanel.sqlite"))))
    , m_settings(storage.settingsFile, nullptr, storage.standard)
    , m_controller(link, m_settings, nullptr)
    , m_editor(m_controller, recipeFolder(storage), nullptr)
    , m_records(recipeFolder(storage), nullptr)
    , m_alarms(m_controller, m_editor, m_records, m_settings, nullptr)
    , m_recipes(m_controller, m_editor, m_records, recipeFolder(storage), nullptr)
    , m_builderFiles(m_recipes, m_records, nullptr)
    , m_scan({m_controller, m_editor, m_recipes, m_settings}, recipeFolder(storage), nullptr)
    , m_maintenance(m_controller, m_settings, recipeFolder(storage), nullptr)
    , m_trends(m_controller, m_settings, m_records, recipeFolder(storage), nullptr)
    , m_stops(m_controller, m_settings, m_records, nullptr)
    , m_handSpeed(m_controller, nullptr)
    , m_handTrims(m_controller, nullptr)
    , m_handBags(m_controller, nullptr)
    , m_orders(m_controller, m_records, nullptr)
    , m_access(m_records, m_controller, m_settings, nullptr)
    , m_systemClock(m_controller.accessCheck(), nullptr)
    , m_systemNetwork(m_controller.accessCheck(), nullptr)
    , m_trail(m_records, {m_controller, m_editor, m_settings, m_maintenance, m_access}, nullptr)
    , m_audit(m_records, m_trail, nullptr)
    , m_backup({m_controller, m_editor, m_records, m_trends, m_settings, m_access, m_trail},
               recipeFolder(storage), nullptr)
    , m_update(m_controller, recipeFolder(storage), nullptr)
    , m_versions(m_controller, m_editor, m_records, recipeFolder(storage), nullptr)
    , m_commissioning(m_controller, m_editor, m_access, *m_maintenance.files(), nullptr)
    , m_shiftReport(m_controller, m_stops, m_records, *m_maintenance.files(), nullptr)
    , m_bundle({m_controller, m_editor, m_records, *m_maintenance.figures(), *m_maintenance.files(),
                *m_maintenance.frames()},
               nullptr)
    , m_display(m_controller, m_settings, nullptr)
    , m_rotation(m_controller, m_settings, nullptr)
    , m_touchCalibration(m_controller, nullptr)
    , m_explanations({m_controller, m_editor, *m_maintenance.figures(), m_trends, m_stops,
                      *m_maintenance.packing()->edges()},
                     nullptr)
    , m_plant({m_controller, m_alarms, m_stops, m_orders}, m_trail, nullptr)
    , m_hasBroker(!storage.standard.text("gateway.host").isEmpty())
    , m_pageMemory(recipeFolder(storage) + QStringLiteral("/open-page"))
{
    const auto print = [this](const panel::ReportData& data) {
        const auto* theme = m_window ? m_window->property("theme").value<QObject*>() : nullptr;
        const auto* scheme = theme ? theme->property("light").value<QObject*>() : nullptr;
        return report::commissioningPdf(data, report::ReportColors::of(scheme));
    };
    m_commissioning.setPrinter(print);
    m_shiftReport.setPrinter(print);
    m_records.noteRestore(m_restore);
    if (!storage.diskLost.isEmpty()) {
        m_records.noteDiskLost(storage.diskLost);
        m_editor.programDownload()->noteDataLost();
    }
    connect(&m_backup, &panel::Backup::restartWanted, this, &Panel::restartWanted);
    m_bundle.setScreen([this] {
        QByteArray png;
        QBuffer buffer(&png);
        if (m_window && buffer.open(QIODevice::WriteOnly))
            picture().save(&buffer, "PNG");
        return png;
    });
    m_alarms.watch().setTouchscreenCount(&countTouchscreens);
    m_maintenance.dryRun()->follow(m_editor);
    m_maintenance.measurement()->follow(m_editor);
    connect(m_maintenance.packing()->sensor(), &panel::MarkSensor::driftChanged, &m_alarms.watch(),
            &panel::AlarmWatch::noteSensorDrift);
    connect(m_maintenance.packing()->jam(), &panel::JamWatch::residueRecorded, &m_trends,
            &panel::Trends::recordResidue);
    m_recipes.files()->setKeyFolder(storage.keyFolder);
    m_recipes.files()->setGlyphs(&hasGlyph);
    const auto sort = [this] { m_recipes.setOrder(m_settings.values().text("recipes.order")); };
    connect(&m_settings, &panel::Settings::changed, &m_recipes, sort);
    sort();
    connect(m_editor.programDownload()->windowReason(), &panel::WindowReason::noted, &m_trail,
            &panel::AuditTrail::note);
    connect(m_scan.film(), &panel::FilmCheck::noted, &m_trail, &panel::AuditTrail::note);
    connect(&m_plant, &panel::PlantFeed::offerReceived, m_recipes.files(), &panel::RecipeFiles::takeOffer);
    const QString node = storage.standard.text("gateway.node");
    m_orders.offers()->setTrust(storage.keyFolder, node.isEmpty() ? QSysInfo::machineHostName() : node);
    connect(&m_plant, &panel::PlantFeed::offerReceived, m_orders.offers(), &panel::OrderOffers::takeOffer);
    connect(&m_recipes, &panel::Recipes::noted, &m_trail, &panel::AuditTrail::note);
    connect(&m_alarms, &panel::Alarms::noted, &m_trail, &panel::AuditTrail::note);
    for (const panel::FileExchange* files : std::initializer_list<panel::FileExchange*>{
             m_maintenance.files(), m_recipes.exports(), m_editor.camFiles()})
        connect(files, &panel::FileExchange::written, &m_trail, &panel::AuditTrail::noteExport);
    connect(&m_handSpeed, &panel::HandSpeed::noted, &m_trail, &panel::AuditTrail::note);
    connect(&m_handTrims, &panel::HandTrims::noted, &m_trail, &panel::AuditTrail::note);
    connect(&m_handTrims, &panel::HandTrims::saveWanted, &m_recipes, &panel::Recipes::saveTrims);
    m_handTrims.setSaved([this](const QString& name) {
        const store::RecipeVersion* recipe = m_recipes.named(name);
        return recipe ? std::optional(recipe->recipe.trims) : std::nullopt;
    });
    connect(&m_recipes, &panel::Recipes::listChanged, &m_handTrims, &panel::HandTrims::update);
    connect(&m_orders, &panel::Orders::noted, &m_trail, &panel::AuditTrail::note);
    connect(&m_orders, &panel::Orders::turned, &m_stops, &panel::Stops::divide);
    connect(&m_stops, &panel::Stops::noted, &m_trail, &panel::AuditTrail::note);
    connect(&m_systemClock, &panel::SystemClock::noted, &m_trail, &panel::AuditTrail::note);
    connect(&m_systemNetwork, &panel::SystemNetwork::noted, &m_trail, &panel::AuditTrail::note);
    connect(&m_touchCalibration, &panel::TouchCalibration::noted, &m_trail, &panel::AuditTrail::note);
    connect(&m_systemClock, &panel::SystemClock::moved, &m_records, &panel::DatabaseService::noteClockProven);
    connect(&m_update, &panel::SoftwareUpdate::noted, &m_trail, &panel::AuditTrail::note);
    connect(&m_builderFiles, &panel::BuilderFiles::noted, &m_trail, &panel::AuditTrail::noteOutside);
    connect(&m_update, &panel::SoftwareUpdate::ended, &m_trail, &panel::AuditTrail::noteOutside);
    connect(&m_versions, &panel::Versions::noted, &m_trail, &panel::AuditTrail::noteOutside);
    connect(&m_plant, &panel::PlantFeed::gatewayChanged, &m_versions, &panel::Versions::setGateway);
    panel::attachToEngine(m_qml->engine, m_access, m_alarms, m_audit, m_backup, m_builderFiles,
                          m_commissioning, m_display, m_controller, m_editor, m_explanations, m_handSpeed,
                          m_handTrims, m_handBags, m_orders, m_records, m_recipes, m_maintenance, m_scan,
                          m_bundle, m_rotation, m_settings, m_shiftReport, m_stops, m_systemClock,
                          m_systemNetwork, m_touchCalibration, m_trends, m_update, m_versions);
    panel::Units::setOnScreen();
    connect(&m_settings, &panel::Settings::languageChanged, this, &Panel::translate);
    translate();
}

Panel::~Panel()
{
    m_window.reset(); // before the objects that it shows
    m_qml.reset();
    for (QTranslator* translator : {&m_texts, &m_textsOfQt})
        QCoreApplication::removeTranslator(translator);
}

void Panel::open()
{
    m_controller.open();
    m_records.open();
    m_trends.open();
    m_access.open();
    m_trail.open();
    m_builderFiles.open(m_storage.builderFolder, m_storage.keyFolder, m_storage.complaints);
    m_update.open();
    m_versions.setSystem(store::imageVersion());
    m_versions.open();
    m_touchCalibration.resume();
    if (m_hasBroker)
        m_plant.open(plant::panelSocketPath());
}

bool Panel::load(QSize size)
{
    QEventLoop untilLoaded;
    connect(&m_qml->component, &QQmlComponent::statusChanged, &untilLoaded, &QEventLoop::quit);
    while (m_qml->component.isLoading())
        untilLoaded.exec();
    QVariantMap properties{{QStringLiteral("width"), size.width()},
                           {QStringLiteral("height"), size.height()}};
    if (!m_pageMemory.left().isEmpty())
        properties.insert(QStringLiteral("page"), m_pageMemory.left());
    m_window.reset(qobject_cast<QQuickWindow*>(m_qml->component.createWithInitialProperties(properties)));
    if (!m_window) {
        qCritical("%s", qPrintable(m_qml->component.errorString()));
        return false;
    }
    if (!m_pageMemory.left().isEmpty())
        qCInfo(uiLog, "the last run was not ended in order; it had page %s open",
               qPrintable(m_pageMemory.left()));
    m_pageMemory.follow(*m_window);
    return true;
}

QImage Panel::picture()
{
    return m_window->grabWindow().transformed(QTransform().rotate(-m_rotation.degrees()));
}

void Panel::translate()
{
    const QLocale locale(m_settings.language());
    for (QTranslator* translator : {&m_texts, &m_textsOfQt})
        QCoreApplication::removeTranslator(translator);
    if (panel::loadLanguage(m_texts, m_settings.installedLanguages(), m_settings.language()))
        QCoreApplication::installTranslator(&m_texts);
    if (m_textsOfQt.load(locale, QStringLiteral("qtbase"), QStringLiteral("_"),
                         QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&m_textsOfQt);
    QLocale::setDefault(locale);
    m_qml->engine.retranslate();
}

} // namespace campanel::shell
