import { t } from '@farol/editing';
import type { Component, EventTrigger } from '@farol/engine';
import type { ReactNode } from 'react';
import { triggerProblems } from '../../model/triggerProblems';
import { Button } from '../../ui/Button';
import { useEditor, useSignal } from '../../ui/EditorContext';

/** Warnings about triggers that can never fire, each with a button that solves the problem. */
export function TriggerProblems({ components }: { components: readonly Component[] }): ReactNode {
  const editor = useEditor();
  const { document, commands } = editor;
  useSignal(document.structure);
  useSignal(document.commands.changed);
  if (components.length !== 1) return null;
  return triggerProblems(components[0] as EventTrigger).map(({ text, mend }) => (
    <p key={text} className="technique-limit" role="note" aria-label={t('Problem')}>
      {text}{' '}
      {mend && (
        <Button
          look="small framed"
          label={mend.label}
          onClick={() => editor.attempt(() => commands.run(mend.make()))}
        />
      )}
    </p>
  ));
}
