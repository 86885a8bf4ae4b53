"""Messages to the language server."""

import json

from row import Row

INITIALIZE = {"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {"processId": None, "rootUri": None, "capabilities": {}}}
END = [{"jsonrpc": "2.0", "id": "last", "method": "shutdown"}, {"jsonrpc": "2.0", "method": "exit"}]
OPEN = {"jsonrpc": "2.0", "method": "textDocument/didOpen",
        "params": {"textDocument": {"uri": "file:///a.asl", "languageId": "jason", "version": 1, "text": "!a.\n+!a.\n"}}}


def frame(content):
    data = content if isinstance(content, bytes) else json.dumps(content).encode()
    return b"Content-Length: %d\r\n\r\n%s" % (len(data), data)


def served(name, *sent, says='"id":"last"', code=0, ends=True):
    """What is sent between the beginning and the end: messages, or bytes as they are."""
    data = b"".join(part if isinstance(part, bytes) else frame(part) for part in sent)
    return Row(name, ["lsp"], code, says, stdin=frame(INITIALIZE) + data + (b"".join(map(frame, END)) if ends else b""), most=100_000)


def request(method, params):
    return {"jsonrpc": "2.0", "id": 5, "method": method, "params": params}


def edit(line, character, text):
    at = {"line": line, "character": character}
    return {"jsonrpc": "2.0", "method": "textDocument/didChange", "params": {"textDocument": {"uri": "file:///a.asl", "version": 2},
            "contentChanges": [{"range": {"start": at, "end": at}, "text": text}]}}


ROWS = [
    served("an editor that is gone", code=1, says="", ends=False),
    served("an end in the middle of a message", frame(OPEN)[:-20], code=1, says="", ends=False),
    served("a length that is no number", b"Content-Length: x\r\n\r\n"),
    served("a negative length", b"Content-Length: -4\r\n\r\n"),
    served("a length beyond all memory", b"Content-Length: 99999999999999999999\r\n\r\n"),
    served("a header without a length", b"Content-Type: x\r\n\r\n"),
    served("JSON, 100,000 deep", frame(b"[" * 100_000)),
    served("a message that is no JSON", frame(b"hello")),
    served("a message that is no object", frame(b"[1]")),
    served("a batch of nothing", frame(b"[]")),
    served("a method that there is not", request("no/such", {}), says='"code":-32601'),
    served("a request without parameters", request("textDocument/hover", None)),
    served("a document that was not opened", request("textDocument/hover", {"textDocument": {"uri": "file:///b.asl"}, "position": {"line": 0, "character": 0}})),
    served("a place that is not in the document", OPEN, request("textDocument/hover", {"textDocument": {"uri": "file:///a.asl"}, "position": {"line": 4294967295, "character": 4294967295}})),
    served("an edit behind the end", OPEN, edit(99, 99, "x")),
    served("an edit at a negative place", OPEN, edit(-1, -1, "x")),
    served("an edit with half a character", OPEN, edit(0, 0, "\ud800")),
    served("a document opened twice", OPEN, OPEN),
    served("a document closed twice", OPEN, {"jsonrpc": "2.0", "method": "textDocument/didClose", "params": {"textDocument": {"uri": "file:///a.asl"}}},
           {"jsonrpc": "2.0", "method": "textDocument/didClose", "params": {"textDocument": {"uri": "file:///a.asl"}}}),
    served("a new name that is none", OPEN, request("textDocument/rename", {"textDocument": {"uri": "file:///a.asl"}, "position": {"line": 0, "character": 1}, "newName": "(("})),
    Row("requests before the beginning", ["lsp"], 1, "-32002", stdin=frame(request("textDocument/hover", {}))),
    Row("an exit without a shutdown", ["lsp"], 1, "", stdin=frame(INITIALIZE) + frame(END[1])),
]
