/**
 * Draws the pictures of the editor's library, by the editor itself on the software rasteriser, into
 * `public/library`: each item alone in a small room at dusk, lit by its own lights and two weak ones.
 *
 *     node packages/tools/libraryPictures.mjs
 *     node packages/tools/libraryPictures.mjs torch tree
 *     node packages/tools/libraryPictures.mjs material
 */
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { savePicture, withEditor } from './editorPictures.mjs';
import { root } from './root.mjs';

/** Width and height of a picture (pixels); it is drawn at three times that. */
const SIZE = 128;
/** Quality of the WebP pictures, 0 to 1. */
const QUALITY = 0.8;

/**
 * Runs in the page: puts an item before a grey wall, on a floor, at dusk, and looks at it from the right and above.
 *
 * @param {[id: string, group: string]} given
 */
async function showItem([id, group]) {
  const { editor } = /** @type {any} */ (window);
  // addresses of the sources, which the server gives
  const [place, make, bounds] = await Promise.all(
    ['files/library/placeLibraryItem', 'model/creations', 'viewport/boundsOf'].map((path) => import(`/src/${path}.ts`)),
  );
  editor.commands.clear();
  await editor.actions.get('file.new').run(editor);
  const { scene } = editor.document;
  const [, sun, sky] = scene.roots;
  sun.getComponent('Light').set('intensity', 1.8);
  sun.transform.lookAt([3, 5, 6], [0, 0, 0]);
  sky.getComponent('Light').set('intensity', 1);
  sky.getComponent('Light').set('diffuse', [0.6, 0.7, 1]);
  scene.settings.set('backgroundColour', [0.02, 0.026, 0.045]);
  const isSky = !['lamp', 'prop', 'play', 'material'].includes(group);
  if (group === 'material' || isSky) {
    const sphere = await make
      .creations(scene)
      .find((/** @type {{ label: string }} */ each) => each.label === 'Sphere')
      .make();
    sphere.transform.position = [0, 0.5, 0];
    scene.add(sphere);
    editor.document.selection.set([sphere.id]);
  }
  await place.placeLibraryItem(editor, id);
  if (group === 'material') {
    await place.placeLibraryItem(editor, 'studio');
    scene.settings.set('background', 'sky');
    scene.settings.set('backgroundBlur', 0.6);
  }
  if (id === 'player') scene.activeCamera = scene.roots[0].getComponent('Camera');
  await scene.settings.skyReady;
  const item = scene.findById(editor.document.selection.ids[0]);
  if (group !== 'material' && !isSky) item.transform.position = [0, 0, 0];
  // lamps shine along -Z
  if (item.tags.includes('wall')) item.transform.rotation = [0, Math.PI, 0];
  else if (id === 'headlamps' || id === 'floodlight') item.transform.rotation = [0, 2.4, 0];
  await new Promise((resolve) => setTimeout(resolve, 300));
  editor.viewport.renderNow();
  const box = bounds.boundsOf([item]);
  const centre = box.min.clone().add(box.max).multiplyScalar(0.5);
  const radius = box.min.distanceTo(box.max) / 2;
  const isHung = item.tags.includes('ceiling');
  const isOnWall = item.tags.includes('wall');
  const addBox = async (/** @type {number[]} */ position, /** @type {number[]} */ scale) => {
    const object = await make
      .creations(scene)
      .find((/** @type {{ icon: string, label: string }} */ each) => each.label === 'Box')
      .make();
    object.getComponent('ObjectRenderer').set('colour', [0.35, 0.35, 0.37]);
    object.transform.position = position;
    object.transform.scale = scale;
    scene.add(object);
  };
  const wide = 40 * radius;
  if (group !== 'material' && !isSky)
    await addBox([0, centre.y, isOnWall ? -0.051 : box.min.z - 1.2 * radius - 0.05], [wide, wide, 0.1]);
  if (!isOnWall && group !== 'material' && id !== 'ground')
    await addBox([0, (isHung ? box.min.y - radius : 0) - 0.051, 0], [wide, 0.1, wide]);
  editor.document.selection.set([]);
  const fov = 0.45;
  const distance = ((isSky ? 2.4 : 0.92) * radius) / Math.sin(fov / 2);
  const way = [
    isSky ? 0.35 : 0.5,
    isHung ? -0.12 : isSky ? -0.02 : id === 'street' || id === 'ground' ? 0.9 : 0.3,
    isSky ? 0.9 : 1,
  ].map((each, _, all) => each / Math.hypot(...all));
  // the sky takes most of its picture
  const target = [centre.x, centre.y + (isSky ? 1.4 : 0), centre.z];
  const position = target.map((each, i) => each + way[i] * distance);
  editor.viewport.editorCamera.show({ position, target, fov, orthographic: false }, false);
  await new Promise((resolve) => setTimeout(resolve, 1500));
}

const folder = join(root, 'public/library');
mkdirSync(folder, { recursive: true });
let bytes = 0;
await withEditor('scene=empty&welcome=no', { width: 900, height: 700 }, async (page) => {
  await page.evaluate(() => {
    const { editor } = /** @type {any} */ (window);
    editor.layout.maximise('viewport');
    Object.assign(editor.viewport, { showGrid: false, showIcons: false });
  });
  const items = /** @type {{ id: string, group: string, picture: string | null }[]} */ (
    await page.evaluate(async (path) => (await import(path)).libraryItems(), '/src/files/library/libraryItems.ts')
  );
  const wanted = process.argv.slice(2);
  for (const { id, group, picture } of items) {
    if (picture === null) continue;
    const name = picture.slice(picture.lastIndexOf('/') + 1);
    if (wanted.length > 0 && !wanted.includes(id) && !wanted.includes(group)) continue;
    await page.evaluate(showItem, /** @type {[string, string]} */ ([id, group]));
    bytes += await savePicture(page, join(folder, name), { width: SIZE, height: SIZE, quality: QUALITY });
  }
});
console.log(`${(bytes / 1000).toFixed(0)} kB in all`);
