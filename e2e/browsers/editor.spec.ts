import { writeFile } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';
import type { Vector3Tuple } from 'three';
import { type Driven, expect, type Point, test } from './driven';
import { openEditor, pointsOf, savedFile } from './editorPage';
import { pictureOf } from './pictureOf';
import { problemScript } from './problems';

/** Text of the scene, without the small picture that saving makes. */
const serialized = (driven: Driven): Promise<string> =>
  driven.evaluate(() => window.editor.serialize().replace(/\n *"picture": \{[^}]*\},/, ''));
const steps = (driven: Driven): Promise<number> => driven.evaluate(() => window.editor.commands.history.length);
const positionOfBox = (driven: Driven): Promise<Vector3Tuple> =>
  driven.evaluate(
    () => window.editor.document.scene.find('Box')!.getComponent('Transform')!.getAuthored('position') as Vector3Tuple,
  );
const middle = ({ x, y }: Point, by: number): Point => ({ x: x + by, y: y + by });

async function addBox(driven: Driven): Promise<void> {
  await driven.click('button', 'Add');
  await driven.click('[role=menuitem]', 'Mesh');
  await driven.click('[role=menuitem]', 'Box');
  await driven.until(() => document.querySelector('[role=treeitem][aria-selected=true]')?.textContent.includes('Box'));
  await driven.until(() => !document.querySelector('[role=menu], .inspector[aria-busy=true]'));
}

/** Menus, typing, scrubbing, undo. */
async function edit(driven: Driven): Promise<void> {
  const empty = await serialized(driven);
  await addBox(driven);
  expect(await steps(driven)).toBe(1);

  await driven.click('input[aria-label="Position x"]');
  await driven.press('Control+a');
  await driven.type('2.5');
  await driven.press('Enter');
  expect((await positionOfBox(driven))[0]).toBe(2.5);

  const handle = await driven.middleOf('[data-field="position"] .number-handle');
  await driven.drag(handle, { x: handle.x + 40, y: handle.y });
  expect((await positionOfBox(driven))[0]).toBeGreaterThan(2.5);
  expect(await steps(driven)).toBe(3);
  const edited = await serialized(driven);

  for (let left = await steps(driven); left > 0; left--) await driven.press('Control+z');
  expect(await serialized(driven)).toBe(empty);
  for (let i = 0; i < 3; i++) await driven.press('Control+Shift+z');
  expect(await serialized(driven)).toBe(edited);
}

/** Picking, gizmo, turning and zooming the view. */
async function usePicture(driven: Driven): Promise<void> {
  await driven.click('[role=treeitem]', 'Box');
  await driven.press('f');
  // the view goes there in many frames
  const view = (): Promise<number[]> => driven.evaluate(() => window.editor.viewport.camera.matrixWorld.toArray());
  let seen = '';
  const isStill = async (): Promise<boolean> => seen === (seen = JSON.stringify(await view()));
  await expect.poll(isStill).toBe(true);
  await driven.press('Escape');
  await driven.until(() => window.editor.document.selection.ids.length === 0);
  await driven.clickAt((await pointsOf(driven, 'Box')).middle);
  await driven.until(() => window.editor.document.selectedObjects[0]?.name === 'Box');

  const from = await positionOfBox(driven);
  const { middle: at, handle } = await pointsOf(driven, 'Box');
  await driven.hover(handle);
  await driven.until(() => window.editor.viewport.gizmo.isHot);
  await driven.drag(handle, { x: handle.x + (handle.x - at.x), y: handle.y + (handle.y - at.y) });
  const to = await positionOfBox(driven);
  expect(to[0]).toBeGreaterThan(from[0] + 0.05);
  expect(to.slice(1)).toEqual(from.slice(1));

  const distance = (): Promise<number> =>
    driven.evaluate(() => {
      const { camera, target } = window.editor.viewport.editorCamera;
      const [x, y, z] = target.toArray();
      return Math.hypot(camera.position.x - x, camera.position.y - y, camera.position.z - z);
    });
  const corner = middle(await driven.middleOf('.viewport-place canvas'), 90);
  const turned = await view();
  await driven.drag(corner, { x: corner.x + 60, y: corner.y + 20 });
  await expect.poll(view).not.toEqual(turned);

  // one turn of a mouse's wheel is 100 pixels or 3 lines, by browser
  const far = await distance();
  await driven.wheel(corner, 100);
  await expect.poll(distance).toBeGreaterThan(far * 1.02);
  expect(await distance()).toBeLessThan(far * 1.6);
}

async function playSaveOpen(driven: Driven): Promise<void> {
  const saved = await serialized(driven);
  await driven.press('Control+p');
  await driven.until(() => window.editor.document.scene.time > 0.2);
  await driven.press('Control+p');
  await driven.until(() => window.editor.document.simulation.state === 'stopped');
  expect(await serialized(driven)).toBe(saved);

  await driven.press('Control+s');
  const file = await savedFile(driven, '.farol');
  expect(file.subarray(30, 40).toString()).toBe('scene.json');
  await driven.until(() => !window.editor.commands.isDirty);
  await driven.press('Delete');
  expect(await serialized(driven)).not.toBe(saved);
  await driven.press('Control+z');
  await driven.evaluate(async () => {
    const [[name, blob]] = window.savedFiles;
    const bytes = new Uint8Array(await blob.arrayBuffer());
    await window.editor.openFileBytes(bytes as never, { name, handle: null });
  });
  await expect.poll(() => serialized(driven)).toBe(saved);
}

test('editor: menus, typing, scrubbing, undo, picking, gizmo, wheel, play, save, open', async ({ driven }) => {
  await openEditor(driven);
  await test.step('edit', () => edit(driven));
  await test.step('picture', () => usePicture(driven));
  await test.step('file', () => playSaveOpen(driven));
});

test('exported page, from a disk: drawn, turned by the pointer', async ({ driven, found }, info) => {
  await openEditor(driven);
  await driven.evaluate(() => window.editor.openScene('benchmarkLights', { n: 3, m: 3 }));
  await driven.press('Control+Shift+e');
  await driven.click('button', 'Web page…');
  const html = await savedFile(driven, '.html');
  const path = info.outputPath('page.html');
  await writeFile(
    path,
    html.toString().replace(/<head>/, (head) => `${head}<script>${problemScript}</script>`),
  );
  found(`${(html.length / 1e6).toFixed(2)} MB`);

  await driven.open(pathToFileURL(path).href);
  await driven.until(() => document.querySelector('canvas')?.ariaLabel);
  await driven.evaluate(() => window.FarolPlayer.ready);
  const picture = await pictureOf(driven);
  expect(picture.colours).toBeGreaterThan(500);
  const at = await driven.middleOf('canvas');
  await driven.drag(at, { x: at.x + 80, y: at.y });
  await expect.poll(async () => (await pictureOf(driven)).url).not.toBe(picture.url);
});
