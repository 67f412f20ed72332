import { type Diagnostic, setDiagnostics } from '@codemirror/lint';
import { EditorState, type Extension, type Text } from '@codemirror/state';
import { EditorView } from '@codemirror/view';
import { type ReactNode, useEffect, useLayoutEffect, useRef } from 'react';
import { codeExtensions, fromOutside } from './codeExtensions';

export interface CodeProblem {
  readonly message: string;
  /** Line (from 1); marked as a whole unless `from` and `to` are given. */
  readonly line: number;
  /** Start and end of the marked part (characters from the start of the text). */
  readonly from?: number;
  readonly to?: number;
  /** Severity of the problem; 'error' when absent. */
  readonly severity?: 'error' | 'warning' | 'hint';
}

interface CodeEditorProps {
  /** Name of the text; a new name replaces the text, with a history of its own. */
  readonly name: string;
  readonly text: string;
  /** Accessible name of the text. */
  readonly label: string;
  readonly problems: readonly CodeProblem[];
  /** Line (from 1) to scroll to; a new object scrolls again. */
  readonly goTo: { readonly line: number } | null;
  /** Extensions of CodeMirror, such as the language; called when `name` changes. */
  language(this: void): Extension;
  onInput(text: string): void;
  /** Called when the editor loses the focus. */
  onLeave(): void;
}

function diagnosticOf(doc: Text, problem: CodeProblem): Diagnostic {
  const { message, line, from, to = from, severity = 'error' } = problem;
  if (from !== undefined && from <= doc.length) {
    return { from, to: Math.max(from, Math.min(to!, doc.length)), severity, message };
  }
  const whole = doc.line(Math.min(Math.max(line, 1), doc.lines));
  return { from: whole.from, to: whole.to, severity, message };
}

/** Code editor with line numbers, highlighting, search, and problems marked in the text. */
export function CodeEditor(props: CodeEditorProps): ReactNode {
  const { name, text, label, problems, goTo, language, onInput, onLeave } = props;
  const place = useRef<HTMLDivElement>(null);
  const view = useRef<EditorView | null>(null);
  const handlers = useRef({ onInput, onLeave });
  useLayoutEffect(() => {
    handlers.current = { onInput, onLeave };
  });

  useLayoutEffect(() => {
    const extensions = [language(), codeExtensions(label, (next) => handlers.current.onInput(next))];
    const made = new EditorView({ parent: place.current!, state: EditorState.create({ doc: text, extensions }) });
    view.current = made;
    // a list of errors below may shrink the editor: keeps the cursor's line visible
    const sizes = new ResizeObserver(() => {
      if (!made.hasFocus) return;
      made.dispatch({ effects: EditorView.scrollIntoView(made.state.selection.main.head) });
    });
    sizes.observe(place.current!);
    return () => {
      sizes.disconnect();
      view.current = null;
      made.destroy();
    };
    // oxlint-disable-next-line react-hooks/exhaustive-deps, react/exhaustive-effect-dependencies -- one editor for each name
  }, [name]);

  useEffect(() => {
    const { current } = view;
    if (!current || current.state.doc.toString() === text) return;
    current.dispatch({ changes: changeTo(current.state.doc, text), annotations: fromOutside.of(true) });
  }, [name, text]);

  useEffect(() => {
    const { current } = view;
    if (!current) return;
    const diagnostics = problems.map((problem) => diagnosticOf(current.state.doc, problem));
    current.dispatch(setDiagnostics(current.state, diagnostics));
  }, [name, problems]);

  useEffect(() => {
    const { current } = view;
    if (!current || !goTo) return;
    const { doc } = current.state;
    const { from } = doc.line(Math.min(Math.max(goTo.line, 1), doc.lines));
    current.dispatch({ selection: { anchor: from }, effects: EditorView.scrollIntoView(from, { y: 'center' }) });
    current.focus();
  }, [name, goTo]);

  return (
    <div
      ref={place}
      className="code"
      data-own-actions="edit.undo edit.redo edit.copy edit.cut edit.paste edit.select-all"
      onBlur={(event) => !event.currentTarget.contains(event.relatedTarget) && handlers.current.onLeave()}
    />
  );
}

/** The smallest single replacement that turns one text into another. */
function changeTo(before: Text, after: string): { from: number; to: number; insert: string } {
  const old = before.toString();
  let from = 0;
  while (from < old.length && from < after.length && old[from] === after[from]) from++;
  let end = 0;
  while (end < old.length - from && end < after.length - from && old.at(-1 - end) === after.at(-1 - end)) end++;
  return { from, to: old.length - end, insert: after.slice(from, after.length - end) };
}
