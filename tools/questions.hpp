// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_QUESTIONS_HPP
#define TOOLS_QUESTIONS_HPP

#include "tools/command_line/options.hpp"

#include <istream>
#include <ostream>
#include <string>

namespace counterpoint::tools
{
/// What a command has to know and its options may not have told.
struct Question
{
    std::string option;   ///< Its name, such as "--node-id".
    std::string text;     ///< What a person is asked; what was expected, where nobody is there to ask.
    std::string if_empty; ///< The answer of who only presses Enter; empty: there is none.
    Problem problem{nullptr};
    bool is_needed{true}; ///< An empty answer is none.
};

/// Asks a person at a terminal, or nobody.
class Questions
{
  public:
    /// Both live longer. `in` is null where nobody is there.
    Questions(std::istream* in, std::ostream& out) noexcept;

    /// Whether a person is there.
    [[nodiscard]] bool IsAsking() const noexcept;
    /// The answer, which has no problem; asked again until it has none. Without a person the one of an empty answer.
    /// Throws std::runtime_error, which names the option, where there is no answer. [SRS_NEW_002]
    [[nodiscard]] std::string Ask(const Question& question);
    /// Asks where there is no answer yet.
    void Complete(std::string& answer, const Question& question);

  private:
    std::istream* in_;
    std::ostream& out_;
};
} // namespace counterpoint::tools

#endif // TOOLS_QUESTIONS_HPP
