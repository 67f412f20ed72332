/** Each variant of deferred rendering, step by step, by the buffers that its passes leave (thesis 2.2.3.3). */
import { techniques, type TechniqueName, type View } from '@farol/renderer';
import {
  AmbientLight,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshPhongMaterial,
  SphereGeometry,
  WireframeGeometry,
} from 'three';
import { BufferView, type BufferName } from './buffers/BufferView';
import { Figure } from './frame/Figure';
import { lamps, room } from './frame/room';
import { stepsOf, type StepTechnique } from './steps/stepsOf';

const figure = new Figure({ from: [3.6, 3.4, 7.2], at: [0, 1, 0] });
const { scene, farol, camera, webgl, controls } = figure;
const say = figure.say.bind(figure);
const asked = new URLSearchParams(location.search).get('technique');
const technique = asked !== null && asked in stepsOf ? (asked as StepTechnique) : 'deferred';
farol.technique = technique satisfies TechniqueName;
const { label } = techniques[technique];
figure.describe(`${label}, step by step`, `${label}, paso a paso`);

const { group, lights, move } = lamps(40, 2.2, 4);
const pane = new Mesh(
  new SphereGeometry(0.55, 32, 24),
  new MeshPhongMaterial({ color: 0x90d0e0, transparent: true, opacity: 0.45, shininess: 80 }),
);
pane.position.set(1.9, 0.7, 2.6);
scene.add(room(), group, pane, new AmbientLight(0x8090b0, 0.35));
const wire = new WireframeGeometry(new SphereGeometry(1, 12, 8));
const volumes = lights.map((light) => {
  const volume = new LineSegments(wire, new LineBasicMaterial({ color: light.color, transparent: true, opacity: 0.6 }));
  light.add(volume);
  return volume;
});

const view = new BufferView();
view.depths.set(3, 16);
farol.effects = [view];
farol.heatMapMaximum = 24;
/** Techniques that draw what is transparent after all else, by a program of its own. */
const isPaneLate = technique !== 'inferred' && technique !== 'forward-plus' && !technique.endsWith('forward');
let count = 40;
let showsVolumes = false;
let at = 0;
const steps = stepsOf[technique];

/** Sets what the figure shows, by the step and the controls. */
function show(): void {
  const step = steps[at];
  const isView = step.show === 'light-count' || step.show === 'overdraw' || step.show === 'final';
  farol.view = (isView ? step.show : 'final') as View;
  view.show = isView ? null : (step.show as BufferName);
  pane.visible = !isPaneLate || step.show === 'final';
  lights.forEach((light, i) => (light.visible = i < count));
  volumes.forEach((volume, i) => {
    volume.visible = showsVolumes && i < count;
    volume.scale.setScalar(lights[i].distance);
  });
  figure.tell(step.en, step.es);
}
const choose = controls.choice({
  name: 'step',
  label: '',
  value: '0',
  options: steps.map(({ label: [english, spanish] }, i) => [String(i), `${i + 1}. ${say(english, spanish)}`] as const),
  change(value) {
    at = Number(value);
    show();
  },
});
controls.button('next', say('Next', 'Siguiente'), () => choose(String((at + 1) % steps.length)));
controls.range({
  name: 'lights',
  label: say('Lights', 'Luces'),
  value: 40,
  min: 1,
  max: 40,
  change(value) {
    count = value;
    show();
  },
});
controls.range({
  name: 'range',
  label: say('Range (m)', 'Alcance (m)'),
  value: 2.2,
  min: 0.8,
  max: 6,
  step: 0.1,
  change(value) {
    for (const light of lights) light.distance = value;
    show();
  },
});
controls.check({
  name: 'volumes',
  label: say('Light volumes', 'Volúmenes de luz'),
  value: false,
  change(on) {
    showsVolumes = on;
    show();
  },
});
if (technique === 'inferred')
  controls.range({
    name: 'scale',
    label: say('Texels a pixel', 'Téxeles por píxel'),
    value: 0.5,
    min: 0.1,
    max: 1,
    step: 0.05,
    change: (value) => void (farol.inferredScale = value),
  });
figure.animate(move);

export { camera, farol, figure, scene, webgl };
