/**
 * The atrium
 *
 * A hall of the scale of Sponza made in code: 254,000 triangles, two storeys of arcades, a hundred lamps.
 *
 * @tags engine, scenes, many lights
 * @editor ?scene=sponza
 * @still 1 2
 */
import { App } from '@farol/engine';
import { sponza } from '@farol/scenes';
import type { Scene as ThreeScene } from 'three';

const app = new App({
  canvas: document.querySelector('canvas')!,
  parent: document.body,
  renderer: { antialias: true },
  scene: await sponza(100, { textureSize: 128 }),
});
const { renderer: farol, webgl } = app;
const scene: ThreeScene = app.scene.three;
const camera = app.scene.activeCamera!.three;
app.start();

export { camera, farol, scene, webgl };
