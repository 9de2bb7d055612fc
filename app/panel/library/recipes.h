// SPDX-License-Identifier: Apache-2.0
// `Recipes` in QML: the recipes of this panel with all their versions. One is chosen in the list; the edited
// one belongs to the Editor. All database access runs in the database's thread.
#pragma once

#include "app/panel/kit/difference_model.h"
#include "app/panel/kit/figure_model.h"
#include "app/panel/kit/offer_model.h"
#include "app/panel/kit/report_files.h"
#include "app/panel/kit/singleton.h"
#include "app/panel/library/recipe_codes.h"
#include "app/panel/library/recipe_files.h"
#include "app/panel/library/recipe_list.h"
#include "app/panel/library/recipe_windows.h"
#include "app/panel/records/database_service.h"
#include "app/store/logs/audit_log.h"
#include "app/store/recipes/recipe_library.h"

#include <QDateTime>
#include <QHash>
#include <QObject>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

#include <chrono>
#include <functional>
#include <optional>

namespace campanel::panel {

class Editor;
class Controller;

class Recipes : public QObject, public Singleton<Recipes> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

    // The recipes that match the search, in their order.
    Q_PROPERTY(campanel::panel::RowModelBase* list READ list CONSTANT FINAL)
    Q_PROPERTY(QString search READ search WRITE setSearch NOTIFY listChanged FINAL)
    Q_PROPERTY(int total READ total NOTIFY listChanged FINAL)  // without the search
    Q_PROPERTY(bool ready READ ready NOTIFY listChanged FINAL) // the database has been read

    // The chosen recipe: its row in the list, -1: none, and its details.
    Q_PROPERTY(int chosen READ chosen NOTIFY listChanged FINAL)
    Q_PROPERTY(QString chosenName READ chosenName NOTIFY listChanged FINAL)
    Q_PROPERTY(QString chosenNote READ chosenNote NOTIFY listChanged FINAL)
    Q_PROPERTY(bool chosenIsOpen READ chosenIsOpen NOTIFY listChanged FINAL)
    Q_PROPERTY(bool chosenIsActive READ chosenIsActive NOTIFY listChanged FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* figures READ figures CONSTANT FINAL)

    // The name being entered, and the reason why it is not available; empty when it is.
    Q_PROPERTY(QString wantedName READ wantedName WRITE setWantedName NOTIFY wantedNameChanged FINAL)
    Q_PROPERTY(QString nameProblem READ nameProblem NOTIFY wantedNameChanged FINAL)

    // The versions or other recipes to compare the chosen one with, and the differences.
    Q_PROPERTY(campanel::panel::RowModelBase* candidates READ candidates CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* differences READ differences CONSTANT FINAL)
    Q_PROPERTY(QString beforeTitle READ beforeTitle NOTIFY comparisonChanged FINAL)
    Q_PROPERTY(QString afterTitle READ afterTitle NOTIFY comparisonChanged FINAL)
    Q_PROPERTY(bool compared READ compared NOTIFY comparisonChanged FINAL)

    Q_PROPERTY(int nextVersion READ nextVersion NOTIFY listChanged FINAL) // next version of the edited recipe
    Q_PROPERTY(QString message READ message NOTIFY messageChanged FINAL)  // result of the last action
    Q_PROPERTY(bool canRestore READ canRestore NOTIFY messageChanged FINAL) // the last deletion
    Q_PROPERTY(campanel::panel::RecipeCodes* codes READ codes CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::RecipeWindows* windows READ windows CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::RecipeFiles* files READ files CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::ReportFiles* exports READ exports CONSTANT FINAL)

public:
    using WallClock = std::function<QDateTime()>;

    // All arguments must outlive the object. Its own files are in a folder below `folder`.
    Recipes(Controller& controller, Editor& editor, DatabaseService& records, const QString& folder,
            QObject* parent);
    ~Recipes() override;

    void setWallClock(WallClock clock) { m_wallClock = std::move(clock); }
    // Sets how long a message about what was done stays.
    void setMessageTime(std::chrono::milliseconds time) { m_messageTimer.setInterval(time); }

    // Reads all recipes again after the database was changed elsewhere.
    void reload();

