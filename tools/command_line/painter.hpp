// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_COMMAND_LINE_PAINTER_HPP
#define TOOLS_COMMAND_LINE_PAINTER_HPP

#include <ostream>
#include <streambuf>
#include <string>

namespace counterpoint::tools
{
/// `text` with its errors in red, its warnings in yellow and the words of states in their colours.
[[nodiscard]] std::string Painted(const std::string& text);

/// Paints what is written to a stream of the program as long as it lives, where `file`, to which the stream writes, is
/// a terminal that knows colours, and the environment does not say NO_COLOR; elsewhere it changes nothing. A word that
/// two writes to an unbuffered stream are parted by stays as it is. [SRS_EASE_002]
class Painter final : private std::streambuf
{
  public:
    Painter(std::ostream& stream, int file);
    ~Painter() override;
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

  private:
    int_type overflow(int_type letter) override;
    int sync() override;
    [[nodiscard]] bool Write();

    std::ostream& stream_;
    std::streambuf* inner_{nullptr}; ///< Null: nothing is painted.
    std::string line_;
};
} // namespace counterpoint::tools

#endif // TOOLS_COMMAND_LINE_PAINTER_HPP
