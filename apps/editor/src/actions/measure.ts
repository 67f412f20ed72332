import { t } from '@farol/editing';
import { openBeside } from '@farol/engine/files';
import type { Action } from '../api/Action';

/** Opens the current scene in the Lab, which measures techniques. */
export const measure: Action = {
  id: 'file.measure',
  label: 'Measure this scene',
  icon: 'gauge',
  menu: { menu: 'file', group: 'share' },
  run: (editor) =>
    openBeside('lab', t('the Lab'), {
      fragment: '#preset=custom&series=own:pixels:230,922,2074',
      scene: {
        name: editor.document.scene.name,
        bytes: async () => {
          const { measuredFile } = await import('../files/share/measuredFile');
          return measuredFile(editor);
        },
      },
    }),
};
