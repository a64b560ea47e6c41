// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/dictionary/dictionary.hpp"
#include "canopen/cia301/dictionary/no_objects.hpp"
#include "canopen/cia301/objects/service_objects.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <vector>

namespace counterpoint::cia301
{
namespace
{

using KernelObjectsTest = Rig;
using Octets = std::vector<std::uint8_t>;

class ServiceObjectsTest : public ::testing::Test, public HeartbeatListener
{
  public:
    void OnHeartbeat(NodeId, HeartbeatEvent, std::uint8_t) noexcept override
    {
    }
    Octets Read(std::uint16_t index, std::uint8_t sub)
    {
        std::uint8_t bytes[4] = {};
        const Reading reading = objects.OnRead({index, sub}, {bytes, 4U});
        abort = reading.abort;
        return (abort == SdoAbort::kNone) ? Octets(bytes, bytes + reading.size_bytes) : Octets{};
    }
    SdoAbort Write(std::uint16_t index, std::uint8_t sub, const Octets& value)
    {
        return objects.OnWrite({index, sub}, {value.data(), static_cast<std::uint32_t>(value.size())});
    }

    SdoAbort abort{SdoAbort::kNone};
    std::array<SupervisedNode, 2> room{};
    std::array<std::uint32_t, 8> history{};
    EmergencyProducer emergency{NodeId{5U}, ErrorHistory{history.data(), 8U}};
    HeartbeatConsumer consumer{SupervisedNodes{room.data(), 2U}, *this};
    HeartbeatProducer producer{NodeId{5U}};
    NodeGuarding guarding{NodeId{5U}};
    ServiceObjects objects{ServiceParts{emergency, consumer, producer, guarding, 2U}};
};

TEST_F(ServiceObjectsTest, ValuesAreReadFromTheServicesAndWrittenThere)
{
    Verifies(req::SRS_OBD_013);
    emergency.Raise(EmergencyError{0x4210U, 0x08U, {1U, 2U}});
    EXPECT_EQ(Read(0x1001U, 0U), (Octets{0x09U}));
    EXPECT_EQ(Read(0x1003U, 0U), (Octets{1U}));
    EXPECT_EQ(Read(0x1003U, 1U), (Octets{0x10U, 0x42U, 1U, 2U}));
    EXPECT_EQ(Write(0x1003U, 0U, {0U}), SdoAbort::kNone);
    EXPECT_EQ(Read(0x1003U, 0U), (Octets{0U}));
    EXPECT_EQ(Write(0x1014U, 0U, {0x85U, 0U, 0U, 0x80U}), SdoAbort::kNone);
    EXPECT_EQ(Read(0x1014U, 0U), (Octets{0x85U, 0U, 0U, 0x80U}));
    EXPECT_EQ(Write(0x1015U, 0U, {0x34U, 0x12U}), SdoAbort::kNone);
    EXPECT_EQ(Read(0x1015U, 0U), (Octets{0x34U, 0x12U}));
    EXPECT_EQ(Read(0x1016U, 0U), (Octets{2U}));
    EXPECT_EQ(Write(0x1016U, 2U, {0x64U, 0U, 7U, 0U}), SdoAbort::kNone);
    EXPECT_EQ(Read(0x1016U, 2U), (Octets{0x64U, 0U, 7U, 0U}));
    EXPECT_EQ(Write(0x1017U, 0U, {0xE8U, 0x03U}), SdoAbort::kNone);
    EXPECT_EQ(Read(0x1017U, 0U), (Octets{0xE8U, 0x03U}));
    EXPECT_EQ(producer.PeriodMs(), 1000U);
    // Guard time and life factor meet in life guarding
    EXPECT_EQ(Write(0x100CU, 0U, {100U, 0U}), SdoAbort::kNone);
    EXPECT_EQ(Write(0x100DU, 0U, {3U}), SdoAbort::kNone);
    EXPECT_EQ(Read(0x100CU, 0U), (Octets{100U, 0U}));
    EXPECT_EQ(Read(0x100DU, 0U), (Octets{3U}));
    const CanFrame request{0x705U, FrameKind::kRemote, CanPortId::kFirst, 1U, {}};
    static_cast<void>(guarding.OnFrame(request, GuardMoment{NodeState::kOperational, 0U, Instant{0U}}));
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{300000U}}), GuardEvent::kNone);
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{300001U}}), GuardEvent::kLost);
}

