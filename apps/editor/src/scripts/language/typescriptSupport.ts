import {
  autocompletion,
  closeBrackets,
  closeBracketsKeymap,
  type Completion,
  type CompletionContext,
  type CompletionResult,
  completionKeymap,
} from '@codemirror/autocomplete';
import { javascript } from '@codemirror/lang-javascript';
import { codeFolding, foldGutter, foldKeymap, indentOnInput } from '@codemirror/language';
import { EditorState, type Extension } from '@codemirror/state';
import {
  crosshairCursor,
  EditorView,
  hoverTooltip,
  keymap,
  rectangularSelection,
  type Tooltip,
  tooltips,
} from '@codemirror/view';
import { importEdit } from './importable';
import type { ScriptCompletion } from './LanguageAnswers';
import type { ScriptLanguage } from './ScriptLanguage';
import { helpElement, signatureHelp } from './signatureHelp';

/** CodeMirror's completion icons for TypeScript's kinds. */
const kinds: Readonly<Record<string, string>> = {
  alias: 'variable',
  class: 'class',
  const: 'constant',
  constructor: 'method',
  enum: 'enum',
  function: 'function',
  getter: 'property',
  interface: 'interface',
  keyword: 'keyword',
  let: 'variable',
  method: 'method',
  module: 'namespace',
  property: 'property',
  setter: 'property',
  type: 'type',
  var: 'variable',
};

/** Inserts a completion, and the import that it needs. */
function applyCompletion(view: EditorView, completion: ScriptCompletion, from: number, to: number): void {
  const { label, insert = label, module } = completion;
  const added = module === undefined ? null : importEdit(view.state.doc.toString(), label, module);
  view.dispatch({
    changes: [...(added ? [{ from: added.at, insert: added.insert }] : []), { from, to, insert }],
    selection: { anchor: from + insert.length + (added && added.at <= from ? added.insert.length : 0) },
    userEvent: 'input.complete',
    scrollIntoView: true,
  });
}

function completionSource(language: ScriptLanguage, script: string) {
  return async (context: CompletionContext): Promise<CompletionResult | null> => {
    const { pos, explicit } = context;
    const before = context.matchBefore(/[\w$]+$|\.$|['"/]$/);
    if (!explicit && !before) return null;
    const found = await language.ask('completions', script, pos, explicit).catch(() => null);
    if (!found || context.aborted || found.options.length === 0) return null;
    const options = found.options.map((each): Completion => ({
      label: each.label,
      type: kinds[each.kind] ?? 'text',
      detail: each.module,
      boost: each.boost,
      info: async () => {
        const help = await language.ask('completionHelp', script, pos, each).catch(() => null);
        return help && helpElement([help.type], help.help);
      },
      apply: (view, _completion, from, to) => applyCompletion(view, each, from, to),
    }));
    return { from: found.from, options, validFor: /^[\w$]*$/ };
  };
}

const hover = (language: ScriptLanguage, script: string): Extension =>
  hoverTooltip(async (_view, at): Promise<Tooltip | null> => {
    const help = await language.ask('help', script, at).catch(() => null);
    if (!help) return null;
    return { pos: help.from, end: help.to, above: true, create: () => ({ dom: helpElement([help.type], help.help) }) };
  });

/** Goes to the declaration of a name, by F12 or a click with Ctrl. @param open - opens a line of a script */
function definitions(
  language: ScriptLanguage,
  script: string,
  open: (script: string, line: number) => void,
): Extension {
  const go = (at: number): void =>
    void language.ask('definition', script, at).then(
      (found) => found && open(found.script, found.line),
      () => {},
    );
  return [
    keymap.of([
      {
        key: 'F12',
        run: ({ state }) => {
          go(state.selection.main.head);
          return true;
        },
      },
    ]),
    EditorView.domEventHandlers({
      click: (event, view) => {
        const at = event.ctrlKey || event.metaKey ? view.posAtCoords({ x: event.clientX, y: event.clientY }) : null;
        if (at !== null) go(at);
      },
    }),
  ];
}

/**
 * Extensions of a code editor for a script: highlighting, folding, brackets, several cursors, completion, hover,
 * signatures, definitions.
 * @param open - opens a line (from 1) of a script
 */
export function typescriptSupport(
  language: ScriptLanguage,
  script: string,
  isTypeScript: boolean,
  open: (script: string, line: number) => void,
): Extension {
  return [
    javascript({ typescript: isTypeScript }),
    codeFolding(),
    foldGutter(),
    indentOnInput(),
    closeBrackets(),
    EditorState.allowMultipleSelections.of(true),
    rectangularSelection(),
    crosshairCursor(),
    autocompletion({ override: [completionSource(language, script)], maxRenderedOptions: 60 }),
    hover(language, script),
    signatureHelp(language, script),
    definitions(language, script, open),
    // tooltips have fixed positions, since panels clip their content
    tooltips({ position: 'fixed', parent: document.body }),
    keymap.of([...closeBracketsKeymap, ...completionKeymap, ...foldKeymap]),
  ];
}
