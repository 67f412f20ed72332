/**
 * A technique, step by step
 *
 * The views of a FarolRenderer show what each step of a technique has made, on a scene that turns. `&technique=deferred`
 * says which technique; `auto` has a slider for the lights in place of steps.
 */
import { FarolRenderer, type TechniqueName } from '@farol/renderer';
import {
  ACESFilmicToneMapping,
  AmbientLight,
  Color,
  CylinderGeometry,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  PointLight,
  Scene,
  SphereGeometry,
  TorusKnotGeometry,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { type Step, stepsOf } from './steps/techniqueSteps';

const technique = (new URLSearchParams(location.search).get('technique') ?? 'auto') as TechniqueName;
const language = document.documentElement.lang === 'es' ? 1 : 0;
const canvas = document.querySelector('canvas')!;
const webgl = new WebGLRenderer({ canvas });
webgl.toneMapping = ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl, { technique });

const scene = new Scene();
scene.background = new Color(0x05070c);
scene.add(new AmbientLight(0x8090b0, 0.25));
const floor = new Mesh(new PlaneGeometry(24, 24), new MeshStandardMaterial({ color: 0x8f8a80, roughness: 0.55 }));
floor.rotation.x = -Math.PI / 2;
scene.add(floor);
const stone = new MeshStandardMaterial({ color: 0xc0b49c, roughness: 0.8 });
const column = new CylinderGeometry(0.28, 0.34, 2.4, 24);
for (let i = 0; i < 36; i++) {
  const mesh = new Mesh(column, stone);
  mesh.position.set((i % 6) * 3 - 7.5, 1.2, Math.floor(i / 6) * 3 - 7.5);
  scene.add(mesh);
}
for (let i = 0; i < 5; i++) {
  const color = new Color().setHSL(i / 5, 0.45, 0.55);
  const knot = new Mesh(
    new TorusKnotGeometry(0.5, 0.17, 128, 24),
    new MeshStandardMaterial({ color, roughness: 0.15 + i / 6, metalness: i % 2 }),
  );
  knot.position.set(i * 3 - 6, 0.9, 0);
  scene.add(knot);
}

const lights = Array.from({ length: 120 }, (_, i) => {
  const light = new PointLight(new Color().setHSL((i * 0.382) % 1, 0.7, 0.6), 5, 3); // ends after 3 m
  scene.add(light);
  return light;
});
const bulbs = new InstancedMesh(new SphereGeometry(0.05, 12, 8), new MeshBasicMaterial(), lights.length);
bulbs.frustumCulled = false;
lights.forEach((light, i) => bulbs.setColorAt(i, light.color));
scene.add(bulbs);
const matrix = new Matrix4();
const place = new Vector3();

/** Moves the lights. @param seconds - since the page's beginning */
function move(seconds: number): void {
  lights.forEach((light, i) => {
    const angle = 2.4 * i + (i % 2 ? 0.2 : -0.15) * seconds;
    const radius = 1 + 9 * Math.sqrt((i + 1) / lights.length);
    place.set(radius * Math.cos(angle), 0.6 + 0.5 * Math.sin(i + seconds), radius * Math.sin(angle));
    bulbs.setMatrixAt(i, matrix.setPosition(light.position.copy(place)));
  });
  bulbs.instanceMatrix.needsUpdate = true;
}

function shine(count: number): void {
  lights.forEach((light, i) => (light.visible = i < count));
  bulbs.count = count;
}

const camera = new PerspectiveCamera(45, 1, 0.1, 60);
camera.position.set(7, 5, 11);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.8, 0);
controls.maxDistance = 24;
controls.update();

const panel = document.createElement('div');
panel.className = 'panel below';
const help = document.createElement('span');
help.setAttribute('aria-live', 'polite');
document.body.append(panel);

function show(step: Step): void {
  farol.view = step.view;
  shine(step.lights ?? lights.length);
  help.textContent = step.help[language];
}

if (technique === 'auto') {
  const slider = document.createElement('input');
  slider.ariaLabel = language ? 'Luces' : 'Lights';
  Object.assign(slider, { type: 'range', min: '1', max: String(lights.length), value: '12' });
  slider.addEventListener('input', () => shine(Number(slider.value)));
  shine(12);
  panel.append(slider, help);
} else {
  const steps = stepsOf(technique);
  const buttons = steps.map((step) => {
    const button = document.createElement('button');
    button.textContent = step.name[language];
    button.addEventListener('click', () => {
      for (const each of buttons) {
        each.ariaPressed = String(each === button);
        each.style.outline = each === button ? '2px solid var(--live-accent)' : '';
      }
      show(step);
    });
    return button;
  });
  panel.append(...buttons, help);
  buttons.at(-1)!.click();
}
const passes = document.createElement('small');
passes.className = 'passes';
panel.append(passes);

function resize(): void {
  // on a phone the panel lies below the picture
  const height = Math.max(1, innerHeight - (innerWidth < 480 ? panel.offsetHeight : 0));
  camera.aspect = innerWidth / height;
  camera.updateProjectionMatrix();
  farol.setPixelRatio(Math.min(devicePixelRatio, 2));
  farol.setSize(innerWidth, height);
}
addEventListener('resize', resize);
new ResizeObserver(resize).observe(panel);
resize();

/** Writes the passes of the last frame, with their draws. */
function tellPasses(): void {
  const { info } = farol;
  const drawn = info.passes.filter(({ drawCalls }) => drawCalls > 0);
  passes.textContent = drawn.map(({ name, drawCalls }) => `${name}: ${drawCalls}`).join(' · ');
  if (technique === 'auto') help.textContent = `${info.lights.total}: ${info.technique} (${info.reason})`;
}
let frames = 0;
webgl.setAnimationLoop((milliseconds) => {
  move(milliseconds / 1000);
  controls.update();
  farol.render(scene, camera);
  if (frames++ % 30 === 1) tellPasses();
});

export { camera, farol, scene, webgl };
