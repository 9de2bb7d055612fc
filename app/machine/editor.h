// SPDX-License-Identifier: Apache-2.0
// `Editor` in QML: the recipe being edited, its demands on the machine, and its download to the controller.
#pragma once

#include "app/machine/choice_model.h"
#include "app/machine/download_desk.h"
#include "app/machine/edit_history.h"
#include "app/machine/editor_field.h"
#include "app/machine/knot_files.h"
#include "app/machine/knot_model.h"
#include "app/machine/law_model.h"
#include "app/machine/solution.h"
#include "app/machine/table_model.h"
#include "app/store/last_recipe.h"

#include <QObject>
#include <QPointF>
#include <QStringList>
#include <QTimer>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

#include <array>
#include <functional>
#include <map>
#include <optional>

class QJSEngine;
class QQmlEngine;

namespace campanel::machine {

class Editor : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

    Q_PROPERTY(campanel::machine::EditorField* bagLength READ bagLength CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::EditorField* rate READ rate CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::EditorField* baseSpeed READ baseSpeed CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::EditorField* filmSpeed READ filmSpeed CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::EditorField* k1 READ k1 CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::EditorField* k2 READ k2 CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::EditorField* k3 READ k3 CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::EditorField* k4 READ k4 CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::EditorField* syncRatio READ syncRatio CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::EditorField* rampSlices READ rampSlices CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::EditorField* lawParameter1 READ lawParameter1 CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::EditorField* lawParameter2 READ lawParameter2 CONSTANT FINAL)

    // The kind of program, its relevant fields, and the machine data that it needs.
    Q_PROPERTY(Kind kind READ kind NOTIFY kindChanged FINAL)
    Q_PROPERTY(QStringList kindNames READ kindNames NOTIFY kindChanged FINAL)
    Q_PROPERTY(QVariantList fields READ fields NOTIFY fieldsChanged FINAL)
    Q_PROPERTY(QVariantList machineFields READ machineFields NOTIFY fieldsChanged FINAL)
    Q_PROPERTY(campanel::machine::ChoiceModel* choices READ choices CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::KnotModel* knots READ knots CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::KnotFiles* knotFiles READ knotFiles CONSTANT FINAL)
    Q_PROPERTY(bool hasLaw READ hasLaw NOTIFY kindChanged FINAL)
    Q_PROPERTY(QString lawTitle READ lawTitle NOTIFY kindChanged FINAL)

    Q_PROPERTY(campanel::machine::LawModel* laws READ laws CONSTANT FINAL)
    Q_PROPERTY(QString lawName READ lawName NOTIFY solutionChanged FINAL)

    Q_PROPERTY(bool solvable READ solvable NOTIFY solutionChanged FINAL)
    Q_PROPERTY(bool feasible READ feasible NOTIFY solutionChanged FINAL)
    Q_PROPERTY(QString verdict READ verdict NOTIFY solutionChanged FINAL)
    Q_PROPERTY(Severity severity READ severity NOTIFY solutionChanged FINAL)
    Q_PROPERTY(bool hasSuggestion READ hasSuggestion NOTIFY solutionChanged FINAL)
    Q_PROPERTY(QString suggestionText READ suggestionText NOTIFY solutionChanged FINAL)

    Q_PROPERTY(QVariant curves READ curves NOTIFY solutionChanged FINAL)
    // The gray curves in the background: another law for the same move, or else the controller's program.
    Q_PROPERTY(QVariant overlayCurves READ overlayCurves NOTIFY overlayChanged FINAL)
    Q_PROPERTY(QString overlayName READ overlayName NOTIFY overlayChanged FINAL)
    Q_PROPERTY(double cycleSeconds READ cycleSeconds NOTIFY solutionChanged FINAL)
    Q_PROPERTY(QList<double> ratioTimes READ ratioTimes NOTIFY solutionChanged FINAL)
    Q_PROPERTY(QList<double> markTimes READ markTimes NOTIFY solutionChanged FINAL)
    Q_PROPERTY(double limitVelocity READ limitVelocity NOTIFY solutionChanged FINAL)
    Q_PROPERTY(double limitAcceleration READ limitAcceleration NOTIFY solutionChanged FINAL)
    Q_PROPERTY(double limitFrequency READ limitFrequency NOTIFY solutionChanged FINAL)
    Q_PROPERTY(QList<QPointF> violations READ violations NOTIFY solutionChanged FINAL)
    Q_PROPERTY(QString peakText READ peakText NOTIFY solutionChanged FINAL)

