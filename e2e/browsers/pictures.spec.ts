import { movingScene } from '../editor/film';
import { expect, test } from './driven';
import { openEditor, savedFile } from './editorPage';

/** Parts of the viewport that its handle for other tests leaves out. */
interface ShownViewport {
  view: string;
  lookThrough: unknown;
  readonly picture: { readonly ready: Promise<void> };
  readonly panes: { readonly list: readonly { readonly shown: { readonly tiles: readonly object[] } | null }[] };
}

test('editor: fog, a shadow map shown, a pixel explained; in Firefox a film of three frames', async ({
  driven,
  found,
}) => {
  await openEditor(driven);
  const scene = JSON.parse(movingScene(0.1));
  scene.settings.volumetricFog = true;
  scene.objects[0].components[0].values.rotation = [-0.2, 0, 0]; // towards the floor
  scene.objects.find(({ name }: { name: string }) => name === 'sun').components[1].values.castShadow = true;
  await driven.evaluate(async (text) => {
    await window.editor.openFileBytes(text, { name: 'film.farol.json', handle: null });
    await (window.editor.viewport as unknown as ShownViewport).picture.ready;
  }, JSON.stringify(scene));

  await driven.evaluate(() => void ((window.editor.viewport as unknown as ShownViewport).view = 'froxels'));
  const tiles = (): Promise<number> =>
    driven.evaluate(() => (window.editor.viewport as unknown as ShownViewport).panes.list[0].shown?.tiles.length ?? 0);
  await expect.poll(tiles).toBeGreaterThan(8);
  await driven.evaluate(() => void ((window.editor.viewport as unknown as ShownViewport).view = 'shadow-atlas'));
  await expect.poll(tiles).toBe(1);
  await driven.evaluate(() => void ((window.editor.viewport as unknown as ShownViewport).view = 'final'));

  await driven.evaluate(() => {
    const { viewport, document } = window.editor;
    (viewport as unknown as ShownViewport).lookThrough = document.scene.find('camera')!.getComponent('Camera');
    viewport.canvas.focus();
  });
  await driven.press('Shift+M');
  await driven.click('button', 'Explain the middle');
  const rows = (): Promise<string> =>
    driven.evaluate(() =>
      [...document.querySelectorAll('[aria-label="Explain a pixel"] tr')].map(({ textContent }) => textContent).join(),
    );
  await expect.poll(rows).toMatch(/sun.*\d %/);
  await driven.click('button', 'Close');

  // WebKitGTK 2.50 ends the page's process when it is asked what it encodes: see limits.md
  if (test.info().project.name === 'webkit') return;
  // fog takes 64 draws a frame
  await driven.evaluate(() => void Object.assign(window.editor.document.scene.settings, { volumetricFog: false }));
  await driven.click('[role="menuitem"]', 'File');
  await driven.click('[role="menuitem"]', 'Save a film…');
  for (const [label, value] of Object.entries({ Width: '96', Height: '64', To: '0.1' })) {
    await driven.click(`[role="dialog"] input[aria-label="${label}"]`);
    await driven.press('Control+a');
    await driven.type(value);
    await driven.press('Enter');
  }
  await driven.click('[role="dialog"] button', 'Save');
  const film = await savedFile(driven, '');
  const [name] = await driven.evaluate(() => [...window.savedFiles.keys()]);
  found(`${name.replace(/.*\./, '')} of ${(film.length / 1000).toFixed(1)} kB`);
  expect(film.length).toBeGreaterThan(500);
});
