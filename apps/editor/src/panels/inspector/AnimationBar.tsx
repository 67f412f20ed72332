import { t } from '@farol/editing';
import { Animation, type Component } from '@farol/engine';
import type { ReactNode } from 'react';
import { makeEditableCopy, whyNotCopy } from '../../model/copyModelClip';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { useOwnersRevision } from '../../ui/useOwnersRevision';
import { Button } from '../../ui/Button';

/** Buttons for a model's clip that Animations play. @param props.components - Animations, memoised */
export function AnimationBar({ components }: { components: readonly Component[] }): ReactNode {
  const editor = useEditor();
  const { document, commands, notices } = editor;
  useSignal(document.assetsChanged);
  useOwnersRevision(components);
  const animations = components.filter((each) => each instanceof Animation);
  const name = animations[0].getAuthored('clip') as string | null;
  const { assets } = document;
  if (name === null || !animations.every((each) => each.getAuthored('clip') === name)) return null;
  if (!assets.isReady('clip', name)) return null;
  const clip = assets.clip(name);
  if (!('isModelClip' in clip)) return null;
  const problem = whyNotCopy(clip);
  const copy = (): void => {
    const { command, lost } = makeEditableCopy(animations, name);
    commands.run(command);
    if (lost.length > 0)
      notices.show('info', t('Left out, since no field holds it: {tracks}', { tracks: lost.join(', ') }));
  };
  return (
    <div className="material-bar">
      <Button
        icon="copy"
        label={t('Make editable copy')}
        disabled={problem !== null}
        title={
          problem ?? t('Copies the clip as one that can be edited, for the objects that the model is unpacked into')
        }
        onClick={() => editor.attempt(copy)}
      />
      {problem !== null && <p className="model-problem">{problem}</p>}
    </div>
  );
}
