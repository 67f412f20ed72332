import { t } from '@farol/editing';
import type { EditorApi } from '../../api/EditorApi';
import { addClip } from '../../model/timeline/clipEdits';
import { clipPlayer, playerAbove } from '../../model/timeline/clipPlayer';
import { timelineOf } from '../../model/timeline/timelineOf';

/** Adds a clip for the selected object, or for its nearest ancestor that plays clips, and opens the clip. */
export function newClip(editor: EditorApi): void {
  const { document, commands } = editor;
  const { scene } = document;
  const timeline = timelineOf(editor);
  const selected = document.selectedObjects.at(-1) ?? timeline.root;
  const object = selected && (playerAbove(selected) ?? selected);
  const made = addClip(scene, object ? t('{name} clip', { name: object.name }) : t('Clip'), object, clipPlayer(scene));
  commands.run(made.command);
  timeline.choose(made.name);
}
