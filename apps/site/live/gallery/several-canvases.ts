/**
 * Several canvases
 *
 * Three canvases, each with a FarolRenderer and a technique of its own, show one scene from three sides.
 *
 * @tags canvas, technique
 */
import { FarolRenderer, type TechniqueName } from '@farol/renderer';
import * as THREE from 'three';

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x07080d);
const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(30, 30),
  new THREE.MeshStandardMaterial({ color: 0x7c8088, roughness: 0.5 }),
);
floor.rotation.x = -Math.PI / 2;
const knot = new THREE.Mesh(
  new THREE.TorusKnotGeometry(0.8, 0.26, 200, 32),
  new THREE.MeshStandardMaterial({ color: 0xf0e4d4, roughness: 0.3, metalness: 0.2 }),
);
knot.position.y = 1.3;
scene.add(floor, knot, new THREE.HemisphereLight(0x8fa8d8, 0x302820, 0.2));
const lights = Array.from({ length: 24 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL(i / 24, 0.85, 0.6), 3.5, 4);
  scene.add(light);
  return light;
});

const row = document.createElement('main');
row.style.cssText = 'display: flex; gap: 8px; height: 100vh; padding: 8px; box-sizing: border-box; margin: 0';
const first = document.querySelector('canvas')!;
document.body.append(row);
const eyes: [TechniqueName, number, number][] = [
  ['forward-plus', 0, 1.8],
  ['tiled-deferred', 2.1, 3.4],
  ['light-prepass', 4.2, 1.2],
];
const panes = eyes.map(([technique, angle, height], i) => {
  const canvas = i === 0 ? first : document.createElement('canvas');
  canvas.style.cssText = 'flex: 1; min-width: 0; width: 0; height: 100%; border-radius: 8px';
  row.append(canvas);
  const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
  webgl.toneMapping = THREE.ACESFilmicToneMapping;
  const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 60);
  camera.position.set(4.4 * Math.sin(angle), height, 4.4 * Math.cos(angle));
  camera.lookAt(0, 1.1, 0);
  return { canvas, webgl, camera, farol: new FarolRenderer(webgl, { technique }) };
});

function resize(): void {
  for (const { canvas, webgl, camera, farol } of panes) {
    camera.aspect = canvas.clientWidth / canvas.clientHeight;
    camera.updateProjectionMatrix();
    webgl.setPixelRatio(Math.min(devicePixelRatio, 2));
    farol.setSize(canvas.clientWidth, canvas.clientHeight, false); // the page lays the canvas out
  }
}
addEventListener('resize', resize);
resize();

panes[0].webgl.setAnimationLoop((milliseconds) => {
  const seconds = milliseconds / 1000;
  knot.rotation.y = 0.3 * seconds;
  for (const [i, light] of lights.entries()) {
    const angle = 0.4 * seconds + (i / 24) * 2 * Math.PI;
    light.position.set(2.1 * Math.cos(angle), 0.4 + 0.45 * (i % 5), 2.1 * Math.sin(angle));
  }
  for (const { farol, camera } of panes) farol.render(scene, camera);
});

const [{ farol, webgl, camera }] = panes;
export { camera, farol, scene, webgl };
