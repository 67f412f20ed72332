import { useEffect, useState } from 'react';
import type { EditorApi } from '../../api/EditorApi';
import type { ScriptDiagnostic } from '../../scripts/language/LanguageAnswers';
import { ScriptLanguage } from '../../scripts/language/ScriptLanguage';
import type { ScriptEditing } from '../../scripts/ScriptEditing';
import { useEditor, useSignal } from '../../ui/EditorContext';

/** Delay between the last key press and checking a text (ms). */
const DELAY = 250;

const known = new WeakMap<EditorApi, ScriptLanguage>();

/** TypeScript's language service for the scripts of an editor. */
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

/**
 * TypeScript's diagnostics for a script, updated soon after typing. @param texts - texts of all scripts, since they may
 * import each other
 */
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
        // failures are reported by the language service itself
        () => {},
      );
    }, DELAY);
    return () => {
      isLate = true;
      clearTimeout(timer);
    };
    // oxlint-disable-next-line react/exhaustive-effect-dependencies -- the check depends on the texts of all scripts
  }, [language, name, texts]);
  return found.name === name ? found.list : none;
}
