import { t } from '@farol/editing';
import { openBeside } from '@farol/engine/files';
import type { EditorApi } from '../../api/EditorApi';

/** Opens the scene in the Lab, with the series of measurements that is the default for users' scenes. */
export const openInLab = (editor: EditorApi): Promise<void> =>
  openBeside('lab', t('the Lab'), {
    fragment: '#preset=custom&series=own:pixels:230,922,2074',
    scene: {
      name: editor.document.scene.name,
      bytes: async () => {
        const { measuredFile } = await import('./measuredFile');
        return measuredFile(editor);
      },
    },
  });
