// SPDX-License-Identifier: Apache-2.0
// The output of campanelctl: a full disk destroys no file, an incomplete output is an error, control
// characters of a file do not reach a terminal, and CSV has one kind of line end.
#include "app/store/recipes/recipe_json.h"
#include "campanelctl_call.h"
#include "tests/support/full_disk.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <QTemporaryDir>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace test_output {

using namespace campanel;
using namespace Qt::StringLiterals;
using namespace campanel::test;

namespace {

void put(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("%s", qPrintable(file.errorString()));
}

QByteArray get(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("not there");
}

bool hasControls(const QByteArray& bytes)
{
    const QString text = QString::fromUtf8(bytes);
    return std::any_of(text.begin(), text.end(), [](QChar letter) {
        return letter.category() == QChar::Other_Control && letter != u'\n';
    });
}

} // namespace

class OutputTest : public QObject {
    Q_OBJECT

private slots:
    void aFullDiskCostsNoFile_data();
    void aFullDiskCostsNoFile();
    void standardOutputThatIsFullIsAnError_data();
    void standardOutputThatIsFullIsAnError();
    void aPipeIsWrittenNotReplaced();
    void noControlCharacterReachesATerminal();
    void aNameMakesNoLines();
    void linesOfCsvEndInOneWay_data();
    void linesOfCsvEndInOneWay();

private:
    QTemporaryDir m_directory;
};

void OutputTest::aFullDiskCostsNoFile_data()
{
    QTest::addColumn<QString>("command");
    QTest::addColumn<int>("roomBytes");
    for (const QString& command :
         {u"recipe"_s, u"table"_s, u"profile"_s, u"laws"_s, u"compare --kind position_move --format json"_s,
          u"knots --kind point_cam --format csv"_s, u"registers"_s}) {
        QTest::addRow("%s, no room", qPrintable(command)) << command << 0;
        QTest::addRow("%s, a little room", qPrintable(command)) << command << 10;
    }
}

void OutputTest::aFullDiskCostsNoFile()
{
    QFETCH(QString, command);
    QFETCH(int, roomBytes);
    const QString path = m_directory.filePath(u"kept"_s);
    put(path, "the old file");
    const QStringList before = QDir(m_directory.path()).entryList(QDir::Files);
    Result result;
    {
        const FullDisk full(static_cast<rlim_t>(roomBytes));
        result = call(command + u" -o "_s + path);
    }
    QCOMPARE(result.code, int{File});
    QCOMPARE(get(path), QByteArray("the old file"));
    QVERIFY2(result.complaint.contains("cannot be written") &&
                 result.complaint.contains("Free some disk space"),
             result.complaint.constData());
    QCOMPARE(QDir(m_directory.path()).entryList(QDir::Files), before);
}

void OutputTest::standardOutputThatIsFullIsAnError_data()
{
    QTest::addColumn<QString>("arguments");
    for (const char* arguments :
         {"recipe", "table", "--help", "--version", "recipe --help", "recipe -o /dev/stdout"})
        QTest::addRow("%s", arguments) << QString::fromLatin1(arguments);
}

void OutputTest::standardOutputThatIsFullIsAnError()
{
    QFETCH(QString, arguments);
    QProcess controller;
    controller.setStandardOutputFile(u"/dev/full"_s);
    controller.start(programPath("campanel-controller"), {u"--help"_s});
    QVERIFY(controller.waitForFinished());
    QVERIFY(controller.exitCode() != 0);
    QProcess process;
    process.setStandardOutputFile(u"/dev/full"_s);
    process.start(programPath("campanelctl"), arguments.split(u' '));
    QVERIFY(process.waitForFinished());
    QCOMPARE(process.exitCode(), int{File});
    const QByteArray complaint = process.readAllStandardError();
    QVERIFY2(complaint.contains("cannot be written"), complaint.constData());
}

