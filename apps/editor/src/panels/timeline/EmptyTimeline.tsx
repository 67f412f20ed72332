import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { playedClip } from '../../model/timeline/clipPlayer';
import type { Timeline } from '../../model/timeline/Timeline';
import { useEditor } from '../../ui/EditorContext';
import { newClip } from './newClip';
import { Button } from '../../ui/Button';

/** Content of the timeline panel while no clip is edited. */
export function EmptyTimeline({ timeline }: { timeline: Timeline }): ReactNode {
  const editor = useEditor();
  const played = timeline.root && playedClip(timeline.root);
  if (timeline.root && played !== null && editor.document.assets.has(played)) {
    return (
      <div className="timeline-empty">
        <p>
          {t('{name} plays {clip}, which came with a model and cannot be edited. A new clip is in the menu above.', {
            name: timeline.root.name,
            clip: played,
          })}
        </p>
      </div>
    );
  }
  const object = editor.document.selectedObjects.at(-1) ?? timeline.root;
  return (
    <div className="timeline-empty">
      <p>
        {object
          ? t('{name} has no clip yet. A clip moves it, and all below it, over time.', { name: object.name })
          : t('Select an object to animate it, or choose a clip above.')}
      </p>
      {object && (
        <Button
          icon="add"
          label={t('New clip for {name}', { name: object.name })}
          onClick={() => editor.attempt(() => newClip(editor))}
        />
      )}
    </div>
  );
}
