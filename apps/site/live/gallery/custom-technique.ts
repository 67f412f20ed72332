/**
 * A technique of your own
 *
 * Passes put together from `@farol/renderer/authoring`: stone by a G-buffer, glass forward, both by one set of light lists.
 *
 * @tags technique, authoring, deferred, transparency
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { forwardTail, GBufferPass, LightTilesPass, type Technique, TiledOutputPass } from '@farol/renderer/authoring';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl);

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x05070b);
const camera = new THREE.PerspectiveCamera(42, 1, 0.1, 100);
camera.position.set(6, 4, 9);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1, 0);
controls.update();

const sharedLists: Technique = {
  label: 'Tiled, shared lists',
  help: 'Tiled deferred shading whose transparent surfaces are lit by the same lists as the opaque ones.',
  lightOrder: 'by-depth',
  needsFloatTargets: true,
  fills: 'every-pixel',
  writes: ['gbuffer'],
  passes: () => [
    new GBufferPass(),
    // lists of a tile's whole depth: those of 'slices' hold what reaches opaque surfaces alone, and would not do for glass
    new LightTilesPass('none'),
    new TiledOutputPass(),
    ...forwardTail('lightLoopTiled', ['light-lists']),
  ],
};
farol.technique = farol.addTechnique('shared-lists', sharedLists);

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(40, 40),
  new THREE.MeshStandardMaterial({ color: 0x7e8088, roughness: 0.85 }),
);
floor.rotation.x = -Math.PI / 2;
scene.add(floor, new THREE.HemisphereLight(0x90a8e0, 0x302820, 0.2));
const arch = new THREE.TorusGeometry(1.6, 0.16, 16, 64);
for (let i = 0; i < 14; i++) {
  const color = new THREE.Color().setHSL(0.55 + 0.02 * i, 0.5, 0.6);
  const mesh = new THREE.Mesh(arch, new THREE.MeshStandardMaterial({ color, roughness: 0.7 }));
  mesh.position.set(1.6 * Math.sin(0.45 * i), 0.9, 5 - 1.3 * i);
  mesh.rotation.y = 0.5 * Math.cos(0.45 * i);
  scene.add(mesh);
}
const pane = new THREE.CircleGeometry(1.5, 48);
for (let i = 0; i < 7; i++) {
  const color = new THREE.Color().setHSL(0.5 + 0.06 * i, 0.6, 0.7);
  const glass = new THREE.MeshStandardMaterial({
    color,
    roughness: 0.2,
    transparent: true,
    opacity: 0.35,
    side: THREE.DoubleSide,
  });
  const mesh = new THREE.Mesh(pane, glass);
  mesh.position.set(1.6 * Math.sin(0.9 * i), 0.9, 5 - 2.6 * i);
  mesh.rotation.y = 0.5 * Math.cos(0.9 * i);
  scene.add(mesh);
}
const bulb = new THREE.SphereGeometry(0.06, 16, 12);
const lights = Array.from({ length: 44 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL((0.02 * i + 0.9) % 1, 0.9, 0.6), 4, 3.6);
  light.add(new THREE.Mesh(bulb, new THREE.MeshBasicMaterial({ color: light.color })));
  scene.add(light);
  return light;
});

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
  for (const [i, light] of lights.entries()) {
    const along = (i + 0.8 * seconds) % lights.length;
    const turn = 1.3 * i + 0.8 * seconds;
    const z = 6 - 0.42 * along;
    light.position.set(1.6 * Math.sin(0.45 * ((5 - z) / 1.3)) + 1.1 * Math.cos(turn), 1.1 + 0.9 * Math.sin(turn), z);
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
