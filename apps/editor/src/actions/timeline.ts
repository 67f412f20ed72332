import { t } from '@farol/editing';
import type { Action } from '../api/Action';
import { hasSelection } from './hasSelection';

/** Adds keys of position, rotation and scale of the selected objects at the playhead. */
export const addKeys: Action = {
  id: 'timeline.key',
  label: 'Add keys at the playhead',
  keys: ['K'],
  icon: 'key',
  async run(editor) {
    const [{ timelineOf }, { keyTransforms }] = await Promise.all([
      import('../model/timeline/timelineOf'),
      import('../model/timeline/timelineEdits'),
    ]);
    const timeline = timelineOf(editor);
    if (timeline.clip && keyTransforms(timeline)) return;
    editor.layout.open('timeline');
    editor.notices.show('info', t('Make or choose a clip for the object in the Timeline first.'));
  },
  enabled: (editor) => hasSelection(editor) && editor.document.simulation.state === 'stopped',
};

/** Switches recording, by which edits of fields become keys of the clip. */
export const record: Action = {
  id: 'timeline.record',
  label: 'Record keys',
  keys: ['Shift+K'],
  icon: 'record',
  run: ({ timeline }) => timeline?.setRecording(!timeline.isRecording),
  checked: ({ timeline }) => timeline?.isRecording ?? false,
  enabled: ({ timeline }) => timeline !== null && (timeline.isRecording || timeline.canRecord),
};
