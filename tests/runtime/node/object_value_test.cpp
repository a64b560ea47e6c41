// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Values that no file gives an object.
#include "runtime/node/object_value.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace counterpoint::runtime
{
namespace
{
/// Has one number, as the kernel has a mapped variable.
class OneNumber final : public cia301::ForeignObjects
{
  public:
    explicit OneNumber(const std::uint32_t bits) : bits_(bits)
    {
    }
    [[nodiscard]] ObjectReading Read(const ObjectAddress& address) noexcept override
    {
        static_cast<void>(address);
        ObjectReading reading{};
        reading.abort = AbortCode::kNone;
        reading.data.size_bytes = 4U;
        for (std::uint32_t byte = 0U; byte < 4U; ++byte)
        {
            reading.data.bytes[byte] = static_cast<std::uint8_t>(bits_ >> (8U * byte));
        }
        return reading;
    }
    [[nodiscard]] AbortCode Write(const ObjectAddress& address, const ObjectData& data) noexcept override
    {
        static_cast<void>(address);
        static_cast<void>(data);
        return AbortCode::kReadOnly;
    }

  private:
    std::uint32_t bits_;
};

ObjectValue StringOf(std::vector<std::uint8_t> bytes, const cia301::DataType type, const bool has_place = true)
{
    const auto size = static_cast<std::uint32_t>(bytes.size());
    const cia301::Entry entry{0x2000U,
                              0U,
                              type,
                              cia301::Access::kReadWrite,
                              cia301::kInBoth,
                              cia301::kInBoth,
                              size,
                              has_place ? bytes.data() : nullptr,
                              nullptr,
                              nullptr,
                              nullptr,
                              nullptr};
    OneNumber foreign(0U);
    cia301::Dictionary dictionary({&entry, 1U}, foreign);
    return ValueOf({}, dictionary, {0x2000U, 0U});
}

std::string WideText(const std::vector<std::uint8_t>& bytes)
{
    return StringOf(bytes, cia301::DataType::kUnicodeString).text;
}

TEST(ObjectValue, HalfOfAWideCharacterIsACharacterThatNobodyKnows)
{
    Verifies(req::SRS_NODE_552);
    EXPECT_EQ(WideText({0x41U, 0x00U, 0xFCU, 0x00U, 0xACU, 0x20U}), "'A\xC3\xBC\xE2\x82\xAC'");
    EXPECT_EQ(WideText({0x34U, 0xD8U, 0x1EU, 0xDDU}), "'\xF0\x9D\x84\x9E'");
    EXPECT_EQ(WideText({0x34U, 0xD8U, 0x34U, 0xD8U, 0x41U, 0x00U}), "'\xEF\xBF\xBD\xEF\xBF\xBD"
                                                                    "A'");
    EXPECT_EQ(WideText({0x1EU, 0xDDU, 0x41U, 0x00U}), "'\xEF\xBF\xBD"
                                                      "A'");
    EXPECT_EQ(WideText({0x41U, 0x00U, 0x34U, 0xD8U, 0x41U}), "'A\xEF\xBF\xBD'");
}

TEST(ObjectValue, WithoutAValueIsTheReason)
{
    Verifies(req::SRS_NODE_552);
    EXPECT_EQ(StringOf({1U}, cia301::DataType::kOctetString, false).abort, cia301::SdoAbort::kGeneral);
    EXPECT_EQ(StringOf({1U, 2U}, cia301::DataType::kDomain).text, "2 bytes: 01 02");
    EXPECT_EQ(StringOf({1U, 2U}, cia301::DataType::kDomain).details.dump(), R"({"value":"01 02","size_bytes":2})");
    EXPECT_EQ(StringOf({0x41U}, cia301::DataType::kVisibleString).details.dump(), R"({"value":"A","size_bytes":1})");
}

TEST(ObjectValue, OfTheKernelHasTheTypeOfTheFile)
{
    Verifies(req::SRS_NODE_552);
    const auto value_of = [](const std::uint16_t type, const std::uint32_t bits)
    {
        OneNumber kernels(bits);
        cia301::Dictionary dictionary({nullptr, 0U}, kernels);
        cia306::Device file;
        cia306::Entry entry;
        entry.index = 0x2000U;
        entry.data_type = type;
        entry.type = cia306::DataTypeOf(type);
        file.objects[0x2000U].entries[0U] = entry;
        const ObjectValue value = ValueOf(file, dictionary, {0x2000U, 0U});
        return value.text + " " + value.details.dump();
    };
    EXPECT_EQ(value_of(0x0008U, 0x3FC00000U), R"(1.5 {"value":1.5})");
    EXPECT_EQ(value_of(0x0008U, 0x3DCCCCCDU), R"(0.1 {"value":0.1})");
    EXPECT_EQ(value_of(0x0008U, 0xFF800000U), R"(-inf {"value":"-inf"})");
    EXPECT_EQ(value_of(0x0007U, 0x3FC00000U), R"(1069547520 {"value":1069547520})");
}
} // namespace
} // namespace counterpoint::runtime
