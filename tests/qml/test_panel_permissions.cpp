// SPDX-License-Identifier: Apache-2.0
// Everything that QML can call, with nobody logged in and the level View only: each function and each
// property that can be written asks the access check, or is on a list that says why it may not need to. A new
// one that does neither fails here.
#include "panel_test.h"
#include "profile/laws/laws.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QAbstractItemModel>
#include <QDirIterator>
#include <QMetaMethod>
#include <QSet>
#include <QSignalSpy>

#include <array>

namespace test_panel_permissions {

using namespace campanel;
using namespace Qt::StringLiterals;

namespace {

struct Harmless {
    const char* why;
    QStringList names; // Class::function, Class::property=
};

const QList<Harmless>& harmless()
{
    static const QList<Harmless> all{
        {"Stop asks nobody",
         {u"Controller::stop"_s, u"Jog::touch"_s, u"Jog::release"_s, u"Jog::letGo"_s, u"OutputTry::touch"_s,
          u"OutputTry::release"_s, u"OutputTry::letGo"_s}},
        {"logging in and out; ask() asks",
         {u"Access::login"_s, u"Access::logOut"_s, u"Access::clearMessage"_s, u"Access::chosen="_s,
          u"Access::ask"_s}},
        {"answers a question and changes nothing",
         {u"Access::refusalText"_s,      u"Access::permissionText"_s,
          u"Telemetry::text"_s,          u"Access::pinRefusal"_s,
          u"Access::minPinDigits"_s,     u"Access::nameRefusal"_s,
          u"Access::freeName"_s,         u"Editor::field"_s,
          u"Explanations::of"_s,         u"Explanations::ofVerdict"_s,
          u"Explanations::ofTrend"_s,    u"Explanations::ofTrendCursor"_s,
          u"OrderEntry::lotProblem"_s,   u"OrderEntry::textProblem"_s,
          u"ReasonEditor::problemOf"_s,  u"Recipes::choicesOf"_s,
          u"Scan::prefixProblem"_s,      u"SettingField::problem"_s,
          u"Settings::setting"_s,        u"Controller::parameterField"_s,
          u"SoftwareUpdate::actionOf"_s, u"SystemClock::zonesOf"_s,
          u"SystemNetwork::label"_s,     u"SystemNetwork::hint"_s,
          u"SystemNetwork::refusalOf"_s, u"Value::check"_s,
          u"WindowReason::problem"_s}},
        {"a sentence that was read",
         {u"BuilderFiles::dismissNotice"_s, u"Controller::dismissMessage"_s,
          u"DatabaseService::dismissNotice"_s, u"Editor::dismissNotice"_s, u"Orders::dismissNotice"_s,
          u"Orders::clearMessage"_s, u"Recipes::dismissMessage"_s, u"Scan::dismissNotice"_s,
          u"Settings::dismissNotice"_s, u"SoftwareUpdate::dismissNotice"_s,
          u"TouchCalibration::dismissNotice"_s, u"Stops::postpone"_s, u"Stops::dismissAnswer"_s}},
        {"what is looked at, and a filter of it",
         {u"Watched::watched="_s,
          u"Watched::setWatchedBy"_s,
          u"Alarms::showLive"_s,
          u"Alarms::showUrgent"_s,
          u"Alarms::showHistory"_s,
          u"Audit::open"_s,
          u"Audit::select"_s,
          u"Audit::check"_s,
          u"Audit::who="_s,
          u"Audit::area="_s,
          u"ParameterField::read"_s,
          u"CamHandles::selected="_s,
          u"CamSwitches::choose"_s,
          u"DryRun::grab"_s,
          u"DryRun::drag"_s,
          u"DryRun::turn"_s,
          u"DryRun::toStart"_s,
          u"DryRun::playing="_s,
          u"Editor::watchLaws"_s,
          u"Editor::compareLaw"_s,
          u"FileExchange::scan"_s,
          u"FileExchange::refresh"_s,
          u"FrameList::watched="_s,
          u"FrameList::paused="_s,
          u"MarkEdgeList::paused="_s,
          u"FrameList::filter="_s,
          u"FrameList::clear"_s,
          u"FrameList::showDetail"_s,
          u"FrameList::showPrevious"_s,
          u"FrameList::showNext"_s,
          u"LogFilterEditor::id="_s,
          u"LogFilterEditor::word="_s,
          u"LogFilterEditor::move"_s,
          u"LogFilterEditor::removeLimit"_s,
          u"LogFilterEditor::showDay"_s,
          u"LogFilterEditor::clear"_s,
          u"Homing::open"_s,
          u"AxisMeasurement::open"_s,
          u"AxisMeasurement::begin"_s,
          u"AxisMeasurement::beginMainMotor"_s,
          u"PackingSetup::open"_s,
          u"ParameterFields::select"_s,
          u"ProgramProof::compare"_s,
          u"ProgramProof::cancel"_s,
          u"ReasonEditor::openGroup"_s,
          u"ReasonEditor::closeGroup"_s,
          u"ReasonKeys::close"_s,
          u"Recipes::search="_s,
          u"Recipes::choose"_s,
          u"Recipes::chooseNamed"_s,
          u"Recipes::listVersions"_s,
          u"Recipes::listOthers"_s,
          u"Recipes::compareVersion"_s,
          u"Recipes::compareOther"_s,
          u"RegisterInspector::group="_s,
          u"RegisterInspector::nameFilter="_s,
          u"RegisterInspector::setVisibleRows"_s,
          u"RegisterInspector::select"_s,
          u"ScreenRotation::screen="_s,
          u"TouchCalibration::cross="_s,
          u"Settings::refreshPorts"_s,
          u"ParameterFields::readIfUncertain"_s,
          u"MasterSetting::explainRate"_s,
          u"ShiftView::showPrevious"_s,
          u"ShiftView::showNext"_s,
          u"ShiftView::showPresent"_s,
          u"ShiftView::showOrder"_s,
          u"ShiftView::select"_s,
          u"SoftwareUpdate::watched="_s,
          u"Trends::toggle"_s,
          u"Trends::showSpan"_s,
          u"Trends::zoom"_s,
          u"Trends::showWindow"_s,
          u"Trends::showNow"_s}},
        {"cleaning the screen", {u"Display::wipe"_s}},
        {"gathers what may be written; ReportFiles::write asks",
         {u"Commissioning::offer"_s, u"CsvExport::make"_s, u"FrameList::exportText"_s,
          u"LineFigures::exportCsv"_s, u"Recipes::offerExport"_s, u"ServiceBundle::make"_s,
          u"ShiftReport::offer"_s}},
        {"a draft; what applies it asks", {u"MarkWizard::restart"_s,
                                           u"MarkWizard::dropMeasurement"_s,
                                           u"MarkWizard::measureSimulatedBag"_s,
                                           u"AxisMeasurement::measureSimulatedBag"_s,
                                           u"Value::set of MarkWizard"_s,
                                           u"RecipeCodes::enter"_s,
                                           u"Value::set of OrderEntry"_s,
                                           u"OrderEntry::begin"_s,
                                           u"OrderEntry::text="_s,
                                           u"OrderEntry::lot="_s,
                                           u"OrderEntry::recipe="_s,
                                           u"OrderEntry::checkedBy="_s,
                                           u"OrderEntry::action="_s,
                                           u"RecipeCodes::wanted="_s,
                                           u"RecipeWindows::begin"_s,
                                           u"RecipeWindow::clear"_s,
                                           u"Value::set of RecipeWindow"_s,
                                           u"Recipes::wantedName="_s,
                                           u"SystemNetwork::port="_s,
                                           u"SystemNetwork::fixed="_s,
                                           u"SystemNetwork::enter"_s,
                                           u"SystemNetwork::discard"_s}},
        {"ends or undoes what was begun with permission",
         {u"CamHandles::beginDrag"_s, u"CamHandles::endDrag"_s, u"CutterMap::endDrag"_s,
          u"Editor::commitDrag"_s, u"Editor::beginTrial"_s, u"Editor::endTrial"_s, u"RampControl::endDrag"_s,
          u"ScreenRotation::keep"_s, u"ScreenRotation::goBack"_s, u"TouchCalibration::touch"_s,
          u"TouchCalibration::cancel"_s, u"TouchCalibration::keep"_s, u"TouchCalibration::goBack"_s}},
        {"has nothing to do here; Editor::edit(), Settings::set() or SystemService::begin() asks when it has",
         {u"CutterMap::drag"_s, u"KnotModel::removeSelected"_s, u"RampControl::begin"_s,
          u"RampControl::takeOffer"_s, u"ReasonEditor::add"_s, u"SegmentModel::removeSelected"_s,
          u"StopSetup::removeStart"_s, u"SystemNetwork::apply"_s}},
        {"a sheet takes the codes; nothing is opened",
         {u"Scan::beginEntry"_s, u"Scan::endEntry"_s, u"Scan::typing="_s}},
        {"goes through Value::set", {u"Value::step"_s}},
        {"the first start, before there are users", {u"Settings::endFirstStart"_s}},
        {"a group opens; a reason goes to Stops::answer(), which asks", {u"ReasonKeys::touch"_s}},
    };
    return all;
}

QSet<QString> harmlessNames()
{
    QSet<QString> names;
    for (const Harmless& each : harmless())
        names += QSet<QString>(each.names.begin(), each.names.end());
    return names;
}

QString shortName(const QMetaObject* type)
{
    return QString::fromLatin1(type->className()).section(u"::"_s, -1);
}

// Finds the objects of the panel that QML reaches from the singletons.
class Reached {
public:
    void visit(QObject* object)
    {
        if (!object || m_seen.contains(object) ||
            !QByteArray(object->metaObject()->className()).startsWith("campanel::panel::"))
            return;
        m_seen.insert(object);
        m_objects << object;
        const QMetaObject* type = object->metaObject();
        for (int i = 0; i < type->propertyCount(); ++i)
            visit(type->property(i).read(object));
        const auto* model = qobject_cast<QAbstractItemModel*>(object);
        for (int row = 0; model && row < std::min(model->rowCount(), 3); ++row) {
            for (const int role : model->roleNames().keys())
                visit(model->data(model->index(row, 0), role));
        }
    }
    void visit(const QVariant& value)
    {
        const QMetaType type = value.metaType();
        if (type.flags().testFlag(QMetaType::PointerToQObject)) {
            visit(value.value<QObject*>());
        } else if (type.flags().testFlag(QMetaType::IsGadget)) {
            for (int i = 0; type.metaObject() && i < type.metaObject()->propertyCount(); ++i)
                visit(type.metaObject()->property(i).readOnGadget(value.constData()));
        } else if (type.id() == QMetaType::QVariantList) {
            for (const QVariant& each : value.toList())
                visit(each);
        }
    }
    [[nodiscard]] const QObjectList& objects() const { return m_objects; }

private:
    QSet<QObject*> m_seen;
    QObjectList m_objects;
};

// Returns values of a type that some function takes as valid.
QVariantList candidates(const QMetaType& type, QObject* object, QObject* files)
{
    QVariantList values;
    if (type.flags().testFlag(QMetaType::PointerToQObject))
        return {QVariant::fromValue(files)};
    if (type.id() == QMetaType::Int || type.flags().testFlag(QMetaType::IsEnumeration))
        values = {1, 0, 2, 19200, 7, -1};
    else if (type.id() == QMetaType::Double)
        values = {object->property("minimum"), object->property("defaultValue"), 1.0, 0.5, 100.0};
    else if (type.id() == QMetaType::Bool)
        values = {true, false};
    else if (type.id() == QMetaType::QString)
        values = {u"x"_s,
                  u"de"_s,
                  u"dark"_s,
                  u"light"_s,
                  u"E"_s,
                  u"N"_s,
                  u"on"_s,
                  u"off"_s,
                  u"##"_s,
                  u"/dev/ttyUSB7"_s,
                  u"Europe/Berlin"_s,
                  QString::fromStdString(std::string(profile::laws()[1].key)),
                  QString::fromStdString(std::string(profile::laws()[2].key))};
    else
        values = {QVariant(type)};
    QVariantList usable;
    for (QVariant& value : values) {
        if (type.flags().testFlag(QMetaType::IsEnumeration)) {
            const int number = value.toInt();
            value = QVariant(type, &number);
        }
        if (value.isValid() && value.convert(type))
            usable << value;
    }
    return usable;
}

} // namespace

class TestPanelPermissions : public test::PanelTest {
    Q_OBJECT

