// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/command_line/painter.hpp"

#include <cctype>
#include <cstdlib>
#include <unistd.h>

namespace counterpoint::tools
{
namespace
{
constexpr const char* kRed = "\033[31m";
constexpr const char* kYellow = "\033[33m";
constexpr const char* kGreen = "\033[32m";
constexpr const char* kPlain = "\033[0m";

struct PaintedWord
{
    const char* text;
    const char* colour;
};

/// A word stands alone: pre-operational is not operational.
constexpr PaintedWord kWords[] = {
    {"error:", kRed},        {"warning:", kYellow},       {"FAILED", kRed},     {"in time", kGreen},
    {"as expected", kGreen}, {"faulted", kRed},           {"waiting", kYellow}, {"released", kGreen},
    {"operational", kGreen}, {"device safe state", kRed},
};

bool IsOfAWord(const char letter)
{
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' || letter == '-';
}

bool StandsAt(const std::string& text, const std::size_t place, const std::string& word)
{
    const std::size_t end = place + word.size();
    const bool begins = place == 0U || !IsOfAWord(text[place - 1U]);
    return begins && text.compare(place, word.size(), word) == 0 && (end >= text.size() || !IsOfAWord(text[end]));
}

bool IsColourful(const int file)
{
    const char* const refusal = std::getenv("NO_COLOR");
    const char* const terminal = std::getenv("TERM");
    const bool is_refused = refusal != nullptr && *refusal != '\0';
    const bool is_able = terminal != nullptr && *terminal != '\0' && std::string(terminal) != "dumb";
    return !is_refused && is_able && ::isatty(file) == 1;
}
} // namespace

std::string Painted(const std::string& text)
{
    std::string painted;
    std::size_t place = 0U;
    while (place < text.size())
    {
        const PaintedWord* found = nullptr;
        for (const PaintedWord& word : kWords)
        {
            found = StandsAt(text, place, word.text) ? &word : found;
        }
        const std::string piece = (found == nullptr) ? std::string(1U, text[place]) : found->text;
        painted += (found == nullptr) ? piece : found->colour + piece + kPlain;
        place += piece.size();
    }
    return painted;
}

Painter::Painter(std::ostream& stream, const int file) : stream_(stream)
{
    if (IsColourful(file))
    {
        inner_ = stream_.rdbuf(this);
    }
}

Painter::~Painter()
{
    if (inner_ != nullptr)
    {
        static_cast<void>(Write());
        static_cast<void>(stream_.rdbuf(inner_)); // Forgets a failure, which RunProgram has looked at before.
    }
}

Painter::int_type Painter::overflow(const int_type letter)
{
    if (traits_type::eq_int_type(letter, traits_type::eof()))
    {
        return traits_type::not_eof(letter);
    }
    line_ += traits_type::to_char_type(letter);
    return (line_.back() != '\n' || Write()) ? letter : traits_type::eof();
}

int Painter::sync()
{
    const bool is_written = Write();
    return (is_written && inner_->pubsync() == 0) ? 0 : -1;
}

bool Painter::Write()
{
    const std::string painted = Painted(line_);
    line_.clear();
    const auto size = static_cast<std::streamsize>(painted.size());
    return inner_->sputn(painted.data(), size) == size;
}
} // namespace counterpoint::tools
