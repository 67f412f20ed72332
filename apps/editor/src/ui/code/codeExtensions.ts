import { t } from '@farol/editing';
import { defaultKeymap, history, historyKeymap, indentWithTab } from '@codemirror/commands';
import { bracketMatching, HighlightStyle, indentUnit, syntaxHighlighting } from '@codemirror/language';
import { lintGutter, lintKeymap } from '@codemirror/lint';
import { highlightSelectionMatches, search, searchKeymap } from '@codemirror/search';
import { Annotation, EditorState, type Extension } from '@codemirror/state';
import {
  drawSelection,
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  keymap,
  lineNumbers,
} from '@codemirror/view';
import { tags } from '@lezer/highlight';

const style = HighlightStyle.define([
  { tag: tags.comment, color: 'var(--code-comment)' },
  { tag: [tags.keyword, tags.operatorKeyword, tags.controlKeyword], color: 'var(--code-keyword)' },
  {
    tag: [tags.typeName, tags.className, tags.standard(tags.variableName), tags.standard(tags.name)],
    color: 'var(--code-type)',
  },
  { tag: [tags.number, tags.bool, tags.atom], color: 'var(--code-number)' },
  { tag: [tags.string, tags.regexp, tags.meta], color: 'var(--code-meta)' },
]);

const theme = EditorView.theme({
  '&': { height: '100%', color: 'var(--text)', backgroundColor: 'var(--field)', fontSize: '12px' },
  '&.cm-focused': { outline: 'none' },
  '.cm-scroller': { fontFamily: 'var(--code-font)', lineHeight: '1.5' },
  '.cm-gutters': { backgroundColor: 'var(--field)', color: 'var(--dim)', border: '0' },
  '.cm-activeLine, .cm-activeLineGutter': { backgroundColor: 'color-mix(in srgb, var(--hover) 45%, transparent)' },
  '.cm-cursor': { borderLeftColor: 'var(--accent)' },
  '&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground': {
    backgroundColor: 'var(--selected)',
  },
  '.cm-selectionMatch, .cm-searchMatch': { backgroundColor: 'var(--selected-quiet)' },
  '&.cm-focused .cm-matchingBracket': {
    backgroundColor: 'var(--selected-quiet)',
    outline: '1px solid var(--line-strong)',
  },
  '.cm-tooltip': {
    border: '1px solid var(--line-strong)',
    borderRadius: '4px',
    backgroundColor: 'var(--raised)',
    color: 'var(--text)',
  },
  '.cm-tooltip-autocomplete ul li[aria-selected]': { backgroundColor: 'var(--selected)', color: 'var(--text)' },
  '.cm-completionMatchedText': { textDecoration: 'none', color: 'var(--accent-text)', fontWeight: '600' },
  '.cm-completionDetail': { color: 'var(--dim)', fontStyle: 'normal' },
  '.cm-foldGutter': { color: 'var(--dim)' },
  '.cm-foldPlaceholder': { border: '0', backgroundColor: 'var(--selected-quiet)', color: 'var(--dim)' },
  '.cm-diagnostic-error': { borderLeftColor: 'var(--error)' },
  '.cm-panels': { backgroundColor: 'var(--panel)', color: 'var(--text)' },
  '.cm-panels input, .cm-panels button': {
    border: '1px solid var(--line-strong)',
    borderRadius: '3px',
    background: 'var(--field)',
    color: 'var(--text)',
  },
});

/** Texts of the code editor's search and lists, in the user's language. */
const phrases = (): Record<string, string> => ({
  Find: t('Find'),
  Replace: t('Replace'),
  next: t('next'),
  previous: t('previous'),
  all: t('all'),
  'match case': t('match case'),
  regexp: t('regexp'),
  'by word': t('by word'),
  replace: t('replace'),
  'replace all': t('replace all'),
  close: t('close'),
  'current match': t('current match'),
  'on line': t('on line'),
  'replaced $ matches': t('replaced $ matches'),
  'replaced match on line $': t('replaced match on line $'),
  'Go to line': t('Go to line'),
  go: t('go'),
  Diagnostics: t('Diagnostics'),
  'No diagnostics': t('No diagnostics'),
});

/** Marks a change that was not typed, such as an undo of the document. */
export const fromOutside = Annotation.define<boolean>();

/**
 * Extensions of every code editor, in the theme's colours.
 * @param label - accessible name of the text
 * @param onInput - called with the text after each edit by the user
 */
export function codeExtensions(label: string, onInput: (text: string) => void): Extension {
  return [
    lineNumbers(),
    highlightActiveLine(),
    highlightActiveLineGutter(),
    history(),
    drawSelection(),
    bracketMatching(),
    highlightSelectionMatches(),
    search({ top: true }),
    lintGutter(),
    indentUnit.of('  '),
    EditorState.tabSize.of(2),
    syntaxHighlighting(style),
    theme,
    EditorState.phrases.of(phrases()),
    keymap.of([...defaultKeymap, ...historyKeymap, ...searchKeymap, ...lintKeymap, indentWithTab]),
    EditorView.contentAttributes.of({ 'aria-label': label, spellcheck: 'false', tabindex: '0' }),
    EditorView.updateListener.of((update) => {
      const byHand = update.transactions.some(
        (transaction) => transaction.docChanged && transaction.annotation(fromOutside) !== true,
      );
      if (byHand) onInput(update.state.doc.toString());
    }),
  ];
}