    QSet<QString> m_refused;
    QSet<QString> m_done; // called without being refused
    QSet<QString> m_classes;

    panel::AccessCheck& check() { return m_window->panel().controller().accessCheck(); }

    // Calls with the values until it is refused.
    void call(const QString& name, QObject* object, const QMetaMethod& method)
    {
        QList<QVariantList> argumentLists{{}};
        for (int i = 0; i < method.parameterCount(); ++i) {
            QList<QVariantList> longer;
            for (const QVariant& value :
                 candidates(method.parameterMetaType(i), object, m_window->panel().maintenance().files())) {
                for (const QVariantList& each : argumentLists)
                    longer << each + QVariantList{value};
            }
            argumentLists = longer.first(std::min<qsizetype>(longer.size(), 60));
        }
        const QSignalSpy refused(&check(), &panel::AccessCheck::refused);
        for (QVariantList& list : argumentLists) {
            std::array<QGenericArgument, 10> arguments;
            for (int i = 0; i < list.size(); ++i)
                arguments[static_cast<std::size_t>(i)] =
                    QGenericArgument(list[i].typeName(), list[i].constData());
            QVariant answer(method.returnMetaType());
            const QGenericReturnArgument returned =
                method.returnMetaType().id() == QMetaType::Void
                    ? QGenericReturnArgument()
                    : QGenericReturnArgument(method.typeName(), answer.data());
            check().setLevel(panel::Level::Viewer);
            QVERIFY2(method.invoke(object, Qt::DirectConnection, returned, arguments[0], arguments[1],
                                   arguments[2], arguments[3], arguments[4]),
                     qPrintable(name));
            if (!refused.isEmpty())
                break;
        }
        (refused.isEmpty() ? m_done : m_refused) << name;
    }

