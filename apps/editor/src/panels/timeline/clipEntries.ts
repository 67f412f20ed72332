import { SetFields, t } from '@farol/editing';
import type { EditorApi } from '../../api/EditorApi';
import type { MenuEntry } from '../../api/MenuEntry';
import { clipName } from '../../model/timeline/clipEdits';
import { clipPlayer, playedClip } from '../../model/timeline/clipPlayer';
import type { Timeline } from '../../model/timeline/Timeline';
import { newClip } from './newClip';

/** Frame rates in the menu; the clip's inspector accepts any. */
const RATES = [12, 24, 25, 30, 60] as const;

/** Menu of clips: chooses the clip to edit, adds one, and changes the current one. */
export function clipEntries(editor: EditorApi, timeline: Timeline): MenuEntry[] {
  const { document, commands } = editor;
  const { clip, root } = timeline;
  const clips = document.assets.fieldAssets('clip');
  const player = clipPlayer(document.scene);
  const entries: MenuEntry[] = clips.map((each) => ({
    label: each.name,
    checked: each === clip,
    run: () => timeline.choose(each.name),
  }));
  if (clips.length > 0) entries.push('separator');
  entries.push({ label: t('New clip'), icon: 'add', run: () => editor.attempt(() => newClip(editor)) });
  if (!clip) return entries;
  const component = root && player ? root.getComponent(player.type.typeName) : null;
  if (root && component && player && playedClip(root) !== clip.name) {
    const words = { name: root.name, clip: clipName(clip) };
    entries.push({
      label: t('Let {name} play {clip}', words),
      icon: 'play',
      run: () =>
        commands.run(
          new SetFields(t('Let {name} play {clip}', words), [
            { owner: component, name: player.field, value: clip.name },
          ]),
        ),
    });
  }
  entries.push({
    label: t('Frames a second'),
    entries: RATES.map((rate) => ({
      label: String(rate),
      checked: clip.frameRate === rate,
      run: () =>
        commands.run(
          new SetFields(t('Set the frame rate of {name}', { name: clipName(clip) }), [
            { owner: clip, name: 'frameRate', value: rate },
          ]),
        ),
    })),
  });
  return entries;
}
