// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The safety configuration in a store: what comes back valid, and what is refused.
#include "canopen/cia301/store/stored_parts.hpp"
#include "tests/canopen/cia301/cut_memory.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/store.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <cstdint>
#include <utility>

namespace counterpoint::cia301
{
namespace
{

using StoredSafetyTest = Rig;

TEST_F(StoredSafetyTest, TheKernelsConfigurationComesBackValid)
{
    Verifies(req::SRS_STO_012);
    // Given a kernel with a valid configuration that is stored
    Configure();
    std::array<std::uint8_t, 64> scratch{};
    CutMemory memory{8192U};
    StoredSafety safety{kernel};
    std::array<StoredPart*, 1> parts{&safety};
    ParameterStore store{StoreParts{memory, parts.data(), 1U, Room{scratch.data(), 64U}}};
    EXPECT_EQ(store.Begin({StoreAction::kSave, kAllGroups}), SdoAbort::kPending);
    for (int i = 0; (i < 3000) && store.IsBusy(); ++i)
    {
        store.OnCycle();
    }
    EXPECT_EQ(store.Continue({StoreAction::kSave, kAllGroups}), SdoAbort::kNone);
    // When it is changed, and loaded again
    EXPECT_EQ(kernel.Image().RestoreDefaults(), Result::kSuccessful);
    EXPECT_NE(Read(0x13FEU, 0U), 0xA5U);
    const LoadReport report = store.Load(kCommunicationGroup);
    // Then the kernel declares it valid
    EXPECT_EQ(report.refused, 0U);
    EXPECT_GT(report.loaded, 3U);
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    // A set of another device leaves the power-on configuration
    const std::uint8_t foreign[10] = {0U, 1U, 0U, 0U, 0U, 9U, 9U, 9U, 9U, 0xA5U};
    safety.BeginLoad(kAllGroups);
    EXPECT_TRUE(safety.LoadItem({foreign, 10U}));
    EXPECT_FALSE(safety.LoadItem({foreign, 4U}));
    EXPECT_FALSE(safety.EndLoad(kAllGroups));
    EXPECT_NE(Read(0x13FEU, 0U), 0xA5U);
}

// t [cycles]   0 save of SCT 50 ms     moment: 60 ms, signed, A5h     end
TEST_F(StoredSafetyTest, ASaveWithinWhichTheConfigurationChangesIsRefused)
{
    Verifies(req::SRS_STO_019);
    Verifies(req::SRS_STO_005);
    Configure();
    std::array<std::uint8_t, 64> scratch{};
    CutMemory memory{8192U};
    StoredSafety safety{kernel};
    std::array<StoredPart*, 1> parts{&safety};
    ParameterStore store{StoreParts{memory, parts.data(), 1U, Room{scratch.data(), 64U}}};
    const auto write = [this](const std::uint32_t sct_ms)
    {
        EXPECT_EQ(Write(0x1301U, 2U, sct_ms, 2U), AbortCode::kNone);
        const SignReply reply = kernel.Sign(CommunicationIndex{0x1301U});
        EXPECT_EQ(Write(0x13FFU, 1U, reply.signature, 2U), AbortCode::kNone);
        EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    };
    std::uint32_t saved_ms = 0U;
    int refused = 0;
    int changes = 0;
    for (int moment = 0; moment < 3000; ++moment)
    {
        SCOPED_TRACE(moment);
        const std::uint32_t before_ms = 50U + static_cast<std::uint32_t>(moment % 2);
        write(before_ms);
        EXPECT_EQ(store.Begin({StoreAction::kSave, kAllGroups}), SdoAbort::kPending);
        bool is_changed = false;
        for (int i = 0; (i < 3000) && store.IsBusy(); ++i)
        {
            if (i == moment)
            {
                write(60U);
                is_changed = true;
            }
            store.OnCycle();
        }
        const SdoAbort answer = store.Continue({StoreAction::kSave, kAllGroups});
        const std::uint32_t last_ms = saved_ms;
        // Then an answer of success means a set that loads, and a refusal leaves the one before
        EXPECT_TRUE((answer == SdoAbort::kNone) || (answer == SdoAbort::kDeviceState));
        EXPECT_EQ(kernel.Image().RestoreDefaults(), Result::kSuccessful);
        const LoadReport report = store.Load(kCommunicationGroup);
        EXPECT_NE(report.finding, StoreFinding::kRefused);
        EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
        saved_ms = Read(0x1301U, 2U);
        EXPECT_TRUE((answer == SdoAbort::kNone) ? ((saved_ms == before_ms) || (is_changed && (saved_ms == 60U)))
                                                : (saved_ms == last_ms));
        refused += (answer == SdoAbort::kNone) ? 0 : 1;
        if (!is_changed)
        {
            break; // Every moment of a save was tried.
        }
        ++changes;
    }
    EXPECT_GT(refused, 3);
    EXPECT_GT(changes, refused);
}

// 50 ms, 60 ms while the values are read, and 50 ms again: neither the first nor the last look sees it.
TEST_F(StoredSafetyTest, AChangeThatIsTakenBackBeforeTheEndIsFound)
{
    Verifies(req::SRS_STO_019);
    Configure();
    std::array<std::uint8_t, 64> scratch{};
    const Room room{scratch.data(), 64U};
    StoredSafety safety{kernel};
    const std::uint32_t items = safety.ItemCount();
    for (std::uint32_t i = 0U; i < items; ++i)
    {
        const std::uint32_t sct_ms = (i == 1U) ? 60U : 50U;
        EXPECT_EQ(Write(0x1301U, 2U, sct_ms, 2U), AbortCode::kNone);
        EXPECT_EQ(safety.Item(i, room).abort, SdoAbort::kNone);
    }
    EXPECT_EQ(Write(0x1301U, 2U, 50U, 2U), AbortCode::kNone);
    const SignReply reply = kernel.Sign(CommunicationIndex{0x1301U});
    EXPECT_EQ(Write(0x13FFU, 1U, reply.signature, 2U), AbortCode::kNone);
    EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    EXPECT_EQ(safety.EndSave(kAllGroups), SdoAbort::kDeviceState);
    // A save of other groups does not mind
    EXPECT_EQ(safety.EndSave(kApplicationGroup), SdoAbort::kNone);
}

// 1300h may be written while 13FEh is A5h, and stays in force; with 5F04h the next start would refuse it.
TEST_F(StoredSafetyTest, AConfigurationThatTheNextStartWouldRefuseIsNotSaved)
{
    Verifies(req::SRS_STO_021);
    Configure();
    config.digest = kernel.Digest().digest;
    std::array<std::uint8_t, 64> scratch{};
    CutMemory memory{8192U};
    StoredSafety safety{kernel};
    std::array<StoredPart*, 1> parts{&safety};
    ParameterStore store{StoreParts{memory, parts.data(), 1U, Room{scratch.data(), 64U}}};
    const auto save = [&store](const std::uint8_t groups = kAllGroups)
    {
        EXPECT_EQ(store.Begin({StoreAction::kSave, groups}), SdoAbort::kPending);
        for (int i = 0; (i < 3000) && store.IsBusy(); ++i)
        {
            store.OnCycle();
        }
        return store.Continue({StoreAction::kSave, groups});
    };
    EXPECT_EQ(save(), SdoAbort::kNone);
    const std::uint32_t gfc = Read(0x1300U, 0U);
    EXPECT_EQ(Write(0x1300U, 0U, 1U - gfc, 1U), AbortCode::kNone);
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    // Then it is refused, and the set before is still there; of the communication group alone, too, and of no other
    EXPECT_EQ(save(), SdoAbort::kDeviceState);
    EXPECT_EQ(save(kCommunicationGroup), SdoAbort::kDeviceState);
    EXPECT_EQ(static_cast<std::uint32_t>(SdoAbort::kDeviceState), 0x08000022U);
    EXPECT_EQ(save(kApplicationGroup), SdoAbort::kNone);
    EXPECT_EQ(kernel.Image().RestoreDefaults(), Result::kSuccessful);
    EXPECT_NE(store.Load(kCommunicationGroup).finding, StoreFinding::kRefused);
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    EXPECT_EQ(Read(0x1300U, 0U), gfc);
    // One that is not valid is nothing that a start could refuse, and without an expected digest there is nothing to be
    EXPECT_EQ(Write(0x1300U, 0U, 1U - gfc, 1U), AbortCode::kNone);
    EXPECT_EQ(Write(0x13FEU, 0U, 0U, 1U), AbortCode::kNone);
    EXPECT_EQ(save(), SdoAbort::kNone);
    config.digest = 0U;
    EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    EXPECT_EQ(save(), SdoAbort::kNone);
    EXPECT_NE(store.Load(kCommunicationGroup).finding, StoreFinding::kRefused);
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    EXPECT_EQ(Read(0x1300U, 0U), 1U - gfc);
}

TEST_F(StoredSafetyTest, AfterALostSetTheDeviceDoesNotComeUpWithA5)
{
    Verifies(req::SRS_STO_014);
    // Given a valid configuration that was saved twice
    Configure();
    std::array<std::uint8_t, 64> scratch{};
    CutMemory memory{8192U};
    StoredSafety safety{kernel};
    std::array<StoredPart*, 1> parts{&safety};
    ParameterStore store{StoreParts{memory, parts.data(), 1U, Room{scratch.data(), 64U}}};
    for (int save = 0; save < 2; ++save)
    {
        EXPECT_EQ(store.Begin({StoreAction::kSave, kAllGroups}), SdoAbort::kPending);
        for (int i = 0; (i < 3000) && store.IsBusy(); ++i)
        {
            store.OnCycle();
        }
        EXPECT_EQ(store.Continue({StoreAction::kSave, kAllGroups}), SdoAbort::kNone);
    }
    // When a bit of the newer set changes, and the defaults of the device are valid
    memory.banks[1][77] ^= 0x20U;
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    // Then another group is loaded as ever, and with the communication group 13FEh is withdrawn
    EXPECT_EQ(store.Load(kApplicationGroup).finding, StoreFinding::kLost);
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    EXPECT_EQ(store.Load(kCommunicationGroup).finding, StoreFinding::kLost);
    EXPECT_EQ(Read(0x13FEU, 0U), 0U);
}

TEST_F(StoredSafetyTest, AConfigurationThatTheKernelDoesNotGiveIsNotLeftOutOfASet)
{
    Verifies(req::SRS_STO_210);
    Configure();
    kernel.Stop();
    std::array<std::uint8_t, 64> scratch{};
    StoredSafety safety{kernel};
    EXPECT_EQ(safety.ItemCount(), 1U);
    EXPECT_EQ(safety.Item(0U, {scratch.data(), 64U}).abort, SdoAbort::kDeviceState);
    EXPECT_EQ(safety.Item(0U, {scratch.data(), 64U}).group, kCommunicationGroup);
    // When that group is saved, then it is refused; another one is not
    std::array<std::uint8_t, 64> room{};
    CutMemory memory{8192U};
    std::array<StoredPart*, 1> parts{&safety};
    ParameterStore store{StoreParts{memory, parts.data(), 1U, Room{room.data(), 64U}}};
    for (const auto& [group, told] :
         {std::pair(kCommunicationGroup, SdoAbort::kDeviceState), std::pair(kApplicationGroup, SdoAbort::kNone)})
    {
        const StoreRequest save{StoreAction::kSave, group};
        SdoAbort answer = store.Begin(save);
        for (int i = 0; (i < 3000) && (answer == SdoAbort::kPending); ++i)
        {
            store.OnCycle();
            answer = store.Continue(save);
        }
        EXPECT_EQ(answer, told);
    }
    EXPECT_EQ(static_cast<std::uint32_t>(SdoAbort::kDeviceState), 0x08000022U);
}

} // namespace
} // namespace counterpoint::cia301
