// SPDX-License-Identifier: Apache-2.0
#pragma once

// Answers about one document, as JSON of the language server protocol.

#include <span>

#include "tools/jaywalk/lsp/lsp_document.h"
#include "tools/jaywalk/lsp/lsp_protocol.h"

namespace jaywalk::lsp {

/// A Diagnostic of the protocol.
[[nodiscard]] Json json_of(const Diagnostic& diagnostic, const Document& document);

/// CompletionItems.
[[nodiscard]] Json completion_items(const Document& document, Position at);

/// DocumentSymbols: plans with their sub-plans, beliefs, rules, goals, namespaces.
[[nodiscard]] Json symbols(const Document& document, std::span<const ast::Component> components);

/// TextEdits; none if the layout is fine, or the document has errors or is a project.
[[nodiscard]] Json formatting(const Document& document);

}  // namespace jaywalk::lsp
