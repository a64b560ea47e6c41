// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/html_text.hpp"
#include "simulator/judge/sweep.hpp"
#include "simulator/report/page_parts.hpp"
#include "simulator/scenario/names.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>

// The plot of a sweep: time to the safe output over the first key, one line for each combination of the others, the
// limit as a line of its own. Drawn here, so that the page needs neither network nor script. [SRS_SIM_051]
namespace counterpoint::simulator
{
namespace
{
constexpr double kWidth = 1100.0;
constexpr double kHeight = 460.0;
constexpr double kLeft = 74.0;
constexpr double kRight = 24.0;
constexpr double kTop = 30.0;
constexpr double kBottom = 54.0;
constexpr int kTicks = 6;
constexpr const char* kColours[] = {"var(--normal)", "var(--inverse)", "var(--srvt)", "var(--released)",
                                    "var(--waiting)"};

std::string Number(const double value, const int digits)
{
    std::array<char, 64U> text{};
    static_cast<void>(std::snprintf(text.data(), text.size(), "%.*f", digits, value));
    return text.data();
}

double Milliseconds(const Nanoseconds time)
{
    return static_cast<double>(time) / static_cast<double>(kNanosecondsPerMillisecond);
}

/// The least of 1, 2, 5 times a power of ten that gives few enough ticks.
double TickStep(const double span)
{
    double step = 1e-6;
    const std::array<double, 3U> factors{2.0, 2.5, 2.0};
    for (std::size_t turn = 0U; span / step > kTicks; ++turn)
    {
        step *= factors.at(turn % factors.size());
    }
    return step;
}

class Plot
{
  public:
    explicit Plot(const SweepResult& result) : result_(result)
    {
        const SweepAxis& axis = result.axes.front();
        x_from_ = XOf(axis.values.front());
        x_to_ = XOf(axis.values.back());
        if (x_to_ <= x_from_)
        {
            x_from_ -= 1.0;
            x_to_ += 1.0;
        }
        for (const SweepRow& row : result.rows)
        {
            if (row.measurement)
            {
                y_to_ = std::max({y_to_, Milliseconds(row.measurement->limit), Milliseconds(row.measurement->elapsed)});
                series_[{row.places.begin() + 1, row.places.end()}].push_back(&row);
            }
        }
        y_to_ *= 1.08;
    }

    [[nodiscard]] std::string Draw() const
    {
        std::string svg = "<svg viewBox=\"0 0 " + Number(kWidth, 0) + " " + Number(kHeight, 0) +
                          "\" role=\"img\" aria-label=\"Time to the safe output\">\n" + Grid();
        std::size_t number = 0U;
        for (const auto& [places, rows] : series_)
        {
            svg += Line(rows, true, "var(--faulted)") + Line(rows, false, kColours[number % std::size(kColours)]);
            for (const SweepRow* const row : rows)
            {
                svg += Point(*row, kColours[number % std::size(kColours)]);
            }
            ++number;
        }
        return svg + "</svg>\n";
    }

    [[nodiscard]] std::string Legend() const
    {
        std::string text = "<p class=\"legend\"><span style=\"color:var(--faulted)\">&#9473; limit</span>";
        std::size_t number = 0U;
        for (const auto& [places, rows] : series_)
        {
            std::string name;
            for (std::size_t axis = 1U; axis < result_.axes.size(); ++axis)
            {
                name += (name.empty() ? "" : ", ") + result_.axes[axis].path + " = " +
                        result_.axes[axis].Text(places[axis - 1U]);
            }
            text += " <span style=\"color:" + std::string(kColours[number % std::size(kColours)]) + "\">&#9679; " +
                    cia306::HtmlText(name.empty() ? "time to the safe output" : name) + "</span>";
            ++number;
        }
        return text + "</p>\n";
    }

  private:
    [[nodiscard]] double XOf(const std::int64_t value) const
    {
        return result_.axes.front().is_time ? Milliseconds(value) : static_cast<double>(value);
    }
    [[nodiscard]] double X(const double value) const
    {
        return kLeft + (value - x_from_) / (x_to_ - x_from_) * (kWidth - kLeft - kRight);
    }
    [[nodiscard]] double Y(const double value) const
    {
        return kHeight - kBottom - value / y_to_ * (kHeight - kTop - kBottom);
    }

    [[nodiscard]] std::string Text(const double x, const double y, const char* const anchor,
                                   const std::string& text) const
    {
        return "<text x=\"" + Number(x, 1) + "\" y=\"" + Number(y, 1) + "\" text-anchor=\"" + anchor + "\">" +
               cia306::HtmlText(text) + "</text>\n";
    }

    [[nodiscard]] std::string Rule(const double x1, const double y1, const double x2, const double y2) const
    {
        return "<line class=\"grid\" x1=\"" + Number(x1, 1) + "\" y1=\"" + Number(y1, 1) + "\" x2=\"" + Number(x2, 1) +
               "\" y2=\"" + Number(y2, 1) + "\"/>\n";
    }