    Q_PROPERTY(campanel::machine::TableModel* table READ table CONSTANT FINAL)
    Q_PROPERTY(QStringList tableSummary READ tableSummary NOTIFY tableChanged FINAL)

    Q_PROPERTY(bool canUndo READ canUndo NOTIFY historyChanged FINAL)
    Q_PROPERTY(bool canRedo READ canRedo NOTIFY historyChanged FINAL)
    Q_PROPERTY(QString recipeName READ recipeName WRITE setRecipeName NOTIFY recipeChanged FINAL)
    Q_PROPERTY(int recipeVersion READ recipeVersion NOTIFY recipeChanged FINAL)
    Q_PROPERTY(bool edited READ edited NOTIFY recipeChanged FINAL)
    Q_PROPERTY(QString notice READ notice NOTIFY noticeChanged FINAL)

    Q_PROPERTY(DownloadState downloadState READ downloadState NOTIFY downloadChanged FINAL)
    Q_PROPERTY(double downloadProgress READ downloadProgress NOTIFY downloadChanged FINAL)
    Q_PROPERTY(QString downloadText READ downloadText NOTIFY downloadChanged FINAL)
    Q_PROPERTY(bool canDownload READ canDownload NOTIFY downloadChanged FINAL)
    Q_PROPERTY(campanel::machine::DifferenceModel* differences READ differences CONSTANT FINAL)
    Q_PROPERTY(int differenceCount READ differenceCount NOTIFY activeChanged FINAL)
    Q_PROPERTY(QString controllerText READ controllerText NOTIFY activeChanged FINAL)
    Q_PROPERTY(campanel::machine::ProgramProof* proof READ proof CONSTANT FINAL)
    Q_PROPERTY(bool saved READ saved NOTIFY activeChanged FINAL)
    Q_PROPERTY(bool canSave READ canSave NOTIFY activeChanged FINAL)

public:
    enum class Kind { RotaryCutter = 1, PositionMove, SpeedMove, PointCam, Press };
    Q_ENUM(Kind)
    enum class Severity { Good, Warning, Bad };
    Q_ENUM(Severity)
    enum class DownloadState { NothingToDo, Ready, Blocked, Transferring, Sealing, Armed, Applied, Failed };
    Q_ENUM(DownloadState)

    // Stores both recipes in `folder`. The machine must outlive the object.
    Editor(Machine& machine, const QString& folder, QObject* parent);
    ~Editor() override;

    static Editor* create(QQmlEngine* qmlEngine, QJSEngine* jsEngine);

    [[nodiscard]] EditorField* bagLength() { return item(profile::Field::BagLength); }
    [[nodiscard]] EditorField* rate() { return item(profile::Field::Rate); }
    [[nodiscard]] EditorField* baseSpeed() { return item(profile::Field::BaseSpeed); }
    [[nodiscard]] EditorField* filmSpeed() { return item(profile::Field::FilmSpeed); }
    [[nodiscard]] EditorField* k1() { return item(profile::Field::K1); }
    [[nodiscard]] EditorField* k2() { return item(profile::Field::K2); }
    [[nodiscard]] EditorField* k3() { return item(profile::Field::K3); }
    [[nodiscard]] EditorField* k4() { return item(profile::Field::K4); }
    [[nodiscard]] EditorField* syncRatio() { return item(profile::Field::SyncRatio); }
    [[nodiscard]] EditorField* rampSlices() { return item(profile::Field::SlicesPerRamp); }
    [[nodiscard]] EditorField* lawParameter1() { return &m_lawParameter1; }
    [[nodiscard]] EditorField* lawParameter2() { return &m_lawParameter2; }

