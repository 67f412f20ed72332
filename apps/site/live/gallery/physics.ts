/**
 * Falling lamps
 *
 * Glowing balls are thrown at a wall of crates by Rapier's physics; each is a moving light. Press to throw one yourself.
 *
 * @tags engine, physics, point light
 * @still 2.4 60
 */
import { App, Camera, Collider, GameObject, Light, ObjectRenderer, PhysicsSystem, RigidBody } from '@farol/engine';
import { type Scene as ThreeScene, Vector3 } from 'three';

const canvas = document.querySelector('canvas')!;
const app = new App({ canvas, parent: document.body, renderer: { antialias: true } });
const { renderer: farol, webgl } = app;
app.scene.settings.set('backgroundColour', [0.01, 0.012, 0.02]);

function add(name: string, position: [number, number, number], scale: [number, number, number] = [1, 1, 1]) {
  const object = new GameObject(name);
  object.transform.position = position;
  object.transform.scale = scale;
  app.scene.add(object);
  return object;
}

const eye = add('Camera', [0, 0, 0]).addComponent(Camera, { fov: 0.8, toneMapping: 'aces-filmic' });
eye.lookAt([4.2, 3.4, 10], [0, 1.6, 0]);
add('Sky', [0, 0, 0]).addComponent(Light, { type: 'hemisphere', diffuse: [0.3, 0.4, 0.7], intensity: 0.25 });

const floor = add('Floor', [0, -0.25, 0], [60, 0.5, 60]);
floor.addComponent(ObjectRenderer, { colour: [0.25, 0.25, 0.28], roughness: 0.7 });
floor.addComponent(Collider); // without a body it stays where it is

for (let i = 0; i < 40; i++) {
  const row = Math.floor(i / 8);
  const crate = add('Crate', [(i % 8) * 1.02 - 3.6 + 0.5 * (row % 2), 0.31 + 0.62 * row, 0], [1, 0.6, 0.7]);
  crate.addComponent(ObjectRenderer, { colour: [0.5, 0.3, 0.14], roughness: 0.8 });
  crate.addComponent(Collider);
  crate.addComponent(RigidBody, { mass: 2 });
}

const balls = Array.from({ length: 24 }, (_, i) => {
  const colour = [1, 0.2 + 0.5 * ((i * 0.37) % 1), 0.04 + 0.6 * ((i * 0.61) % 1)] as const;
  const ball = add('Ball', [2.2 * Math.sin(2.4 * i), 5 + 1.1 * i, 2 * Math.cos(2.4 * i)], [0.5, 0.5, 0.5]);
  ball.addComponent(ObjectRenderer, { mesh: 'sphere', kind: 'basic', colour });
  ball.addComponent(Light, { diffuse: colour, intensity: 5, range: 6 });
  ball.addComponent(Collider, { shape: 'sphere', restitution: 0.5 });
  return ball.addComponent(RigidBody, { mass: 4 });
});

let thrown = 0;
function throwBall(target: Vector3): void {
  const ball = balls[thrown++ % balls.length];
  const from = new Vector3(4.2, 3.4, 10);
  ball.teleport(from);
  ball.velocity = target.sub(from).normalize().multiplyScalar(16);
}
canvas.addEventListener('pointerdown', ({ offsetX, offsetY }) => {
  const { clientWidth, clientHeight } = canvas;
  throwBall(new Vector3((2 * offsetX) / clientWidth - 1, 1 - (2 * offsetY) / clientHeight, 0.5).unproject(camera));
});
let next = 1;
app.onFrame(({ time }) => {
  if (time < next) return;
  next = time + 1.2;
  throwBall(new Vector3(2.5 * Math.sin(1.9 * thrown), 1.2 + 0.8 * Math.sin(thrown), 0));
});

const scene: ThreeScene = app.scene.three;
const camera = eye.three;
await app.scene.system(PhysicsSystem).prepare(); // so that Rapier is loaded before the first frame
app.start();

export { camera, farol, scene, webgl };
