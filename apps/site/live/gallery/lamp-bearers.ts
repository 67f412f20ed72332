/**
 * Skinned figures with lamps
 *
 * Bones carry real lights: forty lanterns swing as their bearers wave, on skinned meshes in a G-buffer.
 *
 * @tags animation, deferred, many lights
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'clustered-deferred' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x05060b);
const camera = new THREE.PerspectiveCamera(42, 1, 0.1, 100);
camera.position.set(4.4, 3, 7.6);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(40, 40),
  new THREE.MeshStandardMaterial({ color: 0x6d6a72, roughness: 0.55 }),
);
floor.rotation.x = -Math.PI / 2;
scene.add(floor, new THREE.HemisphereLight(0x7a8ad0, 0x201818, 0.2));

const BONES = 6;
const HEIGHT = 2.2;
const stalk = new THREE.CylinderGeometry(0.1, 0.2, HEIGHT, 16, 24).translate(0, HEIGHT / 2, 0);
const places = stalk.attributes.position;
const skinIndex = new Uint16Array(4 * places.count);
const skinWeight = new Float32Array(4 * places.count);
for (let i = 0; i < places.count; i++) {
  const along = THREE.MathUtils.clamp((places.getY(i) / HEIGHT) * (BONES - 1), 0, BONES - 1.001);
  skinIndex.set([Math.floor(along), Math.floor(along) + 1], 4 * i);
  skinWeight.set([1 - (along % 1), along % 1], 4 * i);
}
stalk.setAttribute('skinIndex', new THREE.BufferAttribute(skinIndex, 4));
stalk.setAttribute('skinWeight', new THREE.BufferAttribute(skinWeight, 4));
const glass = new THREE.SphereGeometry(0.13, 20, 14);

const bearers = Array.from({ length: 40 }, (_, i) => {
  const color = new THREE.Color().setHSL(0.52 + 0.45 * ((i * 0.618) % 1), 0.75, 0.6);
  const mesh = new THREE.SkinnedMesh(stalk, new THREE.MeshStandardMaterial({ color: 0xb8c8b0, roughness: 0.45 }));
  const bones = Array.from({ length: BONES }, (_, k) => {
    const bone = new THREE.Bone();
    bone.position.y = k === 0 ? 0 : HEIGHT / (BONES - 1);
    return bone;
  });
  for (let k = 1; k < BONES; k++) bones[k - 1].add(bones[k]);
  mesh.add(bones[0]);
  mesh.bind(new THREE.Skeleton(bones));
  const light = new THREE.PointLight(color, 3.2, 3);
  light.position.y = 0.12;
  light.add(new THREE.Mesh(glass, new THREE.MeshBasicMaterial({ color })));
  bones[BONES - 1].add(light);
  const angle = 2.4 * i;
  mesh.position.set(0.62 * Math.sqrt(i) * Math.cos(angle), 0, 0.62 * Math.sqrt(i) * Math.sin(angle));
  mesh.scale.setScalar(0.6 + 0.4 * ((i * 0.37) % 1));
  mesh.frustumCulled = false;
  scene.add(mesh);
  return bones;
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
  for (const [i, bones] of bearers.entries()) {
    for (let k = 1; k < BONES; k++) {
      bones[k].rotation.x = 0.22 * Math.sin(1.1 * seconds + 0.5 * k + 0.7 * i);
      bones[k].rotation.z = 0.22 * Math.cos(0.9 * seconds + 0.4 * k + 1.3 * i);
    }
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