    [[nodiscard]] EditorField* item(profile::Field field)
    {
        return m_fields[static_cast<std::size_t>(field)];
    }
    [[nodiscard]] Kind kind() const { return static_cast<Kind>(m_recipe.kind()); }
    [[nodiscard]] QStringList kindNames() const;
    [[nodiscard]] QVariantList fields() const; // list of EditorField*
    [[nodiscard]] QVariantList machineFields() const;
    [[nodiscard]] ChoiceModel* choices() { return &m_choices; }
    [[nodiscard]] KnotModel* knots() { return &m_knots; }
    [[nodiscard]] KnotFiles* knotFiles() { return &m_knotFiles; }
    [[nodiscard]] bool hasLaw() const { return program::lawParameters(m_recipe.program) != nullptr; }
    [[nodiscard]] QString lawTitle() const;
    [[nodiscard]] LawModel* laws() { return &m_laws; }
    [[nodiscard]] QString lawName() const;
    [[nodiscard]] bool solvable() const { return m_solution.solved.has_value(); }
    [[nodiscard]] bool feasible() const { return m_solution.isFeasible(); }
    [[nodiscard]] QString verdict() const;
    [[nodiscard]] Severity severity() const;
    [[nodiscard]] bool hasSuggestion() const { return suggestion() != nullptr; }
    [[nodiscard]] QString suggestionText() const;
    [[nodiscard]] QVariant curves() const;
    [[nodiscard]] QVariant overlayCurves() const;
    [[nodiscard]] QString overlayName() const;
    [[nodiscard]] double cycleSeconds() const { return m_cycleSeconds; }
    [[nodiscard]] QList<double> ratioTimes() const; // only for a rotary cutter, else empty
    [[nodiscard]] QList<double> markTimes() const;
    [[nodiscard]] double limitVelocity() const;
    [[nodiscard]] double limitAcceleration() const;
    [[nodiscard]] double limitFrequency() const;
    [[nodiscard]] QList<QPointF> violations() const;
    [[nodiscard]] QString peakText() const;
    [[nodiscard]] TableModel* table() { return &m_table; }
    [[nodiscard]] QStringList tableSummary() const;
    [[nodiscard]] bool canUndo() const { return m_history.canUndo(); }
    [[nodiscard]] bool canRedo() const { return m_history.canRedo(); }
    [[nodiscard]] QString recipeName() const { return QString::fromStdString(m_recipe.name); }
    void setRecipeName(const QString& name);
    [[nodiscard]] int recipeVersion() const;
    [[nodiscard]] bool edited() const;
    [[nodiscard]] QString notice() const { return m_notice; }
    [[nodiscard]] DownloadState downloadState() const { return static_cast<DownloadState>(m_desk.state()); }
    [[nodiscard]] double downloadProgress() const { return m_desk.progress(); }
    [[nodiscard]] QString downloadText() const { return m_desk.text(); }
    [[nodiscard]] bool canDownload() const { return m_desk.canDownload(); }
    [[nodiscard]] DifferenceModel* differences() { return &m_desk.differences(); }
    [[nodiscard]] int differenceCount() { return m_desk.differences().count(); }
    [[nodiscard]] QString controllerText() const { return m_desk.controllerText(); }
    [[nodiscard]] ProgramProof* proof() { return &m_desk.proof(); }
    [[nodiscard]] bool saved() const { return m_desk.isSaved(); }
    [[nodiscard]] bool canSave() const { return m_desk.canSave(); }

    // Creates a recipe of this kind with the defaults of its paper. Can be undone.
    Q_INVOKABLE void newProgram(int kind);
    Q_INVOKABLE void setChoice(int row, int option);
    Q_INVOKABLE void setLaw(const QString& lawId);
    // Displays the curves of the same motion with another law in the background; an empty id ends it.
    Q_INVOKABLE void compareLaw(const QString& lawId);
    Q_INVOKABLE void applySuggestion();
    // Moves the end of segment `index` (0..3: ta, tb, tc, td) during a drag; commitDrag() ends it as one undo
    // step.
    Q_INVOKABLE void dragRatio(int index, double timeSeconds);
    Q_INVOKABLE void commitDrag();
    Q_INVOKABLE void undo();
    Q_INVOKABLE void redo();
    Q_INVOKABLE void revert();
    Q_INVOKABLE void download();
    Q_INVOKABLE void cancelDownload();
    Q_INVOKABLE void saveToFlash();
    Q_INVOKABLE void dismissNotice();

