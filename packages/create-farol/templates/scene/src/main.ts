import * as engine from '@farol/engine';
import * as fields from '@farol/engine/fields';
import { deserialize, readSceneFile } from '@farol/engine/files';
import { compileScript, runInPage, SceneScripts } from '@farol/engine/scripts';
import { registerSceneAssets } from '@farol/scenes';
import * as three from 'three';

/** File saved by the editor, .farol or .json; put yours into public/ and its name here. */
const file = './scene.json';

const app = new engine.App({ parent: document.body, renderer: { antialias: true } });
const assets = new engine.AssetLibrary({ renderer: app.webgl });
registerSceneAssets(assets); // meshes of Farol's demo scenes, for scenes that are based on one
const registry = new engine.ComponentRegistry(engine.builtinComponents.types.values(), { keepUnknown: true });

const response = await fetch(file);
const { text, fileOf } = await readSceneFile(new Uint8Array(await response.arrayBuffer()));
const scene = await deserialize(text, { assets, registry, fileOf });

const modules = { three, '@farol/engine': engine, '@farol/engine/fields': fields };
const scripts = new SceneScripts(scene, registry, { modules, run: runInPage, compile: compileScript });
await scripts.settled();
for (const { message } of scripts.errors.values()) console.error(message);

if (!scene.activeCamera) {
  const camera = new engine.GameObject('Camera');
  camera.transform.position = [0, 2, 8];
  scene.add(camera);
  scene.activeCamera = camera.addComponent(engine.Camera);
}
document.title = scene.name;
app.scene = scene;
app.start();
