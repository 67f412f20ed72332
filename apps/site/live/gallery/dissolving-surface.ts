/**
 * A statue that dissolves
 *
 * A surface discards what its noise says and lets the rim glow; shadows have the same holes.
 *
 * @tags microshader, surface, shadows
 */
import { FarolRenderer } from '@farol/renderer';
import { Surface, setSurface } from '@farol/renderer/surfaces';
import {
  ACESFilmicToneMapping,
  Color,
  DoubleSide,
  HemisphereLight,
  Mesh,
  MeshStandardMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  PointLight,
  Scene,
  SpotLight,
  TorusKnotGeometry,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const canvas = document.querySelector('canvas')!;
const webgl = new WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = ACESFilmicToneMapping;
webgl.toneMappingExposure = 2.2;
webgl.shadowMap.enabled = true;
const farol = new FarolRenderer(webgl, { technique: 'clustered-forward' });

const scene = new Scene();
scene.background = new Color(0x08070a);
const camera = new PerspectiveCamera(40, 1, 0.1, 100);
camera.position.set(2.6, 1.8, 4.6);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1.1, 0);
controls.update();

const dissolve = new Surface(
  'dissolve',
  `#include "surfaceNoise"
uniform float share; // = 0.5 [0, 1, 0.01] Share that is gone
uniform vec3 rimColor; // = #ff6a20 Colour of the rim
void surface(inout SurfaceData s) {
  float rest = farol_fractalNoise(s.positionOS * 5.0) - share;
  if (rest < 0.0) discard;
  s.emissive += rimColor * 4.0 * smoothstep(0.05, 0.0, rest);
}`,
);
const floor = new Mesh(new PlaneGeometry(30, 30), new MeshStandardMaterial({ color: 0x9a9288, roughness: 0.8 }));
floor.rotation.x = -Math.PI / 2;
floor.receiveShadow = true;
const material = new MeshStandardMaterial({ color: 0xd8d2c8, roughness: 0.4, side: DoubleSide });
const statue = new Mesh(new TorusKnotGeometry(0.75, 0.27, 256, 48), material);
statue.position.y = 1.3;
statue.castShadow = statue.receiveShadow = true;
const values = setSurface(material, dissolve, { share: 0.4 });
scene.add(floor, statue, new HemisphereLight(0x8090c0, 0x302820, 0.12));
const spot = new SpotLight(0xffe0b8, 80, 14, 0.45, 0.6);
spot.position.set(2.5, 5, 3);
spot.target = statue;
spot.castShadow = true;
spot.shadow.mapSize.set(1024, 1024);
spot.shadow.normalBias = 0.03;
const back = new SpotLight(0x4a7aff, 50, 14, 0.5, 0.6);
back.position.set(-4, 3, -3);
back.target = statue;
back.castShadow = true;
back.shadow.normalBias = 0.03;
const ember = new PointLight(0xff6a20, 2.2, 4);
ember.position.y = 1.3;
scene.add(spot, back, ember);

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
  statue.rotation.y = 0.25 * seconds;
  values.share.value = 0.36 + 0.14 * Math.sin(0.8 * seconds);
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
