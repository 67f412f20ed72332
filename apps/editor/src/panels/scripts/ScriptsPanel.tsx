import type { EditorApi } from '../../api/EditorApi';
import { ScriptEditing } from '../../scripts/ScriptEditing';
import { t } from '@farol/editing';
import { type ReactNode, useEffect, useMemo, useState, useSyncExternalStore } from 'react';
import { isJavaScript } from '../../model/scriptNames';
import { typescriptSupport } from '../../scripts/language/typescriptSupport';
import { Button } from '../../ui/Button';
import { CodeEditor } from '../../ui/code/CodeEditor';
import '../../ui/code/code.css';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { newScript } from '../../files/newScript';
import { ScriptBar } from './ScriptBar';
import { ScriptList } from './ScriptList';
import { ProblemList } from './ProblemList';
import { problemsOf } from './scriptProblems';
import './scripts.css';
import { useDiagnostics, useScriptLanguage } from './useScriptLanguage';

const known = new WeakMap<EditorApi, ScriptEditing>();

/** The `ScriptEditing` of an editor, which holds the texts being typed; created at the first call. */
function useScriptEditing(): ScriptEditing {
  const editor = useEditor();
  let editing = known.get(editor);
  if (!editing) known.set(editor, (editing = new ScriptEditing(editor.document)));
  useSignal(editing.changed);
  return editing;
}

/** The scene's scripts: list and editor; a script's text runs while it is typed. */
export function ScriptsPanel(): ReactNode {
  const editor = useEditor();
  const editing = useScriptEditing();
  const place = useSyncExternalStore(editor.scriptPlace.subscribe, () => editor.scriptPlace.current);
  const [shown, setShown] = useState(place?.name ?? '');
  const [lastPlace, setLastPlace] = useState(place);
  if (place !== lastPlace) {
    setLastPlace(place);
    if (place) setShown(place.name);
  }
  const { names } = editing;
  const name = names.includes(shown) ? shown : (names.at(0) ?? null);
  // oxlint-disable-next-line react/exhaustive-effect-dependencies -- edits become a step when another script is chosen
  useEffect(() => () => editing.finish(), [editing, name]);

  const language = useScriptLanguage(editing);
  const { texts } = editing;
  const found = useDiagnostics(language, name, [...texts].join('\0'));
  const { scripts } = editor.document;
  useSignal(scripts.changed);
  const { errors, failures } = scripts;
  const problems = useMemo(
    () => (name === null ? [] : problemsOf(name, { errors, failures }, found)),
    [name, errors, failures, found],
  );

  return (
    <section className="panel scripts" aria-label={t('Scripts')}>
      <ScriptList names={names} current={name} isBroken={(each) => editing.isBroken(each)} />
      {name === null ? (
        <div className="script-none">
          <p>{t('A script is a component of your own: a class with fields and what it does each frame.')}</p>
          <Button
            look="primary"
            icon="add"
            label={t('New script')}
            onClick={() => editor.attempt(() => newScript(editor))}
          />
        </div>
      ) : (
        <div className="chunk">
          <ScriptBar
            name={name}
            isBroken={editing.isBroken(name)}
            problems={problems.length}
            isReady={language.isReady}
            failure={language.failure}
          />
          <CodeEditor
            name={name}
            text={editing.textOf(name)}
            label={t('Text of the script')}
            problems={problems}
            goTo={place?.name === name && place.line > 0 ? place : null}
            language={() =>
              typescriptSupport(language, name, !isJavaScript(name), (script, line) => editor.openScript(script, line))
            }
            onInput={(text) => editing.edit(name, text)}
            onLeave={() => editing.finish()}
          />
          {problems.length > 0 && <ProblemList name={name} list={problems} />}
        </div>
      )}
    </section>
  );
}
