// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/dictionary/dictionary.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/cia301.hpp"

namespace counterpoint::cia301
{
namespace
{

class KernelObjectsTest : public Rig
{
};

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

} // namespace
} // namespace counterpoint::cia301
