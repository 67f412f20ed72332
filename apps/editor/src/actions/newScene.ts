import { scenes } from '@farol/engine/scenes';
import { makeEmptyScene } from '../model/makeEmptyScene';
import type { Action } from '../api/Action';

/** A scene to begin with: a camera, a sun and a sky. */
export const newScene: Action = {
  id: 'file.new',
  label: 'New empty scene',
  menu: { menu: 'file', group: 'new' },
  async run(editor) {
    if (!(await editor.mayLoseChanges())) return;
    editor.show(makeEmptyScene(editor.libraryForNext()), { name: null, handle: null });
  },
};

/** One action for each scene of the engine's. */
export const openExamples: readonly Action[] = Object.values(scenes).map(({ name, label, sample }) => ({
  id: `file.new.${name}`,
  label,
  menu: { menu: 'file', group: 'new', submenu: 'Samples' },
  async run(editor) {
    if (await editor.mayLoseChanges()) await editor.openScene(name, sample);
  },
}));
