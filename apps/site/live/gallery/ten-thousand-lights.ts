/**
 * 10,000 lights as data
 *
 * A LightField holds ten thousand lights in one typed array, as InstancedMesh holds meshes: no object a light.
 *
 * @tags many lights, light field
 */
import { FarolRenderer } from '@farol/renderer';
import { LightField } from '@farol/renderer/light-field';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { ImprovedNoise } from 'three/addons/math/ImprovedNoise.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl);

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x020308);
scene.fog = new THREE.Fog(0x020308, 30, 95);
const camera = new THREE.PerspectiveCamera(42, 1, 0.1, 160);
camera.position.set(0, 13, 34);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0, 0);
controls.update();

const noise = new ImprovedNoise();
const heightAt = (x: number, z: number) =>
  2.2 * noise.noise(x / 9, 0.5, z / 9) + 0.5 * noise.noise(x / 2.5, 3.5, z / 2.5);

const land = new THREE.PlaneGeometry(110, 110, 220, 220).rotateX(-Math.PI / 2);
const places = land.attributes.position;
for (let i = 0; i < places.count; i++) places.setY(i, heightAt(places.getX(i), places.getZ(i)));
land.computeVertexNormals();
scene.add(new THREE.Mesh(land, new THREE.MeshStandardMaterial({ color: 0xcfd2da, roughness: 0.5 })));

const COUNT = 10_000;
const field = new LightField(COUNT);
const color = new THREE.Color();
const { array } = field.spheres; // x, y, z and range (m) of each light
for (let i = 0; i < COUNT; i++) {
  const x = 100 * (THREE.MathUtils.seededRandom() - 0.5);
  const z = 100 * (THREE.MathUtils.seededRandom() - 0.5);
  color.setHSL(0.6 + 0.75 * noise.noise(x / 16, 9, z / 16), 0.85, 0.5).multiplyScalar(0.42);
  field.setPoint(i, x, heightAt(x, z) + 0.35, z, 1.8, color.r, color.g, color.b);
}
scene.add(field);
const start = array.slice();

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
  for (let i = 0; i < COUNT; i++) {
    const x = start[i * 4] + 0.8 * Math.sin(seconds * 0.7 + i);
    const z = start[i * 4 + 2] + 0.8 * Math.cos(seconds * 0.6 + 2 * i);
    array[i * 4] = x;
    array[i * 4 + 1] = heightAt(x, z) + 0.35;
    array[i * 4 + 2] = z;
  }
  field.spheres.update(0, COUNT);
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
