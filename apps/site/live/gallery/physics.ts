/**
 * Physics
 *
 * Lamps are rigid bodies: Rapier lets a heap of glowing balls roll down a stair, and their light goes with them.
 *
 * @tags engine, physics, point light
 * @still 2.4 48
 */
import {
  App,
  Camera,
  Collider,
  GameObject,
  Light,
  MouseController,
  ObjectRenderer,
  RigidBody,
  Scene,
} from '@farol/engine';
import { loadRapier } from '@farol/engine/physics';
import { MathUtils, type Scene as ThreeScene } from 'three';

await loadRapier(); // else the scene fetches it while its first frames are drawn
const stage = new Scene({ name: 'Stair' });
const add = (name: string, position: [number, number, number], scale: [number, number, number] = [1, 1, 1]) => {
  const object = new GameObject(name);
  object.transform.position = position;
  object.transform.scale = scale;
  stage.add(object);
  return object;
};
const view = add('Camera', [7, 5, 9]);
view.transform.lookAt([7, 5, 9], [0, 1.2, 0]);
stage.activeCamera = view.addComponent(Camera, { fov: 0.75 });
view.addComponent(MouseController); // drag to look around

for (let i = 0; i < 9; i++) {
  const step = add('Step', [-4 + i, 0.22 * (8 - i) - 0.5, 0], [1, 0.44 * (8 - i) + 1, 5]);
  step.addComponent(ObjectRenderer, { mesh: 'box', colour: [0.62, 0.56, 0.5], roughness: 0.6 });
  step.addComponent(Collider, { shape: 'box' });
}
const floor = add('Floor', [0, -0.25, 0], [40, 0.5, 40]);
floor.addComponent(ObjectRenderer, { mesh: 'box', colour: [0.3, 0.31, 0.35], roughness: 0.4 });
floor.addComponent(Collider, { shape: 'box' });

for (let i = 0; i < 40; i++) {
  const hue = MathUtils.seededRandom();
  const colour = [0.35 + 0.65 * hue, 0.3 + 0.4 * ((3 * hue) % 1), 1 - 0.9 * hue] as const;
  const place = [-4 + 0.5 * (i % 3), 4.5 + 0.45 * Math.floor(i / 5), 0.6 * ((i % 5) - 2)] as const;
  const ball = add('Ball', [...place], [0.36, 0.36, 0.36]);
  ball.addComponent(ObjectRenderer, {
    mesh: 'sphere',
    colour: [...colour],
    emissive: [...colour],
    emissiveIntensity: 1.5,
  });
  ball.addComponent(Light, { diffuse: [...colour], intensity: 2.4, range: 2.6 });
  ball.addComponent(RigidBody, { mass: 1 });
  ball.addComponent(Collider, { shape: 'sphere', restitution: 0.45 });
}

const app = new App({
  canvas: document.querySelector('canvas')!,
  parent: document.body,
  renderer: { antialias: true },
  scene: stage,
});
const { renderer: farol, webgl } = app;
const scene: ThreeScene = app.scene.three;
const camera = app.scene.activeCamera!.three;
app.start();

export { camera, farol, scene, webgl };
