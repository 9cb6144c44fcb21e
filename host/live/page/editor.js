// Edits a shader or a scene file: in CodeMirror when the program was built with it, else in a plain text field.
"use strict";

function makeEditor(parent, onChange, onSave) {
  let quiet = false; // while the page, not the user, sets the text
  if (typeof CodeMirror === "undefined") {
    const area = document.createElement("textarea");
    area.className = "plain";
    area.spellcheck = false;
    area.setAttribute("aria-label", "Text of the file");
    area.addEventListener("input", () => onChange());
    area.addEventListener("keydown", (event) => {
      if ((event.ctrlKey || event.metaKey) && event.key === "s") { event.preventDefault(); onSave(); }
    });
    parent.append(area);
    return {
      open(text) { area.value = text; },
      text: () => area.value,
      setReadOnly(on) { area.readOnly = on; },
      showProblems() {},
      goTo(line) {
        const start = area.value.split("\n").slice(0, line - 1).join("\n").length + (line > 1 ? 1 : 0);
        area.focus();
        area.setSelectionRange(start, start);
      },
      refresh() {},
    };
  }
  const editor = CodeMirror(parent, {
    lineNumbers: true, indentUnit: 4, tabSize: 4, matchBrackets: true, styleActiveLine: true,
    gutters: ["problems", "CodeMirror-linenumbers"],
    extraKeys: {
      "Ctrl-S": onSave, "Cmd-S": onSave,
      Tab: (cm) => cm.somethingSelected() ? cm.indentSelection("add") : cm.replaceSelection("    "),
      Esc: (cm) => cm.getInputField().blur(), // so that Tab leaves the editor again
    },
  });
  editor.getInputField().setAttribute("aria-label", "Text of the file");
  editor.on("change", () => { if (!quiet) { onChange(); } });
  let marked = [];
  return {
    open(text, name) {
      quiet = true;
      editor.setOption("mode", name.endsWith(".yaml") ? "text/x-yaml" : "x-shader/x-fragment");
      editor.setValue(text);
      editor.clearHistory();
      quiet = false;
      marked = [];
    },
    text: () => editor.getValue(),
    setReadOnly(on) { editor.setOption("readOnly", on); },
    showProblems(problems) { // [{line, message}]
      editor.clearGutter("problems");
      for (const handle of marked) { editor.removeLineClass(handle, "background", "error-line"); }
      marked = [];
      for (const { line, message } of problems) {
        if (line < 1 || line > editor.lineCount()) { continue; }
        const mark = document.createElement("div");
        mark.className = "problem";
        mark.textContent = "●";
        mark.title = message;
        editor.setGutterMarker(line - 1, "problems", mark);
        marked.push(editor.addLineClass(line - 1, "background", "error-line"));
      }
    },
    goTo(line) {
      editor.focus();
      editor.setCursor(line - 1, 0);
      editor.scrollIntoView(null, 120);
    },
    refresh() { editor.refresh(); },
  };
}
