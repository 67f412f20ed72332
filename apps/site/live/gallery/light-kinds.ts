/**
 * Every kind of light
 *
 * Ambient, hemisphere, directional, point, spot and area light, each alone over the same still life.
 *
 * @tags start, area light, spot light, directional light
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { TeapotGeometry } from 'three/addons/geometries/TeapotGeometry.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
webgl.shadowMap.enabled = true;
const farol = new FarolRenderer(webgl, { technique: 'clustered-forward', lightLayers: true });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x06070a);
const camera = new THREE.PerspectiveCamera(32, 1, 0.1, 100);
camera.position.set(0, 1.5, 9.6);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1.05, 0);
controls.update();

const plaster = new THREE.MeshStandardMaterial({ color: 0xd8d2c6, roughness: 0.8 });
const glaze = new THREE.MeshStandardMaterial({ color: 0xc96a4a, roughness: 0.25 });
const brass = new THREE.MeshStandardMaterial({ color: 0xd0a050, roughness: 0.3, metalness: 0.8 });
const box = new THREE.BoxGeometry(2, 0.1, 2);
const wall = new THREE.BoxGeometry(2, 2.3, 0.1);
const pot = new TeapotGeometry(0.36, 8);
const cone = new THREE.ConeGeometry(0.3, 0.9, 32);
const ball = new THREE.SphereGeometry(0.24, 32, 20);

/** A niche whose things are on a layer of their own: with `lightLayers` a light reaches only what shares one with it. */
function niche(
  index: number,
  ...lights: (THREE.DirectionalLight | THREE.PointLight | THREE.SpotLight | THREE.RectAreaLight)[]
): void {
  const group = new THREE.Group();
  group.position.set(2.25 * ((index % 3) - 1), index < 3 ? 1.7 : -1.1, 0);
  const add = (geometry: THREE.BufferGeometry, material: THREE.Material, x: number, y: number, z: number) => {
    const mesh = new THREE.Mesh(geometry, material);
    mesh.position.set(x, y, z);
    mesh.castShadow = mesh.receiveShadow = true;
    group.add(mesh);
  };
  add(box, plaster, 0, -0.05, 0);
  add(wall, plaster, 0, 1.1, -0.95);
  add(pot, glaze, 0.1, 0.36, 0.15);
  add(cone, plaster, -0.55, 0.45, -0.35);
  add(ball, brass, 0.65, 0.24, -0.3);
  for (const light of lights) {
    group.add(light);
    if (light instanceof THREE.SpotLight || light instanceof THREE.DirectionalLight) group.add(light.target);
    light.castShadow = true;
    if (!(light instanceof THREE.RectAreaLight)) light.shadow.normalBias = 0.02;
  }
  group.traverse((object) => object.layers.set(index + 1));
  camera.layers.enable(index + 1);
  scene.add(group);
}
const point = new THREE.PointLight(0xffc890, 7, 5);
point.position.set(-0.3, 1.4, 0.6);
const spot = new THREE.SpotLight(0xffe6c0, 40, 6, 0.38, 0.5);
spot.position.set(0.9, 2.6, 1.4);
spot.target.position.set(0, 0.2, 0);
const sun = new THREE.DirectionalLight(0xfff0d8, 2.6);
sun.position.set(-1.5, 2.4, 2);
const area = new THREE.RectAreaLight(0x9fd0ff, 9, 1.4, 0.5);
area.position.set(0, 1.7, 0.9);
area.lookAt(0, 0, 0);
const blue = new THREE.PointLight(0x5a8cff, 5, 4);
blue.position.set(0.9, 0.8, 0.9);
const warm = new THREE.SpotLight(0xff7a40, 40, 6, 0.5, 1);
warm.position.set(-1.6, 2, 1.6);
const low = new THREE.DirectionalLight(0xff9a50, 2.2);
low.position.set(3, 0.7, 1);
for (const { shadow } of [sun, low]) Object.assign(shadow.camera, { left: -2, bottom: -2, right: 2, top: 2 });
niche(0, sun);
niche(1, point);
niche(2, spot);
niche(3, area);
niche(4, low);
niche(5, blue, warm);
scene.add(new THREE.HemisphereLight(0x9fb8e8, 0x6a5a48, 0.18), new THREE.AmbientLight(0xffffff, 0.04));

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
  point.position.x = 0.9 * Math.sin(seconds);
  spot.target.position.x = 0.5 * Math.sin(0.8 * seconds);
  area.position.x = 0.5 * Math.sin(0.7 * seconds);
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
