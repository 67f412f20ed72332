import { useEffect, useState } from 'react';
import type { EditorApi } from '../../api/EditorApi';
import type { ScriptDiagnostic } from '../../scripts/language/LanguageAnswers';
import { ScriptLanguage } from '../../scripts/language/ScriptLanguage';
import type { ScriptEditing } from '../../scripts/ScriptEditing';
import { useEditor, useSignal } from '../../ui/EditorContext';

/** How long after the last key a text is checked (ms). */
const DELAY = 250;

const known = new WeakMap<EditorApi, ScriptLanguage>();

/** TypeScript's service for the scripts of an editor. */
export function useScriptLanguage(editing: ScriptEditing): ScriptLanguage {
  const editor = useEditor();
  let language = known.get(editor);
  if (!language) known.set(editor, (language = new ScriptLanguage(() => editing.texts)));
  useSignal(language.changed);
  const used = language;
  useEffect(() => used.use(), [used]);
  return language;
}

const none: readonly ScriptDiagnostic[] = [];

/** What TypeScript finds wrong with a script, soon after it was typed. @param texts - of all scripts: one may need another */
export function useDiagnostics(
  language: ScriptLanguage,
  name: string | null,
  texts: string,
): readonly ScriptDiagnostic[] {
  const [found, setFound] = useState<{ readonly name: string | null; readonly list: readonly ScriptDiagnostic[] }>({
    name,
    list: none,
  });
  useEffect(() => {
    if (name === null) return undefined;
    let isLate = false;
    const timer = setTimeout(() => {
      language.ask('diagnostics', name).then(
        (list) => isLate || setFound({ name, list }),
        // why there is no answer is told by the language itself
        () => {},
      );
    }, DELAY);
    return () => {
      isLate = true;
      clearTimeout(timer);
    };
    // oxlint-disable-next-line react/exhaustive-effect-dependencies -- the texts are what is checked
  }, [language, name, texts]);
  return found.name === name ? found.list : none;
}
