/**
 * Light layers
 *
 * Each figure has a light that only it sees: with `lightLayers` a light reaches what shares a layer with it.
 *
 * @tags light layers, spot light
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
webgl.shadowMap.enabled = true;
const farol = new FarolRenderer(webgl, { technique: 'clustered-forward', lightLayers: true });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x08090d);
const camera = new THREE.PerspectiveCamera(38, 1, 0.1, 100);
camera.position.set(0, 1.8, 7);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1.15, 0);
controls.update();

const stage = new THREE.Mesh(
  new THREE.CylinderGeometry(6, 6, 0.2, 96),
  new THREE.MeshStandardMaterial({ color: 0x4a4038, roughness: 0.5 }),
);
stage.position.y = -0.1;
stage.receiveShadow = true;
scene.add(stage, new THREE.HemisphereLight(0x7080b0, 0x403828, 0.2));
const wash = new THREE.SpotLight(0xffe0b8, 150, 16, 0.75, 0.8);
wash.position.set(0, 7, 4);
wash.castShadow = true;
scene.add(wash);

const marble = new THREE.MeshStandardMaterial({ color: 0xf2eee6, roughness: 0.4 });
const body = new THREE.LatheGeometry(
  [0.42, 0.38, 0.26, 0.3, 0.36, 0.24, 0.12, 0.1].map((radius, i) => new THREE.Vector2(radius, 0.24 * i)),
  48,
);
const head = new THREE.SphereGeometry(0.22, 32, 20);
const rims: THREE.PointLight[] = [];
for (let i = 0; i < 5; i++) {
  const figure = new THREE.Group();
  figure.position.set(1.7 * (i - 2), 0, i % 2 ? 0.5 : -0.4);
  const skull = new THREE.Mesh(head, marble);
  skull.position.y = 1.86;
  figure.add(new THREE.Mesh(body, marble), skull);
  figure.traverse((object) => {
    object.castShadow = true;
    object.layers.enable(i + 1); // each figure is on layer 0, which all lights reach, and on its own
  });
  const rim = new THREE.PointLight(new THREE.Color().setHSL(i / 5, 1, 0.5), 34, 5);
  rim.layers.set(i + 1); // only this figure shares a layer with its rim light
  rims.push(rim);
  camera.layers.enable(i + 1);
  figure.add(rim);
  scene.add(figure);
}

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
  for (const [i, rim] of rims.entries()) {
    rim.position.set(1.1 * Math.cos(1.2 * seconds + i), 1.3, 1.1 * Math.sin(1.2 * seconds + i));
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
