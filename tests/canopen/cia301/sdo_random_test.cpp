// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/base/little_endian.hpp"
#include "tests/canopen/cia301/sdo_rig.hpp"
#include "verification/trace/ids/cia301.hpp"

#include <algorithm>
#include <memory>
#include <random>

namespace counterpoint::cia301
{
namespace
{

constexpr std::array<std::uint32_t, 31> kCodes{
    0x05030000U, 0x05040000U, 0x05040001U, 0x05040002U, 0x05040003U, 0x05040004U, 0x05040005U, 0x06010000U,
    0x06010001U, 0x06010002U, 0x06020000U, 0x06040041U, 0x06040042U, 0x06040043U, 0x06040047U, 0x06060000U,
    0x06070010U, 0x06070012U, 0x06070013U, 0x06090011U, 0x06090030U, 0x06090031U, 0x06090032U, 0x06090036U,
    0x060A0023U, 0x08000000U, 0x08000020U, 0x08000021U, 0x08000022U, 0x08000023U, 0x08000024U};

/// A server whose buffer stands alone on the heap, so that a sanitizer sees each byte beside it; the guards see the
/// writes without one.
class SdoRandomTest : public SdoRig
{
  public:
    static constexpr std::uint32_t kRoom = 40U;
    static constexpr std::uint32_t kGuard = 16U;

    SdoRandomTest()
    {
        std::fill(memory.get(), memory.get() + kRoom + 2U * kGuard, std::uint8_t{0xD7U});
        domain_length = 33U;
    }

    static void ExpectKnownAbort(const Octets& answer)
    {
        if (!answer.empty() && (answer[0] == 0x80U))
        {
            const auto code = static_cast<std::uint32_t>(FromLittleEndian(&answer[4], 4U));
            EXPECT_NE(std::find(kCodes.begin(), kCodes.end(), code), kCodes.end()) << std::hex << code;
        }
    }
    void ExpectGuards() const
    {
        for (std::uint32_t i = 0U; i < kGuard; ++i)
        {
            EXPECT_EQ(memory[i], 0xD7U);
            EXPECT_EQ(memory[kGuard + kRoom + i], 0xD7U);
        }
    }

    std::unique_ptr<std::uint8_t[]> memory{new std::uint8_t[kRoom + 2U * kGuard]};
    SdoServer small{SdoServerParts{dictionary, Room{memory.get() + kGuard, kRoom}, 1000U, 5U}};
};

/// Whether a request must be answered by a frame, told from what was said before.
class Expectation
{
  public:
    bool MayBeSilent(const SdoFrame& request) const
    {
        return ((request.bytes[0] & 0xE0U) == 0x80U) || is_block_download || is_upload_end;
    }
    void Follow(const Octets& answer)
    {
        if (!answer.empty())
        {
            const std::uint8_t head = answer[0];
            is_block_download = (head == 0xA4U) || ((head == 0xA2U) && is_block_download);
            is_upload_end = ((head & 0xE3U) == 0xC1U);
        }
    }

