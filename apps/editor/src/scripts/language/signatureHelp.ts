import { type Extension, StateEffect, StateField } from '@codemirror/state';
import { keymap, showTooltip, type Tooltip, ViewPlugin, type ViewUpdate } from '@codemirror/view';
import type { ScriptSignature } from './LanguageAnswers';
import type { ScriptLanguage } from './ScriptLanguage';

const setSignature = StateEffect.define<ScriptSignature | null>();

/** Element with a line of code, and its documentation below. */
export function helpElement(code: readonly (string | Node)[], help: string): HTMLElement {
  const element = document.createElement('div');
  element.className = 'code-help';
  const line = document.createElement('code');
  line.append(...code);
  element.append(line);
  if (help !== '') {
    const text = document.createElement('p');
    text.textContent = help;
    element.append(text);
  }
  return element;
}

/** Element with a function's signature; the parameter being written is highlighted. */
function signatureElement({ before, parameters, after, active, help, parameterHelp }: ScriptSignature): HTMLElement {
  const parts = parameters.flatMap((text, i) => {
    const part = document.createElement(i === active ? 'strong' : 'span');
    part.textContent = text;
    return i > 0 ? [', ', part] : [part];
  });
  return helpElement([before, ...parts, after], parameterHelp || help);
}

function tooltipOf(signature: ScriptSignature): Tooltip {
  return { pos: signature.from, above: true, create: () => ({ dom: signatureElement(signature) }) };
}

const shown = StateField.define<Tooltip | null>({
  create: () => null,
  update(before, { effects, changes }) {
    const effect = effects.findLast((each) => each.is(setSignature));
    if (effect) return effect.value ? tooltipOf(effect.value) : null;
    return before && { ...before, pos: changes.mapPos(before.pos) };
  },
  provide: (field) => showTooltip.from(field),
});

/** Shows the signature of a function while its arguments are being written; Escape hides it. */
export function signatureHelp(language: ScriptLanguage, script: string): Extension {
  const plugin = ViewPlugin.define((view) => {
    let asked = 0;
    const ask = async (): Promise<void> => {
      const number = ++asked;
      const found = await language.ask('signature', script, view.state.selection.main.head).catch(() => null);
      if (number === asked) view.dispatch({ effects: setSignature.of(found) });
    };
    return {
      update({ docChanged, selectionSet, state, transactions }: ViewUpdate): void {
        if (!docChanged && !selectionSet) return;
        const isShown = state.field(shown) !== null;
        const isTyped = transactions.some((each) => each.isUserEvent('input'));
        const { head } = state.selection.main;
        const isOpened = isTyped && /[(,]/.test(state.sliceDoc(Math.max(0, head - 2), head));
        if (isShown || isOpened) void ask();
      },
      destroy: () => void asked++,
    };
  });
  const close = keymap.of([
    {
      key: 'Escape',
      run: (view) => {
        if (view.state.field(shown) === null) return false;
        view.dispatch({ effects: setSignature.of(null) });
        return true;
      },
    },
  ]);
  return [shown, plugin, close];
}
