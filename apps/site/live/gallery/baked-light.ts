/**
 * Baked light and moving lamps
 *
 * A room's reflected light is traced on the GPU while you watch; the lamp that moves is lit live on top of it.
 *
 * @tags baking, point light
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { bakeLightmaps } from '@farol/bake';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'clustered-deferred' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x000000);
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 100);
camera.position.set(0, 1.9, 6.4);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1.5, 0);
controls.update();

const wall = (color: number) => new THREE.MeshStandardMaterial({ color, roughness: 0.9 });
const add = (
  name: string,
  geometry: THREE.BufferGeometry,
  material: THREE.Material,
  x: number,
  y: number,
  z: number,
) => {
  const mesh = new THREE.Mesh(geometry, material);
  mesh.name = name;
  mesh.position.set(x, y, z);
  scene.add(mesh);
  return mesh;
};
add('floor', new THREE.BoxGeometry(4, 0.1, 4), wall(0xd8d2c8), 0, -0.05, 0);
add('ceiling', new THREE.BoxGeometry(4, 0.1, 4), wall(0xe8e4dc), 0, 3.05, 0);
add('back', new THREE.BoxGeometry(4, 3, 0.1), wall(0xe0dcd4), 0, 1.5, -2);
add('left', new THREE.BoxGeometry(0.1, 3, 4), wall(0xd04a3a), -2, 1.5, 0);
add('right', new THREE.BoxGeometry(0.1, 3, 4), wall(0x3a8ad0), 2, 1.5, 0);
add('tall', new THREE.BoxGeometry(0.9, 1.8, 0.9), wall(0xf0ece4), -0.7, 0.9, -0.7).rotation.y = 0.35;
add('low', new THREE.BoxGeometry(0.9, 0.9, 0.9), wall(0xf0ece4), 0.75, 0.45, 0.35).rotation.y = -0.3;
const panel = new THREE.RectAreaLight(0xfff0d8, 14, 1, 1);
panel.position.set(0, 2.98, 0);
panel.rotation.x = -Math.PI / 2;
const plate = new THREE.Mesh(
  new THREE.PlaneGeometry(1, 1).rotateX(Math.PI / 2),
  new THREE.MeshBasicMaterial({ color: 0xfff0d8 }),
);
plate.position.set(0, 2.97, 0);
const lamp = new THREE.PointLight(0xffa040, 1.6, 3);
lamp.add(new THREE.Mesh(new THREE.SphereGeometry(0.06, 24, 16), new THREE.MeshBasicMaterial({ color: 0xffc070 })));
scene.add(panel, plate, lamp);

const output = document.createElement('output');
output.className = 'panel';
document.body.append(output);
/** Bakes the light of what does not move; the picture shows the bake as it becomes better. */
async function bake(): Promise<void> {
  const baked = await bakeLightmaps(webgl, scene, {
    ...{ size: 256, bounces: 3, samples: 48 },
    isStatic: (object) => object !== plate && object.parent !== lamp,
    isBaked: (light) => light !== lamp,
    onProgress: ({ share }) => (output.value = `Baking: ${Math.round(100 * share)}%`),
  });
  baked.apply();
  output.value = 'Baked: three bounces';
}
const ready = bake();

function resize(): void {
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  farol.setPixelRatio(Math.min(devicePixelRatio, 2));
  farol.setSize(innerWidth, innerHeight);
}
addEventListener('resize', resize);
resize();

webgl.setAnimationLoop((milliseconds) => {
  const seconds = milliseconds / 1000;
  lamp.position.set(1.2 * Math.cos(0.7 * seconds), 1.6 + 0.4 * Math.sin(seconds), 0.9 + 0.5 * Math.sin(0.7 * seconds));
  farol.render(scene, camera);
});

export { camera, farol, ready, scene, webgl };
