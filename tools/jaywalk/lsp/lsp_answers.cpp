// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/lsp/lsp_answers.h"

#include <string>
#include <string_view>
#include <utility>

#include "interpreter/support/text.h"
#include "interpreter/syntax/format/formatter.h"
#include "tools/jaywalk/lsp/lsp_protocol.h"

namespace jaywalk::lsp {
namespace {

using What = Use::What;

// Kinds of completions and symbols, of diagnostics' severities.
constexpr int kFunction = 3;
constexpr int kVariable = 6;
constexpr int kMethod = 2;
constexpr int kEvent = 23;
constexpr int kSymbolMethod = 6;
constexpr int kSymbolFunction = 12;
constexpr int kSymbolConstant = 14;
constexpr int kSymbolNamespace = 3;
constexpr int kSymbolEvent = 24;

int completion_kind(What what) {
  switch (what) {
    case What::goal:
      return kEvent;
    case What::belief:
      return kVariable;
    case What::action:
      return kMethod;
    case What::internal_action:
      return kFunction;
  }
  return kVariable;
}

// The beginning of a component, on one line.
std::string first_words(std::string_view text) {
  constexpr std::size_t kMost = 60;
  text = text.substr(0, text.find('\n'));
  while (!text.empty() && (text.back() == '\r' || text.back() == ' ')) text.remove_suffix(1);
  return shortened(text, kMost);
}

Json symbol(const Document& document, std::string name, int kind, Span span, Span selection) {
  if (selection.begin < span.begin || selection.end > span.end) selection = span;
  if (name.empty()) name = "?";
  return {{"name", std::move(name)},
          {"kind", kind},
          {"range", to_json(document.places().range(span))},
          {"selectionRange", to_json(document.places().range(selection))}};
}

Json plan_symbol(const Document& document, const ast::Plan& plan) {
  const Span head{plan.trigger.span.begin, plan.trigger.literal->span.end};
  Json json = symbol(document, first_words(document.source()->text(head)), kSymbolMethod, plan.span,
                     plan.trigger.literal->span);
  if (plan.context != nullptr) {
    json["detail"] = first_words(document.source()->text(plan.context->span));
  }
  Json children = Json::array();
  for (const ast::Plan* const subplan : plan.subplans) {
    children.push_back(plan_symbol(document, *subplan));
  }
  if (!children.empty()) json["children"] = std::move(children);
  return json;
}

}  // namespace

Json json_of(const Diagnostic& diagnostic, const Document& document) {
  constexpr int kError = 1;
  constexpr int kWarning = 2;
  constexpr int kInformation = 3;
  const int severity = diagnostic.severity == Severity::error     ? kError
                       : diagnostic.severity == Severity::warning ? kWarning
                                                                  : kInformation;
  std::string message = diagnostic.message;
  if (!diagnostic.hint.empty()) message += "\n" + diagnostic.hint;
  Json json = {{"range", to_json(document.places().range(diagnostic.where.span))},
               {"severity", severity},
               {"source", "jaywalk"},
               {"message", message}};
  if (!diagnostic.code.empty()) json["code"] = diagnostic.code;
  return json;
}

Json completion_items(const Document& document, Position at) {
  Range written;
  Json items = Json::array();
  for (const Completion& completion : document.completions(at, written)) {
    items.push_back({{"label", completion.label},
                     {"kind", completion_kind(completion.what)},
                     {"detail", completion.detail},
                     {"textEdit", {{"range", to_json(written)}, {"newText", completion.label}}}});
  }
  return items;
}

Json symbols(const Document& document, std::span<const ast::Component> components) {
  Json all = Json::array();
  for (const ast::Component& component : components) {
    if (component.kind == ast::ComponentKind::plan) {
      if (component.plan != nullptr) all.push_back(plan_symbol(document, *component.plan));
      continue;
    }
    const Span literal = component.literal->span;
    std::string name = first_words(document.source()->text(literal));
    int kind = component.body == nullptr ? kSymbolConstant : kSymbolFunction;
    if (component.kind == ast::ComponentKind::goal) {
      kind = kSymbolEvent;
      name = "!" + name;
    } else if (component.kind == ast::ComponentKind::directive) {
      kind = kSymbolNamespace;
    }
    Json json = symbol(document, std::move(name), kind, component.span, literal);
    if (!component.inner.empty()) json["children"] = symbols(document, component.inner);
    all.push_back(std::move(json));
  }
  return all;
}

Json formatting(const Document& document) {
  Json edits = Json::array();
  if (!document.is_program()) return edits;
  const auto formatted = format_agent(document.source());
  const std::string_view text = document.source()->text();
  if (!formatted || formatted.value() == text) return edits;
  const Span whole{0, static_cast<std::uint32_t>(text.size())};
  edits.push_back(
      {{"range", to_json(document.places().range(whole))}, {"newText", formatted.value()}});
  return edits;
}

}  // namespace jaywalk::lsp