    [[nodiscard]] std::string Grid() const
    {
        std::string svg;
        const double y_step = TickStep(y_to_);
        for (double tick = 0.0; tick <= y_to_; tick += y_step)
        {
            svg += Rule(kLeft, Y(tick), kWidth - kRight, Y(tick)) +
                   Text(kLeft - 8.0, Y(tick) + 4.0, "end", Number(tick, (y_step < 1.0) ? 3 : 0));
        }
        const double x_step = TickStep(x_to_ - x_from_);
        const auto first = static_cast<std::int64_t>(x_from_ / x_step) - 1;
        for (std::int64_t number = first; static_cast<double>(number) * x_step <= x_to_ + x_step * 1e-6; ++number)
        {
            const double tick = static_cast<double>(number) * x_step;
            if (tick >= x_from_ - x_step * 1e-6)
            {
                svg += Rule(X(tick), kTop, X(tick), kHeight - kBottom) +
                       Text(X(tick), kHeight - kBottom + 18.0, "middle", Number(tick, (x_step < 1.0) ? 3 : 0));
            }
        }
        const SweepAxis& axis = result_.axes.front();
        return svg + Text(kLeft, kTop - 12.0, "start", "time to the safe output / ms") +
               Text(kWidth - kRight, kHeight - 12.0, "end", axis.path + (axis.is_time ? " / ms" : ""));
    }

    [[nodiscard]] std::string Line(const std::vector<const SweepRow*>& rows, const bool is_limit,
                                   const char* const colour) const
    {
        std::string points;
        for (const SweepRow* const row : rows)
        {
            const Nanoseconds value = is_limit ? row->measurement->limit : row->measurement->elapsed;
            if (value >= 0)
            {
                points += Number(X(XOf(result_.axes.front().values[row->places.front()])), 1) + "," +
                          Number(Y(Milliseconds(value)), 1) + " ";
            }
        }
        return "<polyline fill=\"none\" stroke=\"" + std::string(colour) + "\" stroke-width=\"" +
               (is_limit ? "2" : "1") + "\" points=\"" + points + "\"/>\n";
    }

    [[nodiscard]] std::string Point(const SweepRow& row, const char* const colour) const
    {
        const Measurement& measurement = *row.measurement;
        const bool is_safe = measurement.elapsed >= 0;
        const double y = is_safe ? Y(Milliseconds(measurement.elapsed)) : kTop;
        const std::string x = Number(X(XOf(result_.axes.front().values[row.places.front()])), 1);
        const std::string text = result_.axes.front().Text(row.places.front()) + ": " +
                                 (is_safe ? MillisecondsText(measurement.elapsed) : "never safe") + " of " +
                                 LimitText(measurement.limit) + ", " + Name(measurement.detection.party) + " " +
                                 measurement.detection.cause;
        return "<circle cx=\"" + x + "\" cy=\"" + Number(y, 1) + "\" r=\"" + (row.holds ? "3" : "5") + "\" fill=\"" +
               (row.holds ? colour : "var(--faulted)") + "\"><title>" + cia306::HtmlText(text) + "</title></circle>\n";
    }

    const SweepResult& result_;
    double x_from_{0.0};
    double x_to_{1.0};
    double y_to_{1.0};
    std::map<std::vector<std::size_t>, std::vector<const SweepRow*>> series_;
};

std::string Table(const SweepResult& result)
{
    std::string html = "<table>\n<thead><tr>";
    for (const SweepAxis& axis : result.axes)
    {
        html += "<th class=\"num\">" + cia306::HtmlText(axis.path) + "</th>";
    }
    html += "<th>Detected by</th><th>Cause</th><th class=\"num\">Detection</th><th class=\"num\">Safe after</th>"
            "<th class=\"num\">Limit</th><th>Verdict</th></tr></thead>\n<tbody>\n";
    for (const SweepRow& row : result.rows)
    {
        html += "<tr>";
        for (std::size_t axis = 0U; axis < result.axes.size(); ++axis)
        {
            html += "<td class=\"num\">" + result.axes[axis].Text(row.places[axis]) + "</td>";
        }
        const auto time = [](const Nanoseconds value, const char* const none)
        { return "<td class=\"num\">" + ((value < 0) ? std::string(none) : MillisecondsText(value)) + "</td>"; };
        const Measurement none{};
        const Measurement& measurement = row.measurement ? *row.measurement : none;
        html += "<td>" + std::string(row.measurement ? Name(measurement.detection.party) : "") + "</td><td>" +
                cia306::HtmlText(measurement.detection.cause) + "</td>" + time(row.DetectionTime(), "") +
                time(measurement.elapsed, row.measurement ? "never" : "") +
                time(row.measurement ? measurement.limit : -1, "");
        html += std::string("<td><span class=\"pill ") + (row.holds ? "good\">holds" : "bad\">FAILED") + "</span> " +
                cia306::HtmlText(row.failure) + "</td></tr>\n";
    }
    return html + "</tbody>\n</table>\n";
}
} // namespace

std::string SweepHtml(const SweepResult& result)
{
    const auto held =
        std::count_if(result.rows.begin(), result.rows.end(), [](const SweepRow& row) { return row.holds; });
    const Plot plot(result);
    const std::string title = cia306::HtmlText(result.title.empty() ? "Counterpoint sweep" : result.title);
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
           title + "</title>\n<style>\n" + kPageCss +
           "tbody tr { cursor: auto; }\n</style>\n</head>\n<body>\n<header>\n<h1>" + title +
           "</h1>\n<p class=\"lead\">" + cia306::HtmlText(result.scenario) +
           (result.profile.empty() ? "" : ", profile " + result.profile) + ": " + std::to_string(held) + " of " +
           std::to_string(result.rows.size()) +
           " runs hold. The limit is computed from the device's configuration.</p>\n</header>\n" +
           "<main>\n<section>\n" + plot.Draw() + plot.Legend() + "</section>\n" + Table(result) +
           "</main>\n</body>\n</html>\n";
}
} // namespace counterpoint::simulator
