/**
 * Temple under fifty lamps
 *
 * A scene of `@farol/scenes` in an `App`: marble columns, six steady lamps and fifty that wander.
 *
 * @tags engine, scenes, many lights
 * @editor ?scene=temple
 * @still 1 2
 */
import { App } from '@farol/engine';
import { temple } from '@farol/scenes';
import type { Scene as ThreeScene } from 'three';

const app = new App({
  canvas: document.querySelector('canvas')!,
  parent: document.body,
  renderer: { antialias: true },
  scene: await temple(50),
});
const { renderer: farol, webgl } = app;
const scene: ThreeScene = app.scene.three;
const camera = app.scene.activeCamera!.three;
app.start();

export { camera, farol, scene, webgl };