TEST_F(ServiceObjectsTest, TheServicesRefusalsComeBack)
{
    Verifies(req::SRS_OBD_013);
    EXPECT_EQ(Write(0x1001U, 0U, {0U}), SdoAbort::kReadOnly);
    EXPECT_EQ(Write(0x1003U, 0U, {1U}), SdoAbort::kValueRange);
    EXPECT_EQ(Write(0x1003U, 1U, {1U, 0U, 0U, 0U}), SdoAbort::kReadOnly);
    EXPECT_EQ(Write(0x1014U, 0U, {0x90U, 0U, 0U, 0U}), SdoAbort::kValueRange);
    EXPECT_EQ(Write(0x1016U, 0U, {1U}), SdoAbort::kReadOnly);
    EXPECT_EQ(Write(0x1016U, 3U, {0U, 0U, 0U, 0U}), SdoAbort::kSubUnknown);
    EXPECT_EQ(Write(0x1018U, 0U, {0U}), SdoAbort::kObjectUnknown);
    static_cast<void>(Read(0x1003U, 1U));
    EXPECT_EQ(abort, SdoAbort::kNoData);
    static_cast<void>(Read(0x1016U, 3U));
    EXPECT_EQ(abort, SdoAbort::kSubUnknown);
    static_cast<void>(Read(0x1017U, 1U));
    EXPECT_EQ(abort, SdoAbort::kSubUnknown);
    static_cast<void>(Read(0x1018U, 0U));
    EXPECT_EQ(abort, SdoAbort::kObjectUnknown);
    std::uint8_t small[1] = {};
    EXPECT_EQ(objects.OnRead({0x1017U, 0U}, {small, 1U}).abort, SdoAbort::kOutOfMemory);
}

TEST_F(KernelObjectsTest, TheDictionaryServesTheKernelsObjects)
{
    Verifies(req::SRS_OBD_012);
    // Given a configured kernel behind an empty table
    Configure();
    KernelObjects facade{kernel};
    Dictionary dictionary{EntryTable{nullptr, 0U}, facade};
    // Then its constants are read, and its refusals come through
    EXPECT_EQ(dictionary.ReadNumber({0x1301U, 0U}).value, 6U);
    EXPECT_EQ(dictionary.ReadNumber({0x13FEU, 0U}).value, 0xA5U);
    EXPECT_EQ(dictionary.WriteNumber({0x1301U, 0U}, 6U, 1U), SdoAbort::kReadOnly);
    EXPECT_EQ(dictionary.WriteNumber({0x1300U, 0U}, 2U, 1U), SdoAbort::kValueRange);
    EXPECT_EQ(dictionary.WriteNumber({0x1300U, 0U}, 1U, 2U), SdoAbort::kLengthMismatch);
    EXPECT_EQ(dictionary.ReadNumber({0x1341U, 0U}).abort, SdoAbort::kObjectUnknown);
    EXPECT_EQ(dictionary.ReadNumber({0x1381U, 17U}).abort, SdoAbort::kSubUnknown);
    // When it is written over the dictionary, the kernel has it
    EXPECT_EQ(dictionary.WriteNumber({0x1300U, 0U}, 0U, 1U), SdoAbort::kNone);
    EXPECT_EQ(Read(0x1300U, 0U), 0U);
}

// A kernel that was not started answers 0800 0022h to all of these
TEST(NoObjectsTest, ADeviceWithoutSrdosHasNoSafetyObjects)
{
    Verifies(req::SRS_OBD_017);
    NoObjects none{};
    std::uint8_t byte = 7U;
    const Entry own{
        0x2000U, 1U, DataType::kUnsigned8, Access::kReadWrite, kInBoth, kInBoth, 1U, &byte, nullptr, nullptr, nullptr,
        nullptr, 0U};
    Dictionary dictionary{EntryTable{&own, 1U}, none};
    dictionary.SetNmtState(NmtState::kPreOperational);
    for (const std::uint16_t index :
         std::array<std::uint16_t, 6U>{0x1300U, 0x1301U, 0x1381U, 0x13FEU, 0x13FFU, 0x1000U})
    {
        EXPECT_EQ(dictionary.ReadNumber({index, 0U}).abort, SdoAbort::kObjectUnknown) << index;
        EXPECT_EQ(dictionary.WriteNumber({index, 0U}, 0U, 1U), SdoAbort::kObjectUnknown) << index;
        EXPECT_EQ(dictionary.MayWrite({index, 0U}, 1U), SdoAbort::kObjectUnknown) << index;
        EXPECT_EQ(dictionary.SizeOf({index, 0U}).abort, SdoAbort::kObjectUnknown) << index;
    }
    EXPECT_EQ(dictionary.ReadNumber({0x2000U, 0U}).abort, SdoAbort::kSubUnknown);
    EXPECT_EQ(dictionary.ReadNumber({0x2000U, 1U}).value, 7U);
}

} // namespace
} // namespace counterpoint::cia301