    void write(const QString& name, QObject* object, const QMetaProperty& property)
    {
        const QSignalSpy refused(&check(), &panel::AccessCheck::refused);
        for (const QVariant& value : candidates(property.metaType(), object, nullptr)) {
            check().setLevel(panel::Level::Viewer);
            property.write(object, value);
            if (!refused.isEmpty())
                break;
        }
        (refused.isEmpty() ? m_done : m_refused) << name;
    }

    void tryEverything()
    {
        static const QSet<QString> known = harmlessNames();
        panel::Recipes& recipes = m_window->panel().recipes();
        QVERIFY(QTest::qWaitFor([&recipes] {
            recipes.choose(0);
            recipes.windows()->begin(); // the rows of a draft
            return !recipes.windows()->rows().isEmpty();
        }));
        Reached reached;
        auto& engine = m_window->panel().engine();
        for (const QByteArray& key : engine.dynamicPropertyNames())
            reached.visit(engine.property(key));
        for (const panel::SettingRow& row : panel::settingTable)
            reached.visit(m_window->panel().settings().setting(QString::fromLatin1(row.name)));
        for (const panel::ParameterRow& row : panel::parameterTable)
            reached.visit(m_window->panel().controller().parameterField(QString::fromLatin1(row.name)));
        for (QObject* object : reached.objects()) {
            // Its numbers are properties that keep their value, see test_packing_line.
            const bool isTelemetry = qobject_cast<panel::Telemetry*>(object) != nullptr;
            for (const QMetaObject* type = object->metaObject(); type != &QObject::staticMetaObject;
                 type = type->superClass()) {
                m_classes << shortName(type);
                if (!QByteArray(type->className()).startsWith("campanel::"))
                    continue; // Qt's models
                for (int i = type->methodOffset(); i < type->methodCount(); ++i) {
                    const QMetaMethod method = type->method(i);
                    QString name = shortName(type) + u"::"_s + QString::fromLatin1(method.name());
                    if (name == u"Value::set" && object->parent())
                        name += u" of "_s + shortName(object->parent()->metaObject());
                    if (method.methodType() != QMetaMethod::Signal && !known.contains(name))
                        call(name, object, method);
                }
                for (int i = type->propertyOffset(); i < type->propertyCount(); ++i) {
                    const QMetaProperty property = type->property(i);
                    const QString name =
                        shortName(type) + u"::"_s + QString::fromLatin1(property.name()) + u'=';
                    if (property.isWritable() && !isTelemetry && !known.contains(name))
                        write(name, object, property);
                }
            }
        }
    }

private slots:
    void everyCallAsksOrIsHarmless()
    {
        auto& editor = m_window->panel().editor();
        m_window->panel().settings().guardBy(check());
        for (int kind = 1; kind <= static_cast<int>(program::kinds().size()); ++kind) {
            check().setLevel(panel::Level::Service);
            editor.newProgram(kind);
            if (editor.handles())
                editor.handles()->beginDrag(1);
            tryEverything();
        }
        const QSet<QString> silent = m_done - m_refused;
        QStringList names(silent.begin(), silent.end());
        names.sort();
        QVERIFY2(names.isEmpty(), qPrintable(u"ask the access check first, or explain why not:\n  "_s +
                                             names.join(u"\n  "_s)));
        QVERIFY(m_refused.size() > 60);
        QVERIFY(m_refused.contains(u"Alarms::acknowledge"_s));
    }