void OutputTest::aPipeIsWrittenNotReplaced()
{
    const QString path = m_directory.filePath(u"pipe"_s);
    const QByteArray name = QFile::encodeName(path);
    QCOMPARE(mkfifo(name.constData(), 0600), 0);
    const int pipe = open(name.constData(), O_RDWR | O_NONBLOCK);
    QVERIFY(pipe >= 0);
    const Result result = call(u"recipe -o "_s + path);
    QByteArray received(65'536, Qt::Uninitialized);
    received.truncate(read(pipe, received.data(), static_cast<std::size_t>(received.size())));
    close(pipe);
    QCOMPARE(result.code, int{Ok});
    QCOMPARE(received, call(u"recipe"_s).out);
    struct stat status = {};
    QCOMPARE(stat(name.constData(), &status), 0);
    QVERIFY(S_ISFIFO(status.st_mode));
}

void OutputTest::noControlCharacterReachesATerminal()
{
    const QString path = m_directory.filePath(u"named.json"_s);
    program::Recipe recipe;
    recipe.name = "Bis\x1b]0;x\x07 \xc2\x9b"
                  "2J";
    put(path, store::toJson(recipe));
    for (const char* command : {"profile", "table", "recipe"}) {
        const Result result = call({QString::fromLatin1(command), path});
        QCOMPARE(result.code, int{Ok});
        QVERIFY2(!hasControls(result.out), result.out.constData());
    }
    // A name keeps what can be seen of it.
    const auto again = store::fromJson(call({u"recipe"_s, path}).out, path);
    QVERIFY(again.has_value());
    QCOMPARE(again->name, "Bis]0;x 2J");

    put(path, store::toJson(recipe).replace("\"k1\"", "\"\\u001b[2Jk1\""));
    const Result unknown = call({u"recipe"_s, path});
    QCOMPARE(unknown.code, int{File});
    QVERIFY2(!hasControls(unknown.complaint) && unknown.complaint.contains("\\u001b[2Jk1"),
             unknown.complaint.constData());
    const Result absent = call({u"recipe"_s, u"absent\x1b[2J.json"_s});
    QCOMPARE(absent.code, int{File});
    QVERIFY2(!hasControls(absent.complaint), absent.complaint.constData());
}

// A name from elsewhere is one line of a report, or is refused in one line.
void OutputTest::aNameMakesNoLines()
{
    const QString path = m_directory.filePath(u"named.json"_s);
    program::Recipe recipe;
    recipe.name = "Mix\nforged  yes\tand\u2028forged\u202eon";
    put(path, store::toJson(recipe));
    for (const QString& words :
         {u"profile"_s, u"table"_s, u"profile --format csv"_s, u"simulate --bags 3"_s}) {
        const QStringList command = words.split(u' ');
        const Result result = call(QStringList{command.first(), path} + command.sliced(1));
        QVERIFY2(!result.out.contains("\nforged") && !result.out.contains('\t') &&
                     !result.out.contains("\u202e"),
                 result.out.constData());
        QVERIFY2(!result.complaint.contains("\nforged") && !result.complaint.contains("\u202e"),
                 result.complaint.constData());
    }
}

void OutputTest::linesOfCsvEndInOneWay_data()
{
    QTest::addColumn<QString>("arguments");
    for (const char* arguments : {"profile", "table", "intervals", "laws", "knots --kind point_cam",
                                  "registers", "simulate --bags 3"})
        QTest::addRow("%s", arguments) << QString::fromLatin1(arguments);
}

void OutputTest::linesOfCsvEndInOneWay()
{
    QFETCH(QString, arguments);
    const Result result = call(arguments + u" --format csv"_s);
    QCOMPARE(result.code, int{Ok});
    QVERIFY(result.out.endsWith('\n'));
    QVERIFY(!result.out.contains('\r'));
}

CAMPANEL_TEST(OutputTest)

} // namespace test_output

#include "test_output.moc"
