import type { Action } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';

/** One action for each recent file, which opens it. */
export const recentActions = ({ recentFiles }: EditorApi): Action[] =>
  recentFiles.list.map((file) => ({
    id: `file.recent.${file.id}`,
    label: () => (file.scene === file.name.replace(/\.\w+$/, '') ? file.name : `${file.name}: ${file.scene}`),
    icon: 'scene',
    menu: { menu: 'file', group: 'open', submenu: 'Recent files' },
    async run(editor) {
      const { openRecent } = await import('../files/recent/openRecent');
      await openRecent(editor, file);
    },
  }));