    bool is_block_download{false};
    bool is_upload_end{false};
};

SdoFrame RandomFrame(std::mt19937& source)
{
    SdoFrame frame{};
    for (std::uint8_t& byte : frame.bytes)
    {
        byte = static_cast<std::uint8_t>(source() & 0xFFU);
    }
    return frame;
}

TEST_F(SdoRandomTest, RandomFramesAreAnsweredAndStayInTheBuffer)
{
    Verifies(req::SRS_SDO_015);
    constexpr std::array<std::uint8_t, 24> kHeads{0x21U, 0x20U, 0x22U, 0x23U, 0x2FU, 0x40U, 0x60U, 0x70U,
                                                  0x00U, 0x10U, 0x01U, 0x11U, 0xA4U, 0xA0U, 0xA3U, 0xA2U,
                                                  0xA1U, 0xC6U, 0xC4U, 0xC2U, 0xC1U, 0xDDU, 0x80U, 0x02U};
    std::mt19937 source{20260731U};
    const auto random = [&source] { return static_cast<std::uint32_t>(source()); };
    Expectation expectation{};
    bool has_rest = false; // A time-out ended a sub-block: what may be its rest has no answer.
    int aborts = 0;
    int answers = 0;
    for (int i = 0; i < 400000; ++i)
    {
        SdoFrame request = RandomFrame(source);
        // Mostly commands that lead somewhere, and objects that exist
        const std::uint32_t kind = random() % 16U;
        request.bytes[0] = (kind < 10U) ? kHeads[random() % kHeads.size()] : request.bytes[0];
        request.bytes[0] = (kind >= 14U) ? static_cast<std::uint8_t>(random() % 6U) : request.bytes[0];
        if (random() % 4U != 0U)
        {
            request.bytes[1] = static_cast<std::uint8_t>((kind % 2U == 0U) ? 3U : (random() % 7U));
            request.bytes[2] = 0x21U;
            request.bytes[3] = static_cast<std::uint8_t>(random() % 3U);
            request.bytes[4] = static_cast<std::uint8_t>(random() % 50U);
            request.bytes[5] = request.bytes[6] = request.bytes[7] = 0U;
        }
        now_us += random() % 300U;
        const bool may_be_silent = expectation.MayBeSilent(request);
        const Octets answer = Plain(small.OnFrame(request, 8U, Instant{now_us}));
        const bool is_rest = has_rest && (((request.bytes[0] & 0x7FU) - 1U) < 5U);
        ASSERT_TRUE(may_be_silent || is_rest || !answer.empty()) << i << " " << int{request.bytes[0]};
        has_rest = is_rest && answer.empty() && (request.bytes[0] < 5U);
        ExpectKnownAbort(answer);
        aborts += (!answer.empty() && (answer[0] == 0x80U)) ? 1 : 0;
        answers += answer.empty() ? 0 : 1;
        expectation.Follow(answer);
        if (((request.bytes[0] & 0xE0U) == 0x80U) || answer.empty())
        {
            expectation.is_upload_end = false;
        }
        expectation = small.IsBusy() ? expectation : Expectation{};
        for (Octets more = Plain(small.Poll(Instant{now_us})); !more.empty(); more = Plain(small.Poll(Instant{now_us})))
        {
            ExpectKnownAbort(more);
            has_rest = has_rest || (expectation.is_block_download && (more[0] == 0x80U));
            expectation.Follow(more);
            if (!small.IsBusy())
            {
                expectation = Expectation{};
            }
        }
        domain_length = random() % 60U;
    }
    ExpectGuards();
    EXPECT_GT(aborts, 1000);
    EXPECT_GT(answers - aborts, 1000);
}

TEST_F(SdoRandomTest, AfterEveryRandomSequenceAnAbortMakesTheServerUsable)
{
    Verifies(req::SRS_SDO_015);
    std::mt19937 source{42U};
    for (int round = 0; round < 5000; ++round)
    {
        for (int i = 0; i < 10; ++i)
        {
            static_cast<void>(small.OnFrame(RandomFrame(source), 8U, Instant{now_us}));
            static_cast<void>(small.Poll(Instant{now_us}));
        }
        static_cast<void>(small.OnFrame(SdoFrame{{0x80U}}, 8U, Instant{now_us}));
        ASSERT_FALSE(small.IsBusy());
        const SdoFrame read{{0x40U, 0x00U, 0x10U, 0x00U}};
        ASSERT_EQ(Plain(small.OnFrame(read, 8U, Instant{now_us})).at(0), 0x43U);
    }
    ExpectGuards();
}

/// Every length around that of the buffer, which has 40 bytes: to its last byte and never beside it.
TEST_F(SdoRandomTest, DownloadsOfEveryLengthAroundTheBuffersStayInIt)
{
    Verifies(req::SRS_SDO_013);
    Verifies(req::SRS_SDO_015);
    for (const std::uint32_t head : {0x20U, 0xC0U})
    {
        for (std::uint32_t length = 1U; length <= 56U; ++length)
        {
            const std::uint32_t segments = (length + 6U) / 7U;
            const std::uint32_t unused = segments * 7U - length;
            domain_length = 0U;
            Octets answer =
                Plain(small.OnFrame(SdoFrame{{static_cast<std::uint8_t>(head), 0x03U, 0x21U}}, 8U, {now_us}));
            for (std::uint32_t i = 0U; (i < segments) && (answer.empty() || (answer[0] != 0x80U)); ++i)
            {
                const bool is_last = (i + 1U) == segments;
                const std::uint32_t ordinary = ((i % 2U) << 4U) | (is_last ? ((unused << 1U) | 1U) : 0U);
                const std::uint32_t block = ((i % 5U) + 1U) | (is_last ? 0x80U : 0U);
                SdoFrame segment{{0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}};
                segment.bytes[0] = static_cast<std::uint8_t>((head == 0x20U) ? ordinary : block);
                answer = Plain(small.OnFrame(segment, 8U, Instant{now_us}));
            }
            if ((head == 0xC0U) && (answer.at(0) != 0x80U))
            {
                const SdoFrame end{{static_cast<std::uint8_t>(0xC1U | (unused << 2U))}};
                answer = Plain(small.OnFrame(end, 8U, Instant{now_us}));
            }
            ExpectGuards();
            EXPECT_FALSE(small.IsBusy());
            EXPECT_EQ(domain_length, (length <= 40U) ? length : 0U);
            EXPECT_EQ(answer == AbortOf(0x2103U, 0U, 0x05040005U), length > 40U) << length;
        }
    }
}

/// Lossy bus: every length from 0 to 40 arrives unharmed in both directions by blocks although segments vanish.
TEST_F(SdoRandomTest, BlocksArriveThroughALossyBus)
{
    Verifies(req::SRS_SDO_006);
    Verifies(req::SRS_SDO_007);
    std::mt19937 source{7U};
    const auto random = [&source] { return static_cast<std::uint32_t>(source()); };
    for (std::uint32_t length = 1U; length <= kRoom; ++length)
    {
        domain_length = length;
        const SdoFrame begin{{0xA4U, 0x03U, 0x21U, 0x00U, 3U}};
        ASSERT_EQ(Plain(small.OnFrame(begin, 8U, Instant{now_us})).at(0), 0xC6U);
        Octets received{};
        SdoFrame request{{0xA3U}};
        Octets end{};
        while (end.empty())
        {
            std::uint8_t expected = 1U;
            for (Octets segment = Plain(small.OnFrame(request, 8U, Instant{now_us})); !segment.empty();
                 segment = Plain(small.Poll(Instant{now_us})))
            {
                if ((segment[0] & 0xE3U) == 0xC1U && request.bytes[0] == 0xA2U && received.size() >= length)
                {
                    end = segment;
                }
                else if (((segment[0] & 0x7FU) == expected) && (random() % 4U != 0U))
                {
                    received.insert(received.end(), segment.begin() + 1, segment.end());
                    ++expected;
                }
            }
            request = SdoFrame{{0xA2U, static_cast<std::uint8_t>(expected - 1U), 3U}};
        }
        received.resize(length);
        ASSERT_TRUE(std::equal(received.begin(), received.end(), domain.begin()));
        ASSERT_TRUE(Plain(small.OnFrame(SdoFrame{{0xA1U}}, 8U, Instant{now_us})).empty());
        ASSERT_FALSE(small.IsBusy());
    }
}

} // namespace
} // namespace counterpoint::cia301