    // How this screen looks: everybody reads it in his language, by his light.
    void everybodySetsOnlyTheScreen()
    {
        QStringList names;
        for (const panel::SettingRow& row : panel::settingTable) {
            if (!row.key.empty() && row.level == panel::Level::Viewer)
                names << QString::fromLatin1(row.name);
        }
        QCOMPARE(names, QStringList({u"display.language"_s, u"display.units"_s, u"display.theme"_s,
                                     u"display.gloves"_s, u"display.brightness"_s,
                                     u"display.dark_after_minutes"_s, u"recipes.order"_s}));
    }

    // Each class of the panel with functions or properties for QML was among them.
    void everyClassIsReached()
    {
        tryEverything();
        static const QRegularExpression classes(uR"(^class (\w+)[^;\x7b]*\x7b(.*?)^\x7d;)"_s,
                                                QRegularExpression::MultilineOption |
                                                    QRegularExpression::DotMatchesEverythingOption);
        static const QRegularExpression forQml(uR"(Q_INVOKABLE|Q_PROPERTY\([^)]* WRITE )"_s);
        QStringList missing;
        int found = 0;
        QDirIterator it(test::sourcePath("app/panel"), {u"*.h"_s}, QDir::Files, QDirIterator::Subdirectories);
        while (it.hasNext()) {
            QFile file(it.next());
            QVERIFY(file.open(QIODevice::ReadOnly));
            for (const auto& match : classes.globalMatch(QString::fromUtf8(file.readAll()))) {
                if (!match.captured(2).contains(forQml))
                    continue;
                ++found;
                if (!m_classes.contains(match.captured(1)))
                    missing << match.captured(1);
            }
        }
        QVERIFY(found > 50);
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join(u", "_s)));
    }

    void noExplanationIsOfSomethingElse()
    {
        QSet<QString> names;
        for (const Harmless& each : harmless()) {
            for (const QString& name : each.names) {
                QVERIFY2(!names.contains(name), qPrintable(name));
                names << name;
            }
        }
        QVERIFY(!names.contains(u"Alarms::acknowledge"_s));
    }
};

CAMPANEL_TEST(TestPanelPermissions)

} // namespace test_panel_permissions

#include "test_panel_permissions.moc"
