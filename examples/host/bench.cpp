// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/host/bench.hpp"

#include "names/safety_core/kernel/start_check.hpp"

#include <cstdio>

namespace counterpoint::examples
{

void OtherNode::OnReceived(const CanFrame& frame, host::BusTime /*at*/)
{
    if (frame.identifier == hears_)
    {
        normal_ = frame;
    }
    if (frame.identifier == (hears_ + 1U))
    {
        const bool is_inverse = (static_cast<unsigned>(normal_.data[0]) + frame.data[0] == 0xFFU) &&
                                (static_cast<unsigned>(normal_.data[1]) + frame.data[1] == 0xFFU);
        wrong += is_inverse ? 0U : 1U;
        pairs += is_inverse ? 1U : 0U;
        heard = is_inverse ? TwoBytes{normal_.data[0], normal_.data[1]} : heard;
    }
}

void OtherNode::StartAll()
{
    static_cast<void>(bus_.Submit(node_, CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 0U}}));
}

void OtherNode::Send(const TwoBytes& data)
{
    CanFrame frame{sends_, FrameKind::kData, CanPortId::kFirst, 2U, {data.first, data.second}};
    static_cast<void>(bus_.Submit(node_, frame));
    frame.identifier = sends_ + 1U;
    frame.data[0] = static_cast<std::uint8_t>(~data.first);
    frame.data[1] = static_cast<std::uint8_t>(~data.second);
    static_cast<void>(bus_.Submit(node_, frame));
}

void TimeLine::Note(const unsigned ms, const std::string& line)
{
    if (line != last_)
    {
        char moment[16]{};
        static_cast<void>(std::snprintf(moment, sizeof(moment), "%4u ms ", ms));
        text_ += moment + line + "\n";
        last_ = line;
    }
}

std::string RefusalOf(const StartResult started, const AbortCode configured)
{
    if (started != StartResult::kStarted)
    {
        return std::string{"start refused: "} + NameOf(started) + ", " + MeaningOf(started) + "\n";
    }
    char code[16]{};
    static_cast<void>(std::snprintf(code, sizeof(code), "%08X", static_cast<unsigned>(configured)));
    return std::string{"configuration refused, abort code "} + code + "\n";
}

std::string NameOf(const DeviceFaultReport& report)
{
    return (report.fault == DeviceFault::kNone) ? std::string{"running"}
                                                : std::string{"device fault "} + NameOf(report.fault);
}

} // namespace counterpoint::examples
