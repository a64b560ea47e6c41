// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_SELFTEST_VOICE_HPP
#define VERIFICATION_TARGET_SELFTEST_VOICE_HPP

#include <cstdint>

/// The border between channels in small: an abstract class, structs by reference and by value.
namespace counterpoint::target
{

struct Note
{
    std::uint32_t pitch;
    std::uint64_t mask;
    std::uint8_t bytes[4];
};

class Voice
{
  public:
    [[nodiscard]] virtual Note Answer(const Note& note) noexcept = 0;

    Voice(const Voice&) = delete;
    Voice(Voice&&) = delete;
    Voice& operator=(const Voice&) = delete;
    Voice& operator=(Voice&&) = delete;

  protected:
    Voice() noexcept = default;
    ~Voice() noexcept = default;
};

/// Compiled by Clang; what calls it is compiled by GCC.
class ClangVoice final : public Voice
{
  public:
    explicit ClangVoice(const Note& first) noexcept;
    [[nodiscard]] Note Answer(const Note& note) noexcept override;

  private:
    Note kept_;
};

} // namespace counterpoint::target

#endif