    // Returns the results computed from the present recipe.
    [[nodiscard]] const Solution& solution() const { return m_solution; }
    [[nodiscard]] const program::Recipe& recipe() const { return m_recipe; }
    // Returns the reference of edited(): the version last opened, downloaded or saved.
    [[nodiscard]] const program::Recipe& storedRecipe() const { return m_stored; }

    // Opens another recipe, unchanged or with the edits in `edited`. Clears the previous recipe and the undo
    // history.
    void open(const program::Recipe& stored, const std::optional<program::Recipe>& edited = {});
    // Sets the saved recipe as the new reference of edited(); the edits stay.
    void takeStored(const program::Recipe& recipe);
    // Returns the newest stored version of a name, 0: none. An edited recipe has the next version.
    using NewestVersion = std::function<int(const std::string& name)>;
    void setNewestVersion(NewestVersion newest);
    void setMachine(profile::ProgramKind kind, const profile::Machine& machine)
    {
        m_machines[kind] = machine;
    }
    [[nodiscard]] program::Recipe newRecipe(profile::ProgramKind kind) const;

signals:
    // Emitted when the controller executes the recipe.
    void applied(const campanel::program::Recipe& recipe);
    void kindChanged();
    void fieldsChanged();
    void overlayChanged();
    void solutionChanged();
    void activeChanged();
    void tableChanged();
    void historyChanged();
    void recipeChanged();
    void downloadChanged();
    void noticeChanged();
    // Emitted for the audit trail, see DownloadDesk.
    void downloadBegun(const campanel::program::ProgramImage& image);
    void downloadEnded(const campanel::link::DownloadReport& report);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void connectFields();
    void connectKnots();
    void compareCurves();
    void showFields();
    // Returns true when the person has the level. Otherwise requests a login, and nothing changes.
    [[nodiscard]] bool admits(Level needed) const;
    template <typename Change> void edit(Level needed, Change change);
    void replace(program::Recipe recipe); // undo, redo, revert
    void recompute();
    void takeSolution(Solution solution);
    void show();
    void watchController();
    void keepWorkingCopy();
    void showNotice(const QString& text);
    [[nodiscard]] const profile::Suggestion* suggestion() const;
    [[nodiscard]] const profile::Machine& limits() const;
    [[nodiscard]] int nextVersion() const;

    EditorField m_lawParameter1{QStringLiteral("lawParameter1"), this};
    EditorField m_lawParameter2{QStringLiteral("lawParameter2"), this};
    std::array<EditorField*, profile::fields.size()> m_fields{}; // children, by field
    KnotModel m_knots;
    KnotFiles m_knotFiles;
    ChoiceModel m_choices;
    LawModel m_laws;
    TableModel m_table;

    Machine& m_machine;
    DownloadDesk m_desk;
    store::LastRecipe m_storedFile;
    store::LastRecipe m_workingFile;
    QTimer m_keepTimer;
    QTimer m_tableTimer; // builds a slow table once the finger rests
    program::Recipe m_stored;
    program::Recipe m_recipe;
    NewestVersion m_newestVersion = [](const std::string&) { return 0; };
    std::map<profile::ProgramKind, profile::Machine> m_machines;
    std::optional<program::Recipe> m_beforeDrag;
    EditHistory<program::Recipe> m_history;
    std::optional<modbus::Identity> m_controller; // controller that the solution was computed for
    Solution m_solution;
    program::Recipe m_solvedFor;
    std::optional<profile::LawId> m_comparedLaw;
    std::shared_ptr<const profile::Curves> m_comparedCurves;
    QList<profile::Field> m_shownFields; // last fields reported by fieldsChanged()
    double m_cycleSeconds = 1;           // the last known one, so that the handles keep their places
    QString m_notice;
};

} // namespace campanel::machine
