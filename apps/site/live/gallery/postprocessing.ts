/**
 * pmndrs' postprocessing
 *
 * `FarolPostPass` in place of its RenderPass, then depth of field from Farol's depth, bloom and tone mapping.
 *
 * @tags post-processing, effect
 */
import { FarolRenderer } from '@farol/renderer';
import { FarolPostPass } from '@farol/renderer/postprocessing';
import {
  BloomEffect,
  DepthOfFieldEffect,
  EffectComposer,
  EffectPass,
  ToneMappingEffect,
  ToneMappingMode,
} from 'postprocessing';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new THREE.WebGLRenderer({ canvas, powerPreference: 'high-performance', stencil: false, depth: false });
const farol = new FarolRenderer(webgl, { technique: 'clustered-forward' });

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x05060a);
const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 100);
camera.position.set(0, 1.3, 6);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.7, 0);
controls.update();

const floor = new THREE.Mesh(
  new THREE.PlaneGeometry(60, 60),
  new THREE.MeshStandardMaterial({ color: 0x50555e, roughness: 0.35 }),
);
floor.rotation.x = -Math.PI / 2;
const gems = new THREE.InstancedMesh(
  new THREE.IcosahedronGeometry(0.32, 0),
  new THREE.MeshStandardMaterial({ color: 0xe8e2da, roughness: 0.2, metalness: 0.3 }),
  120,
);
const place = new THREE.Object3D();
for (let i = 0; i < 120; i++) {
  place.position.set(14 * (THREE.MathUtils.seededRandom() - 0.5), 0.3, 4 - 18 * THREE.MathUtils.seededRandom());
  place.rotation.set(i, 2 * i, 3 * i);
  place.scale.setScalar(0.5 + THREE.MathUtils.seededRandom());
  place.updateMatrix();
  gems.setMatrixAt(i, place.matrix);
}
scene.add(floor, gems, new THREE.HemisphereLight(0x8090d0, 0x201820, 0.2));
const bulb = new THREE.SphereGeometry(0.05, 16, 12);
const lights = Array.from({ length: 60 }, (_, i) => {
  const light = new THREE.PointLight(new THREE.Color().setHSL(0.05 + 0.5 * ((i * 0.618) % 1), 0.9, 0.6), 2.6, 3);
  light.add(new THREE.Mesh(bulb, new THREE.MeshBasicMaterial({ color: light.color.clone().multiplyScalar(8) })));
  scene.add(light);
  return light;
});

const composer = new EffectComposer(webgl, { frameBufferType: THREE.HalfFloatType });
composer.addPass(new FarolPostPass(farol, scene, camera)); // in place of: new RenderPass(scene, camera)
const focus = new DepthOfFieldEffect(camera, { focusDistance: 5.5, focusRange: 3, bokehScale: 4 });
composer.addPass(new EffectPass(camera, focus));
const bloom = new BloomEffect({ intensity: 1.4, luminanceThreshold: 1, mipmapBlur: true });
composer.addPass(new EffectPass(camera, bloom, new ToneMappingEffect({ mode: ToneMappingMode.ACES_FILMIC })));

function resize(): void {
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  composer.setSize(innerWidth, innerHeight);
}
addEventListener('resize', resize);
resize();

webgl.setAnimationLoop((milliseconds) => {
  const seconds = milliseconds / 1000;
  for (const [i, light] of lights.entries()) {
    const x = 7 * Math.sin(2.4 * i + 0.1 * seconds);
    light.position.set(x, 0.8 + 0.4 * Math.sin(seconds + i), 3.5 - 0.26 * i);
  }
  composer.render();
});

export { camera, farol, scene, webgl };
