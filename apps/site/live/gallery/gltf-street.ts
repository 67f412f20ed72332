/**
 * glTF with lamps in it
 *
 * A street lamp as GLTFLoader gives it, its light by KHR_lights_punctual and its animation, placed along a lane.
 *
 * @tags loaders, animation, spot light
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { clone } from 'three/addons/utils/SkeletonUtils.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique: 'clustered-deferred' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x070b18);
scene.fog = new THREE.Fog(0x070b18, 10, 40);
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 100);
camera.position.set(0.9, 2, 7.6);
const controls = new OrbitControls(camera, canvas);
controls.target.set(-0.2, 1.9, -4);
controls.update();

const road = new THREE.Mesh(
  new THREE.PlaneGeometry(60, 80),
  new THREE.MeshStandardMaterial({ color: 0x5a5c62, roughness: 0.45 }),
);
road.rotation.x = -Math.PI / 2;
road.position.z = -20;
scene.add(road, new THREE.HemisphereLight(0x5a78c8, 0x181410, 0.3));
const { scene: lamp, animations } = await new GLTFLoader().loadAsync('./models/streetLamp.glb');
const mixers: THREE.AnimationMixer[] = [];
for (let i = 0; i < 12; i++) {
  const copy = clone(lamp);
  copy.position.set(i % 2 ? 2.2 : -2.2, 0, 1.5 - 3.2 * Math.floor(i / 2));
  copy.rotation.y = i % 2 ? Math.PI / 2 : -Math.PI / 2;
  scene.add(copy);
  const mixer = new THREE.AnimationMixer(copy);
  for (const clip of animations) mixer.clipAction(clip).play();
  mixer.update(0.7 * i);
  mixers.push(mixer);
}
const house = new THREE.BoxGeometry(3, 5, 3.4);
for (let i = 0; i < 14; i++) {
  const mesh = new THREE.Mesh(
    house,
    new THREE.MeshStandardMaterial({
      color: new THREE.Color().setHSL(0.07, 0.18, 0.3 + 0.03 * (i % 3)),
      roughness: 0.9,
    }),
  );
  mesh.position.set(i % 2 ? 5.6 : -5.6, 2 + 0.5 * (i % 3), 2 - 3.6 * Math.floor(i / 2));
  scene.add(mesh);
}
const timer = new THREE.Timer();

function resize(): void {
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  farol.setPixelRatio(Math.min(devicePixelRatio, 2));
  farol.setSize(innerWidth, innerHeight);
}
addEventListener('resize', resize);
resize();

webgl.setAnimationLoop(() => {
  timer.update();
  for (const mixer of mixers) mixer.update(timer.getDelta());
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
