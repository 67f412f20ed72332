import type { MicroShaderCompileEntry } from '@farol/renderer';
import { type Diagnostic, setDiagnostics } from '@codemirror/lint';
import { EditorState, type Text } from '@codemirror/state';
import { EditorView } from '@codemirror/view';
import { type ReactNode, useEffect, useLayoutEffect, useRef } from 'react';
import { fromOutside, glslExtensions } from './glslEditor';

interface CodeEditorProps {
  /** Another name begins another text, with a history of its own. */
  readonly name: string;
  readonly text: string;
  /** Of this chunk; shown at their lines. */
  readonly errors: readonly MicroShaderCompileEntry[];
  /** The line (from 1) to go to; another object goes there again. */
  readonly goTo: { readonly line: number } | null;
  onInput(text: string): void;
  /** The focus left. */
  onLeave(): void;
}

/** The part of the smallest change that leads from one text to another. */
function changeTo(before: Text, after: string): { from: number; to: number; insert: string } {
  const old = before.toString();
  let from = 0;
  while (from < old.length && from < after.length && old[from] === after[from]) from++;
  let end = 0;
  while (end < old.length - from && end < after.length - from && old.at(-1 - end) === after.at(-1 - end)) end++;
  return { from, to: old.length - end, insert: after.slice(from, after.length - end) };
}

/** Text of a microshader with line numbers, highlighting, and the compiler's errors at their lines. */
export function CodeEditor({ name, text, errors, goTo, onInput, onLeave }: CodeEditorProps): ReactNode {
  const place = useRef<HTMLDivElement>(null);
  const view = useRef<EditorView | null>(null);
  const handlers = useRef({ onInput, onLeave });
  useLayoutEffect(() => {
    handlers.current = { onInput, onLeave };
  });

  useLayoutEffect(() => {
    const made = new EditorView({
      parent: place.current!,
      state: EditorState.create({ doc: text, extensions: glslExtensions((next) => handlers.current.onInput(next)) }),
    });
    view.current = made;
    // the list of errors comes below the text and takes room of it: the line that is typed stays in sight
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
    // oxlint-disable-next-line react-hooks/exhaustive-deps, react/exhaustive-effect-dependencies -- a text of its own for each name
  }, [name]);

  useEffect(() => {
    const { current } = view;
    if (!current || current.state.doc.toString() === text) return;
    current.dispatch({ changes: changeTo(current.state.doc, text), annotations: fromOutside.of(true) });
  }, [name, text]);

  useEffect(() => {
    const { current } = view;
    if (!current) return;
    const { doc } = current.state;
    const diagnostics = errors.map(({ line, message }): Diagnostic => {
      const { from, to } = doc.line(Math.min(Math.max(line, 1), doc.lines));
      return { from, to, severity: 'error', message };
    });
    current.dispatch(setDiagnostics(current.state, diagnostics));
  }, [name, errors]);

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
