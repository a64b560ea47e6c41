// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia302/safety_gate/rig.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint8_t kNode = 2U;

std::array<SlaveSetup, kNodeRoom>& WithSafety(std::array<SlaveSetup, kNodeRoom>& slaves,
                                              const SafetyExpectation& safety)
{
    slaves[kNode].assignment = kInNetwork | kBootSlave;
    slaves[kNode].safety = &safety;
    return slaves;
}

} // namespace

GateRig::GateRig()
    : setup{NodeId{1U}, 1U, 0U, 0U, 0U, WithSafety(slaves, expectation).data()}, lanes{*this, SdoTimes{100000U, 3U}},
      pool{lanes.All(), SdoTimes{100000U, 3U}}, gate{setup, SafetySlots{slots.data(), 2U}, pool}
{
}

bool GateRig::Send(const CanFrame& frame) noexcept
{
    requests_.push_back(frame);
    return true;
}

std::vector<ExpectedObject> GateRig::Configuration()
{
    std::vector<ExpectedObject> list{};
    for (std::uint32_t index = 0x1300U; index <= 0x13FFU; ++index)
    {
        for (std::uint32_t sub = 0U; sub <= 128U; ++sub)
        {
            const ObjectAddress address{static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub)};
            const ObjectReading reading = core.ReadObject(address);
            const bool is_mapping = (index >= 0x1381U) && (index <= 0x13C0U);
            const bool is_used = !is_mapping || (sub <= Has(address.index, 0U));
            const bool is_signed = (index != 0x13FFU) || (sub == 0U) || (ToValue(reading.data) != 0U);
            if ((reading.abort == AbortCode::kNone) && (SizeOf(address) > 0U) && is_used && is_signed)
            {
                list.push_back(ExpectedObject{address, ToValue(reading.data), false});
            }
        }
    }
    for (ExpectedObject& object : list)
    {
        object.is_fixed = (object.address.index == 0x13FFU) && (object.address.sub == 0U);
    }
    return list;
}

void GateRig::Expect(std::vector<ExpectedObject> list)
{
    expected = std::move(list);
    expectation = SafetyExpectation{expected.data(), static_cast<std::uint16_t>(expected.size())};
}

void GateRig::Pass(const std::uint32_t milliseconds)
{
    for (std::uint32_t ms = 0U; ms < milliseconds; ++ms)
    {
        Cycle();
        Answer();
        pool.OnCycle(Instant{now_us});
        gate.OnCycle(Instant{now_us});
        std::vector<CanFrame> requests{};
        requests.swap(requests_);
        for (CanFrame& request : requests)
        {
            if (!on_request || on_request(request))
            {
                const auto index = static_cast<std::uint16_t>(request.data[1] | (request.data[2] << 8U));
                ((request.data[0] == 0x40U) ? read : written).push_back(ObjectAddress{index, request.data[3]});
                Frame(request.identifier, device::Octets(request.data, request.data + request.length_bytes));
            }
        }
    }
}

void GateRig::Answer()
{
    for (; answered_ < ports.sent.size(); ++answered_)
    {
        CanFrame frame = ports.sent[answered_];
        const bool is_answer = (frame.identifier == 0x580U + kNode);
        if (is_answer && (!on_answer || on_answer(frame)))
        {
            pool.OnFrame(frame, Instant{now_us});
        }
    }
}

void GateRig::Finish()
{
    for (std::uint32_t ms = 0U; (ms < 2000U) && (gate.State(NodeId{kNode}) == GateState::kBusy); ++ms)
    {
        Pass(1U);
    }
}

std::uint32_t GateRig::Has(const std::uint16_t index, const std::uint8_t sub)
{
    return ToValue(core.ReadObject(ObjectAddress{index, sub}).data);
}

} // namespace counterpoint::cia302
