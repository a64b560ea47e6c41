// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/questions.hpp"

#include "canopen/cia306/text/ini_document.hpp"

#include <stdexcept>

namespace counterpoint::tools
{
namespace
{
[[noreturn]] void Refuse(const Question& question)
{
    throw std::runtime_error(question.option + " is missing, expected: " + question.text);
}
} // namespace

Questions::Questions(std::istream* const in, std::ostream& out) noexcept : in_(in), out_(out)
{
}

bool Questions::IsAsking() const noexcept
{
    return in_ != nullptr;
}

std::string Questions::Ask(const Question& question)
{
    if (in_ == nullptr)
    {
        if (question.is_needed && question.if_empty.empty())
        {
            Refuse(question);
        }
        return question.if_empty;
    }
    std::string line;
    const std::string prompt = question.text + (question.if_empty.empty() ? "" : " [" + question.if_empty + "]") + ": ";
    while (out_ << prompt << std::flush && std::getline(*in_, line))
    {
        const std::string typed(cia306::Trimmed(line));
        const std::string answer = typed.empty() ? question.if_empty : typed;
        const bool is_none = answer.empty() && question.is_needed;
        const std::string wrong = answer.empty() || question.problem == nullptr ? "" : question.problem(answer);
        if (!is_none && wrong.empty())
        {
            return answer;
        }
        out_ << (is_none ? "  an answer is needed" : "  " + wrong) << "\n";
    }
    out_ << "\n";
    Refuse(question);
}

void Questions::Complete(std::string& answer, const Question& question)
{
    if (answer.empty())
    {
        answer = Ask(question);
    }
}
} // namespace counterpoint::tools