    [[nodiscard]] RecipeList* list() { return &m_list; }
    [[nodiscard]] QString search() const { return m_search; }
    void setSearch(const QString& search);
    // Sets the order of the list, as the setting has it.
    void setOrder(const QString& order);
    [[nodiscard]] int total() const { return static_cast<int>(m_all.size()); }
    [[nodiscard]] bool ready() const { return m_isReady; }
    [[nodiscard]] int chosen() const;
    [[nodiscard]] QString chosenName() const;
    [[nodiscard]] QString chosenNote() const;
    [[nodiscard]] bool chosenIsOpen() const;
    [[nodiscard]] bool chosenIsActive() const;
    [[nodiscard]] FigureModel* figures() { return &m_figures; }
    [[nodiscard]] QString wantedName() const { return m_wantedName; }
    void setWantedName(const QString& name);
    [[nodiscard]] QString nameProblem() const;
    [[nodiscard]] OfferModel* candidates() { return &m_candidates; }
    [[nodiscard]] DifferenceModel* differences() { return &m_differences; }
    [[nodiscard]] QString beforeTitle() const { return m_beforeTitle; }
    [[nodiscard]] QString afterTitle() const { return m_afterTitle; }
    [[nodiscard]] bool compared() const { return !m_afterTitle.isEmpty(); }
    [[nodiscard]] int nextVersion() const;
    [[nodiscard]] QString message() const { return m_message; }
    [[nodiscard]] bool canRestore() const { return m_deletedId != 0; }
    [[nodiscard]] RecipeCodes* codes() { return &m_codes; }
    [[nodiscard]] RecipeWindows* windows() { return &m_windows; }
    [[nodiscard]] RecipeFiles* files() { return &m_files; }
    [[nodiscard]] ReportFiles* exports() { return &m_exports; }

    [[nodiscard]] AccessCheck& accessCheck() const;
    // Returns the sentence for a recipe that is open because the file of the open one was lost.
    [[nodiscard]] static QString openedInsteadText(const QString& name, int version);
    // Returns the newest version of each recipe.
    [[nodiscard]] const QList<store::RecipeVersion>& newest() const { return m_all; }
    // Returns the newest version of the chosen recipe; null: none.
    [[nodiscard]] const store::RecipeVersion* chosenRecipe() const;
    // Returns the newest version of the recipe of that name, whatever its capitals; null: none.
    [[nodiscard]] const store::RecipeVersion* named(const QString& name) const;
    // Returns the recipes that this code selects: one, unless files brought the same code twice.
    [[nodiscard]] QList<store::RecipeVersion> coded(const QString& code) const;
    // Chooses the recipe with this id of the database, and ends the search.
    void chooseId(qint64 recipeId);
    // Saves the codes of the chosen recipe as its next version.
    void setCodes(const program::Recipe& withCodes);
    // Saves the approved windows of the chosen recipe as its next version.
    void setWindows(const program::Recipe& withWindows);
    // Saves the trims with the recipe of this name as its next version; says when there is none. For
    // operators.
    void saveTrims(const QString& name, const program::Trims& trims);

    // Takes the recipe files of the machine builder from a folder, in the order of their names. On a panel
    // without recipes the first of each kind sets the machine data, and the first of all is opened. Then
    // `done` gets the number of recipes that were taken, and per file why it was not.
    void takeFromBuilder(const QString& folder, const QString& keyFolder,
                         std::function<void(int count, const QMap<QString, QString>& refused)> done);

    // Returns {key, text, note} of each recipe of this kind, for a choice.
    [[nodiscard]] Q_INVOKABLE QVariantList choicesOf(int kind) const;
    Q_INVOKABLE void choose(int row);
    // Chooses the recipe of that name. Returns false when there is none.
    Q_INVOKABLE bool chooseNamed(const QString& name);
    // Opens the chosen recipe in the Editor; unsaved edits are lost.
    Q_INVOKABLE void open();
    // Saves the edited recipe as the next version of its name.
    Q_INVOKABLE void save();
    // Create, copy and rename with wantedName, which must have no problem. A new recipe and a copy are
    // opened.
    Q_INVOKABLE void create(int kind);
    using Singleton<Recipes>::create; // that of QML, which the one above would hide
    Q_INVOKABLE void copy();          // the chosen recipe
    Q_INVOKABLE void saveAs();
    Q_INVOKABLE void rename();
    Q_INVOKABLE void remove();
    Q_INVOKABLE void restore();
    Q_INVOKABLE void dismissMessage();

    // Fills the candidates with the versions of the chosen recipe, or with the other recipes.
    Q_INVOKABLE void listVersions();
    Q_INVOKABLE void listOthers();
    // Compares a candidate: a version with the previous or the newest one, another recipe with the chosen
    // one.
    Q_INVOKABLE void compareVersion(int row, bool withNewest);
    Q_INVOKABLE void compareOther(int row);
    Q_INVOKABLE void openVersion(int row);

    // Sets the recipes for `exports`: the chosen one, or all of them.
    Q_INVOKABLE void offerExport(bool all);

signals:
    // Emitted for the audit trail.
    void noted(const campanel::store::AuditEntry& entry);
    // Emitted when the controller executes this recipe, and when a recipe got other codes.
    void downloaded(const campanel::program::Recipe& recipe);
    void codesSet(const campanel::store::RecipeVersion& recipe);
    void listChanged();
    void wantedNameChanged();
    void comparisonChanged();
    void messageChanged();

private:
    using Versions = QList<store::RecipeVersion>;

