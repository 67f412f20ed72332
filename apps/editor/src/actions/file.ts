import { t } from '@farol/editing';
import type { Action } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';
import { samples } from '../api/Sample';
import { fileType } from '../files/fileType';
import { makeEmptyScene } from '../model/makeEmptyScene';

/** Opens the welcome page with samples, recent files and the tour. */
export const welcome: Action = {
  id: 'file.welcome',
  label: 'Welcome…',
  icon: 'lamp',
  run: ({ dialogs }) => void dialogs.show({ kind: 'welcome', recovery: null }),
};

/** Opens a new scene with a camera, a sun and a sky. */
export const newScene: Action = {
  id: 'file.new',
  label: 'New empty scene',
  async run(editor) {
    if (!(await editor.mayLoseChanges())) return;
    editor.show(makeEmptyScene(editor.libraryForNext()), { name: null, handle: null });
  },
};

/** One action for each sample, which opens it. */
export const openExamples: readonly Action[] = Object.values(samples).map(({ name, label }) => ({
  id: `file.new.${name}`,
  label,
  async run(editor) {
    if (await editor.mayLoseChanges()) await editor.openSample(name);
  },
}));

export const open: Action = {
  id: 'file.open',
  label: 'Open…',
  keys: ['Ctrl+O'],
  inFields: true,
  icon: 'open',
  async run(editor) {
    const { fileOpen } = await import('browser-fs-access');
    const file = await fileOpen(fileType);
    const { name, handle = null } = file;
    await editor.openFileBytes(new Uint8Array(await file.arrayBuffer()), { name, handle });
  },
};

/** One action for each recent file, which opens it. */
export const recentActions = ({ recentFiles }: EditorApi): Action[] =>
  recentFiles.list.map((file) => ({
    id: `file.recent.${file.id}`,
    label: () => (file.scene === file.name.replace(/\.\w+$/, '') ? file.name : `${file.name}: ${file.scene}`),
    icon: 'scene',
    async run(editor) {
      const { openRecent } = await import('../files/recent/openRecent');
      await openRecent(editor, file);
    },
  }));

async function write(editor: EditorApi, handle: FileSystemFileHandle | null): Promise<void> {
  const { writeScene } = await import('../files/writeScene');
  await writeScene(editor, handle);
}

export const save: Action = {
  id: 'file.save',
  label: 'Save',
  keys: ['Ctrl+S'],
  inFields: true,
  icon: 'save',
  run: (editor) => write(editor, editor.file.handle),
};

export const saveAs: Action = {
  id: 'file.save-as',
  label: 'Save as…',
  keys: ['Ctrl+Shift+S'],
  inFields: true,
  run: (editor) => write(editor, null),
};

export const exportScene: Action = {
  id: 'file.export',
  label: 'Export and share…',
  keys: ['Ctrl+Shift+E'],
  inFields: true,
  icon: 'assets',
  run: ({ dialogs }) => void dialogs.show({ kind: 'export' }),
};

export const openOnPhone: Action = {
  id: 'file.phone',
  label: 'Open on a phone…',
  run: ({ dialogs }) => void dialogs.show({ kind: 'phone' }),
};

export const savePicture: Action = {
  id: 'file.picture',
  label: 'Save a picture…',
  icon: 'camera',
  run: ({ dialogs }) => void dialogs.show({ kind: 'picture' }),
};

export const saveFilm: Action = {
  id: 'file.film',
  label: 'Save a film…',
  icon: 'play',
  run: ({ dialogs }) => void dialogs.show({ kind: 'film' }),
};

export const choosePicture: Action = {
  id: 'file.thumbnail',
  label: 'Use this view as the scene’s picture',
  run: async (editor) => (await import('../files/recent/scenePicture')).choosePicture(editor),
};

export const letAgentEdit: Action = {
  id: 'file.agent',
  label: 'Let an agent edit…',
  run: ({ dialogs }) => void dialogs.show({ kind: 'agent' }),
};

/** Opens the current scene in the Lab, which measures techniques. */
export const measure: Action = {
  id: 'file.measure',
  label: 'Measure this scene',
  icon: 'gauge',
  run: async (editor) => (await import('../files/share/openInLab')).openInLab(editor),
};

/** Offers unsaved scenes of closed tabs again, including those put off with the button Later. */
export const recover: Action = {
  id: 'file.recover',
  label: 'Recover…',
  icon: 'undo',
  async run(editor) {
    if (!editor.autosave) return;
    if (await editor.autosave.offerRecovery()) return;
    editor.notices.show('info', t('There is nothing to recover: no tab was closed with unsaved work'));
  },
  enabled: ({ autosave }) => autosave !== null,
};
