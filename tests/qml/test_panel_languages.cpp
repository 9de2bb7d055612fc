// SPDX-License-Identifier: Apache-2.0
// The texts of all objects that QML sees, before and after a change of the language while the panel runs.
#include "panel_test.h"
#include "tests/support/test_program.h"

#include <QAbstractItemModel>
#include <QMetaProperty>
#include <QQmlEngine>
#include <QSet>
#include <QSignalSpy>

#include <map>
#include <memory>
#include <vector>

namespace test_panel_languages {

using namespace campanel;
using namespace Qt::StringLiterals;
using looks::DemoLink;

namespace {

struct Text {
    QString value;
    std::vector<QSignalSpy*> notices; // of the signals that report a change of the value
};

// All texts by the path of their property, as "Controller.packing.gateText", and of the rows of the lists.
class Texts {
public:
    explicit Texts(QQmlEngine& engine)
    {
        for (const QByteArray& name : engine.dynamicPropertyNames())
            if (auto* object = engine.property(name).value<QObject*>())
                add(*object, QString::fromLatin1(name).section(u':', -1));
    }

    [[nodiscard]] const std::map<QString, Text>& all() const { return m_texts; }
    [[nodiscard]] QString value(const QString& path) const
    {
        const auto found = m_texts.find(path);
        return found == m_texts.end() ? QString() : found->second.value;
    }

private:
    void add(QObject& object, const QString& path)
    {
        if (m_seen.contains(&object) ||
            !QByteArray(object.metaObject()->className()).startsWith("campanel::"))
            return;
        m_seen.insert(&object);
        object.setProperty("watched", true); // fills the lists that are read only then
        if (const auto* model = qobject_cast<const QAbstractItemModel*>(&object))
            addRows(*model, path);
        const QMetaObject& meta = *object.metaObject();
        for (int i = QObject::staticMetaObject.propertyCount(); i < meta.propertyCount(); ++i) {
            const QMetaProperty property = meta.property(i);
            const QString place = path + u'.' + QString::fromLatin1(property.name());
            const QVariant value = property.read(&object);
            if (auto* child = value.value<QObject*>())
                add(*child, place);
            else if (isText(value))
                m_texts[place] = {shown(value), property.hasNotifySignal()
                                                    ? std::vector{spy(object, property.notifySignal())}
                                                    : std::vector<QSignalSpy*>()};
        }
    }

    void addRows(const QAbstractItemModel& model, const QString& path)
    {
        const std::vector<QSignalSpy*> notices{
            spy(model, QMetaMethod::fromSignal(&QAbstractItemModel::dataChanged)),
            spy(model, QMetaMethod::fromSignal(&QAbstractItemModel::modelReset)),
            spy(model, QMetaMethod::fromSignal(&QAbstractItemModel::rowsInserted))};
        const QHash<int, QByteArray> roles = model.roleNames();
        for (int row = 0; row < model.rowCount(); ++row)
            for (const auto& [role, name] : roles.asKeyValueRange())
                if (const QVariant value = model.data(model.index(row, 0), role); isText(value))
                    m_texts[u"%1[%2].%3"_s.arg(path, QString::number(row), QString::fromLatin1(name))] = {
                        shown(value), notices};
    }

    [[nodiscard]] static bool isText(const QVariant& value)
    {
        const int type = value.typeId();
        return type == QMetaType::QString || type == QMetaType::QStringList ||
               type == QMetaType::QVariantList;
    }

    [[nodiscard]] static QString shown(const QVariant& value)
    {
        QString text = value.toString();
        if (value.typeId() != QMetaType::QString) // a list
            QDebug(&text).noquote() << value.toStringList() << value.toList();
        return text;
    }

    [[nodiscard]] QSignalSpy* spy(const QObject& object, const QMetaMethod& signal)
    {
        std::unique_ptr<QSignalSpy>& spy = m_spies[{&object, signal.methodIndex()}];
        if (!spy)
            spy = std::make_unique<QSignalSpy>(&object, signal);
        return spy.get();
    }

    QSet<const QObject*> m_seen;
    std::map<QString, Text> m_texts;
    std::map<std::pair<const QObject*, int>, std::unique_ptr<QSignalSpy>> m_spies;
};

bool isChinese(const QString& text)
{
    return std::ranges::any_of(text, [](QChar each) { return each.script() == QChar::Script_Han; });
}

} // namespace

class TestPanelLanguages : public test::PanelTest {
    Q_OBJECT

private slots:
    void everyTextFollowsTheLanguage_data()
    {
        QTest::addColumn<DemoLink::Situation>("situation");
        QTest::addColumn<DemoLink::Kind>("kind");
        QTest::newRow("a cutter that runs") << DemoLink::Situation::Running << DemoLink::Kind::RotaryCutter;
        QTest::newRow("every alarm") << DemoLink::Situation::ManyAlarms << DemoLink::Kind::RotaryCutter;
        QTest::newRow("a lost line") << DemoLink::Situation::Lost << DemoLink::Kind::RotaryCutter;
        QTest::newRow("a press that stands") << DemoLink::Situation::Stopped << DemoLink::Kind::Press;
    }

    void everyTextFollowsTheLanguage()
    {
        QFETCH(DemoLink::Situation, situation);
        QFETCH(DemoLink::Kind, kind);
        showSituation(situation, kind);
        Texts watched(engine()); // they watch from now on
        m_window->settle();
        const Texts before(engine());
        m_window->panel().settings().overrideValue("display.language", u"zh_CN"_s);
        const Texts after(engine());
        int changed = 0;
        for (const auto& [path, text] : before.all()) {
            const QString now = after.value(path);
            changed += now != text.value;
            QVERIFY2(
                now == text.value ||
                    std::ranges::any_of(text.notices, [](const QSignalSpy* spy) { return !spy->isEmpty(); }),
                qPrintable(u"%1 was not notified: %2, now %3"_s.arg(path, text.value, now)));
        }
        QVERIFY(changed > 300);

        m_window =
            std::make_unique<looks::TestWindow>(looks::Variant{u"zh_CN"_s, u"light"_s, QSize(1024, 600)});
        showSituation(situation, kind);
        Texts watchedAgain(engine());
        m_window->settle();
        const Texts fresh(engine());
        for (const auto& [path, text] : fresh.all()) {
            if (path == u"Alarms.urgent.detail")
                continue; // a record keeps the words of its time
            const QString now = after.value(path);
            const bool isOld = !now.isEmpty() && now == before.value(path) && isChinese(text.value);
            QVERIFY2(!isOld || now == text.value,
                     qPrintable(u"%1 stays %2 instead of %3"_s.arg(path, now, text.value)));
        }
    }

private:
    QQmlEngine& engine() { return *qmlEngine(m_window->frame()); }
    void showSituation(DemoLink::Situation situation, DemoLink::Kind kind)
    {
        m_window->link().show(situation, kind);
        m_window->settle();
    }
};

CAMPANEL_TEST(TestPanelLanguages)

} // namespace test_panel_languages

#include "test_panel_languages.moc"
