// SPDX-License-Identifier: Apache-2.0
// Signed packages: what a key has signed is accepted whole, anything else is refused with its reason; the
// order of versions is dpkg's.
#include "app/store/update/package_offers.h"
#include "tests/support/fake_package.h"
#include "tests/support/test_program.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

namespace test_signed_package {

using namespace campanel;
using namespace campanel::store;
using namespace Qt::StringLiterals;
using Kind = PackageFault::Kind;

namespace {

SignerKey publicOf(const SigningKey& key)
{
    return publicKeyIn(publicKeyFile(key)).value();
}

} // namespace

class SignedPackageTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;
    SigningKey m_anna = newSigningKey(u"Anna"_s).value();
    QString m_package;

    std::optional<Kind> fault(const QList<SignerKey>& keys)
    {
        const auto read = verifyPackage(m_package, keys);
        return read ? std::nullopt : std::optional(read.error().kind);
    }
    void changeSignature(const QString& key, const QJsonValue& value)
    {
        const auto bytes = readBytes(signaturePath(m_package));
        QJsonObject root = QJsonDocument::fromJson(bytes.value()).object();
        root[key] = value;
        QVERIFY(test::writeFile(signaturePath(m_package), QJsonDocument(root).toJson()));
    }

private slots:
    // os-release(5) of an image, of another maker's and of a computer without one.
    void anImageIsItsOwnVersion()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(u"os-release"_s);
        QCOMPARE(imageVersion(file), QString());
        QVERIFY(replaceBytes(file, "ID=debian\nIMAGE_ID=campanel-system\nIMAGE_VERSION=1.2.3-20260115\n"));
        QCOMPARE(imageVersion(file), u"1.2.3-20260115"_s);
        QVERIFY(compareVersions(u"1.2.3-20260115", u"1.2.3-20260116") < 0);
        QVERIFY(compareVersions(u"1.2.3-20260115", u"1.3.0-20260101") < 0);
        QVERIFY(replaceBytes(file, "ID=debian\nIMAGE_ID=kiosk\nIMAGE_VERSION=7\n"));
        QCOMPARE(imageVersion(file), QString());
    }

    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_package = test::makePackage(m_folder->path(), u"1.2.3+deb12"_s);
        QVERIFY(!m_package.isEmpty());
        QVERIFY(test::signPackage(m_package, m_anna));
    }

    void isReadBack()
    {
        const auto read = verifyPackage(m_package, {publicOf(m_anna)});
        QVERIFY(read.has_value());
        QCOMPARE(read->package, (PackageId{u"campanel"_s, u"1.2.3+deb12"_s, u"amd64"_s}));
        QCOMPARE(read->signer, u"Anna"_s);
        QCOMPARE(read->signedMs, test::packageSignedMs);
        QCOMPARE(read->bytes, QFileInfo(m_package).size());
    }

    void onlyAValidKeyOpensIt()
    {
        SignerKey withdrawn = publicOf(m_anna);
        withdrawn.isWithdrawn = true;
        QCOMPARE(fault({}), Kind::UnknownSigner);
        QCOMPARE(fault({publicOf(newSigningKey(u"Anna"_s).value())}), Kind::WrongSignature);
        QCOMPARE(fault({withdrawn}), Kind::WithdrawnSigner);
    }

    void everyChangeIsFound_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("value");
        QTest::newRow("time") << u"signed_utc"_s << u"2026-01-13T10:26:41Z"_s;
        QTest::newRow("version") << u"version"_s << u"1.2.4"_s;
        QTest::newRow("architecture") << u"architecture"_s << u"arm64"_s;
        QTest::newRow("package") << u"package"_s << u"other"_s;
        QTest::newRow("hash") << u"sha256"_s << QString(64, u'0');
        QTest::newRow("signature") << u"signature"_s << u"AAAA"_s;
        QTest::newRow("no base64") << u"signature"_s << u"%%"_s;
        QTest::newRow("further key") << u"more"_s << u"x"_s;
        QTest::newRow("other format") << u"format"_s << u"campanel-signed-recipe"_s;
    }
    void everyChangeIsFound()
    {
        QFETCH(QString, key);
        QFETCH(QString, value);
        changeSignature(key, value);
        QCOMPARE(fault({publicOf(m_anna)}), Kind::WrongSignature);
    }

    void aNewerFormIsNamed()
    {
        changeSignature(u"format_version"_s, 2);
        QCOMPARE(fault({publicOf(m_anna)}), Kind::NewerSignature);
    }

    void aChangedFileIsFound()
    {
        QFile file(m_package);
        QVERIFY(file.open(QIODevice::ReadWrite));
        QByteArray bytes = file.readAll();
        bytes[bytes.size() - 1] = static_cast<char>(bytes.back() ^ 1);
        QVERIFY(file.seek(0) && file.write(bytes) == bytes.size());
        file.close();
        QCOMPARE(fault({publicOf(m_anna)}), Kind::Damaged);
        QVERIFY(QFile::resize(m_package, 100));
        QCOMPARE(fault({publicOf(m_anna)}), Kind::Damaged);
    }

    // The same key and bytes under the first line of a recipe are no signature of a package.
    void anotherPurposeIsNoSignature()
    {
        const auto content = verifyPackage(m_package, {publicOf(m_anna)});
        QVERIFY(content.has_value());
        const QByteArray text = QStringList{u"campanel-signed-recipe 1"_s,
                                            content->signer,
                                            u"2026-01-13T10:26:40Z"_s,
                                            u"campanel"_s,
                                            u"1.2.3+deb12"_s,
                                            u"amd64"_s,
                                            QString::number(content->bytes),
                                            QString::fromLatin1(content->sha256.toHex())}
                                    .join(u'\n')
                                    .toUtf8();
        QByteArray own = text;
        own.replace("campanel-signed-recipe", "campanel-package-signature");
        changeSignature(u"signature"_s, QString::fromLatin1(signatureOf(own, m_anna).toBase64()));
        QCOMPARE(fault({publicOf(m_anna)}), std::nullopt);
        changeSignature(u"signature"_s, QString::fromLatin1(signatureOf(text, m_anna).toBase64()));
        QCOMPARE(fault({publicOf(m_anna)}), Kind::WrongSignature);
    }

    void missingFiles()
    {
        QVERIFY(QFile::remove(signaturePath(m_package)));
        QCOMPARE(fault({publicOf(m_anna)}), Kind::NotSigned);
        QVERIFY(test::writeFile(m_package, "no package"));
        const auto made = signPackage(m_package, 0, m_anna);
        QVERIFY(!made);
        QCOMPARE(made.error().kind, Kind::NotAPackage);
    }

    void versionsAreOrderedAsByDpkg_data()
    {
        QTest::addColumn<QString>("lower");
        QTest::addColumn<QString>("higher");
        for (const auto& [lower, higher] :
             {std::pair("0.9", "0.10"), std::pair("1.0", "1.0.1"), std::pair("1.0~rc1", "1.0"),
              std::pair("1.0", "1.0+deb12"), std::pair("1.0+deb12", "1.0+deb13"), std::pair("1.0~~", "1.0~"),
              std::pair("1.0a", "1.0+"), std::pair("1.0-1", "1.0-2"), std::pair("9.9", "1:0.1"),
              std::pair("1.0.9", "1.0.010"), std::pair("1.0-1", "1.0.1-0"), std::pair("1.2a", "1.2b")})
            QTest::addRow("%s < %s", lower, higher)
                << QString::fromLatin1(lower) << QString::fromLatin1(higher);
    }
    void versionsAreOrderedAsByDpkg()
    {
        QFETCH(QString, lower);
        QFETCH(QString, higher);
        QVERIFY(compareVersions(lower, higher) < 0);
        QVERIFY(compareVersions(higher, lower) > 0);
        QVERIFY(compareVersions(lower, lower) == 0);
        QCOMPARE(QProcess::execute(u"dpkg"_s, {u"--compare-versions"_s, lower, u"lt"_s, higher}), 0);
    }

    void equalVersions()
    {
        QVERIFY(compareVersions(u"1.0", u"1.0-0") == 0);
        QVERIFY(compareVersions(u"1.00", u"1.0") == 0);
        QCOMPARE(shortVersion(u"1.2.3+deb12"_s), u"1.2.3"_s);
    }

    void offersAreSorted()
    {
        const QString stick = m_folder->filePath(u"stick"_s);
        const QString keys = m_folder->filePath(u"keys"_s);
        QVERIFY(test::writeFile(keys + u"/anna.json"_s, publicKeyFile(m_anna)));
        for (const QString& version : {u"1.9.0"_s, u"1.10.0"_s, u"1.11.0"_s}) {
            const QString path = test::makePackage(stick, version);
            QVERIFY(version == u"1.11.0" || test::signPackage(path, m_anna));
        }
        QVERIFY(test::writeFile(stick + u"/other_1.0_amd64.deb"_s, "x"));
        CheckedPackages checked;
        const auto offers = offeredPackages({{stick, u"KINGSTON"_s}}, keys, checked);
        QCOMPARE(offers.size(), 3);
        QCOMPARE(offers[0].package->package.version, u"1.10.0"_s);
        QCOMPARE(offers[1].package->package.version, u"1.9.0"_s);
        QCOMPARE(offers[2].package.error().kind, Kind::NotSigned);
        QCOMPARE(checked.size(), 3);
        // A file that has not changed is not read again.
        const QString first = checked.constBegin().key();
        checked[first] = tl::unexpected(PackageFault{Kind::Damaged, {}, {}});
        const auto again = offeredPackages({{stick, u"KINGSTON"_s}}, keys, checked);
        QVERIFY(std::ranges::any_of(again, [](const PackageOffer& offer) {
            return !offer.package && offer.package.error().kind == Kind::Damaged;
        }));
    }
};

CAMPANEL_TEST(SignedPackageTest)

} // namespace test_signed_package

#include "test_signed_package.moc"
