import { t } from '@farol/editing';
import type { SceneView } from '@farol/engine';
import type { Action } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';
import { setView } from '../model/commands/SetValue';

/** Numbers under which views can be stored with a scene. */
export const places = [1, 2, 3, 4, 5, 6, 7, 8, 9] as const;

export const nameOfView = (place: number, { name }: SceneView): string =>
  name === '' ? t('View {place}', { place }) : name;

/** Stores the active view's pose, keeping the name stored before. */
export function keepView({ commands, document, viewport }: EditorApi, place: number): void {
  const { scene } = document;
  const before = scene.views.get(place);
  const view = { name: before?.name ?? '', ...viewport.editorCamera.pose };
  commands.run(setView(t('Keep view {place}', { place }), scene, place, view));
}

/** Moves the active view to a stored pose. */
export function showView({ document, viewport }: EditorApi, place: number): void {
  const view = document.scene.views.get(place);
  if (!view) return;
  viewport.lookThrough = null;
  viewport.editorCamera.show(view);
  viewport.viewChanged();
}

export const showViews: readonly Action[] = places.map((place) => ({
  id: `view.bookmark.${place}`,
  label({ document }) {
    const view = document.scene.views.get(place);
    return view ? nameOfView(place, view) : t('View {place}: empty', { place });
  },
  keys: [String(place)],
  run: (editor) => showView(editor, place),
  enabled: ({ document }) => document.scene.views.get(place) !== null,
}));

/** One action for each number, which stores the active view. */
export const keepViews: readonly Action[] = places.map((place) => ({
  id: `view.keep.${place}`,
  label: () => t('Keep this view as {place}', { place }),
  keys: [`Ctrl+${place}`],
  run: (editor) => keepView(editor, place),
}));
