/**
 * The thesis's room
 *
 * A dragon, a ball and a cylinder under the three kinds of light: NiceScene of 2.2.1.3, by the engine.
 *
 * @tags engine, scenes, thesis
 * @still 1 2
 */
import { App } from '@farol/engine';
import { niceScene } from '@farol/scenes';
import type { Scene as ThreeScene } from 'three';

const app = new App({
  canvas: document.querySelector('canvas')!,
  parent: document.body,
  renderer: { antialias: true },
  technique: 'clustered-forward',
  scene: await niceScene({ lights: 12, shadows: true }),
});
const { renderer: farol, webgl } = app;
const scene: ThreeScene = app.scene.three;
const camera = app.scene.activeCamera!.three;
app.start();

export { camera, farol, scene, webgl };
