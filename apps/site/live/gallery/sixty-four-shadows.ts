/**
 * 64 lights with shadows
 *
 * Sixty-four spot lights, each with a shadow map of its own in one atlas; stock three stops at its texture units.
 *
 * @tags shadows, spot light, many lights
 */
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = THREE.ACESFilmicToneMapping;
webgl.shadowMap.enabled = true;
const farol = new FarolRenderer(webgl, { technique: 'clustered-deferred' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x040508);
const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 100);
camera.position.set(9, 9, 15);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(60, 60),
  new THREE.MeshStandardMaterial({ color: 0xaaa49a, roughness: 0.75 }),
);
floor.rotation.x = -Math.PI / 2;
floor.receiveShadow = true;
scene.add(floor, new THREE.HemisphereLight(0x8090c0, 0x302820, 0.06));

const pieces = new THREE.InstancedMesh(
  new THREE.CylinderGeometry(0.1, 0.22, 1.1, 6),
  new THREE.MeshStandardMaterial({ color: 0xf0e8dc }),
  81,
);
pieces.castShadow = pieces.receiveShadow = true;
const matrix = new THREE.Matrix4();
for (let i = 0; i < 81; i++) {
  const high = 0.7 + THREE.MathUtils.seededRandom();
  matrix.makeScale(1, high, 1).setPosition(1.8 * ((i % 9) - 4), 0.55 * high, 1.8 * (Math.floor(i / 9) - 4));
  pieces.setMatrixAt(i, matrix);
}
scene.add(pieces);

const bulb = new THREE.SphereGeometry(0.07, 12, 8);
const lights = Array.from({ length: 64 }, (_, i) => {
  const light = new THREE.SpotLight(new THREE.Color().setHSL((i * 0.13) % 1, 0.75, 0.6), 34, 6, 0.62, 0.6);
  light.position.set(1.8 * ((i % 8) - 3.5), 2.6, 1.8 * (Math.floor(i / 8) - 3.5));
  light.castShadow = true;
  light.shadow.mapSize.set(256, 256);
  light.add(new THREE.Mesh(bulb, new THREE.MeshBasicMaterial({ color: light.color })));
  scene.add(light, light.target);
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
  for (const [i, { position, target }] of lights.entries()) {
    target.position.set(
      position.x + 1.4 * Math.sin(seconds + i),
      0,
      position.z + 1.4 * Math.cos(0.8 * seconds + 2 * i),
    );
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
