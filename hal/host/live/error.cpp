// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/error.hpp"

#include <linux/can/error.h>
#include <string>

namespace counterpoint::host
{
namespace
{

struct Bit
{
    std::uint32_t mask;
    const char* text;
};

constexpr Bit kController[]{
    {CAN_ERR_CRTL_RX_OVERFLOW, "receive buffer overflow"},
    {CAN_ERR_CRTL_TX_OVERFLOW, "transmit buffer overflow"},
    {CAN_ERR_CRTL_RX_WARNING, "error warning (receiver)"},
    {CAN_ERR_CRTL_TX_WARNING, "error warning (transmitter)"},
    {CAN_ERR_CRTL_RX_PASSIVE, "error passive (receiver)"},
    {CAN_ERR_CRTL_TX_PASSIVE, "error passive (transmitter)"},
    {CAN_ERR_CRTL_ACTIVE, "error active"},
};
constexpr Bit kProtocol[]{
    {CAN_ERR_PROT_BIT, "bit error"},         {CAN_ERR_PROT_FORM, "form error"},
    {CAN_ERR_PROT_STUFF, "stuff error"},     {CAN_ERR_PROT_BIT0, "no dominant bit"},
    {CAN_ERR_PROT_BIT1, "no recessive bit"}, {CAN_ERR_PROT_OVERLOAD, "overload"},
    {CAN_ERR_PROT_ACTIVE, "error active"},   {CAN_ERR_PROT_TX, "on transmission"},
};
constexpr Bit kClasses[]{
    {CAN_ERR_TX_TIMEOUT, "transmit timeout"}, {CAN_ERR_LOSTARB, "arbitration lost"}, {CAN_ERR_TRX, "transceiver fault"},
    {CAN_ERR_ACK, "no acknowledgement"},      {CAN_ERR_BUSOFF, "bus-off"},           {CAN_ERR_BUSERROR, "bus error"},
    {CAN_ERR_RESTARTED, "restarted"},
};

template <std::size_t kCount> void Name(const Bit (&bits)[kCount], const std::uint32_t value, std::string& text)
{
    for (const Bit& bit : bits)
    {
        if ((value & bit.mask) != 0U)
        {
            text += (text.empty() ? "" : ", ") + std::string(bit.text);
        }
    }
}

std::optional<BusState> ControllerState(const std::uint8_t bits)
{
    if ((bits & (CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE)) != 0)
    {
        return BusState::kPassive;
    }
    if ((bits & (CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING)) != 0)
    {
        return BusState::kWarning;
    }
    return ((bits & CAN_ERR_CRTL_ACTIVE) != 0) ? std::optional<BusState>{BusState::kActive} : std::nullopt;
}

} // namespace

ErrorNews ReadErrorFrame(const LiveFrame& frame)
{
    ErrorNews news;
    if (!frame.error)
    {
        return news;
    }
    const auto has = [&frame](const std::uint32_t mask) { return (frame.identifier & mask) != 0U; };
    if (has(CAN_ERR_CRTL))
    {
        news.state = ControllerState(frame.data[1]);
        news.is_overflow = (frame.data[1] & CAN_ERR_CRTL_RX_OVERFLOW) != 0;
    }
    if (has(CAN_ERR_PROT) && ((frame.data[2] & CAN_ERR_PROT_ACTIVE) != 0))
    {
        news.state = BusState::kActive;
    }
    news.is_restart = has(CAN_ERR_RESTARTED);
    if (news.is_restart)
    {
        news.state = BusState::kActive;
    }
    news.is_bus_off = has(CAN_ERR_BUSOFF);
    if (news.is_bus_off)
    {
        news.state = BusState::kBusOff;
    }
    news.has_counters = has(CAN_ERR_CNT);
    if (news.has_counters)
    {
        news.transmit_errors = frame.data[6];
        news.receive_errors = frame.data[7];
    }
    return news;
}

std::string DescribeErrorFrame(const LiveFrame& frame)
{
    std::string text;
    Name(kClasses, frame.identifier, text);
    if ((frame.identifier & CAN_ERR_CRTL) != 0U)
    {
        Name(kController, frame.data[1], text);
    }
    if ((frame.identifier & CAN_ERR_PROT) != 0U)
    {
        Name(kProtocol, frame.data[2], text);
    }
    if (text.empty())
    {
        text = "error of no known class";
    }
    if ((frame.identifier & CAN_ERR_CNT) != 0U)
    {
        text +=
            "; " + std::to_string(frame.data[6]) + " transmit, " + std::to_string(frame.data[7]) + " receive errors";
    }
    return text;
}

} // namespace counterpoint::host
