/**
 * Flat, Gouraud, Phong
 *
 * The three ways to shade of the thesis, in one frame: one normal a triangle, light at vertices, light in pixels.
 *
 * @tags materials, start
 */
import { FarolRenderer, setShading } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { TeapotGeometry } from 'three/addons/geometries/TeapotGeometry.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'clustered-deferred' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x07080c);
const camera = new THREE.PerspectiveCamera(36, 1, 0.1, 100);
camera.position.set(0, 1.4, 7);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.75, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(30, 30),
  new THREE.MeshStandardMaterial({ color: 0x4c505a, roughness: 0.5 }),
);
floor.rotation.x = -Math.PI / 2;
scene.add(floor, new THREE.HemisphereLight(0x8fa8d8, 0x302820, 0.25));
const pot = new TeapotGeometry(0.72, 4);
const pots = (['flat', 'gouraud', 'phong'] as const).map((shading, i) => {
  const material = new THREE.MeshPhongMaterial({ color: 0xd98b5a, shininess: 60, specular: 0x888888 });
  setShading(material, shading);
  const mesh = new THREE.Mesh(pot, material);
  mesh.position.set(2.35 * (i - 1), 0.75, 0);
  scene.add(mesh);
  return mesh;
});
const bulb = new THREE.SphereGeometry(0.05, 16, 12);
const lights = Array.from({ length: 12 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL((i * 0.13) % 1, 0.5, 0.7), 4, 5);
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
  for (const mesh of pots) mesh.rotation.y = 0.4 * seconds;
  for (const [i, light] of lights.entries()) {
    const angle = 0.4 * seconds + (i / 12) * 2 * Math.PI;
    light.position.set(3.6 * Math.cos(angle), 1 + 0.4 * (i % 3), 2 * Math.sin(angle));
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
