// SPDX-License-Identifier: Apache-2.0
#include "master.h"

#include <QEventLoop>
#include <QModbusRtuSerialClient>
#include <QSerialPort>
#include <QVariant>

#include <stdexcept>

namespace campanel::bench {
namespace {

constexpr int unit = 1;

class QtMaster : public Master {
public:
    QtMaster(const std::string& port, std::uint32_t baud)
    {
        m_client.setConnectionParameter(QModbusDevice::SerialPortNameParameter, QString::fromStdString(port));
        m_client.setConnectionParameter(QModbusDevice::SerialBaudRateParameter, baud);
        m_client.setConnectionParameter(QModbusDevice::SerialParityParameter,
                                        static_cast<int>(QSerialPort::NoParity));
        m_client.setConnectionParameter(QModbusDevice::SerialDataBitsParameter,
                                        static_cast<int>(QSerialPort::Data8));
        m_client.setConnectionParameter(QModbusDevice::SerialStopBitsParameter,
                                        static_cast<int>(QSerialPort::OneStop));
        if (!m_client.connectDevice())
            throw std::runtime_error("QModbusRtuSerialClient: " + m_client.errorString().toStdString());
    }

    std::vector<std::uint16_t> writeAndRead(std::uint16_t writeAddress,
                                            std::span<const std::uint16_t> written, std::uint16_t readAddress,
                                            std::uint16_t count) override
    {
        const QModbusDataUnit question(QModbusDataUnit::HoldingRegisters, readAddress, count);
        const QModbusDataUnit values(QModbusDataUnit::HoldingRegisters, writeAddress,
                                     QList<quint16>(written.begin(), written.end()));
        return wait(m_client.sendReadWriteRequest(question, values, unit));
    }
    std::vector<std::uint16_t> read(std::uint16_t address, std::uint16_t count) override
    {
        return wait(m_client.sendReadRequest({QModbusDataUnit::HoldingRegisters, address, count}, unit));
    }

private:
    std::vector<std::uint16_t> wait(QModbusReply* sent) const
    {
        const std::unique_ptr<QModbusReply> reply(sent);
        if (!reply)
            throw std::runtime_error("QModbusRtuSerialClient: " + m_client.errorString().toStdString());
        QEventLoop loop;
        QObject::connect(reply.get(), &QModbusReply::finished, &loop, &QEventLoop::quit);
        if (!reply->isFinished())
            loop.exec();
        if (reply->error() != QModbusDevice::NoError)
            throw std::runtime_error("QModbusRtuSerialClient: " + reply->errorString().toStdString());
        const QList<quint16> values = reply->result().values();
        return {values.begin(), values.end()};
    }

    QModbusRtuSerialClient m_client;
};

} // namespace

std::unique_ptr<Master> qtMaster(const std::string& port, std::uint32_t baud)
{
    return std::make_unique<QtMaster>(port, baud);
}

} // namespace campanel::bench
