/**
 * Mirrors by three's Reflector
 *
 * A Reflector draws the scene by stock `webgl.render` within Farol's frame: both draw one scene, with one depth.
 *
 * @tags targets, point light
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { Reflector } from 'three/addons/objects/Reflector.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'clustered-forward' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x07080d);
const camera = new THREE.PerspectiveCamera(42, 1, 0.1, 100);
camera.position.set(2.8, 2.2, 5);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1, 0);
controls.update();

const mirror = new Reflector(new THREE.CircleGeometry(4, 96), {
  textureWidth: 1024,
  textureHeight: 1024,
  color: 0x9a9fa8,
});
mirror.rotation.x = -Math.PI / 2;
const stand = new THREE.Mesh(
  new THREE.RingGeometry(4, 14, 96),
  new THREE.MeshStandardMaterial({ color: 0x3a3d46, roughness: 0.7 }),
);
stand.rotation.x = -Math.PI / 2;
scene.add(mirror, stand, new THREE.HemisphereLight(0x90a0e0, 0x302820, 0.3));
const shapes = Array.from({ length: 9 }, (_, i) => {
  const material = new THREE.MeshPhysicalMaterial({
    color: new THREE.Color().setHSL(i / 9, 0.55, 0.6),
    roughness: 0.35,
    clearcoat: 1,
  });
  const mesh = new THREE.Mesh(
    i % 3 ? new THREE.IcosahedronGeometry(0.5, 0) : new THREE.TorusKnotGeometry(0.36, 0.13, 120, 18),
    material,
  );
  scene.add(mesh);
  return mesh;
});
const lights = Array.from({ length: 12 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL(0.1 + 0.02 * i, 0.6, 0.7), 9, 6);
  light.add(
    new THREE.Mesh(new THREE.SphereGeometry(0.06, 16, 12), new THREE.MeshBasicMaterial({ color: light.color })),
  );
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
  for (const [i, mesh] of shapes.entries()) {
    const angle = 0.25 * seconds + (i / 9) * 2 * Math.PI;
    mesh.position.set(2 * Math.cos(angle), 1 + 0.5 * Math.sin(2 * angle + seconds), 2 * Math.sin(angle));
    mesh.rotation.set(seconds, 0.7 * seconds + i, 0);
  }
  for (const [i, light] of lights.entries()) {
    const angle = -0.3 * seconds + (i / 12) * 2 * Math.PI;
    light.position.set(3 * Math.cos(angle), 0.6 + 0.55 * (i % 4), 3 * Math.sin(angle));
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