    // Calls `job` with the library in its thread, then `done` in this one; reports an error.
    template <typename Job, typename Done> void work(Job job, Done done);
    // Saves the recipe, reports it (`recipe` of the result is the given one, under its version) and reads all
    // again. The audit trail names who signed it.
    // The machine data of the database change only with a recipe of the Editor.
    enum class Origin { Library, Editor };
    void keep(const program::Recipe& recipe, Origin origin,
              std::function<void(const store::RecipeVersion& kept)> done, const QString& signer = {});
    // Saves a recipe with something that is not part of its program. The open recipe of that name gets it,
    // too: `put` copies it.
    void keepBeside(const program::Recipe& recipe,
                    std::function<void(program::Recipe& recipe, const program::Recipe& kept)> put,
                    std::function<void(const store::RecipeVersion& kept)> done);
    void import(const QList<store::RecipeOffer>& offers);
    void begin();
    // Keeps the open recipe, which outlives the database because it has its own file. When that file is lost
    // or damaged, the library's recipe is opened: no default takes the place of what a person saved.
    void checkOpenRecipe(const program::Recipe& open, bool isKept, bool isLibraryEmpty);
    void nameUnreadable();
    // Opens a recipe because the file of the open one was lost, and says so.
    void openAtStart(const program::Recipe& recipe);
    void reportLostMachineData();
    void keepAndOpen(const program::Recipe& recipe, Origin origin,
                     std::function<QString(const program::Recipe& kept)> sentence);
    void followEditor();
    void show();
    void sort(QList<RecipeRow>& rows) const;
    void showFigures();
    void addMotor(QList<FigureRow>& rows, const program::Recipe& recipe) const;
    void clearComparison();
    void compare(const program::Recipe& before, const program::Recipe& after);
    // A message about what was done ends by itself.
    enum class Lasts { SomeSeconds, UntilAnswered };
    void say(const QString& text, Lasts lasts = Lasts::SomeSeconds);
    void note(const QString& what, const QString& name, const QString& before, const QString& after);
    [[nodiscard]] static QString nameOf(const program::Recipe& recipe)
    {
        return QString::fromStdString(recipe.name);
    }
    [[nodiscard]] program::Recipe onThisMachine(program::Recipe recipe) const;
    // Returns the recipe as first version of the wanted name.
    [[nodiscard]] program::Recipe renamed(program::Recipe recipe) const;
    [[nodiscard]] QString savedText(const store::RecipeVersion& version) const;
    [[nodiscard]] RecipeFiles::Effect consequence(const store::RecipeOffer& offer) const;
    [[nodiscard]] static QString changes(const QList<DifferenceRow>& rows);
    // Returns why this machine does not take a signed recipe; empty when it does.
    [[nodiscard]] QString refusalOf(const store::RecipeOffer& offer) const;

    Controller& m_controller;
    Editor& m_editor;
    DatabaseService& m_records;
    WallClock m_wallClock;
    Versions m_all;    // the newest of each
    Versions m_unread; // new ones that were saved since the last reading
    QList<store::MachineData> m_machineData;
    QHash<qint64, CurveShape> m_shapes; // of each
    RecipeList m_list{this};
    FigureModel m_figures{this};
    OfferModel m_candidates{this};
    DifferenceModel m_differences{this};
    RecipeCodes m_codes{*this};
    RecipeWindows m_windows{*this};
    RecipeFiles m_files;
    ReportFiles m_exports;
    Versions m_compared; // the rows of the candidates
    QString m_beforeTitle;
    QString m_afterTitle;
    QString m_search;
    QString m_order = QStringLiteral("date"); // or "name", "use"
    QHash<QString, qint64> m_downloads;       // of each name; see RecipeLibrary::downloads()
    QString m_wantedName;
    QString m_shownName; // name of the Editor's recipe at the last update of the list, and its next version
    int m_shownNextVersion = 0;
    QString m_message;
    QTimer m_messageTimer;
    bool m_isReading = false;
    bool m_isReadWanted = false; // again, after a change since
    qint64 m_chosenId = 0;
    qint64 m_deletedId = 0;
    QString m_deletedName;
    bool m_isReady = false;
};

template <typename Job, typename Done> void Recipes::work(Job job, Done done)
{
    m_records.store().run(
        this,
        [job = std::move(job)](store::Database& database) {
            store::RecipeLibrary library(database);
            return job(library);
        },
        [this, done = std::move(done)](const auto& outcome) {
            if (outcome)
                done(*outcome);
            else
                m_records.reportError(outcome.error());
        });
}

} // namespace campanel::panel
