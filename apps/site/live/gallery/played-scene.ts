/**
 * A scene from the editor, played
 *
 * A `.farol` file saved by the editor, read and played in a dozen lines: lamps, doors, sounds and prefabs.
 *
 * @tags engine, files, editor
 * @still 1 2
 */
import { App, AssetLibrary, builtinComponents, ComponentRegistry } from '@farol/engine';
import { deserialize, readSceneFile } from '@farol/engine/files';
import { registerSceneAssets } from '@farol/scenes';
import type { Scene as ThreeScene } from 'three';

const app = new App({
  canvas: document.querySelector('canvas')!,
  parent: document.body,
  renderer: { antialias: true },
});
const { renderer: farol, webgl } = app;
const response = await fetch('./scenes/night-in-the-temple.farol');
const { text, fileOf } = await readSceneFile(new Uint8Array(await response.arrayBuffer()));
const assets = new AssetLibrary({ renderer: webgl });
registerSceneAssets(assets); // the file names meshes of the temple
// scripts of the scene do not run here: their components are kept as data
const registry = new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });
app.scene = await deserialize(text, { assets, fileOf, registry });
const scene: ThreeScene = app.scene.three;
const camera = app.scene.activeCamera!.three;
app.start();
const { ready } = app;

export { camera, farol, ready, scene, webgl };
