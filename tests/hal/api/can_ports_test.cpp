// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/api/can_ports.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace counterpoint::hal
{
namespace
{

class RecordingPorts final : public CanPorts
{
  public:
    explicit RecordingPorts(const TransmitStatus answer) : answer_(answer)
    {
    }
    [[nodiscard]] CanGuarantees Guarantees() const noexcept override
    {
        return CanGuarantees{Guarantee::kGiven, Guarantee::kGiven, Guarantee::kGiven};
    }

    int calls{0};
    CanFrame last{};

  private:
    [[nodiscard]] TransmitStatus DoTransmit(const CanFrame& frame) noexcept override
    {
        ++calls;
        last = frame;
        return answer_;
    }

    TransmitStatus answer_;
};

constexpr CanFrame kGood{0x101U, FrameKind::kData, CanPortId::kFirst, 2U, {0x12U, 0x34U}};

TEST(CanPorts, FrameThatMayBeSentReachesThePortUnchanged)
{
    Verifies(req::SRS_HAL_001);
    // Given a port that takes frames
    RecordingPorts ports(TransmitStatus::kAccepted);
    // When a right frame is transmitted
    const TransmitStatus status = ports.Transmit(kGood);
    // Then the port got it as it was
    EXPECT_EQ(status, TransmitStatus::kAccepted);
    EXPECT_EQ(ports.calls, 1);
    EXPECT_EQ(ports.last.identifier, 0x101U);
    EXPECT_EQ(ports.last.length_bytes, 2U);
    EXPECT_EQ(ports.last.data[1], 0x34U);
}

TEST(CanPorts, AnswerOfThePortIsPassedOn)
{
    Verifies(req::SRS_HAL_001);
    for (const TransmitStatus answer :
         {TransmitStatus::kAccepted, TransmitStatus::kQueueFull, TransmitStatus::kBusOff, TransmitStatus::kRefused})
    {
        // Given a port that answers so
        RecordingPorts ports(answer);
        // When a right frame is transmitted, then the answer is that of the port
        EXPECT_EQ(ports.Transmit(kGood), answer);
    }
}

TEST(CanPorts, GreatestIdentifierAndGreatestLengthAreSent)
{
    Verifies(req::SRS_HAL_001);
    // Given a frame at both limits, on the second controller
    RecordingPorts ports(TransmitStatus::kAccepted);
    const CanFrame frame{0x7FFU, FrameKind::kData, CanPortId::kSecond, 8U, {}};
    // When it is transmitted, then it reaches the port
    EXPECT_EQ(ports.Transmit(frame), TransmitStatus::kAccepted);
    EXPECT_EQ(ports.calls, 1);
}

TEST(CanPorts, FrameThatMayNotBeSentIsRefusedAndDoesNotReachThePort)
{
    Verifies(req::SRS_HAL_001);
    // Given frames with one thing wrong each
    CanFrame remote = kGood;
    remote.kind = FrameKind::kRemote;
    CanFrame extended = kGood;
    extended.kind = FrameKind::kExtended;
    CanFrame nothing = kGood;
    nothing.kind = FrameKind::kInvalid;
    CanFrame beyond_identifier = kGood;
    beyond_identifier.identifier = 0x800U;
    CanFrame beyond_length = kGood;
    beyond_length.length_bytes = 9U;
    CanFrame no_port = kGood;
    no_port.port = CanPortId::kInvalid;
    CanFrame third_port = kGood;
    third_port.port = static_cast<CanPortId>(3U);
    for (const CanFrame& frame : {remote, extended, nothing, beyond_identifier, beyond_length, no_port, third_port})
    {
        RecordingPorts ports(TransmitStatus::kAccepted);
        // When one is transmitted, then it is refused and the port saw nothing
        EXPECT_EQ(ports.Transmit(frame), TransmitStatus::kRefused);
        EXPECT_EQ(ports.calls, 0);
    }
}

TEST(CheckGuarantees, FirstMissingGuaranteeIsNamed)
{
    Verifies(req::SRS_HAL_002);
    constexpr Guarantee kYes = Guarantee::kGiven;
    constexpr Guarantee kNo = Guarantee::kAbsent;
    // Given all, then each missing, then several missing; when checked, then the first in order is named
    EXPECT_EQ(CheckGuarantees(CanGuarantees{kYes, kYes, kYes}), MissingGuarantee::kNone);
    EXPECT_EQ(CheckGuarantees(CanGuarantees{kNo, kYes, kYes}), MissingGuarantee::kBusOrder);
    EXPECT_EQ(CheckGuarantees(CanGuarantees{kYes, kNo, kYes}), MissingGuarantee::kStamps);
    EXPECT_EQ(CheckGuarantees(CanGuarantees{kYes, kYes, kNo}), MissingGuarantee::kConfirmations);
    EXPECT_EQ(CheckGuarantees(CanGuarantees{kYes, kNo, kNo}), MissingGuarantee::kStamps);
    EXPECT_EQ(CheckGuarantees(CanGuarantees{kNo, kNo, kNo}), MissingGuarantee::kBusOrder);
}

TEST(CheckGuarantees, ZeroFilledMemoryGuaranteesNothing)
{
    Verifies(req::SRS_HAL_002);
    // Given zero-filled guarantees, when checked, then the first one is missing
    EXPECT_EQ(CheckGuarantees(CanGuarantees{}), MissingGuarantee::kBusOrder);
}

} // namespace
} // namespace counterpoint::hal
