import { makeEmptyScene } from '../model/makeEmptyScene';
import type { Action } from '../api/Action';
import { samples } from '../api/Sample';

/** Opens a new scene with a camera, a sun and a sky. */
export const newScene: Action = {
  id: 'file.new',
  label: 'New empty scene',
  menu: { menu: 'file', group: 'new' },
  async run(editor) {
    if (!(await editor.mayLoseChanges())) return;
    editor.show(makeEmptyScene(editor.libraryForNext()), { name: null, handle: null });
  },
};

/** One action for each sample, which opens it. */
export const openExamples: readonly Action[] = Object.values(samples).map(({ name, label }) => ({
  id: `file.new.${name}`,
  label,
  menu: { menu: 'file', group: 'new', submenu: 'Samples' },
  async run(editor) {
    if (await editor.mayLoseChanges()) await editor.openSample(name);
  },
}));
