// SPDX-License-Identifier: Apache-2.0
// Coverage as a page: a table of the files, then each with its counts, coloured by lines. No script
// and no network; it prints, and follows the reader's light or dark scheme.

#include <algorithm>

#include <fmt/format.h>

#include "interpreter/coverage/source_coverage.h"
#include "interpreter/support/markup.h"

namespace jaywalk {
namespace {

constexpr std::string_view kHead = R"page(<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Coverage of {0}</title>
<style>
:root {{ color-scheme: light dark; --text: #1b1f24; --paper: #fff; --quiet: #667; --line: #d5d9e0;
  --full: #d9f2dd; --part: #fff0c2; --none: #ffd9d6; --bar: #2f9e44; --shade: rgb(27 31 36 / .4); }}
@media (prefers-color-scheme: dark) {{ :root {{ --text: #e4e7eb; --paper: #14171b; --quiet: #99a;
  --line: #333a44; --full: #16351e; --part: #453a10; --none: #4d1f1c; --bar: #51cf66;
  --shade: rgb(228 231 235 / .4); }} }}
body {{ margin: 1.5rem auto; max-width: 76rem; padding: 0 1rem; background: var(--paper);
  color: var(--text); font: 15px/1.5 system-ui, sans-serif;
  /* The colours are the message: browsers leave backgrounds out of print unless told otherwise. */
  -webkit-print-color-adjust: exact; print-color-adjust: exact; }}
.subject {{ font-weight: 600; overflow-wrap: anywhere; }}
h1 {{ font-size: 1.5rem; }} h2 {{ font-size: 1.1rem; margin-top: 2.5rem; overflow-wrap: anywhere; }}
/* A shade at each side where the table goes on; strips of the page's colour that scroll with the table
   cover the shades at its ends. */
.wide {{ overflow-x: auto; background:
  linear-gradient(to right, var(--paper) 85%, transparent) left / 1.2rem 100% local,
  linear-gradient(to left, var(--paper) 85%, transparent) right / 1.2rem 100% local,
  linear-gradient(to right, var(--shade), transparent) left / 1rem 100%,
  linear-gradient(to left, var(--shade), transparent) right / 1rem 100%; background-repeat: no-repeat; }}
table {{ border-collapse: collapse; }}
.files td, .files th {{ padding: .25rem .8rem .25rem 0; border-bottom: 1px solid var(--line);
  text-align: right; white-space: nowrap; }}
.files td:first-child, .files th:first-child {{ text-align: left; }}
meter {{ width: 6rem; }}
.source {{ width: 100%; font: 13px/1.45 ui-monospace, monospace; }}
.source td {{ padding: 0 .6rem; vertical-align: top; white-space: pre-wrap; overflow-wrap: anywhere; }}
.source td.n {{ color: var(--quiet); text-align: right; width: 1%; white-space: pre; user-select: none; }}
.source td.gap {{ white-space: normal; color: var(--quiet); }}
tr.full {{ background: var(--full); }} tr.part {{ background: var(--part); }}
tr.none {{ background: var(--none); }}
.key span {{ padding: 0 .5rem; margin-right: .5rem; }}
/* What of a line is not covered stands below it where the screen is narrow. */
@media (max-width: 40rem) {{ .source, .source tbody {{ display: block; }}
  .source tr {{ display: grid; grid-template-columns: 3.5rem 3rem 1fr; }} .source td.n {{ width: auto; }}
  .source td.gap {{ grid-column: 3; }} }}
@media print {{ .wide {{ background: none; }} tr {{ break-inside: avoid; }} .source {{ font-size: 9px; }} }}
</style></head><body>
<h1>Coverage of agents' programs</h1>
<p class="subject">{0}</p>
<p>Plans are covered when one of their instances was chosen, conditions of contexts and rules when
they were seen to hold and to fail, formulas when they were executed. The number before a line counts
how often its plan was chosen, its condition asked or its formula executed.</p>
<p class="key"><span style="background:var(--full)">covered</span><span
style="background:var(--part)">in part</span><span style="background:var(--none)">not</span></p>
)page";

std::string html_cell(const Share& share) {
  if (share.of == 0) return "<td>-</td><td></td>";
  return fmt::format("<td>{} of {}</td><td><meter value=\"{}\" max=\"{}\"></meter> {}</td>",
                     share.covered, share.of, share.covered, share.of, percent(share));
}

void add_row(std::string& out, const std::string& name, const CoverageTotals& totals) {
  out += fmt::format("<tr><td>{}</td>{}{}{}</tr>\n", name, html_cell(totals.plans),
                     html_cell(totals.outcomes), html_cell(totals.formulas));
}

void add_line(std::string& out, const Source& source, std::uint32_t number,
              const CoveredLine* line) {
  std::string_view state;
  std::string count;
  std::string gaps;
  if (line != nullptr) {
    state = line->count == 0 ? "none" : line->gaps.empty() ? "full" : "part";
    count = fmt::format("{}", line->count);
    for (const std::string& gap : line->gaps) {
      gaps += fmt::format("{}{}", gaps.empty() ? "" : "<br>", escaped(gap));
    }
  }
  out += fmt::format(
      "<tr class=\"{}\"><td class=\"n\">{}</td><td class=\"n\">{}</td><td>{}</td>"
      "<td class=\"gap\">{}</td></tr>\n",
      state, count, number, escaped(source.line(number)), gaps);
}

void add_source(std::string& out, const CoveredFile& file) {
  const auto lines = covered_lines(file);
  const std::string_view text = file.source->text();
  const auto count = static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n')) +
                     (text.empty() || text.ends_with('\n') ? 0U : 1U);
  out += "<div class=\"wide\"><table class=\"source\">\n";
  for (std::uint32_t number = 1; number <= count; ++number) {
    const auto line = lines.find(number);
    add_line(out, *file.source, number, line == lines.end() ? nullptr : &line->second);
  }
  out += "</table></div>\n";
}

}  // namespace

std::string coverage_html(const SourceCoverage& coverage, const std::string& subject) {
  std::string out = fmt::format(fmt::runtime(kHead), escaped(subject));
  out +=
      "<div class=\"wide\"><table class=\"files\">\n<tr><th>file</th><th colspan=\"2\">plans "
      "chosen</th><th colspan=\"2\">outcomes seen</th><th colspan=\"2\">formulas executed</th>"
      "</tr>\n";
  std::size_t number = 0;
  for (const auto& [name, file] : coverage.files) {
    add_row(out, fmt::format("<a href=\"#file{}\">{}</a>", ++number, escaped(name)), file.totals());
  }
  add_row(out, "total", coverage.totals());
  out += "</table></div>\n";
  number = 0;
  for (const auto& [name, file] : coverage.files) {
    out += fmt::format("<h2 id=\"file{}\">{}</h2>\n", ++number, escaped(name));
    add_source(out, file);
  }
  return out + "</body></html>\n";
}

}  // namespace jaywalk
