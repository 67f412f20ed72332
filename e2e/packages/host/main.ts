import { attachEditor } from '@farol/attach';
import { bakeLightmaps } from '@farol/bake';
import { App, GameObject, Light, ObjectRenderer } from '@farol/engine';
import { loadRapier } from '@farol/engine/physics';
import { compileScript } from '@farol/engine/scripts';
import { FarolRenderer, type TechniqueName } from '@farol/renderer';
import { temple } from '@farol/scenes';
import {
  DataUtils,
  FloatType,
  Mesh,
  MeshLambertMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  PointLight,
  Scene,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { litScene } from './litScene';

const WIDTH = 160;
const HEIGHT = 120;
const webgl = new WebGLRenderer();
webgl.shadowMap.enabled = true;
webgl.setSize(WIDTH, HEIGHT);
document.body.append(webgl.domElement);
const scene = litScene();
const camera = new PerspectiveCamera(50, WIDTH / HEIGHT, 0.1, 50);
camera.position.set(0, 4, 7);
camera.lookAt(0, 0, 0);

/** Linear floats of what is drawn, bottom row first. */
function picture(draw: () => void) {
  const target = new WebGLRenderTarget(WIDTH, HEIGHT, { type: FloatType });
  const data = new Float32Array(WIDTH * HEIGHT * 4);
  webgl.setRenderTarget(target);
  draw();
  webgl.readRenderTargetPixels(target, 0, 0, WIDTH, HEIGHT, data);
  webgl.setRenderTarget(null);
  target.dispose();
  return { width: WIDTH, height: HEIGHT, data: [...data] };
}

/** Functions that the test calls in the page. */
const page = {
  /** The scene as stock three draws it. */
  stock: () => picture(() => webgl.render(scene, camera)),

  /** The scene drawn by Farol, with all code that is fetched on demand. */
  async byFarol(technique: TechniqueName) {
    await FarolRenderer.preload();
    const farol = new FarolRenderer(webgl, { technique });
    try {
      return picture(() => farol.render(scene, camera));
    } finally {
      farol.dispose();
    }
  },

  /** A frame of the engine's: its draws, and whether the engine's renderer is the one that the page imports. */
  byEngine() {
    const app = new App({ webgl, technique: 'clustered-forward' });
    const lamp = new GameObject('Lamp');
    lamp.addComponent(Light, { intensity: 8, range: 6 });
    const box = new GameObject('Box');
    box.addComponent(ObjectRenderer);
    app.scene.add(lamp);
    app.scene.add(box);
    app.scene.setTime(0);
    app.renderer.render(app.scene.three, camera);
    const { drawCalls } = app.renderer.info;
    const isOneRenderer = app.renderer instanceof FarolRenderer;
    app.dispose();
    return { drawCalls, isOneRenderer };
  },

  /** Draws of a frame of a demo scene. */
  async byScenes() {
    const app = new App({ webgl, technique: 'deferred', scene: await temple(4) });
    app.scene.setTime(0);
    app.renderer.render(app.scene.three, camera);
    const { drawCalls } = app.renderer.info;
    app.dispose();
    return drawCalls;
  },

  /** Errors of what the engine does by packages that this host has not installed. */
  async byMissing() {
    const error = (promise: Promise<unknown>) => promise.then(() => 'none', String);
    return [await error(loadRapier()), await error(compileScript('Spin', 'export default class {}'))];
  },

  /** Bakes a floor, with the worker that unwraps it. */
  async byBake() {
    const room = new Scene();
    const floor = new Mesh(new PlaneGeometry(2, 2), new MeshLambertMaterial());
    const lamp = new PointLight(0xffffff, 3);
    lamp.position.z = 1;
    room.add(floor, lamp);
    const bake = await bakeLightmaps(webgl, room, { size: 16, bounces: 0, showProgress: false });
    const brightest = Math.max(...Array.from(bake.lightmaps[0].data, DataUtils.fromHalfFloat));
    bake.dispose();
    return { brightest, corners: bake.meshes[0].uv1.length / 2 };
  },

  /** Attaches the editor, has Farol draw the page, and takes the editor away. */
  async byEditor() {
    const before = document.body.childElementCount;
    const editor = attachEditor(scene, camera, webgl);
    const panels = document.body.childElementCount - before;
    await editor.drawWith('deferred');
    webgl.render(scene, camera);
    const isOneRenderer = editor.farol instanceof FarolRenderer;
    const technique = editor.farol?.info.technique;
    editor.dispose();
    return { panels, isOneRenderer, technique, left: document.body.childElementCount - before };
  },
};

export type HostPage = typeof page;
Object.assign(window, { page });
