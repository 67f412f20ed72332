import { type Command, t } from '@farol/editing';
import type { Scene, ScenePicture } from '@farol/engine';
import type { EditorApi } from '../../api/EditorApi';
import { smallPicture } from './smallPicture';

/** The picture stored with a scene; null for none. */
export function storedPicture({ picture }: Scene): Blob | null {
  if (!picture) return null;
  const [head, bytes] = picture.url.slice('data:'.length).split(';base64,');
  return new Blob([Uint8Array.from(atob(bytes), (letter) => letter.charCodeAt(0))], { type: head });
}

/** Draws a picture of the current view; null when none can be made. */
async function makePicture(editor: EditorApi): Promise<ScenePicture | null> {
  const blob = await smallPicture(editor);
  if (!blob) return null;
  const letters = Array.from(new Uint8Array(await blob.arrayBuffer()), (byte) => String.fromCharCode(byte));
  return { url: `data:${blob.type};base64,${btoa(letters.join(''))}` };
}

/**
 * Gives the scene a picture before it is saved: of the view as shown, unless the user chose one or the scene plays. Not
 * in `.json` files, which people read and compare.
 */
export async function keepPicture(editor: EditorApi, fileName: string): Promise<void> {
  const { scene, simulation } = editor.document;
  if (scene.picture?.chosen || simulation.state !== 'stopped' || fileName.toLowerCase().endsWith('.json')) return;
  // a scene is saved without a picture rather than not at all
  const picture = await makePicture(editor).catch(() => null);
  if (picture && editor.document.scene === scene) scene.picture = picture;
}

/** Stores a picture of the current view with the scene, as a step of history. @throws Error when none can be made */
export async function choosePicture(editor: EditorApi): Promise<void> {
  const { commands, document, notices } = editor;
  const { scene } = document;
  const made = await makePicture(editor);
  if (!made) throw new Error(t('No picture could be made: show the panel Viewport and try again.'));
  const before = scene.picture;
  const picture: ScenePicture = { ...made, chosen: true };
  const command: Command = {
    label: t('Chose the scene’s picture'),
    isEmpty: false,
    do: () => void (scene.picture = picture),
    undo: () => void (scene.picture = before),
  };
  commands.run(command);
  notices.show('info', t('This view is the scene’s picture: lists of files show it once the scene is saved.'));
}
