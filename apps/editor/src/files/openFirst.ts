import { shortText, t } from '@farol/editing';
import { type AssetLibrary, Light, type Scene } from '@farol/engine';
import { scenes } from '@farol/scenes';
import type { EditorApi } from '../api/EditorApi';
import { samples } from '../api/Sample';
import { makeEmptyScene } from '../model/makeEmptyScene';

/** Reads the editor's next scene. @returns null when another one was opened meanwhile */
type Read = (build: (assets: AssetLibrary) => Promise<Scene>) => Promise<Scene | null>;

/** Opens the first scene of an editor. @param name - a sample's, or 'empty'; the temple when null or unknown */
export async function openFirst(editor: EditorApi, name: string | null, read: Read): Promise<void> {
  if (name === 'empty') editor.show(makeEmptyScene(editor.document.assets), { name: null, handle: null });
  else if (name !== null && Object.hasOwn(samples, name)) await openNamed(editor, name);
  else {
    await openTemple(editor, read);
    if (name === null) return;
    editor.notices.show(
      'warning',
      t('There is no scene “{text}”: there are empty, {names}.', {
        text: shortText(name, 60),
        names: Object.keys(samples).join(', '),
      }),
    );
  }
}

const openNamed = (editor: EditorApi, name: string): Promise<void> =>
  Object.hasOwn(scenes, name) ? editor.openScene(name) : editor.openSample(name);

/** Opens the temple in the evening; its first frame is shown before the programs of shadows are compiled. */
async function openTemple(editor: EditorApi, read: Read): Promise<void> {
  const scene = await read((assets) => scenes.temple.build({ lights: 50, evening: true }, assets));
  if (!scene) return;
  const casting = scene.componentsOf(Light).filter(({ castShadow }) => castShadow);
  for (const light of casting) light.castShadow = false;
  editor.show(scene, { name: null, handle: null });
  for (const light of casting) light.castShadow = true;
  editor.viewport.invalidate();
}
